// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace feelem {
namespace {

/// As normalise() sees it: a logarithmic range that reaches zero is SymLog.
Scale scale_of(const ValueRange& range) {
    return range.scale == Scale::Log && !(range.lo > 0) ? Scale::SymLog : range.scale;
}

double magnitude_of(const ValueRange& range) {
    return std::max(std::abs(range.lo), std::abs(range.hi));
}

/// The axis on which a scale is even (docs/effects.md 1), and back.
double to_axis(double value, const ValueRange& range) {
    const double most = magnitude_of(range);
    switch (scale_of(range)) {
    case Scale::Linear:
    case Scale::Signed: return value;
    case Scale::Log: return value > 0 ? std::log10(value) : -1e9;
    case Scale::SymLog: break;
    }
    return most > 0 ? std::copysign(std::log10(1 + std::abs(value) / (1e-3 * most)), value) : value;
}

double from_axis(double place, const ValueRange& range) {
    const double most = magnitude_of(range);
    switch (scale_of(range)) {
    case Scale::Linear:
    case Scale::Signed: return place;
    case Scale::Log: return std::pow(10.0, place);
    case Scale::SymLog: break;
    }
    return most > 0 ? std::copysign((std::pow(10.0, std::abs(place)) - 1) * 1e-3 * most, place) : place;
}

std::array<double, 2> axis_ends(const ValueRange& range) {
    const double most = magnitude_of(range);
    if (range.scale == Scale::Signed) return {-most, most};
    return {to_axis(range.lo, range), to_axis(range.hi, range)};
}

/// normalise()'s position, not clamped.
double position_of(double value, const ValueRange& range) {
    const auto [lo, hi] = axis_ends(range);
    const double place = to_axis(value, range);
    if (hi > lo) return (place - lo) / (hi - lo);
    return place > lo ? 2.0 : place < lo ? -1.0 : 0.5;
}

/// The scalar of a presented result, or a component of a vector or tensor that holds it.
std::optional<ColouredResult> find_result(const SceneContents& contents, const PresentedResult& wanted) {
    std::optional<ColouredResult> found;
    for (std::size_t r = 0; r < contents.results.size(); ++r) {
        const SceneResult& result = contents.results[r];
        if (result.values.empty() || (result.quantity != wanted.name && result.id != wanted.name)) continue;
        const auto component = std::ranges::find(result.components, wanted.component);
        const bool has = component != result.components.end();
        const bool magnitude = wanted.component == "magnitude" && result.shape == Shape::Vector;
        if (!has && !magnitude) continue;
        const bool scalar = result.components.size() == 1;
        if (found && !(scalar && contents.results[found->result].components.size() > 1)) continue;
        ColouredResult hit;
        hit.result = r;
        hit.component = has ? static_cast<int>(component - result.components.begin()) : -1;
        hit.component_name = wanted.component;
        const auto at_step = std::ranges::find(result.values, contents.shown_step, &SceneValues::step);
        hit.values = at_step == result.values.end()
                         ? result.values.size() - 1
                         : static_cast<std::size_t>(at_step - result.values.begin());
        found = hit;
    }
    return found;
}

ValueRange range_for(
    const SceneContents& contents, const ColouredResult& hit, const PresentedResult& wanted
) {
    const SceneValues& values = contents.results[hit.result].values[hit.values];
    ValueRange range{0, 1, wanted.scale};
    range.lo = wanted.lo ? *wanted.lo : values.min ? static_cast<double>(values.min->value) : 0;
    range.hi = wanted.hi ? *wanted.hi : values.max ? static_cast<double>(values.max->value) : range.lo + 1;
    return range;
}

double component_value(const SurfaceField& field, std::size_t vertex, int component) {
    const float* row = field.values.data() + vertex * field.component_count;
    if (component >= 0) return static_cast<double>(row[component]);
    const double x = row[0], y = row[1], z = row[2];
    return std::sqrt(x * x + y * y + z * z);
}

/// Outwards, so that no value changes sides at the ends of the range.
float on_texcoord_grid(float u) {
    const float pieces = u / gltf::kTexcoordGrid;
    return (u > 15.0F / 16 ? std::ceil(pieces) : std::floor(pieces)) * gltf::kTexcoordGrid;
}

}  // namespace

void choose_coloured(SceneBuild& build) {
    const Presentation& presentation = build.contents.presentation;
    const auto effect_of = [&](const std::string& key) {
        return std::ranges::find_if(presentation.effects, [&](const PresentedEffect& effect) {
            return effect.result == key && effect.sense == Sense::Colour;
        });
    };
    for (const bool with_effect : {true, false}) {
        for (const PresentedResult& wanted : presentation.results) {
            const auto effect = effect_of(wanted.key);
            if ((effect != presentation.effects.end()) != with_effect) continue;
            std::optional<ColouredResult> hit = find_result(build.contents, wanted);
            if (!hit || build.coloured.size() == kMostColoured) continue;
            hit->range = range_for(build.contents, *hit, wanted);
            if (with_effect) hit->effect = effect->colour;
            build.coloured.push_back(std::move(*hit));
        }
    }
}

double value_at(double t, const ValueRange& range) {
    const auto [lo, hi] = axis_ends(range);
    if (t == 0 && range.scale != Scale::Signed) return range.lo;
    if (t == 1 && range.scale != Scale::Signed) return range.hi;
    return from_axis(lo + t * (hi - lo), range);
}

std::array<float, 2> texcoord_of(double value, const ValueRange& range) {
    if (!std::isfinite(value)) return {0.5F, 1.0F};
    const double t = position_of(value, range);
    double u = 1.0 / 16 + 14.0 / 16 * t;
    constexpr double kInset = 1.0 / 32768;  // 2^-15: a value at lo or hi stays inside the palette
    if (t >= 0 && t <= 1)
        u = std::min(u + kInset, 15.0 / 16 - kInset);
    else
        u = std::clamp(u, -15.0, 16.0);
    const auto place = static_cast<float>(u);
    // Rounded to float32, a value hardly outside would stand on the border and be drawn as one inside.
    if (t < 0) return {std::min(place, std::nextafter(1.0F / 16, 0.0F)), 0.0F};
    if (t > 1) return {std::max(place, std::nextafter(15.0F / 16, 1.0F)), 0.0F};
    return {place, 0.0F};
}

void write_texcoords(SceneBuild& build, const SurfaceField& field, std::size_t set) {
    const ColouredResult& coloured = build.coloured[set];
    for (ScenePartBuild& part : build.parts) {
        const std::size_t first = part.range->first_vertex;
        const std::string semantic = fmt::format("TEXCOORD_{}", set);
        ArraySpec spec{part.prefix + semantic, 2, part.range->vertex_count, gltf::kAttributeTarget, false};
        spec.grid = build.grid > 0 ? gltf::kTexcoordGrid : 0;
        const int accessor = build.arrays.floats(spec, [&](std::size_t row, float* out) {
            const bool missing = field.validity[first + row] == Validity::Missing;
            const double value = missing ? NAN : component_value(field, first + row, coloured.component);
            std::ranges::copy(texcoord_of(value, coloured.range), out);
            if (spec.grid > 0) out[0] = on_texcoord_grid(out[0]);
        });
        part.mesh.primitive.attributes.emplace_back(semantic, accessor);
    }
}

}  // namespace feelem
