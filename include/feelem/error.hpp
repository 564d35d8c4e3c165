// SPDX-License-Identifier: Apache-2.0
// The only exception type: what went wrong, where, and what to try.
#pragma once

#include "feelem/diagnostics.hpp"

#include <stdexcept>
#include <string>

namespace feelem {

/// Thrown when the work cannot go on. `what()` is "where: text" (text alone when there is no place).
/// The text says what was found, what was expected, and a hint.
class Error : public std::runtime_error {
public:
    Error(Code code, std::string where, const std::string& text);

    Code code() const noexcept { return code_; }
    const std::string& where() const noexcept { return where_; }

private:
    Code code_;
    std::string where_;
};

}  // namespace feelem
