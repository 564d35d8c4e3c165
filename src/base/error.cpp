// SPDX-License-Identifier: Apache-2.0
#include "feelem/error.hpp"

#include <utility>

namespace feelem {

Error::Error(Code code, std::string where, const std::string& text)
    : std::runtime_error(where.empty() ? text : where + ": " + text), code_(code), where_(std::move(where)) {}

}  // namespace feelem
