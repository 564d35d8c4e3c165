// SPDX-License-Identifier: Apache-2.0
// Must: never let a sample out of its bounds, keep the surface as connected as it is, and give the same
// result everywhere. Assumes: connect() and fill_samples(). Algorithm: half-edge collapse onto a neighbour;
// the lists of the triangles round the point hold all samples that they stand for, so each is tested against
// the new triangles themselves; points that changed are left alone until the next sweep; a point that was
// refused is remembered with the least error that refused it. One thread, in the order of the places. Data: 5
// bytes a place.
#include "lod/collapser.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

constexpr std::uint32_t kMostNewValence = 20;
constexpr std::size_t kMostTries = 3;
/// longest edge^2 / (2 area): worse triangles are made only where they were worse already.
constexpr float kWorstShape = 50;
constexpr float kShapeWeight = 0.01F;

float crossed2(float ax, float ay, float bx, float by) {
    return ax * by - ay * bx;
}

float shape(float ux, float uy, float vx, float vy, float twice_area) {
    const float wx = ux - vx, wy = uy - vy;
    return std::max({ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy}) / twice_area;
}

}  // namespace

Collapser::Collapser(Model& model, float least_cosine) : model_(model), fan_(model) {
    limits_.least_cosine = least_cosine;
    cost_.assign(model.place_count, 0);
    stamp_.assign(model.place_count, 0);
    triangles_ = model.faces.size();
    points_ = model.report.points;
}

std::uint64_t Collapser::sweep(float error, std::uint64_t target) {
    limits_.error = error;
    std::fill(stamp_.begin(), stamp_.end(), std::uint8_t{0});
    std::uint64_t gone = 0;
    for (std::uint32_t p = 0; p < model_.place_count && triangles_ > target; ++p) {
        const Role role = model_.role[p];
        if ((role != Role::Free && role != Role::Crease) || stamp_[p] != 0 || cost_[p] > error) continue;
        if (model_.out[p] == kNone) continue;
        if (visit(p)) ++gone;
    }
    points_ -= gone;
    return gone;
}

bool Collapser::visit(std::uint32_t place) {
    blocked_ = Fan::kRefused;
    const bool went = model_.role[place] == Role::Free ? visit_free(place) : visit_crease(place);
    if (!went) cost_[place] = blocked_;
    return went;
}

bool Collapser::visit_free(std::uint32_t place) {
    Patch& patch = patches_[0];
    if (!collect_closed(model_.out[place], patch) || !flatten(patch)) return false;
    choose(patch);
    bool is_gathered = false;
    for (std::size_t i = 0; i < std::min(choices_.size(), kMostTries); ++i) {
        const std::uint32_t from = choices_[i].corner;
        if (!fan_.build(patch, from)) continue;
        if (!is_gathered) {
            pending_.clear();
            gather(patch, patch.centre);
            is_gathered = true;
        }
        const float error = test(0, pending_.size());
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        if (!keeps_corners(patch, from) || !keeps_topology(place, 1, from)) continue;
        apply(patch, from, 0, pending_.size());
        finish(place, 1);
        return true;
    }
    return false;
}

bool Collapser::visit_crease(std::uint32_t place) {
    const std::uint32_t count = collect_open(model_.out[place]);
    if (count == 0) return false;
    CreasePoint& point = model_.creases[model_.crease[place]];
    for (std::uint32_t i = 0; i < count; ++i) {
        if (patches_[i].count < 2 || !flatten(patches_[i])) return false;
    }
    pending_.clear();
    std::array<std::size_t, 3> first{};
    for (std::uint32_t i = 0; i < count; ++i) {
        gather(patches_[i], i == 1 && point.alias != kNone ? point.alias : patches_[i].centre);
        first[i + 1] = pending_.size();
    }
    for (const bool to_last : {false, true}) {
        // Corner 0 of one patch is the last corner of the other.
        std::array<std::uint32_t, 2> from{};
        from[0] = to_last ? patches_[0].count : 0;
        from[1] = to_last ? 0 : patches_[1].count;
        const std::uint32_t target = model_.place[patches_[0].link[from[0]]];
        if (model_.role[target] == Role::Pinned) continue;
        float error = curve_error(point, patches_[0]);
        for (std::uint32_t i = 0; i < count && error <= limits_.error; ++i) {
            std::uint32_t over = 0;
            if (shape_of(patches_[i], from[i], over) < 0 || !fan_.build(patches_[i], from[i])) {
                error = Fan::kRefused;
            } else {
                error = std::max(error, test(first[i], first[i + 1]));
            }
        }
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        bool is_good = keeps_topology(place, count, from[0]);
        for (std::uint32_t i = 0; i < count; ++i) is_good = is_good && keeps_corners(patches_[i], from[i]);
        if (!is_good) continue;
        for (std::uint32_t i = 0; i < count; ++i) apply(patches_[i], from[i], first[i], first[i + 1]);
        join_curve(place, target);
        finish(place, count);
        return true;
    }
    return false;
}

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

/// Worst shape of the fan from a corner, -1 when a triangle is turned over or too thin; `over_centre`: the
/// triangle of the fan that lies over the centre, 0 when none does.
float Collapser::shape_of(const Patch& patch, std::uint32_t from, std::uint32_t& over_centre) const {
    const float pu = patch.u[from], pv = patch.v[from];
    over_centre = 0;
    float worst = 0;
    std::uint32_t k = from + 1 == patch.corners ? 0 : from + 1;
    float au = patch.u[k] - pu, av = patch.v[k] - pv;
    float side = crossed2(au, av, -pu, -pv);
    for (std::uint32_t m = 1; m + 1 < patch.corners; ++m) {
        k = k + 1 == patch.corners ? 0 : k + 1;
        const float bu = patch.u[k] - pu, bv = patch.v[k] - pv;
        const float area = crossed2(au, av, bu, bv);
        if (!(area > 0)) return -1;
        worst = std::max(worst, shape(au, av, bu, bv, area));
        const float next_side = crossed2(bu, bv, -pu, -pv);
        if (side >= 0 && next_side <= 0) over_centre = m;
        side = next_side;
        au = bu;
        av = bv;
    }
    if (worst <= kWorstShape) return worst;
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        const std::uint32_t j = i + 1 == patch.corners ? 0 : i + 1;
        const float area = crossed2(patch.u[i], patch.v[i], patch.u[j], patch.v[j]);
        if (!(area > 0) || shape(patch.u[i], patch.v[i], patch.u[j], patch.v[j], area) >= worst) return worst;
    }
    return -1;
}

/// Error of the centre on the triangle of the fan that lies over it, without the whole fan.
float Collapser::guess(const Patch& patch, std::uint32_t from, std::uint32_t m) const {
    const std::uint32_t i = (from + m) % patch.corners, j = (from + m + 1) % patch.corners;
    const float vx = patch.x[from], vy = patch.y[from], vz = patch.z[from];
    const float ax = patch.x[i] - vx, ay = patch.y[i] - vy, az = patch.z[i] - vz;
    const float bx = patch.x[j] - vx, by = patch.y[j] - vy, bz = patch.z[j] - vz;
    const float nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const float square = nx * nx + ny * ny + nz * nz;
    if (!(square > 0)) return Fan::kRefused;
    const float height = nx * vx + ny * vy + nz * vz;
    const Sample& c = model_.samples[patch.centre];
    float worst = std::abs(height) * c.inverse_distance / std::sqrt(square);
    if (worst > limits_.error) return worst;
    const float cx = vy * nz - vz * ny, cy = vz * nx - vx * nz, cz = vx * ny - vy * nx;
    const float b1 = (bx * cx + by * cy + bz * cz) / square;
    const float b2 = -(ax * cx + ay * cy + az * cz) / square;
    const std::size_t width = model_.field_count;
    const float* f = model_.values.data();
    const float *at = f + patch.centre * width, *v = f + patch.link[from] * width,
                *a = f + patch.link[i] * width, *b = f + patch.link[j] * width;
    const std::uint64_t missing =
        model_.missing.empty() ? 0 : model_.missing_in(model_.faces[patch.face[0]].vertex);
    for (std::size_t k = 0; k < width; ++k) {
        if (((missing >> (k % kMaskedFields)) & 1U) != 0) continue;
        worst = std::max(worst, std::abs(at[k] - v[k] - b1 * (a[k] - v[k]) - b2 * (b[k] - v[k])));
    }
    return worst;
}

void Collapser::choose(const Patch& patch) {
    choices_.clear();
    for (std::uint32_t from = 0; from < patch.corners; ++from) {
        if (model_.role[model_.place[patch.link[from]]] == Role::Pinned) continue;
        std::uint32_t over = 0;
        const float worst = shape_of(patch, from, over);
        if (worst < 0) continue;
        const float error = over == 0 ? 0 : guess(patch, from, over);
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        choices_.push_back({error + kShapeWeight * limits_.error * worst, error, from});
    }
    std::ranges::sort(choices_, [](const Choice& a, const Choice& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.corner < b.corner;
    });
}

void Collapser::gather(const Patch& patch, std::uint32_t own) {
    pending_.push_back(own);
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        for (std::uint32_t s = model_.faces[patch.face[i]].list; s != kNone; s = model_.samples[s].next)
            pending_.push_back(s);
    }
    if (where_.size() < pending_.size()) where_.resize(2 * pending_.size());
}

float Collapser::test(std::size_t first, std::size_t last) {
    float worst = 0;
    for (std::size_t i = first; i < last; ++i) {
        const float error = fan_.error_of(pending_[i], limits_, where_[i]);
        if (error > limits_.error) return error;
        worst = std::max(worst, error);
    }
    return worst;
}

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

void Collapser::finish(std::uint32_t place, std::uint32_t patches) {
    model_.role[place] = Role::Dead;
    for (std::uint32_t i = 0; i < patches; ++i) {
        for (std::uint32_t k = 0; k < patches_[i].corners; ++k) {
            const std::uint32_t p = model_.place[patches_[i].link[k]];
            stamp_[p] = 1;
            cost_[p] = 0;
        }
    }
}

}  // namespace feelem::lod
