// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/visible.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

bool is_culled(const VisibleQuestion& question, std::size_t index) {
    const Cluster& cluster = question.clusters[index];
    glm::vec3 centre = cluster.centre;
    float radius = cluster.radius;
    const auto move = [&](std::span<const ClusterMove> moves, float factor) {
        if (moves.empty() || factor == 0) return;
        centre += factor * moves[index].middle;
        radius += std::abs(factor) * moves[index].radius;
    };
    move(question.moves, question.factor);
    move(question.moves_im, question.factor_im);
    return std::ranges::all_of(question.eyes, [&](const SeenFrom& eye) {
        return is_outside(eye, centre, radius) || (question.hides_backs && is_turned_away(eye, cluster));
    });
}

}  // namespace

PartLook look_of(std::span<const PartLook> parts, std::uint32_t part) {
    return part < parts.size() ? parts[part] : PartLook::Shown;
}

bool is_solid(const std::vector<bool>& solid, std::uint32_t part) {
    return part < solid.size() && solid[part];
}

Visible find_visible(const VisibleQuestion& question) {
    Visible out;
    for (std::size_t i = 0; i < question.clusters.size(); ++i) {
        const Cluster& cluster = question.clusters[i];
        if (look_of(question.parts, cluster.part) != question.wanted) continue;
        if (question.solid && !is_solid(*question.solid, cluster.part)) continue;
        ++out.clusters;
        if (question.is_culled && is_culled(question, i)) {
            ++out.culled;
            continue;
        }
        out.triangles += cluster.triangles;
        DrawCommand* last = out.commands.empty() ? nullptr : &out.commands.back();
        if (last && last->part == cluster.part && last->first + last->count == 3 * cluster.first)
            last->count += 3 * cluster.triangles;
        else
            out.commands.push_back(
                {3 * cluster.triangles, question.instances, 3 * cluster.first, 0, cluster.part}
            );
    }
    return out;
}

}  // namespace feelem::viewer
