// SPDX-License-Identifier: Apache-2.0
// A small model that the tests write and open: one tetrahedron with results.
#pragma once

#include "read_nastran_op2/op2_writer.hpp"

#include "feelem/model.hpp"
#include "feelem/read.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace feelem::test {

Op2Word whole(std::int64_t value);
/// A GRID of eight words.
Op2Words grid(std::int64_t id, double x, double y, double z, std::int64_t motion = 0);
/// A tetrahedron 7 of grids 1 to 4 with unit edges, property 3; grid 4 moves in cylindrical system 5.
void write_geometry(Op2Writer& writer, std::int64_t motion = 0);
/// A row of a nodal table: translations id + 0.1, 0.2, 0.3 times scale, rotations the same negated.
Op2Words row(std::int64_t id, double scale);
Op2Words rows(double scale);
/// Two halves of six numbers after the id.
Op2Words complex_row(std::int64_t id);
/// A point of a solid: xx yy zz are base + 1, 2, 3, shears base + 4, 5, 6, von Mises base + 7.
Op2Words solid_point(std::int64_t node, double base);
Op2Words solid_element(std::int64_t system);
std::unique_ptr<ModelSource> open(std::string bytes, Diagnostics& diagnostics);
std::vector<std::string> names_of(const ModelSource& model);
std::string static_file(Op2Form form);

}  // namespace feelem::test
