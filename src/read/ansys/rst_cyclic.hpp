// SPDX-License-Identifier: Apache-2.0
// One sector of a cyclic model repeated round its axis.
#pragma once

#include "read/ansys/rst_source.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <memory>

namespace feelem::rst {

/// The whole model: sector s (from 0) has node and element numbers s * 10^n + those of the file; nodes where
/// sectors meet stand once. Results of a step are kept only when they run on from each sector to the next.
/// The sector itself, and a diagnostic, when the file does not say how it is repeated.
std::unique_ptr<ModelSource> expand_sectors(std::unique_ptr<RstSource> sector, Diagnostics& diagnostics);

}  // namespace feelem::rst
