// SPDX-License-Identifier: Apache-2.0
// Levels of detail that do not lie: fewer triangles over original vertices, with a certificate of how far any
// original value and place may be from what is shown; and a checker that shares no code with the simplifier.
#pragma once

#include "feelem/surface.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace feelem {

/// What is simplified. Keep alive what the spans point to.
struct LodSurface {
    std::span<const Point3> positions;
    std::span<const std::array<VertexIndex, 3>> triangles;
    /// Per vertex: vertices of one number are one point of the model, split at a crease or at the border of a
    /// part. They go or stay together, so that no crack opens. Empty: no two vertices are one point.
    std::vector<std::uint32_t> places;
    /// Per vertex: its part; only the checker looks at it. Empty: one part.
    std::vector<std::uint32_t> parts;
};

/// The skin as it is drawn. Vertices of solids and shells with the same node, or mixed from the same nodes
/// with the same weights, are one point.
LodSurface lod_surface(const Surface& surface);

/// One component of one result at one step. NaN = missing: a triangle with a missing corner is missing whole,
/// and stays so.
struct LodField {
    std::span<const float> values;  ///< Per vertex.
    double bound = 0;               ///< In the field's unit; > 0.
};

/// A level is ready when it has no more than `triangles`, or when nothing more can go within `bound`.
struct LodTarget {
    std::uint64_t triangles = 0;
    double bound = 1;  ///< Fraction of every field's bound and of the distance.
};

struct LodOptions {
    double distance = 0;      ///< Length units; 0: a thousandth of the largest extent.
    bool centroids = true;    ///< One sample per original triangle is bounded besides all vertices.
    double slip = 0.5;        ///< No vertex may move so far that its field changes by more than slip * bound.
    double cone_angle = 45;   ///< Degrees between the normal of a sample and of the triangle that shows it.
    double first_step = 0.1;  ///< The search begins at this fraction of the bounds ...
    double growth = 3;        ///< ... and widens by this factor when little can be removed.
    std::vector<VertexIndex> keep;  ///< Stay in every level, besides the extremes of the fields.
    std::vector<LodTarget> targets{LodTarget{}};  ///< Triangles descending, bounds ascending.
};

struct LodFieldError {
    double bound = 0;  ///< Promised for this level, in the field's unit.
    double max = 0;    ///< Found over all samples.
    double rms = 0;
};

/// What holds for every original vertex (and the centroid of every original triangle): on the triangle that
/// stands for it there is a place within `distance_bound` whose values are within the fields' bounds.
/// Recomputed in double from the original arrays after the level was made.
struct LodCertificate {
    double bound = 0;  ///< Fraction of the bounds that was needed; never above the target's.
    std::vector<LodFieldError> fields;
    double distance_bound = 0;
    double max_distance = 0;
    double max_border_distance = 0;  ///< Of removed crease and border vertices to the line that replaced it.
    double worst = 0;                ///< Largest error as a fraction of its bound: <= 1.
    std::uint64_t samples = 0;       ///< Vertices and centroids compared.
    std::uint64_t missing = 0;       ///< Of these, samples without a value in some field.
};

struct LodLevel {
    std::vector<std::array<VertexIndex, 3>> triangles;  ///< Of original vertices, in their original order.
    std::vector<VertexIndex> vertices;                  ///< Those in use, ascending.
    /// Per original vertex: the triangle of this level that stands for it; 0xffffffff: on no triangle.
    std::vector<std::uint32_t> witness;
    /// Likewise per original triangle for its middle; empty without centroids.
    std::vector<std::uint32_t> middle_witness;
    /// Vertices on a crease that its two sides share, each with the triangle of the second side.
    std::vector<std::pair<VertexIndex, std::uint32_t>> second_witness;
    bool reached = false;  ///< The count was reached; else the bounds allow no fewer triangles.
    LodCertificate certificate;
};

/// What the simplifier found in the surface.
struct LodReport {
    std::uint64_t points = 0;        ///< Distinct points of the model.
    std::uint64_t creases = 0;       ///< Points on creases and borders, which go along the line only.
    std::uint64_t locked = 0;        ///< Points that stay: corners, non-manifold places, extremes.
    std::uint64_t non_manifold = 0;  ///< Of these, where edges or fans of triangles meet that should not.
    std::uint64_t extremes = 0;      ///< Of these, kept for the persistence of a value there.
    std::uint64_t degenerate = 0;    ///< Triangles without three points: left out of every level.
};

struct LodResult {
    std::vector<LodLevel> levels;  ///< One a target.
    LodReport report;
};

/// The same bytes whatever the number of threads. Throws Error(BadOption) when a bound is not positive or too
/// fine for float32, Error(TooLarge) above 2^30 triangles.
LodResult simplify(const LodSurface& surface, std::span<const LodField> fields, const LodOptions& options);

/// What holds on a finished level for results that it was not made for: each vertex and middle against the
/// triangle that stands for it, as in the certificate. `bound` stays 0.
std::vector<LodFieldError> measure_level(
    const LodSurface& surface, std::span<const LodField> fields, const LodLevel& level
);

/// Vertices whose value rises out of its surroundings by more than twice the field's bound, or falls so far
/// below them; and the highest and lowest of each connected piece. Ascending.
std::vector<VertexIndex> lasting_extremes(const LodSurface& surface, std::span<const LodField> fields);

/// What an observer measures on a level who knows nothing of how it was made.
struct LodCheck {
    struct Field {
        double max = 0;  ///< |value shown at the closest place - value| over all original vertices.
        double rms = 0;
        std::uint64_t over = 0;  ///< Vertices above the bound.
        VertexIndex worst{};     ///< Where the maximum is.
    };
    std::vector<Field> fields;
    double max_distance = 0;
    std::uint64_t vertices = 0;       ///< Compared.
    std::uint64_t without_place = 0;  ///< No triangle of the part faces as the original one does.
    std::uint64_t invented = 0;       ///< Missing in the original, shown with a value.
    std::uint64_t lost = 0;           ///< Has a value, shown as missing.
};

/// For every original vertex the closest place on the level's triangles of the same part whose normal agrees
/// (cosine > 0.25) with that of an original triangle at the vertex: brute force over a tree of boxes, in
/// double. A vertex of the level shows itself. Where a value is missing in part of the surface, a place
/// within `distance` (length units) on the right side of that border counts as the closest.
LodCheck check_level(
    const LodSurface& surface,
    std::span<const LodField> fields,
    std::span<const std::array<VertexIndex, 3>> level,
    double distance
);

}  // namespace feelem
