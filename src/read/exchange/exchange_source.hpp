// SPDX-License-Identifier: Apache-2.0
// A file that the helper program reads, as a ModelSource.
#pragma once

#include "read/read_format.hpp"

#include <memory>
#include <string>
#include <vector>

namespace feelem::exchange {

/// `format`: the helper's word. `others`: files that belong to the main one, by their names from its folder.
std::unique_ptr<ModelSource> open_exchange(
    const std::string& format,
    const Input& input,
    const std::vector<std::string>& others,
    const ReadContext& context,
    Diagnostics& diagnostics
);

}  // namespace feelem::exchange
