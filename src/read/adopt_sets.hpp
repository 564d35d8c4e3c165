// SPDX-License-Identifier: Apache-2.0
// Named sets (components) of a mesh that is not shown, carried over to the one that is.
#pragma once

#include "read/mesh_agreement.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <string>

namespace feelem {

/// Sets of names that `shown` does not have, upper and lower case being one, by the ids of their members;
/// `map` is null when both meshes have the same indexes. Members that are not in the mesh shown, and sets
/// that hold other members under the same name (that of the mesh shown stays), are told (SourcesDisagree).
/// `name`: of the input that `other` comes from.
void adopt_sets(
    const Mesh& other, const MeshMap* map, const std::string& name, Mesh& shown, Diagnostics& diagnostics
);

/// Sets of `own` that `shared`, the same mesh in all else, does not have. False, and nothing is changed, when
/// sets of one name hold other members.
bool share_sets(const Mesh& own, Mesh& shared);

}  // namespace feelem
