// SPDX-License-Identifier: Apache-2.0
// The same reading as the page's: barycentric on the drawn triangle, the file's value at the nearest corner.
#include "feelem/probe.hpp"

#include "convert/scene_target.hpp"
#include "convert/selection.hpp"
#include "pick/place_value.hpp"

#include "feelem/error.hpp"
#include "feelem/pick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace feelem {
namespace {

struct Place {
    std::size_t part = 0;
    std::uint32_t triangle = 0;
    std::array<double, 3> weights{};
    double distance = 0;
};

/// A triangle corner at the node in each part that has it.
std::vector<Place> places_of_node(const Scene& scene, std::int64_t id) {
    std::vector<Place> places;
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const ScenePart& part = scene.parts[p];
        for (std::size_t t = 0; t < part.triangles.size() * 3; ++t) {
            if (part.node_ids[part.triangles[t / 3][t % 3]] != id) continue;
            Place place{p, static_cast<std::uint32_t>(t / 3)};
            place.weights[t % 3] = 1;
            places.push_back(place);
            break;
        }
    }
    if (places.empty()) {
        throw Error(
            Code::UnknownName,
            "",
            fmt::format("node {} is not on the skin: it is an inner node, or the model has no such node", id)
        );
    }
    return places;
}

std::vector<Place> nearest_place(const Scene& scene, const ProbeQuery& query) {
    std::optional<Place> best;
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const ScenePart& part = scene.parts[p];
        if (part.triangles.empty()) continue;
        const Picker picker(part.positions, part.triangles);
        std::optional<Hit> hit;
        const auto local = [&](double x, double y, double z) {
            return std::array{x - scene.origin[0], y - scene.origin[1], z - scene.origin[2]};
        };
        if (query.ray) {
            const auto& [ox, oy, oz, dx, dy, dz] = *query.ray;
            hit = picker.ray(local(ox, oy, oz), {dx, dy, dz});
        } else {
            const auto& [x, y, z] = *query.point;
            hit = picker.nearest(local(x, y, z));
        }
        if (hit && (!best || hit->distance < best->distance)) {
            best = Place{p, hit->triangle, hit->weights, hit->distance};
        }
    }
    return best ? std::vector{*best} : std::vector<Place>{};
}

TrianglePlace on_triangle(const ScenePart& part, const Place& place) {
    return {part.triangles[place.triangle], place.weights};
}

const SceneField* field_at(const Scene& scene, std::size_t result, std::size_t step, std::size_t part) {
    for (const SceneField& field : scene.fields) {
        if (field.result == result && field.step == step && field.part == part) return &field;
    }
    return nullptr;
}

ProbedValue probed_value(
    const Scene& scene, const Place& place, std::size_t step, SceneTarget target, std::string key
) {
    const SceneResult& result = scene.results[target.result];
    const ScenePart& part = scene.parts[place.part];
    ProbedValue value;
    value.key = std::move(key);
    value.name = result.quantity;
    value.component = result.components[target.component];
    value.unit = result.unit;
    value.state = "missing";
    value.bound = result.bound;
    const TrianglePlace here = on_triangle(part, place);
    if (const auto vertex = nearest_vertex(here, part.node_ids)) value.node_id = part.node_ids[*vertex];
    if (const SceneField* field = field_at(scene, target.result, step, place.part)) {
        const FieldView view{field->values, field->validity, result.components.size()};
        const PlaceValue read = value_at(here, part.node_ids, view, target.component);
        value.value = read.value;
        value.node_value = read.node_value;
        value.state = read.state;
    }
    return value;
}

std::size_t shown_step(const Scene& scene) {
    if (!scene.presentation.step) return 0;
    const auto [input, step, substep] = *scene.presentation.step;
    for (std::size_t i = 0; i < scene.steps.size(); ++i) {
        const Step& s = scene.steps[i];
        if (static_cast<int>(s.input) == input && s.step == step && s.substep == substep) return i;
    }
    return 0;
}

/// What the presentation makes of the values: each sense of the effect that drives it.
void fill_senses(const Presentation& presentation, ProbedPlace& place) {
    for (const PresentedEffect& effect : presentation.effects) {
        const auto shown = std::ranges::find(presentation.results, effect.result, &PresentedResult::key);
        const auto read = std::ranges::find(place.results, effect.result, &ProbedValue::key);
        if (shown == presentation.results.end() || read == place.results.end()) continue;
        const ValueRange range = value_range(*shown);
        const double value = read->value.value_or(std::nan(""));
        switch (effect.sense) {
        case Sense::Colour: place.colour = colour_of(value, range, effect.colour); break;
        case Sense::Pitch: place.tone = tone_of(value, range, effect.pitch); break;
        case Sense::Ticks: place.tick_rate = tick_rate_of(value, range, effect.ticks); break;
        case Sense::Pulses: place.pulse = pulse_of(value, range, effect.pulses); break;
        case Sense::Shape: break;
        }
    }
}

ProbedPlace read_place(const Scene& scene, const Place& place, std::size_t step) {
    const ScenePart& part = scene.parts[place.part];
    ProbedPlace out;
    out.part = part.name;
    out.element_id = part.element_ids[place.triangle];
    out.distance = place.distance;
    const TrianglePlace here = on_triangle(part, place);
    out.point = point_of(here, part.positions, scene.origin);
    if (const auto vertex = nearest_vertex(here, part.node_ids)) out.node_id = part.node_ids[*vertex];

    std::vector<const SceneResult*> results;
    for (const SceneResult& result : scene.results) results.push_back(&result);
    if (step < scene.steps.size()) out.step = scene.steps[step];
    std::set<std::pair<std::size_t, std::size_t>> done;
    for (const PresentedResult& shown : scene.presentation.results) {
        const auto target = find_presented(results, shown);
        if (!target) continue;
        done.insert({target->result, target->component});
        out.results.push_back(probed_value(scene, place, step, *target, shown.key));
    }
    for (std::size_t i = 0; i < results.size(); ++i) {
        for (std::size_t c = 0; c < results[i]->components.size(); ++c) {
            if (done.contains({i, c})) continue;
            out.results.push_back(probed_value(scene, place, step, {i, c}, results[i]->id));
        }
    }
    fill_senses(scene.presentation, out);
    return out;
}

}  // namespace

std::vector<ProbedPlace> probe(const Scene& scene, const ProbeQuery& query) {
    if (query.ray && (*query.ray)[3] == 0 && (*query.ray)[4] == 0 && (*query.ray)[5] == 0) {
        throw Error(Code::BadOption, "--ray", "the direction is 0,0,0");
    }
    const std::vector<Place> found =
        query.node ? places_of_node(scene, *query.node) : nearest_place(scene, query);
    std::vector<std::size_t> steps{shown_step(scene)};
    if (!query.steps.empty()) {
        Diagnostics none;  // Steps that are named are never left out.
        steps = select_steps(scene.steps, query.steps, DefaultSteps::All, none);
    }
    std::vector<ProbedPlace> places;
    for (const std::size_t step : steps) {
        for (const Place& place : found) places.push_back(read_place(scene, place, step));
    }
    return places;
}

}  // namespace feelem
