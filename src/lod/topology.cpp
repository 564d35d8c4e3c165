// SPDX-License-Identifier: Apache-2.0
// Must: find which triangles are neighbours, and which points may go, along what. Assumes: places and missing
// values are known. Algorithm: half-edges in buckets of the place where they begin; an edge with one triangle
// each way is inner, with one triangle a border, all else is left alone with both its ends. Points where the
// triangles are no single fan are left alone as well. Data: 28 bytes a triangle while it runs.
#include "lod/lod_mesh.hpp"

#include "feelem/error.hpp"

#include <cmath>
#include <numeric>

namespace feelem::lod {
namespace {

constexpr float kSmooth = 0.8F;                  ///< Cosine: triangles that meet at more are a crease.
constexpr double kStraight = 0.8;                ///< Cosine: a crease that turns more has a corner there.
constexpr std::uint64_t kMostFaces = 1U << 30U;  ///< Half-edges are 4 * face + slot in 32 bits.

struct Outgoing {
    std::uint32_t end;
    std::uint32_t edge;
};

/// The half-edges of each place: those of place p are [first[p], first[p + 1]).
struct Buckets {
    std::vector<std::uint32_t> first;
    std::vector<Outgoing> edges;

    std::span<const Outgoing> of(std::uint32_t place) const {
        return std::span(edges).subspan(first[place], first[place + 1] - first[place]);
    }
};

Buckets bucket_edges(const Model& model) {
    Buckets buckets;
    buckets.first.assign(model.place_count + std::size_t{2}, 0);
    for (const Face& face : model.faces) {
        for (const std::uint32_t v : face.vertex) ++buckets.first[model.place[v] + std::size_t{2}];
    }
    std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
    buckets.edges.resize(model.faces.size() * 3);
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        const auto& v = model.faces[f].vertex;
        const std::array<std::uint32_t, 3> at{model.place[v[0]], model.place[v[1]], model.place[v[2]]};
        for (std::uint32_t k = 0; k < 3; ++k)
            buckets.edges[buckets.first[at[k] + std::size_t{1}]++] = {at[kNext[k]], half_edge(f, k)};
    }
    buckets.first.pop_back();
    return buckets;
}

struct Matches {
    std::size_t count = 0;
    std::uint32_t edge = kNone;
};

Matches edges_to(std::span<const Outgoing> from, std::uint32_t end) {
    Matches found;
    for (const Outgoing& out : from) {
        if (out.end != end) continue;
        ++found.count;
        found.edge = out.edge;
    }
    return found;
}

void pair_edges(const Buckets& buckets, Model& model) {
    const auto twin_of = [&](std::uint32_t edge) -> std::uint32_t& {
        return model.faces[face_of(edge)].twin[slot_of(edge)];
    };
    for (std::uint32_t a = 0; a < model.place_count; ++a) {
        const auto from_a = buckets.of(a);
        for (const Outgoing& out : from_a) {
            const std::uint32_t b = out.end;
            if (b < a && twin_of(out.edge) != kNone) continue;
            const std::size_t same = edges_to(from_a, b).count;
            const Matches back = edges_to(buckets.of(b), a);
            if (same == 1 && back.count == 1) {
                twin_of(out.edge) = back.edge;
                twin_of(back.edge) = out.edge;
            } else if (same + back.count > 1) {
                model.role[a] = Role::Pinned;
                model.role[b] = Role::Pinned;
            }
        }
    }
}

bool is_feature(const Model& model, std::span<const std::array<float, 3>> normals, std::uint32_t edge) {
    const Face& face = model.faces[face_of(edge)];
    const std::uint32_t slot = slot_of(edge);
    const std::uint32_t twin = face.twin[slot];
    if (twin == kNone) return true;
    const Face& other = model.faces[face_of(twin)];
    const std::uint32_t other_slot = slot_of(twin);
    if (face.vertex[slot] != other.vertex[kNext[other_slot]]) return true;
    if (face.vertex[kNext[slot]] != other.vertex[other_slot]) return true;
    if (!model.missing.empty() && model.missing_in(face.vertex) != model.missing_in(other.vertex))
        return true;
    const auto& n = normals[face_of(edge)];
    const auto& m = normals[face_of(twin)];
    // A triangle without area has no side.
    if ((n[0] == 0 && n[1] == 0 && n[2] == 0) || (m[0] == 0 && m[1] == 0 && m[2] == 0)) return false;
    return n[0] * m[0] + n[1] * m[1] + n[2] * m[2] < kSmooth;
}

/// Counts the feature edges of each place; notes the first two neighbours along them.
struct FeatureEnds {
    std::vector<std::uint8_t> count;
    std::vector<std::uint32_t> first, second;  ///< Vertices.

    void add(std::uint32_t place, std::uint32_t vertex) {
        if (count[place] == 0) first[place] = vertex;
        if (count[place] == 1) second[place] = vertex;
        if (count[place] < 3) ++count[place];
    }
};

FeatureEnds mark_features(Model& model, std::span<const std::array<float, 3>> normals) {
    FeatureEnds ends;
    ends.count.assign(model.place_count, 0);
    ends.first.assign(model.place_count, kNone);
    ends.second.assign(model.place_count, kNone);
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        Face& face = model.faces[f];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t edge = half_edge(f, k);
            const std::uint32_t twin = face.twin[k];
            const bool is = twin != kNone && twin < edge
                                ? ((unsigned{model.faces[face_of(twin)].features} >> slot_of(twin)) & 1U) != 0
                                : is_feature(model, normals, edge);
            if (!is) continue;
            face.features = static_cast<std::uint8_t>(face.features | (1U << k));
            const std::uint32_t from = face.vertex[k], to = face.vertex[kNext[k]];
            ends.add(model.place[from], to);
            if (twin == kNone) ends.add(model.place[to], from);
        }
    }
    return ends;
}

/// True when turning round the place from one half-edge passes all of them.
bool is_one_fan(const Model& model, std::uint32_t start, std::size_t count) {
    std::size_t seen = 0;
    std::uint32_t edge = start;
    do {
        ++seen;
        edge = model.faces[face_of(edge)].twin[kPrevious[slot_of(edge)]];
    } while (edge != kNone && edge != start && seen <= count);
    if (edge == start) return seen == count;
    for (edge = start; seen <= count; ++seen) {
        const std::uint32_t twin = model.faces[face_of(edge)].twin[slot_of(edge)];
        if (twin == kNone) break;
        edge = half_edge(face_of(twin), kNext[slot_of(twin)]);
    }
    return seen == count;
}

bool runs_on(const Model& model, std::uint32_t vertex, std::uint32_t before, std::uint32_t after) {
    const Sample& u = model.samples[vertex];
    const Sample& a = model.samples[before];
    const Sample& b = model.samples[after];
    const double x = double{u.x} - double{a.x}, y = double{u.y} - double{a.y}, z = double{u.z} - double{a.z};
    const double s = double{b.x} - double{u.x}, t = double{b.y} - double{u.y}, w = double{b.z} - double{u.z};
    const double lengths = std::sqrt((x * x + y * y + z * z) * (s * s + t * t + w * w));
    return lengths > 0 && x * s + y * t + z * w > kStraight * lengths;
}

void give_roles(const Buckets& buckets, const FeatureEnds& ends, Model& model) {
    for (std::uint32_t p = 0; p < model.place_count; ++p) {
        const auto from = buckets.of(p);
        if (from.empty()) continue;
        ++model.report.points;
        model.out[p] = from[0].edge;
        if (model.role[p] == Role::Pinned || !is_one_fan(model, from[0].edge, from.size())) {
            model.role[p] = Role::Pinned;
            ++model.report.non_manifold;
            continue;
        }
        if (ends.count[p] == 0) continue;
        model.role[p] = Role::Locked;
        const Face& face = model.faces[face_of(from[0].edge)];
        const std::uint32_t vertex = face.vertex[slot_of(from[0].edge)];
        if (ends.count[p] == 2 && runs_on(model, vertex, ends.first[p], ends.second[p])) {
            model.role[p] = Role::Crease;
            ++model.report.creases;
            if (model.crease.empty()) model.crease.assign(model.place_count, kNone);
            model.crease[p] = static_cast<std::uint32_t>(model.creases.size());
            CreasePoint point;
            point.vertex = vertex;
            point.neighbour = {model.place[ends.first[p]], model.place[ends.second[p]]};
            model.creases.push_back(point);
        }
    }
}

/// More kinds of missing than bits: where any value is missing, nothing moves.
void lock_round_missing(Model& model) {
    for (const Face& face : model.faces) {
        if (model.missing_in(face.vertex) == 0) continue;
        for (const std::uint32_t v : face.vertex) {
            Role& role = model.role[model.place[v]];
            if (role != Role::Pinned) role = Role::Locked;
        }
    }
}

}  // namespace

void make_faces(const LodSurface& surface, Model& model) {
    const std::size_t vertices = surface.positions.size();
    if (surface.triangles.size() >= kMostFaces || vertices >= kMostFaces) {
        throw Error(
            Code::TooLarge, "", "a surface of more than 2^30 triangles cannot be simplified in one piece"
        );
    }
    if (surface.places.empty()) {
        model.place.resize(vertices);
        std::iota(model.place.begin(), model.place.end(), 0U);
    } else {
        model.place = surface.places;
    }
    for (const std::uint32_t p : model.place) model.place_count = std::max(model.place_count, p + 1);
    model.faces.reserve(surface.triangles.size());
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& v = surface.triangles[t];
        const std::array<std::uint32_t, 3> at{
            model.place[raw(v[0])], model.place[raw(v[1])], model.place[raw(v[2])]};
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) {
            if (model.triangle.empty()) {
                model.triangle.resize(t);
                std::iota(model.triangle.begin(), model.triangle.end(), 0U);
            }
            ++model.report.degenerate;
            continue;
        }
        if (model.report.degenerate > 0) model.triangle.push_back(t);
        Face& face = model.faces.emplace_back();
        face.vertex = {raw(v[0]), raw(v[1]), raw(v[2])};
    }
    model.out.assign(model.place_count, kNone);
    model.role.assign(model.place_count, Role::Free);
}

void connect(Model& model, std::span<const std::array<float, 3>> normals) {
    const Buckets buckets = bucket_edges(model);
    pair_edges(buckets, model);
    give_roles(buckets, mark_features(model, normals), model);
    if (model.shares_bits) lock_round_missing(model);
}

}  // namespace feelem::lod
