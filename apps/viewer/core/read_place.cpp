// SPDX-License-Identifier: Apache-2.0
// Values at a place of the skin, as feelem::probe() reads them.
#include "pick/place_value.hpp"
#include "viewer/core/probe.hpp"
#include "viewer/core/viewer_state.hpp"

#include <cmath>
#include <limits>

namespace feelem::viewer {
namespace {

TrianglePlace place_on(const ViewedModel& model, const SkinHit& hit) {
    const ModelArrays& arrays = model.arrays();
    return {arrays.triangles[arrays.parts[hit.part].first_triangle + hit.triangle], hit.weights};
}

Reading read_result(
    const ViewerState& state,
    const ViewedModel& model,
    const TrianglePlace& place,
    const PresentedResult& result,
    FieldChoice field
) {
    Reading reading;
    reading.key = result.key;
    reading.field = field;
    reading.value = std::numeric_limits<double>::quiet_NaN();
    reading.state = "missing";
    const FieldSpan span = model.values(field);
    if (span.components > 0) {
        const FieldView view{span.values, span.validity, span.components};
        const PlaceValue read = value_at(place, model.arrays().node_ids, view, field.component);
        if (read.value) reading.value = *read.value;
        reading.node_value = read.node_value;
        reading.state = read.state;
    }
    reading.at = normalise(reading.value, range_at(state, model, result));
    reading.beyond_limit = !std::isnan(reading.value) && is_past_limit(reading.value, result);
    return reading;
}

}  // namespace

std::optional<std::int64_t> node_of(const ViewedModel& model, const SkinHit& hit) {
    const auto vertex = nearest_vertex(place_on(model, hit), model.arrays().node_ids);
    return vertex ? std::optional(model.arrays().node_ids[*vertex]) : std::nullopt;
}

Probed read_place(const ViewerState& state, const ViewedModel& model, const SkinHit& hit) {
    const ModelArrays& arrays = model.arrays();
    const TrianglePlace place = place_on(model, hit);
    Probed probed;
    probed.part = hit.part;
    probed.triangle = hit.triangle;
    probed.weights = hit.weights;
    probed.world = hit.world;
    probed.normal = hit.normal;
    probed.model = point_of(place, arrays.positions, model.about().origin);
    probed.element_id = arrays.element_ids[arrays.parts[hit.part].first_triangle + hit.triangle];
    probed.node_id = node_of(model, hit);
    for (const PresentedResult& result : state.presentation.results) {
        auto field = find_field(model.about(), result, state.step);
        if (!field) field = find_component(model.about(), result);
        if (field) probed.readings.push_back(read_result(state, model, place, result, *field));
    }
    return probed;
}

}  // namespace feelem::viewer
