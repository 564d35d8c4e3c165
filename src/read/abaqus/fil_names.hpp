// SPDX-License-Identifier: Apache-2.0
// Keys of records with values -> names of results.
#pragma once

#include "feelem/result.hpp"

#include <cstdint>
#include <string_view>

namespace feelem::fil {

enum class Form : std::uint8_t {
    Plain,  ///< One value, or several without directions.
    Vector,
    Dofs,  ///< A vector and a rotation by the active degrees of freedom.
    Tensor,
};
struct Variable {
    std::int64_t key;
    std::string_view solver;  ///< Abaqus' name.
    std::string_view ours;
    Form form = Form::Plain;
    Shear shear = Shear::NotApplicable;
};
/// Null: a key without values of nodes or elements, or one that is not read.
const Variable* find_variable(std::int64_t key);
/// By Abaqus' name: "S".
const Variable* find_variable(std::string_view solver);

}  // namespace feelem::fil
