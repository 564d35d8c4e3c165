// SPDX-License-Identifier: Apache-2.0
// What the two hands do in the room: buttons, grips, rays, touches. Parts of interact().
#pragma once

#include "viewer/core/interaction.hpp"

namespace feelem::viewer {

/// What the parts of interact() work on.
struct InteractionFrame {
    Interaction& interaction;
    ViewerState& state;
    const ViewedModel& model;
    Prober& prober;
    const FrameInput& input;
    std::array<bool, kSides> notes{};  ///< The hand's note button was pressed.
};

inline constexpr std::array<Pointer, kSides> kPointerOf{Pointer::Left, Pointer::Right};

/// Lost and found hands, buttons and sticks: before anything is pointed at.
void press_buttons(InteractionFrame& frame);
/// Moves the model with the hands that hold it.
void carry_model(InteractionFrame& frame);
/// Where each hand is on the model, and what its trigger takes.
void point_hands(InteractionFrame& frame);
/// Everything that hands hold is let go; what is pressed now does nothing until it is pressed again.
void let_go_of_all(InteractionFrame& frame);

/// The place of a pointer: keeps count of which moved last.
void move_pointer(Interaction& interaction, Pointer pointer, const std::optional<SkinHit>& hit);
/// Hear and feel is asked for, or not.
void hold_pointer(InteractionFrame& frame, Pointer pointer, bool on);
/// Takes the knob that the ray is on.
bool take_knob(InteractionFrame& frame, Pointer pointer, const Ray& ray);
void drag_knob(InteractionFrame& frame, const Ray& ray);

}  // namespace feelem::viewer
