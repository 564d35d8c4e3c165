// SPDX-License-Identifier: Apache-2.0
// The triangles that are being reduced, and the samples that must stay within their bounds: plain arrays that
// the stages of the simplifier share.
#pragma once

#include "feelem/lod.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem::lod {

inline constexpr std::uint32_t kNone = 0xffffffffU;

/// A half-edge is 4 * face + slot, from vertex[slot] to vertex[next(slot)].
struct Face {
    std::array<std::uint32_t, 3> vertex{};
    std::array<std::uint32_t, 3> twin{kNone, kNone, kNone};
    std::uint32_t list = kNone;  ///< First of the samples that this triangle stands for.
    std::uint8_t features = 0;   ///< Bit of a slot: the half-edge is on a crease, border or edge of a part.
    bool is_dead = false;
};

inline constexpr std::array<std::uint8_t, 3> kNext{1, 2, 0};
inline constexpr std::array<std::uint8_t, 3> kPrevious{2, 0, 1};

constexpr std::uint32_t half_edge(std::uint32_t face, std::uint32_t slot) {
    return 4 * face + slot;
}
constexpr std::uint32_t face_of(std::uint32_t edge) {
    return edge >> 2U;
}
constexpr std::uint32_t slot_of(std::uint32_t edge) {
    return edge & 3U;
}

enum class Role : std::uint8_t {
    Free,
    Crease,  ///< On exactly two feature edges that run on: may go along them.
    Locked,
    Pinned,  ///< Locked, and nothing may be drawn to it: its triangles are no single fan.
    Dead
};

/// A place on the original surface with what must hold there. Coordinates are those of the surface, moved to
/// its middle and divided by its largest extent.
struct Sample {
    float x = 0, y = 0, z = 0;
    float inverse_distance = 0;    ///< 1 / how far its witness may be.
    float nx = 0, ny = 0, nz = 0;  ///< Unit normal of the original; zero where there is no single one.
    std::uint32_t next = kNone;    ///< In the list of a triangle.
};

/// A point on a crease: its two neighbours along it, and the removed points that each of the two lines stands
/// for.
struct CreasePoint {
    std::array<std::uint32_t, 2> neighbour{kNone, kNone};  ///< Places.
    std::array<std::uint32_t, 2> head{kNone, kNone};       ///< First removed crease point of each line.
    std::uint32_t next = kNone;
    std::uint32_t vertex = kNone;  ///< One of the vertices at the place.
    std::uint32_t alias = kNone;   ///< Second sample of a vertex that both sides of the crease share.
};

/// A line between two points that stay, with the removed crease points that it stands for.
struct ClosedLine {
    std::uint32_t head = kNone;
    std::array<std::uint32_t, 2> ends{kNone, kNone};  ///< Places.
};

struct Model {
    std::vector<Face> faces;
    std::vector<std::uint32_t> triangle;  ///< Per face: original triangle; empty: the same.
    std::vector<std::uint32_t> place;     ///< Per vertex.
    std::uint32_t place_count = 0;
    std::vector<std::uint32_t> out;     ///< Per place: a half-edge that begins there, or kNone.
    std::vector<Role> role;             ///< Per place.
    std::vector<std::uint32_t> crease;  ///< Per place: its crease point, or kNone; empty: no creases.
    std::vector<CreasePoint> creases;
    std::vector<ClosedLine> closed_lines;
    /// Vertices, then centroids of faces (when asked for), then second samples of crease points.
    std::vector<Sample> samples;
    std::vector<float> values;  ///< Samples x fields, each divided by its bound.
    std::size_t field_count = 0;
    std::vector<std::uint64_t> missing;  ///< Per vertex: bits of the fields that have no value; empty: none.
    /// Per field: its bit in `missing`, that of all fields that are missing at the same vertices; kNoBit: a
    /// field with all its values.
    std::vector<std::uint8_t> missing_bit;
    bool shares_bits = false;  ///< More different kinds of missing than bits.
    double scale = 1;          ///< Largest extent.
    Point3 middle{};
    LodReport report;

    std::uint32_t end_of(std::uint32_t edge) const {
        return faces[face_of(edge)].vertex[kNext[slot_of(edge)]];
    }
    bool is_missing(std::uint64_t bits, std::size_t field) const {
        return bits != 0 && missing_bit[field] < 64 && ((bits >> missing_bit[field]) & 1U) != 0;
    }
    std::uint64_t missing_in(const std::array<std::uint32_t, 3>& v) const {
        return missing[v[0]] | missing[v[1]] | missing[v[2]];
    }
};

inline constexpr std::uint8_t kNoBit = 64;

/// Unit normals of all faces (zero for a face without area), from the samples of the vertices.
std::vector<std::array<float, 3>> face_normals(const Model& model);

/// Faces of the triangles with three different places, and the place of every vertex.
void make_faces(const LodSurface& surface, Model& model);
/// Samples of the vertices: places only.
void place_vertices(const LodSurface& surface, Model& model);
/// Which fields are missing at which vertices.
void mark_missing(std::span<const LodField> fields, Model& model);
/// Twins, features, roles and creases.
void connect(Model& model, std::span<const std::array<float, 3>> normals);
/// Values, normals, distances; centroids and second samples of crease points.
void fill_samples(
    std::span<const LodField> fields,
    const LodOptions& options,
    double distance,
    std::span<const std::array<float, 3>> normals,
    Model& model
);
/// Locks the extremes whose persistence is more than twice the bound, and the highest and lowest of each
/// connected piece.
void lock_extremes(std::span<const LodField> fields, Model& model);

/// The level as it stands, with all that its certificate says recomputed in double from the original arrays.
LodLevel certified_level(
    const LodSurface& surface,
    std::span<const LodField> fields,
    const Model& model,
    double bound,
    double distance
);

}  // namespace feelem::lod
