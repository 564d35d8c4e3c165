// SPDX-License-Identifier: Apache-2.0
// What hands, mouse and keys do (docs/interaction.md): from the input of a frame to changes of the state and
// to where each pointer is on the model. Nothing moves by itself.
#pragma once

#include "viewer/core/probe.hpp"
#include "viewer/core/viewer_state.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::viewer {

/// A tip within so many metres of the skin reads it without a ray.
inline constexpr float kTouchReach = 0.03F;
/// The last pose of a lost hand stays so long as a ghost, seconds.
inline constexpr double kGhostSeconds = 0.5;
inline constexpr float kTurnDegrees = 30;

inline constexpr std::size_t kPointers = 4;
/// One way to point: the mouse, a hand, or the pin.
struct PointerState {
    std::optional<SkinHit> hit;
    bool is_held = false;  ///< Hear and feel is asked for.
    bool can_vibrate = false;
    std::uint64_t moved = 0;           ///< Larger: later. The latest counts.
    std::optional<glm::vec3> counted;  ///< Where it was when that was counted.
};

/// What a hand's trigger holds.
enum class Holds : std::uint8_t {
    Nothing,
    Model,    ///< Heard and felt.
    Carried,  ///< The model, by the bar under it or by a pinch on nothing.
    Knob,     ///< Of a cutting plane.
    Panel,    ///< Also while its ray only rests on one.
};

struct HandState {
    Holds holds = Holds::Nothing;
    bool grips = false;               ///< Its fist holds the model, or its squeeze.
    bool touches = false;             ///< Its tip is on the skin; no ray then.
    std::optional<float> ray_length;  ///< As it is drawn, metres; empty: it does not point.
    std::optional<Pose> ghost;        ///< Where a lost hand was last, for a while.
    float ring = 0;                   ///< How far the ring that offers a note has opened, 0..1.

    HandInput before;  ///< Of the frame before; of a lost hand as it was last seen.
    bool trigger_down = false, squeeze_down = false;
    int stick_x = 0, stick_y = 0;  ///< -1 0 1: pushed.
    double lost_since = 0;
    std::optional<glm::vec3> rest_at;  ///< Where a pinch rests, and since when.
    double rest_since = 0;
    bool carries = false;
    Pose carried_from;  ///< Of the grip when it took hold.
};

/// A knob of a plane that is dragged.
struct KnobDrag {
    Pointer by = Pointer::Mouse;
    std::size_t cut = 0;
    float along = 0, offset = 0;  ///< Of the pointer and of the plane when it was taken.
};

/// What is remembered from frame to frame.
struct Interaction {
    std::array<PointerState, kPointers> pointers;  ///< By Pointer.
    std::array<HandState, kSides> hands;
    std::optional<glm::vec3> ring;    ///< Where one would stand, on the floor.
    std::optional<glm::vec3> inside;  ///< The mouse or a hand points at opened material.
    bool boards_moved = false;  ///< In this frame the panels' places have changed: see ViewerState::stand.
    bool menu_asked = false;    ///< In this frame: the menu at the wrist is to come or go.

    bool mouse_down = false, mouse_probes = false;  ///< Pressed; pressed on the model.
    double pressed_at = -1;                         ///< Of the mouse, on the model: for a double press.
    std::optional<KnobDrag> knob;
    glm::mat4 held_placement{1};         ///< Of the model when hands took hold of it.
    std::optional<std::int64_t> chosen;  ///< Node of the place that was pressed last.
    double time = 0, step_age = 0;
    std::uint64_t clock = 0;
    bool has_begun = false, was_headset = false;
    std::string told;  ///< The notice that stands, and since when.
    double told_at = 0;
};

/// Once a frame. Shows the prober what is drawn.
void interact(
    Interaction& interaction,
    ViewerState& state,
    const ViewedModel& model,
    Prober& prober,
    const FrameInput& input
);

/// The pointer on the model that counts: a held one first, then the one that moved last. Empty: none is.
std::optional<Pointer> leading(const Interaction& interaction);
}  // namespace feelem::viewer
