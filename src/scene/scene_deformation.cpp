// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_deformation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace feelem {
namespace {

constexpr double kPeriod = 4;  ///< Seconds of one turn.

std::optional<ShapeResult> vector_at_step(
    const SceneContents& contents, const std::string& quantity, Complex complex
) {
    for (std::size_t r = 0; r < contents.results.size(); ++r) {
        const SceneResult& result = contents.results[r];
        const bool fits =
            result.shape == Shape::Vector && result.components.size() == 3 && result.complex == complex;
        if (!fits || (result.quantity != quantity && result.id != quantity)) continue;
        const auto at = std::ranges::find(result.values, contents.shown_step, &SceneValues::step);
        if (at != result.values.end())
            return ShapeResult{r, static_cast<std::size_t>(at - result.values.begin())};
    }
    return std::nullopt;
}

double largest_length(const SceneContents& contents, const ShapeResult& shape) {
    const SurfaceField field = contents.load(shape.result, shape.values);
    double most = 0;
    for (std::size_t i = 0; i + 2 < field.values.size(); i += 3) {
        const double x = field.values[i], y = field.values[i + 1], z = field.values[i + 2];
        const double length = std::sqrt(x * x + y * y + z * z);
        if (std::isfinite(length)) most = std::max(most, length);
    }
    return most;
}

/// Weight of a shape and its slope at a time: (1 - cos)/2, or for modes cos and -sin.
std::array<double, 2> weight_at(double seconds, bool is_mode, std::size_t shape) {
    const double speed = 2 * std::numbers::pi / kPeriod;
    const double angle = speed * seconds;
    if (!is_mode) return {(1 - std::cos(angle)) / 2, speed * std::sin(angle) / 2};
    if (shape == 0) return {std::cos(angle), -speed * std::sin(angle)};
    return {-std::sin(angle), -speed * std::cos(angle)};
}

}  // namespace

void choose_deformation(SceneBuild& build) {
    const SceneContents& contents = build.contents;
    const Presentation& presentation = contents.presentation;
    if (presentation.deformation_result.empty()) return;
    const auto shown =
        std::ranges::find(presentation.results, presentation.deformation_result, &PresentedResult::key);
    if (shown == presentation.results.end()) return;
    Deformation out;
    const auto real = vector_at_step(contents, shown->name, Complex::Real);
    const auto imaginary = vector_at_step(contents, shown->name, Complex::Imaginary);
    const auto plain = vector_at_step(contents, shown->name, Complex::No);
    if (plain)
        out.shapes = {*plain};
    else if (real && imaginary)
        out.shapes = {*real, *imaginary};
    else
        return;
    out.is_mode = contents.steps[contents.shown_step].kind == StepKind::Mode || out.shapes.size() == 2;
    if (presentation.deformation_factor) {
        out.factor = *presentation.deformation_factor;
    } else {
        double most = 0;
        for (const ShapeResult& shape : out.shapes) most = std::max(most, largest_length(contents, shape));
        out.factor = automatic_deformation_factor(build.box.largest(), most);
    }
    if (out.factor == 0 || !std::isfinite(out.factor)) return;
    out.name = fmt::format("deformation x{:.4g}", out.factor);
    build.deformation = std::move(out);
}

void write_animation(SceneBuild& build) {
    if (!build.deformation) return;
    const Deformation& deformation = *build.deformation;
    const std::size_t shapes = deformation.shapes.size();
    const std::size_t keys = deformation.is_mode ? 17 : 9;
    const auto time = [&](std::size_t key) {
        return static_cast<double>(
            static_cast<float>(kPeriod * static_cast<double>(key) / static_cast<double>(keys - 1))
        );
    };
    const int times = build.arrays.floats({"animation/times", 1, keys}, [&](std::size_t key, float* out) {
        *out = static_cast<float>(time(key));
    });
    // A key is in-tangents, values, out-tangents, each of them one number per shape.
    const ArraySpec spec{"animation/weights", 1, 3 * keys * shapes, 0, false};
    const int weights = build.arrays.floats(spec, [&](std::size_t i, float* out) {
        const auto [value, slope] = weight_at(time(i / (3 * shapes)), deformation.is_mode, i % shapes);
        *out = static_cast<float>(i / shapes % 3 == 1 ? value : slope);
    });
    gltf::Animation animation;
    animation.name = deformation.name;
    for (const ScenePartBuild& part : build.parts) {
        gltf::Mesh& mesh = build.document.meshes[static_cast<std::size_t>(
            build.document.nodes[static_cast<std::size_t>(part.node)].mesh
        )];
        mesh.weights.assign(shapes, 0);
        mesh.target_names = {deformation.name};
        if (shapes == 2) mesh.target_names = {deformation.name + ", real", deformation.name + ", imaginary"};
        animation.channels.push_back({part.node, times, weights});
    }
    build.document.animations.push_back(std::move(animation));
}

}  // namespace feelem
