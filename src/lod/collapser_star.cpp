// SPDX-License-Identifier: Apache-2.0
// The triangles round a point, and what may not happen to them: which collapses keep the surface connected as
// it is (link condition: Dey, Edelsbrunner, Guha & Nekhayev 1999).
#include "lod/collapser.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

constexpr std::uint32_t kMostNewValence = 20;

}  // namespace

bool Collapser::collect_closed(std::uint32_t start, Patch& patch) const {
    std::uint32_t n = 0;
    std::uint32_t edge = start;
    do {
        if (n == kMostValence) return false;
        const std::uint32_t f = face_of(edge), k = slot_of(edge);
        const Face& face = model_.faces[f];
        patch.face[n] = f;
        patch.slot[n] = static_cast<std::uint8_t>(k);
        patch.link[n] = face.vertex[kNext[k]];
        patch.centre = face.vertex[k];
        ++n;
        edge = face.twin[kPrevious[k]];
    } while (edge != start);
    patch.count = patch.corners = n;
    patch.is_closed = true;
    return n >= 3;
}

/// The one or two patches of a crease point; 0 when they are too large.
std::uint32_t Collapser::collect_open(std::uint32_t start) {
    const auto is_feature = [&](std::uint32_t edge) {
        return ((unsigned{model_.faces[face_of(edge)].features} >> slot_of(edge)) & 1U) != 0;
    };
    // Back to a half-edge where a patch begins: one on a border, when there is any.
    std::uint32_t edge = start, feature = kNone;
    for (std::uint32_t turns = 0;; ++turns) {
        if (turns == 2 * kMostValence) return 0;
        if (is_feature(edge)) feature = edge;
        const std::uint32_t twin = model_.faces[face_of(edge)].twin[slot_of(edge)];
        if (twin == kNone) break;
        edge = half_edge(face_of(twin), kNext[slot_of(twin)]);
        if (edge == start) {
            edge = feature;
            break;
        }
    }
    if (edge == kNone || !is_feature(edge)) return 0;
    const std::uint32_t begin = edge;
    std::uint32_t count = 0;
    do {
        if (count == 2) return 0;
        Patch& patch = patches_[count++];
        patch.is_closed = false;
        std::uint32_t n = 0;
        do {
            if (n == kMostValence) return 0;
            const std::uint32_t f = face_of(edge), k = slot_of(edge);
            const Face& face = model_.faces[f];
            patch.face[n] = f;
            patch.slot[n] = static_cast<std::uint8_t>(k);
            patch.link[n] = face.vertex[kNext[k]];
            patch.link[n + 1] = face.vertex[kPrevious[k]];
            patch.centre = face.vertex[k];
            ++n;
            edge = face.twin[kPrevious[k]];
        } while (edge != kNone && !is_feature(edge));
        patch.count = n;
        patch.corners = n + 1;
    } while (edge != kNone && edge != begin);
    return count;
}

/// Corners from the centre, in the plane of the mean normal.
bool Collapser::flatten(Patch& patch) const {
    const Sample& c = model_.samples[patch.centre];
    for (std::uint32_t i = 0; i < patch.corners; ++i) {
        const Sample& s = model_.samples[patch.link[i]];
        patch.x[i] = s.x - c.x;
        patch.y[i] = s.y - c.y;
        patch.z[i] = s.z - c.z;
    }
    float nx = 0, ny = 0, nz = 0;
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        const std::uint32_t k = i + 1 == patch.corners ? 0 : i + 1;
        nx += patch.y[i] * patch.z[k] - patch.z[i] * patch.y[k];
        ny += patch.z[i] * patch.x[k] - patch.x[i] * patch.z[k];
        nz += patch.x[i] * patch.y[k] - patch.y[i] * patch.x[k];
    }
    const float length = std::sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0)) return false;
    nx /= length;
    ny /= length;
    nz /= length;
    patch.nx = nx;
    patch.ny = ny;
    patch.nz = nz;
    // Two unit vectors across the normal (Duff et al. 2017).
    const float sign = nz < 0 ? -1.0F : 1.0F;
    const float a = -1 / (sign + nz), b = nx * ny * a;
    const float tx = 1 + sign * nx * nx * a, ty = sign * b, tz = -sign * nx;
    const float sx = b, sy = sign + ny * ny * a, sz = -ny;
    for (std::uint32_t i = 0; i < patch.corners; ++i) {
        patch.u[i] = patch.x[i] * tx + patch.y[i] * ty + patch.z[i] * tz;
        patch.v[i] = patch.x[i] * sx + patch.y[i] * sy + patch.z[i] * sz;
    }
    return true;
}

/// The two points have no neighbour in common but the corners of the triangles between them (link condition),
/// and the one that stays gets no more triangles than fit.
bool Collapser::keeps_topology(std::uint32_t place, std::uint32_t patches, std::uint32_t corner0) const {
    std::array<std::uint32_t, 2 * kMostValence + 2> ring;
    std::uint32_t ring_count = 0;
    std::uint32_t on_edge = 0, valence = 0;
    const std::uint32_t target = model_.place[patches_[0].link[corner0]];
    for (std::uint32_t i = 0; i < patches; ++i) {
        const Patch& patch = patches_[i];
        valence += patch.count;
        for (std::uint32_t k = 0; k < patch.corners; ++k) ring[ring_count++] = model_.place[patch.link[k]];
        on_edge += patch.is_closed ? 2 : 1;
    }
    const auto is_common = [&](std::uint32_t vertex) {
        const std::uint32_t p = model_.place[vertex];
        if (p == target || p == place) return false;
        return std::find(ring.begin(), ring.begin() + ring_count, p) != ring.begin() + ring_count;
    };
    // Turn round the target, from the collapsing edge, both ways when it is on a border.
    const Patch& patch = patches_[0];
    const bool is_first = corner0 < patch.count;
    const std::uint32_t f = patch.face[is_first ? corner0 : corner0 - 1];
    const std::uint32_t k = patch.slot[is_first ? corner0 : corner0 - 1];
    const std::uint32_t start = half_edge(f, is_first ? kNext[k] : kPrevious[k]);
    std::uint32_t common = 0, others = 0;
    std::uint32_t edge = start;
    do {
        const Face& face = model_.faces[face_of(edge)];
        const std::uint32_t slot = slot_of(edge);
        if (is_common(face.vertex[kNext[slot]])) ++common;
        if (++others > 2 * kMostValence) return false;
        edge = face.twin[kPrevious[slot]];
        // The last neighbour at a border begins no half-edge here.
        if (edge == kNone && is_common(face.vertex[kPrevious[slot]])) ++common;
    } while (edge != kNone && edge != start);
    if (edge == kNone) {
        for (edge = start;;) {
            const std::uint32_t twin = model_.faces[face_of(edge)].twin[slot_of(edge)];
            if (twin == kNone) break;
            edge = half_edge(face_of(twin), kNext[slot_of(twin)]);
            if (is_common(model_.faces[face_of(edge)].vertex[kNext[slot_of(edge)]])) ++common;
            if (++others > 2 * kMostValence) return false;
        }
    }
    return common == on_edge && valence + others <= std::max(kMostNewValence, others) + 2 * on_edge;
}

/// No third corner of a dying triangle is left with two triangles.
bool Collapser::keeps_corners(const Patch& patch, std::uint32_t from) const {
    const auto is_left_alone = [&](std::uint32_t dying, std::uint32_t survivor) {
        const Face& d = model_.faces[patch.face[dying]];
        const Face& s = model_.faces[patch.face[survivor]];
        const std::uint32_t beyond = d.twin[kNext[patch.slot[dying]]];
        const std::uint32_t after = s.twin[kNext[patch.slot[survivor]]];
        return beyond != kNone && after != kNone && face_of(beyond) == face_of(after);
    };
    const std::uint32_t n = patch.count;
    if (from < n && is_left_alone(from, (from + 1) % n)) return false;
    return !((patch.is_closed || from > 0) && is_left_alone((from + n - 1) % n, (from + 2 * n - 2) % n));
}

}  // namespace feelem::lod
