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
#include <string>

namespace feelem::op2 {

/// Nothing when the block holds no stresses or strains that Feelem knows.
const ElementLayout* element_layout(const Ident& ident);

/// From word 11 of the ident; nothing when it is not known.
std::optional<StressKind> stress_kind(const Ident& ident);

/// The same, with what OptiStruct (`version` starts with OS) leaves out there: that OSTR tables are strains
/// and that its last column is von Mises'.
StressKind block_kind(const Ident& ident, const std::string& table, const std::string& version);

/// Throws Error(BadStructure).
ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
);

}  // namespace feelem::op2
