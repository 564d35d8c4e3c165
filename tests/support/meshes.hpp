// SPDX-License-Identifier: Apache-2.0
// Tiny named meshes for tests.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <initializer_list>
#include <vector>

namespace feelem::test {

/// The reference element of a type as a one-element mesh: node ids 1.., element 1.
Mesh one_element(ElementType type);
/// nx x ny x nz unit bricks side by side, node ids from 1 with x fastest, one part.
Mesh brick_grid(int nx, int ny, int nz);

/// A mesh from lists: coordinates of nodes 1.., then elements (ids 1..) by 1-based node ids, all in part "p".
struct TinyElement {
    ElementType type;
    std::vector<int> nodes;
    const char* part = "p";
};
Mesh tiny_mesh(std::initializer_list<Point3> nodes, std::initializer_list<TinyElement> elements);
Mesh tiny_mesh(
    std::initializer_list<Point3> nodes, std::initializer_list<TinyElement> elements, Diagnostics& diagnostics
);

}  // namespace feelem::test
