// SPDX-License-Identifier: Apache-2.0
// Results onto the vertices of the skin: bit for bit where a node has a value.
#include "base/parallel.hpp"
#include "skin/result_rows.hpp"

#include "feelem/skin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace feelem {
namespace {

class Carrier {
public:
    Carrier(const Mesh& mesh, const Surface& surface, const Result& result)
        : mesh_(mesh), surface_(surface), result_(result), rows_(result, mesh.node_count()),
          width_(result.component_count()) {
        field_.component_count = static_cast<std::uint32_t>(width_);
        const float missing = std::numeric_limits<float>::quiet_NaN();
        field_.values.assign(surface.positions.size() * width_, missing);
        field_.validity.assign(surface.positions.size(), Validity::Missing);
    }

    SurfaceField run() {
        for (const SurfacePart& part : surface_.parts) {
            parallel_chunks(part.vertex_count, kParallelChunk, [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) copy(part.first_vertex + i, place(part, i));
            });
        }
        if (result_.info.corner_only) fill_middles();
        for (const Blend& blend : surface_.blends) mix(blend);
        for (std::size_t v = 0; v < field_.validity.size(); ++v) {
            if (surface_.vertex_node[v] == kNoNode) continue;
            if (field_.validity[v] == Validity::Missing) ++field_.missing;
            if (field_.validity[v] == Validity::Interpolated) ++field_.interpolated;
        }
        return std::move(field_);
    }

private:
    ResultPlace place(const SurfacePart& part, std::size_t i) const {
        const std::size_t vertex = part.first_vertex + i;
        return {part.part, surface_.vertex_element.empty() ? kNoElement : surface_.vertex_element[vertex]};
    }

    void copy(std::size_t vertex, ResultPlace place) {
        const NodeIndex node = surface_.vertex_node[vertex];
        if (node == kNoNode) return;
        const std::size_t row = rows_.find(node, place);
        if (row == kNoRow) return;
        bool is_whole = true;
        for (std::size_t c = 0; c < width_; ++c) {
            const float value = result_.values[row * width_ + c];
            field_.values[vertex * width_ + c] = value;
            is_whole = is_whole && !std::isnan(value);
        }
        if (is_whole) field_.validity[vertex] = Validity::Solver;
    }

    /// Per node: the corners of the edge that it is the middle of, from the elements of the surface.
    std::vector<std::array<NodeIndex, 2>> corners_of_middles() const {
        std::vector<std::array<NodeIndex, 2>> corners(mesh_.node_count(), {kNoNode, kNoNode});
        ElementIndex last = kNoElement;
        for (const ElementIndex element : surface_.triangle_element) {
            if (element == last) continue;
            last = element;
            const ElementRef ref = element_at(mesh_, element);
            const auto nodes = ref.nodes();
            for (const EdgeRow& edge : edges_of(ref.block->type)) {
                if (edge.middle == kNoLocalNode || nodes[edge.middle] == kNoNode) continue;
                corners[raw(nodes[edge.middle])] = {nodes[edge.first], nodes[edge.second]};
            }
        }
        return corners;
    }

    void fill_middles() {
        const auto corners = corners_of_middles();
        for (const SurfacePart& part : surface_.parts) {
            for (std::size_t i = 0; i < part.vertex_count; ++i) {
                const std::size_t vertex = part.first_vertex + i;
                const NodeIndex node = surface_.vertex_node[vertex];
                if (node == kNoNode || field_.validity[vertex] != Validity::Missing) continue;
                const auto [a, b] = corners[raw(node)];
                if (a != kNoNode) fill(vertex, rows_.find(a, place(part, i)), rows_.find(b, place(part, i)));
            }
        }
    }

    void fill(std::size_t vertex, std::size_t row_a, std::size_t row_b) {
        if (row_a == kNoRow || row_b == kNoRow) return;
        bool is_whole = true;
        for (std::size_t c = 0; c < width_; ++c) {
            float& value = field_.values[vertex * width_ + c];
            if (!std::isnan(value)) continue;
            value = middle_value(result_.values[row_a * width_ + c], result_.values[row_b * width_ + c]);
            is_whole = is_whole && !std::isnan(value);
        }
        if (is_whole) field_.validity[vertex] = Validity::Interpolated;
    }

    void mix(const Blend& blend) {
        const std::size_t vertex = raw(blend.vertex);
        bool is_whole = true;
        for (std::uint32_t i = blend.first; i < blend.first + blend.count; ++i)
            is_whole = is_whole && field_.validity[raw(surface_.blend_sources[i])] != Validity::Missing;
        for (std::size_t c = 0; c < width_; ++c) {
            double sum = 0;
            for (std::uint32_t i = blend.first; i < blend.first + blend.count; ++i) {
                const std::size_t source = raw(surface_.blend_sources[i]);
                sum += surface_.blend_weights[i] * static_cast<double>(field_.values[source * width_ + c]);
            }
            field_.values[vertex * width_ + c] = static_cast<float>(sum);
        }
        if (is_whole) field_.validity[vertex] = Validity::Interpolated;
    }

    const Mesh& mesh_;
    const Surface& surface_;
    const Result& result_;
    ResultRows rows_;
    std::size_t width_;
    SurfaceField field_;
};

}  // namespace

SurfaceField carry(const Mesh& mesh, const Surface& surface, const Result& result) {
    return Carrier(mesh, surface, result).run();
}

}  // namespace feelem
