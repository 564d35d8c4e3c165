// SPDX-License-Identifier: Apache-2.0
// `feelem probe`: every result at one place, as the page's card shows it.
#include "bound_text.hpp"
#include "command.hpp"
#include "scene_input.hpp"

#include "feelem/probe.hpp"

#include <fmt/format.h>

namespace feelem::cli {
namespace {

void print_place(const ProbedPlace& place) {
    fmt::print("Point    {:g}, {:g}, {:g}\n", place.point[0], place.point[1], place.point[2]);
    fmt::print("Part     {}\n", place.part);
    fmt::print("Element  {}\n", place.element_id);
    fmt::print("Node     {}\n", place.node_id ? std::to_string(*place.node_id) : "none");
    if (const auto& step = place.step) {
        fmt::print("Step     {}.{}, {} {:g}\n", step->step, step->substep, word(step->kind), step->value);
    }
    for (const ProbedValue& value : place.results) {
        const std::string name = value.component == "value" ? value.name : value.name + " " + value.component;
        const std::string number = value.value ? fmt::format("{:.7g}", *value.value) : "no value";
        const std::string node = value.node_value ? fmt::format("{}", *value.node_value) : "no value";
        const std::string bound = value.bound > 0 ? ", within " + bound_text(value.bound) : "";
        fmt::print(
            "{:<24} {}{:<14} {:<6} at node {}{}\n",
            name,
            value.state == "interpolated" ? "~" : " ",
            number,
            value.unit.empty() ? "-" : value.unit,
            node,
            bound
        );
    }
    if (const auto& rgb = place.colour) {
        fmt::print("Seen     #{:02x}{:02x}{:02x}\n", (*rgb)[0], (*rgb)[1], (*rgb)[2]);
    }
    if (place.tone) fmt::print("Heard    {:.2f} Hz, gain {:.3f}\n", place.tone->hz, place.tone->gain);
    if (place.tick_rate) fmt::print("Ticks    {:.2f} a second\n", *place.tick_rate);
    if (place.pulse) {
        fmt::print(
            "Felt     {:.2f} pulses a second, amplitude {:.3f}\n", place.pulse->rate, place.pulse->amplitude
        );
    }
}

}  // namespace

int run_probe(const Options& options) {
    const int given = (options.node ? 1 : 0) + (options.point ? 1 : 0) + (options.ray ? 1 : 0);
    if (given != 1)
        throw UsageError("probe needs one place: --node ID, --point X,Y,Z or --ray OX,OY,OZ,DX,DY,DZ");
    const SceneInput scene(options);
    if (scene.path().empty()) return 1;
    // A scene made for this run holds the steps that were asked for and no other.
    std::string steps = options.job.steps;
    if (scene.is_made() && !steps.empty()) steps = "all";
    const std::vector<ProbedPlace> places =
        probe(load_scene(scene.path()), {options.node, options.point, options.ray, steps});
    if (options.json) {
        fmt::print("{}", probe_json(places));
        return 0;
    }
    if (places.empty()) fmt::print("The ray meets nothing.\n");
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0) fmt::print("\n");
        print_place(places[i]);
    }
    return 0;
}

}  // namespace feelem::cli
