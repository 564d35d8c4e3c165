// SPDX-License-Identifier: Apache-2.0
// Must: say what holds for a level, from nothing but the original arrays, its triangles and their lists.
// Algorithm: every sample against the closest place of the triangle whose list holds it, every removed crease
// point against the line that replaced it, in double (closest place: Ericson, Real-Time Collision Detection
// 5.1.5). Data: 4 bytes a vertex; sums are made of fixed chunks.
#include "base/parallel.hpp"
#include "lod/lod_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

using Weights = std::array<double, 3>;

Point3 less(const Point3& a, const Point3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double inner(const Point3& a, const Point3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Weights closest_weights(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
    const Point3 ab = less(b, a), ac = less(c, a), ap = less(p, a);
    const double d1 = inner(ab, ap), d2 = inner(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const Point3 bp = less(p, b);
    const double d3 = inner(ab, bp), d4 = inner(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const Point3 cp = less(p, c);
    const double d5 = inner(ab, cp), d6 = inner(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

/// A sample in original numbers: a vertex, or the mean of three.
struct Origin {
    std::array<std::uint32_t, 3> vertex{};
    std::size_t count = 0;
};

struct Sums {
    std::vector<double> max, squares;
    double distance = 0;
    std::uint64_t samples = 0, missing = 0;
};

class Certifier {
public:
    Certifier(const LodSurface& surface, std::span<const LodField> fields, const Model& model)
        : surface_(surface), fields_(fields), model_(model), vertices_(model.place.size()) {
        alias_first_ = model.samples.size();
        for (const CreasePoint& point : model.creases) {
            if (point.alias == kNone) continue;
            if (alias_.empty()) alias_first_ = point.alias;
            alias_.push_back(point.vertex);
        }
    }

    /// Writes which triangle of the level stands for each sample.
    Sums of_faces(std::span<const std::uint32_t> faces, std::size_t first, std::size_t last, LodLevel& level)
        const {
        Sums sums;
        sums.max.assign(fields_.size(), 0);
        sums.squares.assign(fields_.size(), 0);
        for (std::size_t t = first; t < last; ++t) {
            const Face& face = model_.faces[faces[t]];
            for (std::uint32_t s = face.list; s != kNone; s = model_.samples[s].next) {
                const auto triangle = static_cast<std::uint32_t>(t);
                if (s < vertices_)
                    level.witness[s] = triangle;
                else if (s < alias_first_)
                    level.middle_witness[triangle_of(s)] = triangle;
                else
                    level.second_witness[s - alias_first_].second = triangle;
                add(face, origin_of(s), sums);
            }
        }
        return sums;
    }

    void make_room(LodLevel& level) const {
        if (alias_first_ > vertices_) level.middle_witness.assign(surface_.triangles.size(), kNone);
        for (const std::uint32_t v : alias_) level.second_witness.emplace_back(VertexIndex{v}, kNone);
    }

    /// Of removed crease points from the lines that stand for them.
    double border_distance() const {
        double most = 0;
        const auto follow = [&](std::uint32_t head, std::uint32_t a, std::uint32_t b) {
            const Point3 &from = place_at(a), &to = place_at(b);
            for (std::uint32_t c = head; c != kNone; c = model_.creases[c].next) {
                const Point3& p = surface_.positions[model_.creases[c].vertex];
                most = std::max(most, distance_to(p, from, to));
            }
        };
        for (std::uint32_t p = 0; !model_.crease.empty() && p < model_.place_count; ++p) {
            if (model_.crease[p] == kNone || model_.role[p] == Role::Dead) continue;
            const CreasePoint& point = model_.creases[model_.crease[p]];
            for (std::size_t i = 0; i < 2; ++i) {
                if (point.head[i] != kNone) follow(point.head[i], p, point.neighbour[i]);
            }
        }
        for (const ClosedLine& line : model_.closed_lines) follow(line.head, line.ends[0], line.ends[1]);
        return most;
    }

private:
    const Point3& place_at(std::uint32_t place) const {
        const std::uint32_t edge = model_.out[place];
        return surface_.positions[model_.faces[face_of(edge)].vertex[slot_of(edge)]];
    }
    static double distance_to(const Point3& p, const Point3& a, const Point3& b) {
        const Point3 d = less(b, a), q = less(p, a);
        const double length = inner(d, d);
        const double share = length > 0 ? std::clamp(inner(d, q) / length, 0.0, 1.0) : 0;
        const Point3 e = less(q, {share * d[0], share * d[1], share * d[2]});
        return std::sqrt(inner(e, e));
    }

    /// Of which it is the middle.
    std::size_t triangle_of(std::uint32_t sample) const {
        const std::size_t face = sample - vertices_;
        return model_.triangle.empty() ? face : model_.triangle[face];
    }

    Origin origin_of(std::uint32_t sample) const {
        if (sample < vertices_) return {{sample, 0, 0}, 1};
        if (sample >= alias_first_) return {{alias_[sample - alias_first_], 0, 0}, 1};
        const auto& v = surface_.triangles[triangle_of(sample)];
        return {{raw(v[0]), raw(v[1]), raw(v[2])}, 3};
    }

    void add(const Face& face, const Origin& origin, Sums& sums) const {
        Point3 p{};
        for (std::size_t i = 0; i < origin.count; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                p[axis] += surface_.positions[origin.vertex[i]][axis] / static_cast<double>(origin.count);
        }
        const auto& v = face.vertex;
        const Point3 &a = surface_.positions[v[0]], &b = surface_.positions[v[1]],
                     &c = surface_.positions[v[2]];
        const Weights w = closest_weights(p, a, b, c);
        Point3 off{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            off[axis] = w[0] * a[axis] + w[1] * b[axis] + w[2] * c[axis] - p[axis];
        sums.distance = std::max(sums.distance, std::sqrt(inner(off, off)));
        ++sums.samples;
        bool is_missing = false;
        for (std::size_t k = 0; k < fields_.size(); ++k) {
            const auto f = fields_[k].values;
            double value = 0;
            for (std::size_t i = 0; i < origin.count; ++i)
                value += static_cast<double>(f[origin.vertex[i]]) / static_cast<double>(origin.count);
            const double shown = w[0] * static_cast<double>(f[v[0]]) + w[1] * static_cast<double>(f[v[1]]) +
                                 w[2] * static_cast<double>(f[v[2]]);
            const double error = std::abs(shown - value);
            // Missing on either side: the simplifier keeps triangles with missing values apart from others.
            if (!std::isfinite(error)) {
                is_missing = true;
                continue;
            }
            if (!model_.missing.empty() && model_.is_missing(model_.missing_in(v), k)) continue;
            sums.max[k] = std::max(sums.max[k], error);
            sums.squares[k] += error * error;
        }
        if (is_missing) ++sums.missing;
    }

    const LodSurface& surface_;
    std::span<const LodField> fields_;
    const Model& model_;
    std::size_t vertices_;
    std::size_t alias_first_ = 0;
    std::vector<std::uint32_t> alias_;
};

/// Triangles and vertices of the level; the witness of each vertex that stays is the first triangle that has
/// it. Returns the faces that live.
std::vector<std::uint32_t> take_triangles(const Model& model, LodLevel& level) {
    std::vector<std::uint32_t> faces;
    level.witness.assign(model.place.size(), kNone);
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        if (model.faces[f].is_dead) continue;
        const auto& v = model.faces[f].vertex;
        for (const std::uint32_t w : v) {
            if (level.witness[w] == kNone) level.witness[w] = static_cast<std::uint32_t>(faces.size());
        }
        level.triangles.push_back({VertexIndex{v[0]}, VertexIndex{v[1]}, VertexIndex{v[2]}});
        faces.push_back(f);
    }
    for (std::uint32_t v = 0; v < level.witness.size(); ++v) {
        if (level.witness[v] != kNone) level.vertices.push_back(VertexIndex{v});
    }
    return faces;
}

}  // namespace

LodLevel certified_level(
    const LodSurface& surface,
    std::span<const LodField> fields,
    const Model& model,
    double bound,
    double distance
) {
    LodLevel level;
    const std::vector<std::uint32_t> faces = take_triangles(model, level);
    const Certifier certifier(surface, fields, model);
    certifier.make_room(level);
    constexpr std::size_t kFaces = 1U << 12U;
    std::vector<Sums> parts((faces.size() + kFaces - 1) / kFaces);
    parallel_chunks(faces.size(), kFaces, [&](std::size_t first, std::size_t last) {
        parts[first / kFaces] = certifier.of_faces(faces, first, last, level);
    });

    LodCertificate& certificate = level.certificate;
    certificate.bound = bound;
    certificate.distance_bound = bound * distance;
    certificate.samples = level.vertices.size();
    certificate.fields.resize(fields.size());
    for (std::size_t k = 0; k < fields.size(); ++k) certificate.fields[k].bound = bound * fields[k].bound;
    for (const Sums& sums : parts) {
        certificate.samples += sums.samples;
        certificate.missing += sums.missing;
        certificate.max_distance = std::max(certificate.max_distance, sums.distance);
        for (std::size_t k = 0; k < fields.size(); ++k) {
            certificate.fields[k].max = std::max(certificate.fields[k].max, sums.max[k]);
            certificate.fields[k].rms += sums.squares[k];
        }
    }
    certificate.max_border_distance = certifier.border_distance();
    certificate.worst = std::max(certificate.max_distance, certificate.max_border_distance) / distance;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        LodFieldError& error = certificate.fields[k];
        error.rms =
            std::sqrt(error.rms / static_cast<double>(std::max<std::uint64_t>(1, certificate.samples)));
        certificate.worst = std::max(certificate.worst, error.max / fields[k].bound);
    }
    certificate.worst = bound > 0 ? certificate.worst / bound : certificate.worst;
    return level;
}

}  // namespace feelem::lod

namespace feelem {
namespace {

/// Differences of some fields at one sample; missing on either side: none, the checker looks at that.
struct Measured {
    std::vector<double> max, squares;
    std::uint64_t samples = 0;

    void add(
        const LodSurface& surface,
        std::span<const LodField> fields,
        std::span<const std::uint32_t> of,
        const std::array<VertexIndex, 3>& t
    ) {
        const auto share = 1 / static_cast<double>(of.size());
        Point3 p{};
        for (const std::uint32_t v : of) {
            for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += surface.positions[v][axis] * share;
        }
        const auto w = lod::closest_weights(
            p, surface.positions[raw(t[0])], surface.positions[raw(t[1])], surface.positions[raw(t[2])]
        );
        ++samples;
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const auto f = fields[k].values;
            double error = 0;
            for (const std::uint32_t v : of) error -= static_cast<double>(f[v]) * share;
            for (std::size_t i = 0; i < 3; ++i) error += w[i] * static_cast<double>(f[raw(t[i])]);
            if (!std::isfinite(error)) continue;
            max[k] = std::max(max[k], std::abs(error));
            squares[k] += error * error;
        }
    }
};

}  // namespace

std::vector<LodFieldError> measure_level(
    const LodSurface& surface, std::span<const LodField> fields, const LodLevel& level
) {
    Measured sums;
    sums.max.assign(fields.size(), 0);
    sums.squares.assign(fields.size(), 0);
    const auto add = [&](std::span<const std::uint32_t> of, std::uint32_t triangle) {
        if (triangle != lod::kNone) sums.add(surface, fields, of, level.triangles[triangle]);
    };
    for (std::uint32_t v = 0; v < level.witness.size(); ++v) add({&v, 1}, level.witness[v]);
    for (std::size_t t = 0; t < level.middle_witness.size(); ++t) {
        const auto& c = surface.triangles[t];
        add(std::array{raw(c[0]), raw(c[1]), raw(c[2])}, level.middle_witness[t]);
    }
    for (const auto& [vertex, triangle] : level.second_witness) {
        const std::uint32_t v = raw(vertex);
        add({&v, 1}, triangle);
    }
    std::vector<LodFieldError> errors(fields.size());
    for (std::size_t k = 0; k < fields.size(); ++k) {
        errors[k].max = sums.max[k];
        errors[k].rms =
            std::sqrt(sums.squares[k] / static_cast<double>(std::max<std::uint64_t>(1, sums.samples)));
    }
    return errors;
}

}  // namespace feelem
