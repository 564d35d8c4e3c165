// SPDX-License-Identifier: Apache-2.0
// A point goes: its triangles are joined to their new neighbours, lists and lines are handed on.
#include "lod/collapser.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {

/// How far the point, and those that its two lines stand for, would be from the line that replaces both.
float Collapser::curve_error(const CreasePoint& point, const Patch& patch) const {
    const Sample& a = model_.samples[patch.link[0]];
    const Sample& b = model_.samples[patch.link[patch.corners - 1]];
    const float dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
    const float length = dx * dx + dy * dy + dz * dz;
    if (!(length > 0)) return Fan::kRefused;
    const float inverse = 1 / length;
    const auto error_of = [&](std::uint32_t vertex) {
        const Sample& s = model_.samples[vertex];
        const float x = s.x - a.x, y = s.y - a.y, z = s.z - a.z;
        const float share = std::clamp((x * dx + y * dy + z * dz) * inverse, 0.0F, 1.0F);
        const float ex = x - share * dx, ey = y - share * dy, ez = z - share * dz;
        return std::sqrt(ex * ex + ey * ey + ez * ez) * s.inverse_distance;
    };
    float worst = error_of(point.vertex);
    for (const std::uint32_t head : point.head) {
        for (std::uint32_t c = head; c != kNone && worst <= limits_.error; c = model_.creases[c].next)
            worst = std::max(worst, error_of(model_.creases[c].vertex));
    }
    return worst;
}

void Collapser::apply(const Patch& patch, std::uint32_t from, std::size_t first, std::size_t last) {
    const std::uint32_t n = patch.count;
    const std::uint32_t kept = patch.link[from];
    // Edge `slot` of the survivor takes over what lies beyond the dying triangle.
    const auto close = [&](std::uint32_t dying, std::uint32_t survivor, std::uint32_t slot) {
        Face& d = model_.faces[patch.face[dying]];
        Face& s = model_.faces[patch.face[survivor]];
        const std::uint32_t outer = kNext[patch.slot[dying]];
        const std::uint32_t beyond = d.twin[outer];
        s.twin[slot] = beyond;
        s.features = static_cast<std::uint8_t>(
            (s.features & ~(1U << slot)) | (((static_cast<unsigned>(d.features) >> outer) & 1U) << slot)
        );
        if (beyond != kNone)
            model_.faces[face_of(beyond)].twin[slot_of(beyond)] = half_edge(patch.face[survivor], slot);
        d.is_dead = true;
        --triangles_;
    };
    const bool has_right = from < n, has_left = patch.is_closed || from > 0;
    const std::uint32_t right = (from + 1) % n, left = (from + 2 * n - 2) % n;
    if (has_right) close(from, right, patch.slot[right]);
    if (has_left) close((from + n - 1) % n, left, kPrevious[patch.slot[left]]);
    for (std::uint32_t i = 0; i < n; ++i) {
        Face& face = model_.faces[patch.face[i]];
        face.list = kNone;
        if (!face.is_dead) face.vertex[patch.slot[i]] = kept;
    }
    const std::uint32_t any = has_right ? right : left;
    model_.out[model_.place[kept]] = half_edge(patch.face[any], patch.slot[any]);
    if (has_right) {
        const std::uint32_t edge = half_edge(patch.face[right], kNext[patch.slot[right]]);
        model_.out[model_.place[model_.faces[face_of(edge)].vertex[slot_of(edge)]]] = edge;
    }
    if (has_left) {
        const std::uint32_t edge = half_edge(patch.face[left], kPrevious[patch.slot[left]]);
        model_.out[model_.place[model_.faces[face_of(edge)].vertex[slot_of(edge)]]] = edge;
    }
    for (std::size_t i = first; i < last; ++i) {
        Face& face = model_.faces[patch.face[(from + 1 + where_[i]) % patch.corners]];
        model_.samples[pending_[i]].next = face.list;
        face.list = pending_[i];
    }
}

/// One line for two: it stands for the point and for all that they stood for.
void Collapser::join_curve(std::uint32_t place, std::uint32_t target) {
    const std::uint32_t self = model_.crease[place];
    CreasePoint& point = model_.creases[self];
    const std::size_t toward = point.neighbour[0] == target ? 0 : 1;
    const std::uint32_t other = point.neighbour[1 - toward];
    std::uint32_t head = self;
    point.next = kNone;
    for (const std::uint32_t list : point.head) {
        for (std::uint32_t c = list; c != kNone;) {
            const std::uint32_t next = model_.creases[c].next;
            model_.creases[c].next = head;
            head = c;
            c = next;
        }
    }
    const auto relink = [&](std::uint32_t end, std::uint32_t new_neighbour) {
        const std::uint32_t c = model_.crease[end];
        if (c == kNone) return;
        CreasePoint& at = model_.creases[c];
        const std::size_t i = at.neighbour[0] == place ? 0 : 1;
        at.neighbour[i] = new_neighbour;
        at.head[i] = head;
    };
    relink(target, other);
    relink(other, target);
    if (model_.crease[target] == kNone && model_.crease[other] == kNone)
        model_.closed_lines.push_back({head, {target, other}});
}

}  // namespace feelem::lod
