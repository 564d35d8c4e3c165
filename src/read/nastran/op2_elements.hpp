// SPDX-License-Identifier: Apache-2.0
// Stresses and strains of solids, shells and rods in an .op2.
#pragma once

#include "read/element_lookup.hpp"
#include "read/nastran/element_results.hpp"
#include "read/nastran/element_rows.hpp"
#include "read/nastran/op2_ident.hpp"
#include "read/nastran/op2_records.hpp"

#include "feelem/mesh.hpp"

#include <optional>

namespace feelem::op2 {

/// Nothing when the block holds no stresses or strains that Feelem knows.
const ElementLayout* element_layout(const Ident& ident);

/// From word 11 of the ident.
std::optional<StressKind> stress_kind(const Ident& ident);

/// Throws Error(BadStructure).
ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
);

}  // namespace feelem::op2
