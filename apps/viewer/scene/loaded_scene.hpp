// SPDX-License-Identifier: Apache-2.0
// A scene as the viewer keeps it: mapped from disk, geometry in memory, values of a result at a step read on
// demand.
#pragma once

#include "viewer/core/look.hpp"

#include "feelem/scene.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Where a part's vertices, triangles and edges stand in the arrays of Geometry.
struct PartRange {
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_triangle = 0, triangles = 0;
    std::uint32_t first_edge = 0, edges = 0;
};

/// All parts of the skin in one set of arrays.
struct Geometry {
    std::vector<PartRange> parts;
    std::vector<std::array<float, 3>> positions;          ///< Model units minus the scene's origin.
    std::vector<std::array<float, 3>> normals;            ///< Unit.
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Corners count over all parts.
    /// Element edges have places of their own, a little outside the skin so that they are not hidden in it.
    std::vector<std::array<float, 3>> edge_positions;
    std::vector<std::uint32_t> edge_vertices;  ///< Per edge position: the vertex whose displacement it takes.
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< Ends, into edge_positions.
    std::vector<std::int64_t> node_ids;               ///< Per vertex; 0: none.
    std::vector<std::int64_t> element_ids;            ///< Per triangle.
    std::array<float, 3> low{}, high{};               ///< Box of the positions.
};

/// Values of one result at one step on all vertices.
struct FieldValues {
    std::size_t components = 0;
    std::vector<float> values;       ///< vertices x components; NaN: missing.
    std::vector<Validity> validity;  ///< Per vertex.
};

/// Throws Error(BadScene, FileNotFound, ...). Not for use by several threads at once.
class LoadedScene {
public:
    /// `presentation_file`: instead of the scene's own; empty: that one.
    explicit LoadedScene(const std::string& path, const std::string& presentation_file = {});
    ~LoadedScene();
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;

    /// Titles, results, steps, units, presentation, levels; `parts` have names and kinds but no arrays.
    const Scene& about() const noexcept;
    const Geometry& geometry() const noexcept;
    /// Model units minus origin -> metres, +Y up, as the scene's root says it.
    const glm::mat4& to_metres() const noexcept;
    /// Read once, then kept.
    const FieldValues& values(std::size_t result, std::size_t values);
    /// Triangles of a reduced level, corners as Geometry::triangles. Read once, then kept.
    const std::vector<std::array<std::uint32_t, 3>>& level(std::size_t level);
    /// The result's component that a presentation names, at `step` (into about().steps). Empty: not there.
    std::optional<FieldChoice> find(const PresentedResult& wanted, std::size_t step) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
