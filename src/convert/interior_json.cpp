// SPDX-License-Identifier: Apache-2.0
#include "convert/interior_json.hpp"

#include "scene/json_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace feelem {
namespace {

template <class Values, class Each>
void add_array(JsonText& json, std::string_view key, const Values& values, Each each) {
    json.key(key).begin_array();
    for (const auto& value : values) each(value);
    json.end_array();
}

/// As the float prints, not the double that it becomes.
void add_number(JsonText& json, float number) {
    if (std::isfinite(number)) {
        json.raw(fmt::format("{}", number));
    } else {
        json.null();
    }
}

void add_element(JsonText& json, const Mesh& mesh, const InteriorPlace& place) {
    const ElementRef element = element_at(mesh, place.element);
    json.member("element", raw(element.id()))
        .member("type", element_row(element.block->type).name)
        .member("part", std::string_view(mesh.parts[raw(element.part())].name));
    add_array(json, "natural", place.natural, [&](double v) { json.value(v); });
    add_array(json, "nodes", place.nodes, [&](NodeIndex node) { json.value(raw(mesh.node_ids[raw(node)])); });
    add_array(json, "weights", place.weights, [&](double v) { json.value(v); });
}

}  // namespace

std::string interior_json(
    const Mesh& mesh,
    const Point3& place,
    const std::optional<InteriorPlace>& found,
    std::span<const InteriorReading> readings
) {
    JsonText json;
    json.begin_object().member("version", 1);
    add_array(json, "place", place, [&](double v) { json.value(v); });
    if (found) {
        add_element(json, mesh, *found);
    } else {
        json.key("element").null();
    }
    json.key("results").begin_array();
    for (const InteriorReading& reading : readings) {
        json.begin_object().member("result", reading.result).member("component", reading.component);
        json.key("unit").text_or_null(reading.unit);
        json.key("value");
        if (found) {
            add_number(json, reading.value.value);
        } else {
            json.null();
        }
        json.member("elemental", reading.is_elemental);
        add_array(json, "nodeValues", reading.value.node_values, [&](float v) { add_number(json, v); });
        json.end_object();
    }
    json.end_array().end_object();
    return json.text() + "\n";
}

}  // namespace feelem
