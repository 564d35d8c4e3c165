// SPDX-License-Identifier: Apache-2.0
// One frame of what a person does. First what moves the model, then, against the model as it is drawn now,
// where everybody points.
#include "viewer/core/interaction.hpp"

#include "viewer/core/handles.hpp"
#include "viewer/core/hands.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// Seconds between the two presses of a double press.
constexpr double kTwice = 0.4;
/// A hover counts as a move from so many metres on, so that a hand at rest does not take the word.
constexpr float kMoved = 0.005F;
/// After a pause (a window that was moved, a runtime that was gone) nothing jumps.
constexpr double kLongestFrame = 0.1;
/// Seconds that a notice stands.
constexpr double kNoticeSeconds = 6;

PointerState& pointer_of(Interaction& interaction, Pointer pointer) {
    return interaction.pointers[static_cast<std::size_t>(pointer)];
}

/// Node that a command without a place means.
std::optional<std::int64_t> meant_node(const Interaction& interaction, const ViewedModel& model) {
    const auto pointer = leading(interaction);
    if (!pointer) return interaction.chosen;
    return node_of(model, *interaction.pointers[static_cast<std::size_t>(*pointer)].hit);
}

/// What a device says of a place nobody knows may be no number.
bool is_finite_matrix(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
        }
    }
    return true;
}

/// A headset has come, or gone, or its room is to be laid out anew.
void settle(InteractionFrame& frame) {
    Interaction& interaction = frame.interaction;
    if (frame.input.is_headset != interaction.was_headset) {
        let_go_of_all(frame);
        if (frame.input.is_headset) frame.state.stand.reset();
    }
    interaction.was_headset = frame.input.is_headset;
    if (!frame.input.is_headset || frame.state.stand || !is_finite_matrix(matrix_of(frame.input.head)))
        return;
    frame.state.stand = stand_of(frame.input.head);
    put_on_table(frame.state, frame.model, *frame.state.stand);
    interaction.boards_moved = true;
}

void point_mouse(InteractionFrame& frame) {
    Interaction& interaction = frame.interaction;
    const PointerInput& mouse = frame.input.pointer;
    PointerState& pointer = pointer_of(interaction, Pointer::Mouse);
    pointer.can_vibrate = mouse.can_vibrate;
    const bool pressed = mouse.primary && !interaction.mouse_down;
    const bool released = !mouse.primary && interaction.mouse_down;
    interaction.mouse_down = mouse.primary;
    if (released) {
        interaction.mouse_probes = false;
        if (interaction.knob && interaction.knob->by == Pointer::Mouse) interaction.knob.reset();
    }
    if (!mouse.ray) {
        move_pointer(interaction, Pointer::Mouse, std::nullopt);
        hold_pointer(frame, Pointer::Mouse, false);
        return;
    }
    Cast cast = frame.prober.cast(*mouse.ray);
    if (pressed && !take_knob(frame, Pointer::Mouse, *mouse.ray)) {
        interaction.mouse_probes = cast.hit.has_value();
        const bool is_second = frame.input.time - interaction.pressed_at < kTwice;
        if (cast.hit && is_second) place_marker(frame.state, node_of(frame.model, *cast.hit));
        interaction.pressed_at = cast.hit && !is_second ? frame.input.time : -1;
    }
    if (interaction.knob && interaction.knob->by == Pointer::Mouse) {
        drag_knob(frame, *mouse.ray);
        cast = {};
    }
    if (cast.inside) interaction.inside = cast.inside;
    move_pointer(interaction, Pointer::Mouse, cast.hit);
    hold_pointer(frame, Pointer::Mouse, interaction.mouse_probes || frame.input.hold);
}

/// What was gone to is a pointer too, when nobody else points.
void point_pin(InteractionFrame& frame) {
    std::optional<SkinHit> hit;
    if (frame.state.pin && frame.prober.is_ready()) {
        const auto corner = frame.model.corner_of_node(*frame.state.pin);
        if (corner) {
            hit = frame.prober.at_corner(*corner);
            if (!frame.prober.is_there(hit->part, frame.model.vertex_at(*corner))) hit.reset();
        }
    }
    PointerState& pointer = pointer_of(frame.interaction, Pointer::Pin);
    pointer.hit = hit;
    pointer.can_vibrate = frame.input.pointer.can_vibrate;
    const bool is_alone = !pointer_of(frame.interaction, Pointer::Mouse).hit;
    pointer.is_held = hit && is_alone && frame.input.hold;
}

/// What happened last is said for a while, not for ever.
void forget_notice(Interaction& interaction, ViewerState& state, double time) {
    if (state.notice != interaction.told) {
        interaction.told = state.notice;
        interaction.told_at = time;
    } else if (time - interaction.told_at > kNoticeSeconds) {
        state.notice.clear();
        interaction.told.clear();
    }
}

}  // namespace

void move_pointer(Interaction& interaction, Pointer pointer, const std::optional<SkinHit>& hit) {
    PointerState& state = pointer_of(interaction, pointer);
    state.hit = hit;
    if (!hit) {
        state.counted.reset();
        return;
    }
    if (state.counted && glm::distance(*state.counted, hit->world) < kMoved) return;
    state.counted = hit->world;
    // Who is heard stays so until another presses.
    if (!state.is_held) state.moved = ++interaction.clock;
}

void hold_pointer(InteractionFrame& frame, Pointer pointer, bool on) {
    PointerState& state = pointer_of(frame.interaction, pointer);
    if (on && !state.is_held) state.moved = ++frame.interaction.clock;
    state.is_held = on;
}

bool take_knob(InteractionFrame& frame, Pointer pointer, const Ray& ray) {
    if (frame.interaction.knob) return false;
    const auto knobs = knobs_of(frame.state, frame.model);
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (!knobs[i]) continue;
        const float reach = knob_reach(ray, *knobs[i], pointer == Pointer::Mouse);
        if (distance_to_ray(ray, *knobs[i]) >= reach) continue;
        const float along = along_normal(ray, frame.state, frame.model, i);
        frame.interaction.knob = KnobDrag{pointer, i, along, frame.state.cuts[i].plane.offset};
        return true;
    }
    return false;
}

void drag_knob(InteractionFrame& frame, const Ray& ray) {
    const auto& knob = frame.interaction.knob;
    if (!knob || knob->cut >= frame.state.cuts.size()) return;
    const float along = along_normal(ray, frame.state, frame.model, knob->cut);
    place_cut(frame.state, frame.model, knob->cut, knob->offset + along - knob->along);
}

void interact(
    Interaction& interaction,
    ViewerState& state,
    const ViewedModel& model,
    Prober& prober,
    const FrameInput& input
) {
    InteractionFrame frame{interaction, state, model, prober, input, {}};
    const double passed = interaction.has_begun ? input.time - interaction.time : 0;
    interaction.time = input.time;
    interaction.has_begun = true;
    interaction.boards_moved = interaction.menu_asked = false;
    interaction.inside.reset();
    forget_notice(interaction, state, input.time);
    if (!input.is_focused) {
        let_go_of_all(frame);
        prober.set_look(make_look(state, model, input.is_headset));
        return;
    }
    for (const Command command : input.commands) {
        run(state, model, command, {input.is_headset, meant_node(interaction, model)});
    }
    settle(frame);
    play(state, model, std::clamp(passed, 0.0, kLongestFrame), interaction.step_age);
    const glm::mat4 before = state.placement;
    press_buttons(frame);
    carry_model(frame);
    if (!is_finite_matrix(state.placement)) state.placement = before;
    prober.set_look(make_look(state, model, input.is_headset));
    point_hands(frame);
    point_mouse(frame);
    point_pin(frame);
    if (const auto pointer = leading(interaction)) {
        const PointerState& held = pointer_of(interaction, *pointer);
        if (held.is_held || *pointer == Pointer::Pin) interaction.chosen = node_of(model, *held.hit);
    }
}

std::optional<Pointer> leading(const Interaction& interaction) {
    std::optional<Pointer> best;
    const auto rank = [](Pointer pointer, const PointerState& state) {
        return state.is_held ? 2 : pointer == Pointer::Pin ? 0 : 1;
    };
    for (std::size_t i = 0; i < kPointers; ++i) {
        const auto pointer = static_cast<Pointer>(i);
        const PointerState& state = interaction.pointers[i];
        if (!state.hit) continue;
        if (!best) {
            best = pointer;
            continue;
        }
        const PointerState& known = interaction.pointers[static_cast<std::size_t>(*best)];
        const int here = rank(pointer, state), there = rank(*best, known);
        if (here > there || (here == there && state.moved > known.moved)) best = pointer;
    }
    return best;
}

}  // namespace feelem::viewer
