// SPDX-License-Identifier: Apache-2.0
// What core wants of a scene: views of arrays that somebody else keeps, and a function that gives the values
// of a result at a step. LoadedScene can fill it; so can a test with three triangles.
#pragma once

#include "viewer/core/look.hpp"

#include "feelem/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace feelem::viewer {

/// Where a part's vertices and triangles stand in the arrays.
struct PartSpan {
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_triangle = 0, triangles = 0;
};

/// All parts in one set of arrays, as the scene's order of parts. The arrays must outlive whoever has this.
struct ModelArrays {
    std::vector<PartSpan> parts;
    std::span<const std::array<float, 3>> positions;          ///< Model units minus the scene's origin.
    std::span<const std::array<std::uint32_t, 3>> triangles;  ///< Corners count over all parts.
    std::span<const std::int64_t> node_ids;                   ///< Per vertex; 0: none.
    std::span<const std::int64_t> element_ids;                ///< Per triangle.
    std::array<float, 3> low{}, high{};                       ///< Box of the positions.
    glm::mat4 to_metres{1};                                   ///< Model units minus origin -> metres, +Y up.
};

/// Values of one result at one step on all vertices. Empty where there are none.
struct FieldSpan {
    std::size_t components = 0;
    std::span<const float> values;       ///< vertices x components; NaN: missing.
    std::span<const Validity> validity;  ///< Per vertex.
};

/// Called on the thread of the frames only; what it gave stays valid. May throw Error.
using FieldSource = std::function<FieldSpan(std::size_t result, std::size_t values)>;

struct ModelSource {
    const Scene* about = nullptr;  ///< As LoadedScene::about(): parts need names and kinds only.
    ModelArrays arrays;
    FieldSource values;
};

/// A source with what was once found out about it.
class ViewedModel {
public:
    explicit ViewedModel(ModelSource source);

    const Scene& about() const noexcept { return *source_.about; }
    const ModelArrays& arrays() const noexcept { return source_.arrays; }
    /// A result that cannot be read has no values: see problem().
    FieldSpan values(const FieldChoice& field) const;
    /// Why a result could not be read, for people; empty: all could.
    const std::string& problem() const noexcept { return problem_; }

    /// Smallest and largest value on the skin.
    std::optional<std::array<double, 2>> skin_range(const FieldChoice& field) const;
    /// Of a result with three components: the longest vector. 0 where there is none.
    double longest(const FieldChoice& field) const;
    /// Model units.
    double largest_side() const noexcept;
    double diagonal() const noexcept;
    /// A corner of a triangle at the node: 3 x triangle + 0, 1 or 2. Empty: it is not on the skin.
    std::optional<std::size_t> corner_of_node(std::int64_t node) const;
    std::uint32_t vertex_at(std::size_t corner) const { return arrays().triangles[corner / 3][corner % 3]; }
    /// The first triangle of the element; empty: none of its facets is on the skin.
    std::optional<std::size_t> triangle_of_element(std::int64_t element) const;
    std::size_t part_of_triangle(std::size_t triangle) const;
    /// Which part a vertex belongs to.
    std::size_t part_of_vertex(std::uint32_t vertex) const;

private:
    ModelSource source_;
    mutable std::map<std::array<std::size_t, 3>, std::optional<std::array<double, 2>>> ranges_;
    mutable std::map<std::array<std::size_t, 2>, double> longest_;
    mutable std::vector<std::pair<std::int64_t, std::size_t>> nodes_;  ///< Sorted; made when asked for.
    mutable std::string problem_;
};

}  // namespace feelem::viewer
