// SPDX-License-Identifier: Apache-2.0
// What must hold for every file that another program wrote: node orders by geometry, and the boiler in other
// formats against our own .frd of it.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/model.hpp"

#include <string>

namespace feelem::test {

/// Empty when every solid has a positive volume (of its corners) and every mid-side node is nearer to the
/// middle of its own edge than to that of any other; else the first element where it is not so.
/// `mirrored`: of a file whose own elements are mirrored, the edges alone.
std::string wrong_node_order(const Mesh& mesh, bool mirrored = false);

enum class Boiler {
    Linear,    ///< examples/boiler/hex_linear: 1,248 hex8 and 24 wedge6, 2,568 facets on the skin.
    Quadratic  ///< examples/boiler/small: 3,809 tet10, 2,576 facets on the skin.
};
/// The model is that boiler: nodes and elements by id, skin closed, area and volume to 1e-5.
void expect_boiler_mesh(const Mesh& mesh, Boiler boiler);
/// Its temperatures and displacements are those of the .frd, node by node and bit by bit.
void expect_boiler_results(ModelSource& model, Boiler boiler);

}  // namespace feelem::test
