// SPDX-License-Identifier: Apache-2.0
// Which rows of an element's record are the wanted surface, and along which axes they stand. Rows are the
// corner nodes, once a surface: each layer of a layered element has a bottom and a top (and a middle).
#pragma once

#include "model/rotation.hpp"
#include "read/ansys/rst_mesh.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace feelem::rst {

/// Where the wanted row of each corner is, and in which layer it lies.
struct RowPlan {
    std::size_t layers = 1;  ///< That have rows of their own; 1 also when only outer surfaces are stored.
    struct Corner {
        std::size_t row = 0;
        bool in_last_layer = false;  ///< Else it lies in the first.
    };
    std::vector<Corner> corners;
};

/// The rows of a shell's surface; without corners where it has no such surface. Empty when the order of its
/// surfaces, or their number, is not known.
std::optional<RowPlan> plan_shell(const ElementKindOfFile& kind, std::size_t rows, Layer layer);

/// The rows of a solid: once its corners, or once a layer (then the outer surfaces of the outer layers).
std::optional<RowPlan> plan_solid(const ElementKindOfFile& kind, std::size_t rows);

/// Axes of an element's corners and layers out of its Euler angles, and one angle a layer about its normal.
class ElementAxes {
public:
    /// `corners` with repeats: a wedge may have angles of its six nodes, or of all eight places.
    /// False when the angles are as many as nothing that is known has. `angles` must stay alive.
    bool read(std::span<const double> angles, std::span<const NodeIndex> corners, std::size_t layers);

    bool is_global() const noexcept { return is_global_; }
    Matrix3 axes(std::size_t corner, bool in_last_layer) const;

private:
    std::size_t distinct() const;

    std::span<const double> angles_;
    std::vector<std::size_t> rows_;  ///< Of the angles, for each corner.
    std::size_t layers_first_ = 0;   ///< Where the angles of layers begin; 0: there are none.
    bool is_global_ = true;
};

}  // namespace feelem::rst
