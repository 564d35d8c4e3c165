// SPDX-License-Identifier: Apache-2.0
#include "support/meshes.hpp"

#include "model/mesh_builder.hpp"

namespace feelem::test {
namespace {

std::string nowhere() {
    return "test";
}

}  // namespace

Mesh one_element(ElementType type) {
    Diagnostics diagnostics;
    MeshBuilder builder(diagnostics);
    const ElementRow& row = element_row(type);
    std::vector<NodeId> ids;
    for (std::size_t i = 0; i < row.node_count; ++i) {
        ids.push_back(NodeId{static_cast<std::int64_t>(i) + 1});
        builder.add_node(ids.back(), {row.reference[i][0], row.reference[i][1], row.reference[i][2]});
    }
    builder.seal_nodes();
    builder.add_element(ElementId{1}, type, ids, builder.part("p"), nowhere);
    return builder.finish();
}

Mesh brick_grid(int nx, int ny, int nz) {
    Diagnostics diagnostics;
    MeshBuilder builder(diagnostics);
    const auto id = [&](int x, int y, int z) { return NodeId{1 + x + (nx + 1) * (y + (ny + 1) * z)}; };
    for (int z = 0; z <= nz; ++z) {
        for (int y = 0; y <= ny; ++y) {
            for (int x = 0; x <= nx; ++x) builder.add_node(id(x, y, z), {double(x), double(y), double(z)});
        }
    }
    builder.seal_nodes();
    const PartIndex part = builder.part("p");
    std::int64_t element = 0;
    for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const NodeId nodes[]{
                    id(x, y, z),
                    id(x + 1, y, z),
                    id(x + 1, y + 1, z),
                    id(x, y + 1, z),
                    id(x, y, z + 1),
                    id(x + 1, y, z + 1),
                    id(x + 1, y + 1, z + 1),
                    id(x, y + 1, z + 1)};
                builder.add_element(ElementId{++element}, ElementType::Hex8, nodes, part, nowhere);
            }
        }
    }
    return builder.finish();
}

Mesh tiny_mesh(std::initializer_list<Point3> nodes, std::initializer_list<TinyElement> elements) {
    Diagnostics diagnostics;
    return tiny_mesh(nodes, elements, diagnostics);
}

Mesh tiny_mesh(
    std::initializer_list<Point3> nodes, std::initializer_list<TinyElement> elements, Diagnostics& diagnostics
) {
    MeshBuilder builder(diagnostics);
    std::int64_t id = 0;
    for (const Point3& node : nodes) builder.add_node(NodeId{++id}, node);
    builder.seal_nodes();
    id = 0;
    for (const TinyElement& element : elements) {
        std::vector<NodeId> ids;
        for (const int node : element.nodes) ids.push_back(NodeId{node});
        builder.add_element(ElementId{++id}, element.type, ids, builder.part(element.part), nowhere);
    }
    return builder.finish();
}

}  // namespace feelem::test
