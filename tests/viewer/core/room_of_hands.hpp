// SPDX-License-Identifier: Apache-2.0
// A person in a headset before two squares, for tests of hands.
#pragma once

#include "viewer/core/scene_in_memory.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace feelem::viewer::test {

constexpr std::size_t kLeft = 0, kRight = 1;

inline Pose looking(const glm::vec3& from, const glm::vec3& at) {
    return {from, glm::quatLookAt(glm::normalize(at - from), glm::vec3(0, 1, 0))};
}

/// Both hands are tracked and point to the floor beside the model; the first frame has been.
struct Room : Ready {
    explicit Room(Scene scene) : Ready(std::move(scene)) {
        input.is_headset = true;
        input.head.position = {0, 1.6F, 0};
        for (std::size_t side = 0; side < kSides; ++side) {
            HandInput& hand = input.hands[side];
            hand.is_tracked = hand.can_vibrate = true;
            hand.grip.position = hand.aim.position = {side == kLeft ? -0.3F : 0.3F, 1.2F, -0.2F};
            point_away(side);
        }
        next();
    }

    Snapshot next(double seconds = 0.01) { return last = frame(input, seconds); }
    HandInput& hand(std::size_t side) { return input.hands[side]; }
    void point(std::size_t side, const glm::vec3& at) {
        hand(side).aim = looking(hand(side).aim.position, at);
    }
    void point_away(std::size_t side) { point(side, hand(side).aim.position + glm::vec3(0, -0.5F, 3)); }
    /// World place of a place of the model.
    glm::vec3 world(const glm::vec3& at) const {
        return glm::vec3(model_to_world(viewer.state, viewer.model) * glm::vec4(at, 1));
    }
    /// Moves a hand as it is.
    void move(std::size_t side, const glm::vec3& by) {
        hand(side).grip.position += by;
        hand(side).aim.position += by;
    }
    const HandState& at_hand(std::size_t side) const { return viewer.interaction.hands[side]; }

    FrameInput input;
    Snapshot last;
};

}  // namespace feelem::viewer::test
