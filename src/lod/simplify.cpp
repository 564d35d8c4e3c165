// SPDX-License-Identifier: Apache-2.0
// Must: give the levels that were asked for, each with its certificate, and never one that breaks it.
// Algorithm: the preparation runs on all threads, the collapse on one, so that the same input gives the same
// bytes; bounds widen step by step, so that cheap points go first. Lists hold original samples: errors never
// add up from level to level. Data: 60 bytes a triangle and 2 a field; 36 and 4 a field more with centroids.
#include "lod/collapser.hpp"
#include "lod/lod_mesh.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace feelem {
namespace {

using lod::Collapser;
using lod::Model;
using lod::Role;

/// Below these shares of the points the bounds widen, or the search ends when they cannot.
constexpr double kFewGone = 0.05;
constexpr double kHardlyAny = 0.002;
/// Share of the bounds kept back for the rounding of float32; doubled when a certificate was broken.
constexpr double kLeastReserve = 1e-4;
constexpr double kMostReserve = 0.25;

void check_options(const LodSurface& surface, std::span<const LodField> fields, const LodOptions& options) {
    const auto bad = [](const std::string& text) { throw Error(Code::BadOption, "", text); };
    for (const LodField& field : fields) {
        if (!(field.bound > 0) || !std::isfinite(field.bound))
            bad(fmt::format("the bound of a result must be a positive number, not {}", field.bound));
        if (field.values.size() != surface.positions.size())
            bad(fmt::format(
                "a result has {} values for {} vertices", field.values.size(), surface.positions.size()
            ));
    }
    if (!(options.distance >= 0) || !(options.slip > 0) || !(options.first_step > 0) || !(options.growth > 1))
        bad("distance, slip, first step and growth of a level of detail must be positive, growth above 1");
    for (std::size_t i = 0; i < options.targets.size(); ++i) {
        const LodTarget& target = options.targets[i];
        if (!(target.bound > 0) || !std::isfinite(target.bound)) bad("the bound of a level must be positive");
        if (i > 0 && (target.triangles > options.targets[i - 1].triangles ||
                      target.bound < options.targets[i - 1].bound))
            bad("levels must be asked for from fine to coarse: triangles descending, bounds ascending");
    }
    if (!surface.places.empty() && surface.places.size() != surface.positions.size())
        bad("a surface needs a place for every vertex, or none");
}

Model prepared(
    const LodSurface& surface, std::span<const LodField> fields, const LodOptions& options, double& distance
) {
    Model model;
    lod::make_faces(surface, model);
    lod::place_vertices(surface, model);
    if (!(distance > 0)) distance = model.scale * 1e-3;
    lod::mark_missing(fields, model);
    const auto normals = lod::face_normals(model);
    lod::connect(model, normals);
    lod::fill_samples(fields, options, distance, normals, model);
    lod::lock_extremes(fields, model);
    for (const VertexIndex v : options.keep) {
        Role& role = model.role[model.place[raw(v)]];
        if (role != Role::Pinned) role = Role::Locked;
    }
    for (std::size_t p = 0; p < model.role.size(); ++p) {
        if (model.role[p] == Role::Locked || model.role[p] == Role::Pinned) ++model.report.locked;
    }
    return model;
}

/// Rounding of a value and a coordinate to float32, in bounds.
double reserve_for(const Model& model, std::span<const LodField> fields, double distance) {
    double most = model.scale / distance;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        for (const float f : std::span(model.values).first(model.place.size() * fields.size()))
            most = std::max(most, static_cast<double>(std::abs(f)));
        break;
    }
    return kLeastReserve + most * 2.4e-7;
}

/// All levels with this much kept back; nothing when a certificate does not hold.
std::optional<LodResult> attempt(
    const LodSurface& surface, std::span<const LodField> fields, const LodOptions& options, double reserve
) {
    double distance = options.distance;
    Model model = prepared(surface, fields, options, distance);
    const double kept_back = std::max(reserve, reserve_for(model, fields, distance));
    if (kept_back > kMostReserve)
        throw Error(Code::BadOption, "", "the bounds of a level of detail are too fine for float32 values");
    LodResult result;
    result.report = model.report;
    Collapser collapser(model, static_cast<float>(std::cos(options.cone_angle * std::numbers::pi / 180)));
    double bound = options.first_step;
    for (const LodTarget& target : options.targets) {
        bound = std::min(bound, target.bound);
        while (collapser.triangles() > target.triangles) {
            const std::uint64_t gone =
                collapser.sweep(static_cast<float>(bound * (1 - kept_back)), target.triangles);
            if (collapser.triangles() <= target.triangles) break;
            const double share =
                static_cast<double>(gone) / static_cast<double>(collapser.points() + gone + 1);
            if (bound >= target.bound && (share < kHardlyAny || gone == 0)) break;
            if (bound < target.bound && share < kFewGone)
                bound = std::min(bound * options.growth, target.bound);
        }
        result.levels.push_back(lod::certified_level(surface, fields, model, bound, distance));
        result.levels.back().reached = collapser.triangles() <= target.triangles;
        if (!(result.levels.back().certificate.worst <= 1)) return std::nullopt;
    }
    return result;
}

}  // namespace

LodResult simplify(const LodSurface& surface, std::span<const LodField> fields, const LodOptions& options) {
    check_options(surface, fields, options);
    for (double reserve = kLeastReserve; reserve <= kMostReserve; reserve *= 8) {
        if (auto result = attempt(surface, fields, options, reserve)) return *std::move(result);
    }
    throw Error(Code::BadOption, "", "the bounds of a level of detail are too fine for float32 coordinates");
}

}  // namespace feelem
