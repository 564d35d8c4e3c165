// SPDX-License-Identifier: Apache-2.0
// The files of one distributed run (file0.rst, file1.rst ...) as one model.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace feelem::rst {

/// Each file holds the nodes and elements of its domain; nodes between domains stand in several, with equal
/// values (where values differ they are missing, SeveralValuesAtNode). At least one domain; all with the same
/// steps. Throws Error(MeshesDiffer) when they are not of one run.
std::unique_ptr<ModelSource> merge_domains(
    std::vector<std::unique_ptr<ModelSource>> domains,
    const std::vector<std::string>& names,
    Diagnostics& diagnostics
);

}  // namespace feelem::rst
