// SPDX-License-Identifier: Apache-2.0
// Must: let a lost hand hear and feel nothing, and move nothing when it comes back. How: presses are edges of
// this frame against the last one in which the hand was seen.
#include "viewer/core/hands.hpp"

#include "viewer/core/grab.hpp"
#include "viewer/core/handles.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// Of trigger and squeeze, with some play.
constexpr float kPressAt = 0.55F, kReleaseAt = 0.45F;
/// Of a stick: so that a trembling thumb is one push.
constexpr float kPushAt = 0.7F, kPushEnd = 0.4F;
constexpr float kRayLength = 4;
/// Metres that one can go at once, and that a ray is looked along for the floor.
constexpr float kFurthestWalk = 6, kFurthestAim = 9;
/// Seconds that a pinch rests before a note is offered, and that the offer stays; metres of the same place.
constexpr double kRestSeconds = 0.6, kOfferSeconds = 1.2;
constexpr float kSamePlace = 0.02F;

bool squeezed(float value, bool before) {
    return value >= (before ? kReleaseAt : kPressAt);
}

int pushed(float value, int before) {
    if (std::abs(value) < (before == 0 ? kPushAt : kPushEnd)) return 0;
    return value > 0 ? 1 : -1;
}

std::optional<glm::vec3> floor_under(const Ray& ray) {
    if (ray.direction.y > -1e-3F) return std::nullopt;
    const float far = -ray.origin.y / ray.direction.y;
    if (!(far >= 0) || far > kFurthestAim) return std::nullopt;
    glm::vec3 at = ray.origin + far * ray.direction;
    at.y = 0.005F;
    return at;
}

/// The room comes to the person by as much as they go.
void walk_to_ring(InteractionFrame& frame) {
    if (!frame.interaction.ring) return;
    glm::vec3 way = *frame.interaction.ring - frame.input.head.position;
    frame.interaction.ring.reset();
    way.y = 0;
    const float far = glm::length(way);
    if (far > kFurthestWalk) way *= kFurthestWalk / far;
    frame.state.placement = glm::translate(glm::mat4(1), -way) * frame.state.placement;
}

void press_pointing_hand(InteractionFrame& frame, std::size_t side) {
    const HandInput& now = frame.input.hands[side];
    HandState& hand = frame.interaction.hands[side];
    const int x = pushed(now.stick.x, hand.stick_x), y = pushed(now.stick.y, hand.stick_y);
    if (now.lower_button && !hand.before.lower_button) frame.notes[side] = true;
    if (now.upper_button && !hand.before.upper_button) frame.interaction.menu_asked = true;
    if (now.stick_pressed && !hand.before.stick_pressed) frame.state.stand.reset();
    if (x != 0 && hand.stick_x == 0) {
        const auto degrees = static_cast<float>(-x) * kTurnDegrees;
        frame.state.placement = turned_about(frame.state.placement, frame.input.head.position, degrees);
    }
    if (y == 1) {
        frame.interaction.ring = floor_under(ray_of(now.aim));
    } else if (hand.stick_y == 1) {
        walk_to_ring(frame);
    }
    hand.stick_x = x;
    hand.stick_y = y;
}

void press_other_hand(InteractionFrame& frame, std::size_t side) {
    const HandInput& now = frame.input.hands[side];
    HandState& hand = frame.interaction.hands[side];
    const int x = pushed(now.stick.x, hand.stick_x);
    if (now.lower_button) carry_cut(frame.state, frame.model, ray_of(now.aim));
    if (now.upper_button && !hand.before.upper_button) next_result(frame.state, frame.model);
    if (now.stick_pressed && !hand.before.stick_pressed) frame.state.sound = !frame.state.sound;
    if (x != 0 && hand.stick_x == 0) step_by(frame.state, frame.model, x);
    hand.stick_x = x;
    hand.stick_y = 0;
}

/// Seconds are those of the frame. True while the hand is there.
bool follow_hand(HandState& hand, const HandInput& now, double seconds) {
    if (now.is_tracked) {
        const bool is_back = !hand.before.is_tracked;
        hand.ghost.reset();
        if (!is_back) return true;
        // What was pressed while nobody saw it is not a press.
        hand.before = now;
        hand.trigger_down |= squeezed(now.trigger, false);
        hand.squeeze_down |= squeezed(now.squeeze, false);
        return true;
    }
    if (hand.before.is_tracked) {
        hand.lost_since = seconds;
        hand.ghost = hand.before.grip;
        hand.before.is_tracked = false;
    }
    hand.touches = false;
    hand.ray_length.reset();
    hand.rest_at.reset();
    hand.ring = 0;
    hand.stick_x = hand.stick_y = 0;
    if (seconds - hand.lost_since <= kGhostSeconds) return false;
    hand.ghost.reset();
    hand.holds = Holds::Nothing;
    hand.grips = false;
    return false;
}

float meet_ray_length(const std::optional<SkinHit>& hit, std::optional<float> on_bar) {
    if (hit) return static_cast<float>(hit->distance);
    return on_bar.value_or(kRayLength);
}

/// A pinch that rests on the model is offered a note: 0: none.
float offer_at(HandState& hand, const std::optional<SkinHit>& hit, double seconds) {
    if (!hit || hand.holds != Holds::Model) {
        hand.rest_at.reset();
        return 0;
    }
    if (!hand.rest_at || glm::distance(*hand.rest_at, hit->world) > kSamePlace) {
        hand.rest_at = hit->world;
        hand.rest_since = seconds;
    }
    const double rested = seconds - hand.rest_since - kRestSeconds;
    if (rested < 0 || rested > kOfferSeconds) return 0;
    return std::min(static_cast<float>(0.35 + rested / 0.3), 1.0F);
}

struct HandAim {
    Pointer pointer;
    Ray ray;
    std::optional<SkinHit> hit;
    std::optional<float> on_bar;
};

/// The nearest of panel, knob, bar and model is what is meant; a touch goes before all.
void take(InteractionFrame& frame, std::size_t side, const HandAim& aim) {
    const HandInput& now = frame.input.hands[side];
    HandState& hand = frame.interaction.hands[side];
    if (hand.holds == Holds::Panel) return;
    if (!hand.touches && take_knob(frame, aim.pointer, aim.ray)) {
        hand.holds = Holds::Knob;
        return;
    }
    const bool by_bar =
        !hand.touches && aim.on_bar && (!aim.hit || static_cast<double>(*aim.on_bar) < aim.hit->distance);
    // Bare hands have no grip at hand: a pinch on nothing takes hold of the model too.
    const bool on_nothing = !aim.hit && now.is_bare;
    hand.holds = by_bar || on_nothing ? Holds::Carried : Holds::Model;
}

void let_go(InteractionFrame& frame, std::size_t side, const HandAim& aim) {
    HandState& hand = frame.interaction.hands[side];
    if (frame.interaction.knob && frame.interaction.knob->by == aim.pointer) frame.interaction.knob.reset();
    if (hand.holds == Holds::Model && hand.ring > 0 && aim.hit) {
        place_marker(frame.state, node_of(frame.model, *aim.hit));
    }
    hand.holds = Holds::Nothing;
    hand.rest_at.reset();
    hand.ring = 0;
}

HandAim aim_of(InteractionFrame& frame, std::size_t side) {
    const HandInput& now = frame.input.hands[side];
    HandState& hand = frame.interaction.hands[side];
    HandAim aim{kPointerOf[side], ray_of(now.aim), {}, {}};
    const std::optional<glm::vec3> tip =
        now.is_bare ? now.fingertip : std::optional<glm::vec3>(now.aim.position);
    if (tip) aim.hit = frame.prober.near(*tip, kTouchReach);
    hand.touches = aim.hit.has_value();
    if (hand.touches) return aim;
    if (now.panel_distance) {
        if (hand.holds == Holds::Nothing) hand.holds = Holds::Panel;
        return aim;
    }
    if (hand.holds == Holds::Panel && !hand.trigger_down) hand.holds = Holds::Nothing;
    const Cast cast = frame.prober.cast(aim.ray);
    aim.hit = cast.hit;
    if (cast.inside) frame.interaction.inside = cast.inside;
    aim.on_bar = meet_bar(aim.ray, bar_of(frame.state, frame.model, frame.input.head.position));
    return aim;
}

void point_hand(InteractionFrame& frame, std::size_t side) {
    const HandInput& now = frame.input.hands[side];
    HandState& hand = frame.interaction.hands[side];
    HandAim aim = aim_of(frame, side);
    const bool was_down = hand.trigger_down;
    hand.trigger_down = squeezed(now.trigger, was_down);
    if (hand.trigger_down && !was_down) take(frame, side, aim);
    if (!hand.trigger_down && was_down) let_go(frame, side, aim);
    if (hand.holds == Holds::Knob) {
        drag_knob(frame, aim.ray);
        aim.hit.reset();
    }
    if (hand.holds == Holds::Panel) aim.hit.reset();
    move_pointer(frame.interaction, aim.pointer, aim.hit);
    PointerState& pointer = frame.interaction.pointers[static_cast<std::size_t>(aim.pointer)];
    pointer.can_vibrate = now.can_vibrate;
    const bool by_touch = frame.state.person.by_touch && hand.touches;
    hold_pointer(frame, aim.pointer, hand.holds == Holds::Model || by_touch);
    hand.ring = now.is_bare ? offer_at(hand, aim.hit, frame.input.time) : 0;
    hand.ray_length.reset();
    if (!hand.touches) {
        hand.ray_length = now.panel_distance ? *now.panel_distance : meet_ray_length(aim.hit, aim.on_bar);
    }
    if (frame.notes[side] && aim.hit) place_marker(frame.state, node_of(frame.model, *aim.hit));
}

}  // namespace

void press_buttons(InteractionFrame& frame) {
    const std::size_t pointing = frame.state.person.left_handed ? 0 : 1;
    for (std::size_t side = 0; side < kSides; ++side) {
        const HandInput& now = frame.input.hands[side];
        HandState& hand = frame.interaction.hands[side];
        if (!follow_hand(hand, now, frame.input.time)) {
            move_pointer(frame.interaction, kPointerOf[side], std::nullopt);
            hold_pointer(frame, kPointerOf[side], false);
            if (side == pointing) frame.interaction.ring.reset();
            continue;
        }
        if (now.menu && !hand.before.menu) frame.interaction.menu_asked = true;
        if (side == pointing) {
            press_pointing_hand(frame, side);
        } else {
            press_other_hand(frame, side);
        }
        const bool was_down = hand.squeeze_down;
        hand.squeeze_down = squeezed(now.squeeze, was_down);
        hand.grips = hand.squeeze_down && (hand.grips || !was_down);
        hand.before = now;
    }
}

void carry_model(InteractionFrame& frame) {
    Interaction& interaction = frame.interaction;
    bool is_other = false;
    std::array<std::size_t, kSides> holders{};
    std::size_t count = 0;
    for (std::size_t side = 0; side < kSides; ++side) {
        HandState& hand = interaction.hands[side];
        const bool carries =
            frame.input.hands[side].is_tracked && (hand.grips || hand.holds == Holds::Carried);
        is_other |= carries != hand.carries;
        hand.carries = carries;
        if (carries) holders[count++] = side;
    }
    const auto grip = [&](std::size_t i) -> const Pose& { return frame.input.hands[holders[i]].grip; };
    const auto from = [&](std::size_t i) -> Pose& { return interaction.hands[holders[i]].carried_from; };
    if (is_other) {
        // From now on hands move what is here now, from where they are now.
        interaction.held_placement = frame.state.placement;
        for (std::size_t i = 0; i < count; ++i) from(i) = grip(i);
    }
    if (count == 1) frame.state.placement = carry(interaction.held_placement, from(0), grip(0));
    if (count == 2) {
        frame.state.placement = carry_with_two(
            interaction.held_placement,
            {from(0).position, from(1).position},
            {grip(0).position, grip(1).position},
            frame.state.person.upright
        );
    }
}

void point_hands(InteractionFrame& frame) {
    for (std::size_t side = 0; side < kSides; ++side) {
        if (frame.input.hands[side].is_tracked) point_hand(frame, side);
    }
}

void let_go_of_all(InteractionFrame& frame) {
    Interaction& interaction = frame.interaction;
    for (std::size_t side = 0; side < kSides; ++side) {
        const HandInput& now = frame.input.hands[side];
        HandState& hand = interaction.hands[side];
        hand = HandState{};
        hand.before = now;
        hand.trigger_down = squeezed(now.trigger, true);
        hand.squeeze_down = squeezed(now.squeeze, true);
    }
    for (PointerState& pointer : interaction.pointers) {
        pointer.hit.reset();
        pointer.is_held = false;
    }
    interaction.knob.reset();
    interaction.ring.reset();
    interaction.mouse_probes = false;
    interaction.mouse_down = frame.input.pointer.primary;
}

}  // namespace feelem::viewer
