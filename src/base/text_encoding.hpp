// SPDX-License-Identifier: Apache-2.0
// Text files of other worlds: UTF-16 and byte-order marks.
#pragma once

#include "base/input.hpp"

namespace feelem {

/// The input as UTF-8 without a byte-order mark: itself unless it starts with a mark of UTF-8, UTF-16LE or
/// UTF-16BE. Line numbers stay what they were. Broken surrogates become U+FFFD.
Input without_encoding(const Input& input);

}  // namespace feelem
