// SPDX-License-Identifier: Apache-2.0
// The samples: where the original surface must be found again, with which values, and how far away at most.
#include "base/parallel.hpp"
#include "lod/lod_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem::lod {
namespace {

using Vector3 = std::array<float, 3>;

/// Cosine: a vertex whose triangles stand off its mean normal by more has no normal of its own.
constexpr float kOneNormal = 0.9F;

Vector3 between(const Sample& a, const Sample& b) {
    return {b.x - a.x, b.y - a.y, b.z - a.z};
}
Vector3 crossed(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float dotted(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void normals_of_vertices(const Model& model, std::span<const Vector3> normals, std::span<Sample> samples) {
    for (const Face& face : model.faces) {
        const Sample& a = samples[face.vertex[0]];
        const Vector3 area =
            crossed(between(a, samples[face.vertex[1]]), between(a, samples[face.vertex[2]]));
        for (const std::uint32_t v : face.vertex) {
            samples[v].nx += area[0];
            samples[v].ny += area[1];
            samples[v].nz += area[2];
        }
    }
    for (Sample& s : samples) {
        const float length = std::sqrt(s.nx * s.nx + s.ny * s.ny + s.nz * s.nz);
        const float inverse = length > 0 ? 1 / length : 0;
        s.nx *= inverse;
        s.ny *= inverse;
        s.nz *= inverse;
    }
    // In two passes: a cleared normal must not clear those of other triangles.
    std::vector<bool> is_several(samples.size(), false);
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
        const Vector3& n = normals[f];
        for (const std::uint32_t v : model.faces[f].vertex) {
            const Sample& s = samples[v];
            if (n[0] * s.nx + n[1] * s.ny + n[2] * s.nz < kOneNormal) is_several[v] = true;
        }
    }
    for (std::size_t v = 0; v < samples.size(); ++v) {
        if (is_several[v]) samples[v].nx = samples[v].ny = samples[v].nz = 0;
    }
}

/// Length of the steepest gradient of any field on the face, in bounds a unit of length.
float steepest(const Model& model, const Face& face) {
    const auto& v = face.vertex;
    const Vector3 a = between(model.samples[v[0]], model.samples[v[1]]);
    const Vector3 b = between(model.samples[v[0]], model.samples[v[2]]);
    const Vector3 n = crossed(a, b);
    const float area = dotted(n, n);
    if (!(area > 0)) return 0;
    // |grad|^2 of f = da, db along a, b: (da^2 b.b - 2 da db a.b + db^2 a.a) / |a x b|^2.
    const float aa = dotted(a, a), bb = dotted(b, b), ab = dotted(a, b);
    float most = 0;
    const std::uint64_t missing = model.missing.empty() ? 0 : model.missing_in(v);
    for (std::size_t k = 0; k < model.field_count; ++k) {
        const float f = model.values[v[0] * model.field_count + k];
        const float da = model.values[v[1] * model.field_count + k] - f;
        const float db = model.values[v[2] * model.field_count + k] - f;
        if (model.is_missing(missing, k)) continue;
        most = std::max(most, da * da * bb - 2 * da * db * ab + db * db * aa);
    }
    return std::sqrt(most / area);
}

void scale_values(std::span<const LodField> fields, std::size_t vertices, Model& model) {
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto values = fields[k].values;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const float f : values) {
            low = std::min(low, std::isfinite(f) ? static_cast<double>(f) : low);
            high = std::max(high, std::isfinite(f) ? static_cast<double>(f) : high);
        }
        const double middle = low <= high ? (low + high) / 2 : 0;
        const double inverse = 1 / fields[k].bound;
        for (std::size_t v = 0; v < vertices; ++v) {
            const double f = static_cast<double>(values[v]);
            model.values[v * fields.size() + k] =
                std::isfinite(f) ? static_cast<float>((f - middle) * inverse) : 0.0F;
        }
    }
}

void add_centroids(std::span<const Vector3> normals, std::size_t first, Model& model) {
    const std::size_t width = model.field_count;
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
        Face& face = model.faces[f];
        const auto& v = face.vertex;
        const Sample &a = model.samples[v[0]], &b = model.samples[v[1]], &c = model.samples[v[2]];
        Sample& s = model.samples[first + f];
        s.x = (a.x + b.x + c.x) / 3;
        s.y = (a.y + b.y + c.y) / 3;
        s.z = (a.z + b.z + c.z) / 3;
        s.nx = normals[f][0];
        s.ny = normals[f][1];
        s.nz = normals[f][2];
        s.inverse_distance = std::min({a.inverse_distance, b.inverse_distance, c.inverse_distance});
        for (std::size_t k = 0; k < width; ++k) {
            model.values[(first + f) * width + k] =
                (model.values[v[0] * width + k] + model.values[v[1] * width + k] +
                 model.values[v[2] * width + k]) /
                3;
        }
        face.list = static_cast<std::uint32_t>(first + f);
    }
}

/// True when the triangles on both sides of the crease share the vertex.
bool is_shared(const Model& model, std::uint32_t place, std::uint32_t vertex) {
    std::uint32_t edge = model.out[place];
    const std::uint32_t start = edge;
    do {
        const Face& face = model.faces[face_of(edge)];
        if (face.vertex[slot_of(edge)] != vertex || face.twin[slot_of(edge)] == kNone) return false;
        edge = face.twin[kPrevious[slot_of(edge)]];
    } while (edge != kNone && edge != start);
    return edge == start;
}

void add_aliases(Model& model) {
    for (std::uint32_t p = 0; !model.crease.empty() && p < model.place_count; ++p) {
        if (model.crease[p] == kNone) continue;
        CreasePoint& point = model.creases[model.crease[p]];
        if (!is_shared(model, p, point.vertex)) continue;
        point.alias = static_cast<std::uint32_t>(model.samples.size());
        model.samples.push_back(Sample(model.samples[point.vertex]));
        for (std::size_t k = 0; k < model.field_count; ++k)
            model.values.push_back(float{model.values[point.vertex * model.field_count + k]});
    }
}

}  // namespace

std::vector<Vector3> face_normals(const Model& model) {
    std::vector<Vector3> normals(model.faces.size());
    parallel_chunks(normals.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            const auto& v = model.faces[f].vertex;
            const Sample& a = model.samples[v[0]];
            const Vector3 n = crossed(between(a, model.samples[v[1]]), between(a, model.samples[v[2]]));
            const float length = std::sqrt(dotted(n, n));
            const float inverse = length > 0 ? 1 / length : 0;
            normals[f] = {n[0] * inverse, n[1] * inverse, n[2] * inverse};
        }
    });
    return normals;
}

void place_vertices(const LodSurface& surface, Model& model) {
    Point3 low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const Face& face : model.faces) {
        for (const std::uint32_t v : face.vertex) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], surface.positions[v][axis]);
                high[axis] = std::max(high[axis], surface.positions[v][axis]);
            }
        }
    }
    double extent = 0;
    for (std::size_t axis = 0; axis < 3 && !model.faces.empty(); ++axis) {
        extent = std::max(extent, high[axis] - low[axis]);
        model.middle[axis] = (low[axis] + high[axis]) / 2;
    }
    model.scale = extent > 0 && std::isfinite(extent) ? extent : 1;
    const double inverse = 1 / model.scale;
    model.samples.resize(surface.positions.size());
    for (std::size_t v = 0; v < model.samples.size(); ++v) {
        const Point3& at = surface.positions[v];
        model.samples[v].x = static_cast<float>((at[0] - model.middle[0]) * inverse);
        model.samples[v].y = static_cast<float>((at[1] - model.middle[1]) * inverse);
        model.samples[v].z = static_cast<float>((at[2] - model.middle[2]) * inverse);
    }
}

void mark_missing(std::span<const LodField> fields, Model& model) {
    model.field_count = fields.size();
    model.missing_bit.assign(fields.size(), kNoBit);
    std::vector<std::size_t> kinds;  // One field of each kind of missing.
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto values = fields[k].values;
        const auto is_gone = [](float f) { return !std::isfinite(f); };
        if (std::ranges::none_of(values, is_gone)) continue;
        const auto same = std::ranges::find_if(kinds, [&](std::size_t kind) {
            return std::ranges::equal(values, fields[kind].values, {}, is_gone, is_gone);
        });
        const auto kind = static_cast<std::size_t>(same - kinds.begin());
        model.missing_bit[k] = static_cast<std::uint8_t>(kind % kNoBit);
        if (same != kinds.end()) continue;
        kinds.push_back(k);
        if (model.missing.empty()) model.missing.assign(model.samples.size(), 0);
        for (std::size_t v = 0; v < values.size(); ++v) {
            if (is_gone(values[v])) model.missing[v] |= std::uint64_t{1} << model.missing_bit[k];
        }
    }
    model.shares_bits = kinds.size() > kNoBit;
}

void fill_samples(
    std::span<const LodField> fields,
    const LodOptions& options,
    double distance,
    std::span<const Vector3> normals,
    Model& model
) {
    const std::size_t vertices = model.samples.size();
    const std::size_t count = vertices + (options.centroids ? model.faces.size() : 0);
    model.samples.reserve(count + model.creases.size());
    model.values.reserve((count + model.creases.size()) * fields.size());
    model.values.resize(vertices * fields.size());
    normals_of_vertices(model, normals, model.samples);
    scale_values(fields, vertices, model);
    const auto least = static_cast<float>(model.scale / distance);
    for (Sample& s : model.samples) s.inverse_distance = least;
    const auto by_slope = static_cast<float>(1 / options.slip);
    for (const Face& face : model.faces) {
        const float needed = steepest(model, face) * by_slope;
        for (const std::uint32_t v : face.vertex)
            model.samples[v].inverse_distance = std::max(model.samples[v].inverse_distance, needed);
    }
    model.samples.resize(count);
    model.values.resize(count * fields.size());
    if (options.centroids) add_centroids(normals, vertices, model);
    add_aliases(model);
}

}  // namespace feelem::lod
