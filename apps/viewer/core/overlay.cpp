// SPDX-License-Identifier: Apache-2.0
// What stands at a place of the model goes with it: places are those of the drawn shape, and what a cut took
// away or a hidden part bears has no mark.
#include "viewer/core/overlay.hpp"

#include "viewer/core/handles.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr Rgb kWhite{255, 255, 255}, kBeam{223, 238, 240}, kRingColour{116, 201, 198};
constexpr Rgb kBarColour{165, 180, 188}, kKnobColour{208, 22, 127}, kGhostColour{110, 120, 126};
constexpr Rgb kLargest{255, 170, 60}, kSmallest{90, 180, 255}, kNoteColour{255, 224, 130},
    kAlarm{255, 0, 255};
constexpr float kBeamWidth = 0.0024F, kHandDot = 0.006F, kBarWidth = 0.022F, kKnobRadius = 0.018F;
constexpr float kWalkRing = 0.205F, kGhostRadius = 0.02F;
/// Of marks on the model, a part of the distance from the eye: as large for it at any distance.
constexpr float kMarkAngle = 0.006F, kOfferAngle = 0.03F, kReticleAngle = 0.008F;
/// Labels stand off the place, a part of the distance.
constexpr float kLabelAngle = 0.035F, kNearest = 0.2F;

/// Collects for one frame.
class Gatherer {
public:
    explicit Gatherer(const OverlaySource& source) : source_(source) {}

    void dot(const glm::vec3& at, float size, const Rgb& colour) {
        out_.marks.push_back({Mark::Kind::Dot, at, {0, 1, 0}, size, colour});
    }
    void ring(const glm::vec3& at, const glm::vec3& normal, float size, const Rgb& colour) {
        out_.marks.push_back({Mark::Kind::Ring, at, normal, size, colour});
    }
    void line(const glm::vec3& from, const glm::vec3& to, float width, const Rgb& colour) {
        out_.marks.push_back({Mark::Kind::Line, from, to, width, colour});
    }
    void label(const glm::vec3& at, std::string text, const Rgb& colour, float upwards) {
        Label label;
        const float far = distance(at);
        // A little nearer to the eye, so that the model does not hide it.
        label.place = glm::mix(at, source_.input.head.position, 0.03F);
        label.place.y += upwards * kLabelAngle * far;
        label.text = std::move(text);
        label.colour = colour;
        out_.labels.push_back(std::move(label));
    }
    float distance(const glm::vec3& at) const {
        return std::max(glm::distance(at, source_.input.head.position), kNearest);
    }
    glm::vec3 towards_eye(const glm::vec3& at) const {
        const glm::vec3 way = source_.input.head.position - at;
        return glm::length(way) > 1e-6F ? glm::normalize(way) : glm::vec3(0, 0, 1);
    }
    Overlay take() { return std::move(out_); }

private:
    const OverlaySource& source_;
    Overlay out_;
};

struct MarkedPlace {
    std::size_t part = 0;
    std::uint32_t vertex = 0;
    glm::vec3 world{0};
};

std::optional<MarkedPlace> place_of_corner(const OverlaySource& source, std::optional<std::size_t> corner) {
    if (!corner) return std::nullopt;
    const std::uint32_t vertex = source.model.vertex_at(*corner);
    const std::size_t part = source.model.part_of_triangle(*corner / 3);
    if (!source.prober.is_there(part, vertex)) return std::nullopt;
    return MarkedPlace{part, vertex, source.prober.drawn_at(vertex)};
}

void mark_extreme(const OverlaySource& source, Gatherer& out, const PresentedResult& seen, bool largest) {
    const Scene& scene = source.model.about();
    const auto field = find_field(scene, seen, source.state.step);
    if (!field || scene.results[field->result].components.size() != 1) return;
    const SceneResult& result = scene.results[field->result];
    const auto& stated = largest ? result.values[field->values].max : result.values[field->values].min;
    if (!stated) return;
    std::optional<std::size_t> corner;
    if (result.location == Location::Elemental) {
        const auto triangle = source.model.triangle_of_element(stated->id);
        if (triangle) corner = 3 * *triangle;
    } else {
        corner = source.model.corner_of_node(stated->id);
    }
    const auto place = place_of_corner(source, corner);
    if (!place) return;
    const Rgb& colour = largest ? kLargest : kSmallest;
    const std::string value = source.value_text(static_cast<double>(stated->value), unit_of(scene, seen));
    out.dot(place->world, kMarkAngle * out.distance(place->world), colour);
    out.label(place->world, (largest ? "MX " : "MN ") + value, colour, largest ? 1.0F : -1.0F);
}

void mark_values(const OverlaySource& source, Gatherer& out) {
    const PresentedResult* seen = result_of(source.state.presentation, Sense::Colour);
    if (source.state.extremes && seen != nullptr) {
        mark_extreme(source, out, *seen, true);
        mark_extreme(source, out, *seen, false);
    }
    for (std::size_t i = 0; source.state.hot.shown && i < source.spots.size(); ++i) {
        const HotSpot& spot = source.spots[i];
        if (!source.prober.is_there(spot.part, spot.vertex)) continue;
        const glm::vec3 at = source.prober.drawn_at(spot.vertex);
        out.dot(at, kMarkAngle * out.distance(at), kWhite);
        out.label(at, std::to_string(i + 1), kWhite, 1);
    }
}

void mark_notes(const OverlaySource& source, Gatherer& out) {
    const Scene& scene = source.model.about();
    const PresentedResult* seen = result_of(source.state.presentation, Sense::Colour);
    const auto field =
        seen != nullptr ? find_field(scene, *seen, source.state.step) : std::optional<FieldChoice>();
    const FieldSpan span = field ? source.model.values(*field) : FieldSpan{};
    for (const Marker& marker : source.state.markers) {
        const auto place = place_of_corner(source, source.model.corner_of_node(marker.node));
        if (!place) continue;
        std::string text = std::to_string(marker.id);
        if (!marker.text.empty()) text += " " + marker.text;
        if (span.components > 0) {
            const float value = span.values[place->vertex * span.components + field->component];
            text += "  " + source.value_text(static_cast<double>(value), unit_of(scene, *seen));
        }
        out.dot(place->world, kMarkAngle * out.distance(place->world), kNoteColour);
        out.label(place->world, std::move(text), kNoteColour, 1);
    }
}

/// The label of the limit that is passed where somebody points.
void mark_limit(const OverlaySource& source, Gatherer& out) {
    if (!source.snapshot.probed) return;
    for (const Reading& reading : source.snapshot.probed->readings) {
        if (!reading.beyond_limit) continue;
        const auto& results = source.state.presentation.results;
        const auto result = std::ranges::find(results, reading.key, &PresentedResult::key);
        if (result == results.end() || !result->limit) continue;
        const std::string limit = source.value_text(*result->limit, unit_of(source.model.about(), *result));
        const std::string name = label_of(source.model.about(), *result);
        out.label(
            source.snapshot.probed->world, name + (result->limit_is_upper ? " > " : " < ") + limit, kAlarm, -1
        );
        return;
    }
}

void mark_hand(const OverlaySource& source, Gatherer& out, std::size_t side) {
    const HandState& hand = source.interaction.hands[side];
    const HandInput& now = source.input.hands[side];
    const SkinHit* hit = nullptr;
    const PointerState& pointer = source.interaction.pointers[side + 1];
    if (pointer.hit) hit = &*pointer.hit;
    if (hand.ghost) out.dot(hand.ghost->position, kGhostRadius, kGhostColour);
    if (now.is_tracked && hand.ray_length) {
        const Ray ray = ray_of(now.aim);
        out.line(ray.origin, ray.origin + *hand.ray_length * ray.direction, kBeamWidth, kBeam);
    }
    if (hit == nullptr) return;
    out.dot(hit->world, kHandDot, kWhite);
    if (hand.ring <= 0) return;
    const float size = kOfferAngle * out.distance(hit->world) * hand.ring;
    out.ring(hit->world, out.towards_eye(hit->world), size, kRingColour);
}

void mark_pointers(const OverlaySource& source, Gatherer& out) {
    const PointerState& mouse = source.interaction.pointers[static_cast<std::size_t>(Pointer::Mouse)];
    if (mouse.hit) {
        const float size = kReticleAngle * out.distance(mouse.hit->world);
        out.ring(mouse.hit->world, mouse.hit->normal, size, kWhite);
    }
    const PointerState& pin = source.interaction.pointers[static_cast<std::size_t>(Pointer::Pin)];
    if (pin.hit) {
        const float far = out.distance(pin.hit->world);
        out.dot(pin.hit->world, kMarkAngle * far, kRingColour);
        out.ring(pin.hit->world, out.towards_eye(pin.hit->world), 2 * kMarkAngle * far, kRingColour);
    }
    for (std::size_t side = 0; side < kSides; ++side) mark_hand(source, out, side);
    if (source.interaction.inside) {
        out.dot(*source.interaction.inside, kMarkAngle * out.distance(*source.interaction.inside), kAlarm);
        out.label(*source.interaction.inside, "inside the material: no value", kWhite, 1);
    }
}

void mark_handles(const OverlaySource& source, Gatherer& out) {
    for (const auto& knob : knobs_of(source.state, source.model)) {
        const float size = source.input.is_headset || !knob ? kKnobRadius : kKnobRadius * out.distance(*knob);
        if (knob) out.dot(*knob, size, kKnobColour);
    }
    if (source.interaction.ring) out.ring(*source.interaction.ring, {0, 1, 0}, kWalkRing, kRingColour);
    if (!source.input.is_headset) return;
    const auto [left, right] = bar_of(source.state, source.model, source.input.head.position);
    out.line(left, right, kBarWidth, kBarColour);
}

}  // namespace

Overlay make_overlay(const OverlaySource& source) {
    Gatherer out(source);
    mark_values(source, out);
    mark_notes(source, out);
    mark_pointers(source, out);
    mark_limit(source, out);
    mark_handles(source, out);
    return out.take();
}

}  // namespace feelem::viewer
