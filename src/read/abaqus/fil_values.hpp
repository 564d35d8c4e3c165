// SPDX-License-Identifier: Apache-2.0
// The records of one result -> values in the order of the mesh.
#pragma once

#include "read/abaqus/fil_contents.hpp"
#include "read/element_lookup.hpp"

namespace feelem::fil {

struct LoadedValues {
    Result result;
    std::uint64_t without_place = 0;   ///< Records whose node or element the mesh does not have.
    std::uint64_t without_number = 0;  ///< NaN or infinity.
};
LoadedValues load_values(
    const Input& input, Coding coding, const Listed& listed, const Mesh& mesh, const ElementLookup& elements
);

}  // namespace feelem::fil
