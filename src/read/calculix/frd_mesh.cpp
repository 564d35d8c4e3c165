// SPDX-License-Identifier: Apache-2.0
#include "read/calculix/frd_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/calculix/frd_elements.hpp"
#include "read/calculix/frd_nodes.hpp"

namespace feelem::frd {

Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics) {
    MeshBuilder builder(diagnostics);
    read_nodes(input, layout, builder, diagnostics);
    builder.seal_nodes();
    if (layout.has_elements) read_elements(input, layout, builder, diagnostics);
    return builder.finish();
}

}  // namespace feelem::frd
