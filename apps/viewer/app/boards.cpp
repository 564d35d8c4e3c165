// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/boards.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

// As web/src/xr/vr-boards.ts.
constexpr float kAway = 1.145F, kBelowEyes = 0.1F;
constexpr float kPanelAside = glm::radians(26.2F), kLegendAside = glm::radians(31.5F);
/// Between the place and the card's lower edge, metres at one metre.
constexpr float kAbovePlace = 0.02F;
constexpr float kPressed = 0.5F;

/// A board at `at` whose front looks to the eye, upright.
Pose facing(const glm::vec3& at, const glm::vec3& eye) {
    const glm::vec3 to_eye = eye - at;
    const float length = glm::length(to_eye);
    if (!(length > 1e-6F)) return {at, {1, 0, 0, 0}};
    const float yaw = std::atan2(to_eye.x, to_eye.z);
    const float pitch = std::asin(std::clamp(to_eye.y / length, -1.0F, 1.0F));
    const glm::quat turn =
        glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(-pitch, glm::vec3(1, 0, 0));
    return {at, turn};
}

}  // namespace

std::array<BoardPlace, kBoards> place_boards(
    const Stand& stand,
    float eye_height,
    bool left_handed,
    const Snapshot& snapshot,
    const Look& look,
    const glm::vec3& eye
) {
    const float hand = left_handed ? -1.0F : 1.0F;
    const glm::vec3 sitting_eye = place_before(stand, 0, eye_height, 0);
    const auto aside = [&](float angle) {
        return place_before(
            stand, hand * kAway * std::sin(angle), eye_height - kBelowEyes, kAway * std::cos(angle)
        );
    };
    std::array<BoardPlace, kBoards> places;
    const auto put =
        [&](Board board, const glm::vec3& at, const glm::vec3& looks_to, float scale, bool is_shown) {
            places[static_cast<std::size_t>(board)] = {
                facing(at, looks_to), size_of(board).metres * scale, is_shown};
        };
    put(Board::Panel, aside(-kPanelAside), sitting_eye, 1, true);
    put(Board::Legend, aside(kLegendAside), sitting_eye, 1, look.field.has_value());
    if (!snapshot.probed) return places;
    const glm::vec3 place = snapshot.probed->world;
    const float distance = std::max(glm::distance(place, eye), 0.2F);
    glm::vec3 at = glm::mix(place, eye, 0.12F);
    at.y += (kAbovePlace + size_of(Board::Card).metres.y / 2) * distance;
    put(Board::Card, at, eye, distance, true);
    return places;
}

std::optional<PointedBoard> pointed_board(const Ray& ray, std::span<const BoardPlace, kBoards> places) {
    std::optional<PointedBoard> best;
    // The card is read, not pressed.
    for (const Board board : {Board::Panel, Board::Legend}) {
        const BoardPlace& place = places[static_cast<std::size_t>(board)];
        if (!place.is_shown) continue;
        const auto hit = hit_board(ray, place.pose, {size_of(board).pixels, place.size});
        if (hit && (!best || hit->metres < best->hit.metres)) best = PointedBoard{board, *hit};
    }
    return best;
}

PanelInput BoardPointer::point(FrameInput& input, std::span<const BoardPlace, kBoards> places) {
    std::array<std::optional<PointedBoard>, kSides> pointed;
    for (std::size_t side = 0; side < kSides; ++side) {
        HandInput& hand = input.hands[side];
        hand.panel_distance.reset();
        if (hand.is_tracked) pointed[side] = pointed_board(ray_of(hand.aim), places);
        if (pointed[side]) hand.panel_distance = pointed[side]->hit.metres;
        const bool pulled = hand.is_tracked && input.is_focused && hand.trigger > kPressed;
        const bool is_on_panel = pointed[side] && pointed[side]->board == Board::Panel;
        presses_[side] = pulled && (is_pulled_[side] ? presses_[side] : is_on_panel);
        is_pulled_[side] = pulled;
    }
    const std::size_t other = 1 - hand_;
    const bool other_asks = pointed[other] && (!pointed[hand_] || presses_[other]);
    if (other_asks && !(pointed[hand_] && presses_[hand_])) hand_ = other;
    PanelInput panel;
    panel.seconds = std::max(input.time - time_, 1e-4);
    time_ = input.time;
    if (pointed[hand_] && pointed[hand_]->board == Board::Panel) panel.at = pointed[hand_]->hit.at;
    panel.buttons[0] = panel.at && presses_[hand_];
    return panel;
}

}  // namespace feelem::viewer
