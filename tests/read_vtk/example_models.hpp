// SPDX-License-Identifier: Apache-2.0
// The two models of tests/data/exchange once more: what its script wrote must come out of every format.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/model.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::test {

struct ExampleElement {
    ElementType type;
    std::string part;
    std::int64_t id;
    std::vector<std::size_t> nodes;  ///< Indexes of points.
};

struct Example {
    std::vector<Point3> points;
    std::vector<std::int64_t> node_ids;
    std::vector<ExampleElement> elements;
};

/// A brick and a wedge ("lower"), a pyramid, a tetrahedron and a plate ("upper"), joined.
Example stack_example();
/// An element of each type of second order, apart.
Example curved_example();

/// What a format keeps, and what its file holds.
struct Kept {
    bool node_ids = true;
    bool element_ids = true;
    bool one_node_a_point = true;  ///< Else each part has nodes of its own.
    enum class Parts {
        Named,
        OnePerType,
        None
    } parts = Parts::Named;
    std::vector<std::size_t> steps{0, 1};  ///< Of the script's two.
    bool times = true;
    bool missing_node = true;  ///< One temperature is missing at the second step.
    bool damage = true;
    bool stress = true;
    std::vector<ElementType> unread{};  ///< Types that the library leaves out.
};

/// Elements by their corners and middles, parts, sets aside; ids; all results at all steps, value by value.
void expect_example(ModelSource& model, const Example& example, const Kept& kept);

}  // namespace feelem::test
