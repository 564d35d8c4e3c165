// SPDX-License-Identifier: Apache-2.0
// Nastran's numbers of elements in tables of results, by the names of their cards.
#pragma once

#include <cstdint>
#include <string>

namespace feelem::op2 {

/// "composite CQUAD4 (type 95)"; "elements of type 777" when the number is not known.
std::string element_name(std::int64_t type);

}  // namespace feelem::op2
