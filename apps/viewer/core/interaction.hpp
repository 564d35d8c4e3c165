// SPDX-License-Identifier: Apache-2.0
// What hands, mouse and keys do (docs/interaction.md): from the input of a frame to changes of the state and
// to where each pointer is on the model. Nothing moves by itself.
#pragma once

#include "viewer/core/probe.hpp"
#include "viewer/core/viewer_state.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// A tip within so many metres of the skin reads it without a ray.
inline constexpr float kTouchReach = 0.03F;
/// The last pose of a lost hand stays so long as a ghost, seconds.
inline constexpr double kGhostSeconds = 0.5;
inline constexpr float kTurnDegrees = 30;

/// One way to point: the mouse or a hand.
struct PointerState {
    std::optional<SkinHit> hit;
    bool is_held = false;  ///< Hear and feel is asked for.
    bool can_vibrate = false;
    std::uint64_t moved = 0;  ///< Larger: later. The latest counts.
};

enum class Holds : std::uint8_t {
    Nothing,
    Model,  ///< Heard and felt.
    Carried,
    Knob,  ///< Of the first cutting plane.
    Panel,
};

struct HandState {
    Holds holds = Holds::Nothing;
    bool grips = false;
    bool touches = false;             ///< Its tip is on the skin; no ray then.
    std::optional<float> ray_length;  ///< As it is drawn, metres; empty: it does not point.
    HandInput before;                 ///< Of the frame before.
    bool trigger_down = false, squeeze_down = false;
    int stick_x = 0, stick_y = 0;  ///< -1 0 1: pushed.
    std::optional<Pose> ghost;     ///< Where a lost hand was last, for a while.
    double lost_since = 0;
    std::optional<glm::vec3> rest_at;  ///< Where a pinch rests, and since when.
    double rest_since = 0;
    float ring = 0;             ///< How far the ring that offers a note has opened, 0..1.
    glm::mat4 carried_from{1};  ///< Pose of the grip when it took hold.
};

/// What is remembered from frame to frame.
struct Interaction {
    std::array<PointerState, 3> pointers;  ///< By Pointer: Mouse, Left, Right.
    std::array<HandState, kSides> hands;
    std::optional<glm::vec3> ring;    ///< Where one would stand, on the floor.
    std::optional<glm::vec3> inside;  ///< The mouse or a hand points at opened material.
    bool boards_moved = false;    ///< In this frame the panels' places have changed: see ViewerState::stand.
    bool menu_asked = false;      ///< In this frame: the menu at the wrist is to come or go.
    glm::mat4 held_placement{1};  ///< Of the model when hands took hold of it.
    bool mouse_down = false;
    std::optional<std::size_t>
        knob;  ///< Of the plane that is dragged; who drags it: see `holds`, `mouse_knob`.
    bool mouse_knob = false;
    float knob_along = 0, knob_offset = 0;  ///< Of the pointer and the plane when the knob was taken.
    double pressed_at = -1;                 ///< Of the mouse: for a double press.
    double time = 0, stepped_at = 0;
    std::uint64_t clock = 0;
    std::optional<std::int64_t> chosen;  ///< Node of the place that was pressed last.
    bool was_headset = false;
};

/// Shows the prober what is drawn.
void interact(
    Interaction& interaction,
    ViewerState& state,
    const ViewedModel& model,
    Prober& prober,
    const FrameInput& input
);

/// The pointer on the model that counts: a held one first, then the one that moved last. Empty: none is.
std::optional<Pointer> leading(const Interaction& interaction);
/// Places of the knobs of the planes that are on, world; of the others empty.
std::vector<std::optional<glm::vec3>> knobs_of(const ViewerState& state, const ViewedModel& model);
/// The bar under the model by which it is carried: its two ends, world.
std::array<glm::vec3, 2> bar_of(const ViewerState& state, const ViewedModel& model, const glm::vec3& eye);

}  // namespace feelem::viewer
