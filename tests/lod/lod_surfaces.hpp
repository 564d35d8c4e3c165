// SPDX-License-Identifier: Apache-2.0
// Surfaces with results for the levels of detail, and what must hold for any level of any of them.
#pragma once

#include "lod_models.hpp"

#include "feelem/lod.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem::test {

using bench::LodModel;
using bench::wavy_sheet;

/// A plate of `thickness` with `side` x `side` quads on both large faces, sharp edges, another field in front
/// than behind; every flat face has vertices of its own.
LodModel thin_plate(std::uint32_t side, double thickness);
/// A closed tube with caps: `round` quads round, `along` along; the caps meet the wall at a right angle.
/// With `split`, wall and caps have vertices of their own there, as the skin has them.
LodModel capped_tube(std::uint32_t round, std::uint32_t along, bool split);
/// A flat ring, its inner border a circle of `round` vertices.
LodModel flat_ring(std::uint32_t round, std::uint32_t rings);
/// Two sheets of two parts that meet at x = 0.5; the second field jumps there.
LodModel two_parts(std::uint32_t side);
/// Sheets that meet at one edge: three wings.
LodModel three_wings(std::uint32_t side);

/// Fields with bounds as this share of their ranges.
std::vector<LodField> bounded(const LodModel& model, double share);

/// Vertices of the maxima (sign 1) or minima (-1) whose persistence is above the threshold, the slow and
/// simple way: all vertices sorted, components joined edge by edge.
std::vector<std::uint32_t> lasting_extremes(
    std::span<const float> values,
    std::span<const std::array<VertexIndex, 3>> triangles,
    double threshold,
    float sign
);

/// Edges of the triangles by place, with how often each runs each way: (low, high) -> (up, down).
struct EdgeUse {
    std::uint64_t edges = 0, borders = 0, non_manifold = 0;
};
EdgeUse edge_use(const LodSurface& surface, std::span<const std::array<VertexIndex, 3>> triangles);

/// Fails the running test when a level breaks what its certificate says, whether by its lists or by the
/// independent checker; loses an extreme; tears the surface; or names a witness that does not exist.
void expect_sound(
    const LodSurface& surface,
    std::span<const LodField> fields,
    const LodResult& result,
    const LodOptions& options
);

}  // namespace feelem::test
