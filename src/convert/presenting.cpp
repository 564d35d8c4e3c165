// SPDX-License-Identifier: Apache-2.0
#include "convert/presenting.hpp"

#include "base/input.hpp"
#include "base/nearest_name.hpp"
#include "convert/prepared_source.hpp"
#include "convert/scene_target.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace feelem {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t values_at(const PlannedResult& planned, std::size_t step) {
    for (std::size_t i = 0; i < planned.values.size(); ++i) {
        if (planned.values[i].step == step) return i;
    }
    return kNone;
}

std::vector<std::string> presentable(const ScenePlan& plan) {
    std::vector<std::string> names;
    for (const PlannedResult& planned : plan.results) {
        for (const std::string& component : planned.components) {
            names.push_back(planned.scene.quantity + "." + component);
        }
    }
    return names;
}

std::optional<SceneTarget> find_target(const ScenePlan& plan, const PresentedResult& wanted) {
    std::vector<const SceneResult*> results;
    for (const PlannedResult& planned : plan.results) results.push_back(&planned.scene);
    return find_presented(results, wanted);
}

std::vector<Candidate> candidates(const SceneInMaking& scene, std::size_t step) {
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < scene.plan.results.size(); ++i) {
        const PlannedResult& planned = scene.plan.results[i];
        const std::size_t values = values_at(planned, step);
        if (values == kNone || planned.components.size() != 1) continue;
        const bool is_plain =
            planned.scene.complex == Complex::No || planned.scene.complex == Complex::Amplitude;
        const ComponentRange& range = scene.values.ranges(i, values).front();
        if (range.valid == 0 || !is_plain) continue;
        Candidate candidate;
        candidate.name = planned.scene.quantity;
        candidate.component = planned.components.front();
        candidate.unit = planned.scene.unit;
        candidate.has_sign = range.min < 0 && range.max > 0;
        candidate.mostly_zero = 2 * range.zeros > range.valid;
        found.push_back(std::move(candidate));
    }
    return found;
}

/// Smallest and largest value over the whole model, at one step or at all.
std::array<double, 2> model_range(const SceneInMaking& scene, const SceneTarget& target, std::size_t values) {
    const std::size_t count = scene.plan.results[target.result].values.size();
    double lo = 0, hi = 0;
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (values != kNone && i != values) continue;
        const ComponentRange& range = scene.values.ranges(target.result, i)[target.component];
        if (range.valid == 0) continue;
        lo = any ? std::min<double>(lo, static_cast<double>(range.min)) : static_cast<double>(range.min);
        hi = any ? std::max<double>(hi, static_cast<double>(range.max)) : static_cast<double>(range.max);
        any = true;
    }
    return {lo, hi};
}

void resolve_range(
    const SceneInMaking& scene, const SceneTarget& target, std::size_t step, PresentedResult& shown
) {
    if (shown.range_mode == "manual" && shown.lo && shown.hi) return;
    const PlannedResult& planned = scene.plan.results[target.result];
    std::size_t values = values_at(planned, step);
    if (values == kNone) values = 0;  // Not there at the step shown: its range is that of its first step.
    std::array<double, 2> range = model_range(scene, target, shown.range_mode == "allSteps" ? kNone : values);
    if (shown.range_mode == "percentile") {
        std::vector<float> all =
            solver_values(scene.surface, scene.values.field(target.result, values), target.component);
        if (!all.empty()) {
            range[0] = static_cast<double>(nearest_rank(all, shown.percentile[0]));
            range[1] = static_cast<double>(nearest_rank(all, shown.percentile[1]));
        }
    }
    if (shown.range_mode == "manual") {  // One end is the user's.
        if (shown.lo) range[0] = *shown.lo;
        if (shown.hi) range[1] = *shown.hi;
    }
    if (shown.symmetric) {
        range[1] = std::max(std::abs(range[0]), std::abs(range[1]));
        range[0] = -range[1];
    }
    shown.lo = range[0];
    shown.hi = range[1];
}

/// What the file says of a result must agree with the result.
void tie_to_scene(const SceneResult& scene, const std::string& file, PresentedResult& shown) {
    if (!shown.unit.empty() && !scene.unit.empty() && shown.unit != scene.unit) {
        throw Error(
            Code::BadPresentation,
            file,
            fmt::format(
                "result \"{}\" is given in {}, but {} is in {}", shown.key, shown.unit, shown.name, scene.unit
            )
        );
    }
    if (shown.unit.empty()) shown.unit = scene.unit;
    shown.location = word(scene.location);
}

Presentation read_or_choose(const SceneInMaking& scene, const std::string& file, const std::string& title) {
    if (!file.empty()) {
        const Input input = Input::from_file(file);
        return parse_presentation(input.text(), input.name());
    }
    const std::size_t step = choose_shown_step(scene.plan, {});
    return choose_presentation(candidates(scene, step), title);
}

}  // namespace

std::size_t choose_shown_step(const ScenePlan& plan, const Presentation& presentation) {
    if (presentation.step) {
        const auto [input, step, substep] = *presentation.step;
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {
            const Step& s = plan.steps[i];
            if (static_cast<int>(s.input) == input && s.step == step && s.substep == substep) return i;
        }
        for (std::size_t i = 0; i < plan.steps.size(); ++i) {  // Inputs in another order.
            if (plan.steps[i].step == step && plan.steps[i].substep == substep) return i;
        }
    }
    std::size_t best = 0, most = 0;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const StepKind kind = plan.steps[i].kind;
        if (kind == StepKind::Mode || kind == StepKind::Buckling || is_envelope(plan.steps[i])) continue;
        const auto count =
            static_cast<std::size_t>(std::ranges::count_if(plan.results, [&](const PlannedResult& r) {
                return values_at(r, i) != kNone;
            }));
        if (count < most) continue;
        most = count;
        best = i;
    }
    return best;
}

Presentation make_presentation(
    const SceneInMaking& scene, const std::string& file, const std::string& title
) {
    Presentation presentation = read_or_choose(scene, file, title);
    if (scene.plan.steps.empty()) return presentation;
    const std::size_t step = choose_shown_step(scene.plan, presentation);
    for (PresentedResult& shown : presentation.results) {
        const auto target = find_target(scene.plan, shown);
        if (!target) {
            const std::vector<std::string> names = presentable(scene.plan);
            const std::vector<std::string_view> views(names.begin(), names.end());
            throw Error(
                Code::BadPresentation,
                file,
                fmt::format(
                    "result \"{}\" asks for {}.{}, which the inputs do not have.{} They have: {}",
                    shown.key,
                    shown.name,
                    shown.component,
                    did_you_mean(shown.name + "." + shown.component, views),
                    fmt::join(names, ", ")
                )
            );
        }
        tie_to_scene(scene.plan.results[target->result].scene, file, shown);
        resolve_range(scene, *target, step, shown);
    }
    const Step& at = scene.plan.steps[step];
    presentation.step = std::array{static_cast<int>(at.input), at.step, at.substep};
    return presentation;
}

float nearest_rank(std::vector<float>& values, double percent) {
    std::ranges::sort(values);
    const double rank = std::ceil(percent / 100.0 * static_cast<double>(values.size()));
    const double last = static_cast<double>(values.size());
    return values[static_cast<std::size_t>(std::clamp(rank, 1.0, last)) - 1];
}

std::vector<float> solver_values(const Surface& surface, const SurfaceField& field, std::size_t component) {
    // Vertices are split at creases: the same (part, node) may stand there several times with one value.
    using Owner = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // part, node, element
    std::vector<std::pair<Owner, float>> all;
    for (const SurfacePart& part : surface.parts) {
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
            const float value = field.values[v * std::size_t{field.component_count} + component];
            if (field.validity[v] != Validity::Solver || std::isnan(value)) continue;
            const std::uint32_t element = surface.vertex_element.empty() ? 0 : raw(surface.vertex_element[v]);
            all.push_back({{raw(part.part), raw(surface.vertex_node[v]), element}, value});
        }
    }
    std::ranges::sort(all, {}, &std::pair<Owner, float>::first);
    std::vector<float> values;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == 0 || all[i].first != all[i - 1].first) values.push_back(all[i].second);
    }
    return values;
}

}  // namespace feelem
