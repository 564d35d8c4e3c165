// SPDX-License-Identifier: Apache-2.0
// Mouse, keys, fingers and gamepad, one frame at a time. Steps as on the page (web/src/input/mouse.ts).
#include "viewer/desktop/desk_input.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace feelem::viewer {
namespace {

constexpr float kRadiansPerPoint = 0.008F;
/// exp of it: what a notch of the wheel leaves of the distance.
constexpr float kNotch = -0.18F;
constexpr float kMostNotches = 2;
constexpr float kKeyRadians = 15 * std::numbers::pi_v<float> / 180, kKeyMove = 0.08F, kKeyZoom = 0.8F;
/// Of a gamepad, a second, at full deflection.
constexpr float kPadRadians = 2, kPadMove = 0.8F, kPadZoom = 1.2F;
constexpr float kDeadZone = 0.15F;
/// Longer gaps (a window that was dragged) move nothing at once.
constexpr double kLongestStep = 0.1;

constexpr std::array<std::pair<std::string_view, PanelKey>, 13> kPanelKeys{
    {{"Tab", PanelKey::Tab},
     {"Left", PanelKey::Left},
     {"Right", PanelKey::Right},
     {"Up", PanelKey::Up},
     {"Down", PanelKey::Down},
     {"Home", PanelKey::Home},
     {"End", PanelKey::End},
     {"Delete", PanelKey::Delete},
     {"Backspace", PanelKey::Backspace},
     {"Return", PanelKey::Enter},
     {"Keypad Enter", PanelKey::Enter},
     {"Escape", PanelKey::Escape},
     {"A", PanelKey::All}}};

constexpr std::array<std::pair<std::string_view, Command>, 11> kPadCommands{
    {{"b", Command::Leave},
     {"x", Command::PlaceMarker},
     {"y", Command::NextResult},
     {"dpleft", Command::PreviousStep},
     {"dpright", Command::NextStep},
     {"dpup", Command::PreviousHotSpot},
     {"dpdown", Command::NextHotSpot},
     {"start", Command::PlaySteps},
     {"back", Command::Home},
     {"leftstick", Command::ToggleMute},
     {"rightstick", Command::Fit}}};

bool may_repeat(Command command) {
    return command == Command::NextStep || command == Command::PreviousStep ||
           command == Command::ClipForward || command == Command::ClipBack;
}

/// What a key is bound to, by its name, else by its place on a US keyboard unless that is a letter's.
const KeyBinding* binding_of(const DeskEvent& event) {
    if (const KeyBinding* found = find_binding(event.text, event.shift, event.control)) return found;
    const bool is_letter = event.place.size() == 1 && event.place[0] >= 'A' && event.place[0] <= 'Z';
    return event.place.empty() || is_letter ? nullptr : find_binding(event.place, event.shift, event.control);
}

glm::vec2 beyond_dead_zone(glm::vec2 stick) {
    const float length = glm::length(stick);
    if (length <= kDeadZone) return glm::vec2(0);
    const float share = std::min((length - kDeadZone) / (1 - kDeadZone), 1.0F);
    return stick / length * share * share;
}

float beyond_dead_zone(float trigger) {
    return std::max(0.0F, (trigger - kDeadZone) / (1 - kDeadZone));
}

}  // namespace

/// What a frame's events are read with, and what they come to.
struct DeskInput::Step {
    const DeskSituation& now;
    DeskFrame out;
    std::array<int, 4> stage{};
    double seconds = 0;

    bool on_stage(glm::vec2 at) const {
        const glm::vec2 inside = at - glm::vec2(stage[0], stage[1]);
        return inside.x >= 0 && inside.y >= 0 && inside.x < static_cast<float>(stage[2]) &&
               inside.y < static_cast<float>(stage[3]);
    }
    glm::vec2 share_of(glm::vec2 at) const {
        return (at - glm::vec2(stage[0], stage[1])) / glm::vec2(stage[2], stage[3]);
    }
    Ray ray(const DeskCamera& camera, glm::vec2 at, float aspect) const {
        return ray_at(camera, share_of(at), aspect);
    }
    std::optional<glm::vec3> hit(const Ray& ray) const { return now.hit ? now.hit(ray) : std::nullopt; }
};

DeskFrame DeskInput::step(std::span<const DeskEvent> events, const DeskSituation& situation) {
    Step step{.now = situation, .out = {}};
    step.stage = situation.stage.value_or(std::array{0, 0, situation.pixels.x, situation.pixels.y});
    step.stage[2] = std::max(step.stage[2], 1);
    step.stage[3] = std::max(step.stage[3], 1);
    step.seconds = std::clamp(situation.time - time_.value_or(situation.time), 0.0, kLongestStep);
    time_ = situation.time;
    const float aspect = static_cast<float>(step.stage[2]) / static_cast<float>(step.stage[3]);
    if (aspect != std::exchange(aspect_, aspect)) reshaped(camera_, aspect_);
    if (fits_ > 0) {
        --fits_;
        fit(camera_, situation.box, aspect_);
    }
    pressed_now_ = {};
    if (std::exchange(lifted_, false)) at_.reset();
    for (int button = 0; button < 3; ++button)
        if (std::exchange(let_go_later_.at(static_cast<std::size_t>(button)), false)) release(button);
    for (const DeskEvent& event : events) take(event, step);
    move_by_pad(step);
    finish(step);
    return std::move(step.out);
}

void DeskInput::take(const DeskEvent& event, Step& step) {
    using Kind = DeskEvent::Kind;
    switch (event.kind) {
    case Kind::KeyDown:
    case Kind::KeyUp: take_key(event, step); break;
    case Kind::Text: step.out.panel.text += event.text; break;
    case Kind::Moved:
    case Kind::Pressed:
    case Kind::Released:
    case Kind::Wheel: take_button(event, step); break;
    case Kind::PointerLeft:
        if (drag_ == Drag::None) at_.reset();
        break;
    case Kind::FingerDown:
    case Kind::FingerMoved:
    case Kind::FingerUp: take_finger(event, step); break;
    case Kind::PadPressed:
    case Kind::PadReleased: take_pad(event, step); break;
    case Kind::FocusGained: is_focused_ = true; break;
    case Kind::FocusLost:
        is_focused_ = false;
        let_go();
        break;
    case Kind::Dropped: step.out.dropped.push_back(event.text); break;
    case Kind::CloseWanted: step.out.close_wanted = true; break;
    }
}

void DeskInput::take_key(const DeskEvent& event, Step& step) {
    shift_ = event.shift;
    const bool is_down = event.kind == DeskEvent::Kind::KeyDown;
    const KeyBinding* binding = binding_of(event);
    if (!is_down) {
        // S is let go whatever was pressed with it since.
        const KeyBinding* plain = find_binding(event.text, false, false);
        if (plain && plain->action == DeskAction::Hold) holds_key_ = false;
        return;
    }
    for (const auto& [name, key] : kPanelKeys)
        if (event.text == name && (key == PanelKey::All) == event.control) step.out.panel.keys.push_back(key);
    if (!binding || step.now.is_typing) return;
    if (binding->action) act(*binding->action, event.repeated, step);
    if (binding->command && (!event.repeated || may_repeat(*binding->command)))
        command(*binding->command, step);
}

void DeskInput::act(DeskAction action, bool is_repeated, Step& step) {
    switch (action) {
    case DeskAction::Hold: holds_key_ = true; break;
    case DeskAction::TurnLeft: turn(camera_, -kKeyRadians, 0); break;
    case DeskAction::TurnRight: turn(camera_, kKeyRadians, 0); break;
    case DeskAction::TurnUp: turn(camera_, 0, -kKeyRadians); break;
    case DeskAction::TurnDown: turn(camera_, 0, kKeyRadians); break;
    case DeskAction::MoveLeft: pan(camera_, {-kKeyMove, 0}); break;
    case DeskAction::MoveRight: pan(camera_, {kKeyMove, 0}); break;
    case DeskAction::MoveUp: pan(camera_, {0, -kKeyMove}); break;
    case DeskAction::MoveDown: pan(camera_, {0, kKeyMove}); break;
    case DeskAction::Nearer: zoom(camera_, kKeyZoom, std::nullopt); break;
    case DeskAction::Further: zoom(camera_, 1 / kKeyZoom, std::nullopt); break;
    case DeskAction::ViewX: view({1, 0, 0}, step); break;
    case DeskAction::ViewY: view({0, 1, 0}, step); break;
    case DeskAction::ViewZ: view({0, 0, 1}, step); break;
    case DeskAction::ViewAll: view({1, 1, 1}, step); break;
    case DeskAction::Theme:
    case DeskAction::Help:
    case DeskAction::FullScreen:
        if (!is_repeated) step.out.actions.push_back(action);
        break;
    }
}

void DeskInput::view(const glm::vec3& direction, Step& step) {
    view_from(camera_, direction, step.now.to_world, step.now.box, aspect_);
}

void DeskInput::command(Command command, Step& step) {
    step.out.input.commands.push_back(command);
    // Core moves or scales the model after this frame: fitted again in the next.
    if (command == Command::Fit) fit(camera_, step.now.box, aspect_);
    if (command == Command::Home) go_home(camera_, step.now.box, aspect_);
    if (command == Command::Fit || command == Command::Home || command == Command::TrueScale) fits_ = 1;
}

void DeskInput::take_button(const DeskEvent& event, Step& step) {
    pad_points_ = by_finger_ = lifted_ = false;
    move_to(event.at, step);
    if (event.kind == DeskEvent::Kind::Pressed) press(event.button, step);
    if (event.kind == DeskEvent::Kind::Released) release(event.button);
    if (event.kind != DeskEvent::Kind::Wheel) return;
    if (step.now.over_panel || !step.on_stage(event.at)) {
        step.out.panel.wheel += event.wheel.y;
        return;
    }
    const float notches = std::clamp(event.wheel.y, -kMostNotches, kMostNotches);
    step.out.input.pointer.wheel += notches;
    zoom(camera_, std::exp(kNotch * notches), step.hit(step.ray(camera_, event.at, aspect_)));
}

void DeskInput::press(int button, Step& step) {
    if (button < 0 || button > 2) return;
    const auto index = static_cast<std::size_t>(button);
    buttons_.at(index) = pressed_now_.at(index) = true;
    if (drag_ != Drag::None) return;
    if (step.now.over_panel || !step.on_stage(*at_))
        drag_ = Drag::Panel;
    else if (button == 1)
        drag_ = Drag::Pan;
    else if (button == 2 || !step.hit(step.ray(camera_, *at_, aspect_)))
        drag_ = Drag::Turn;
    else
        drag_ = Drag::Probe;
}

void DeskInput::release(int button) {
    if (button < 0 || button > 2) return;
    const auto index = static_cast<std::size_t>(button);
    // A tap within a frame is still a press of one frame.
    if (pressed_now_.at(index)) {
        let_go_later_.at(index) = true;
        return;
    }
    buttons_.at(index) = false;
    if (std::ranges::none_of(buttons_, [](bool down) { return down; })) {
        drag_ = Drag::None;
        lifted_ = by_finger_;
    }
}

void DeskInput::move_to(glm::vec2 at, Step& step) {
    const glm::vec2 moved = at - at_.value_or(at);
    at_ = at;
    step.out.input.pointer.moved += moved / static_cast<float>(step.stage[3]);
    const glm::vec2 radians = moved * kRadiansPerPoint / std::max(step.now.density, 0.1F);
    if (drag_ == Drag::Turn) turn(camera_, radians.x, radians.y);
    if (drag_ == Drag::Pan) pan(camera_, moved / static_cast<float>(step.stage[3]));
}

void DeskInput::take_finger(const DeskEvent& event, Step& step) {
    pad_points_ = false;
    by_finger_ = true;
    if (event.kind == DeskEvent::Kind::FingerUp) {
        fingers_.erase(event.finger);
        release(0);
        if (drag_ == Drag::Pinch) drag_ = Drag::None;
        return;
    }
    const bool is_new = event.kind == DeskEvent::Kind::FingerDown;
    if (!is_new && !fingers_.contains(event.finger)) return;
    const std::map<std::int64_t, glm::vec2> before = fingers_;
    fingers_[event.finger] = event.at;
    if (fingers_.size() == 1 && (is_new || drag_ != Drag::None)) {
        if (is_new) lifted_ = false;
        if (is_new) at_ = event.at;
        move_to(event.at, step);
        if (is_new) press(0, step);
    }
    if (fingers_.size() < 2 || drag_ == Drag::Panel) return;
    buttons_ = pressed_now_ = {};
    at_.reset();
    if (std::exchange(drag_, Drag::Pinch) == Drag::Pinch && before.size() == fingers_.size())
        pinch_from(before, step);
}

void DeskInput::pinch_from(const std::map<std::int64_t, glm::vec2>& before, Step& step) {
    const auto middle = [](const std::map<std::int64_t, glm::vec2>& two) {
        return (two.begin()->second + std::next(two.begin())->second) / 2.0F;
    };
    const auto spread = [](const std::map<std::int64_t, glm::vec2>& two) {
        return glm::distance(two.begin()->second, std::next(two.begin())->second);
    };
    const glm::vec2 here = middle(fingers_);
    pan(camera_, (here - middle(before)) / static_cast<float>(step.stage[3]));
    if (spread(before) > 0 && spread(fingers_) > 0) {
        const Ray ray = step.ray(camera_, here, aspect_);
        zoom(camera_, spread(before) / spread(fingers_), step.hit(ray));
    }
}

void DeskInput::take_pad(const DeskEvent& event, Step& step) {
    pad_points_ = true;
    const bool is_down = event.kind == DeskEvent::Kind::PadPressed;
    if (event.text == "a") holds_pad_ = is_down;
    if (!is_down) return;
    for (const auto& [name, found] : kPadCommands)
        if (event.text == name) command(found, step);
}

void DeskInput::move_by_pad(Step& step) {
    const PadState& pad = step.now.pad;
    if (!pad.is_connected) {
        holds_pad_ = pad_points_ = false;
        return;
    }
    const auto seconds = static_cast<float>(step.seconds);
    const glm::vec2 turned = beyond_dead_zone(pad.left) * kPadRadians * seconds;
    const glm::vec2 moved = beyond_dead_zone(pad.right) * kPadMove * seconds;
    const float nearer = beyond_dead_zone(pad.right_trigger) - beyond_dead_zone(pad.left_trigger);
    if (turned != glm::vec2(0)) turn(camera_, turned.x, -turned.y);
    if (moved != glm::vec2(0)) pan(camera_, {-moved.x, moved.y});
    if (nearer != 0) zoom(camera_, std::exp(-nearer * kPadZoom * seconds), std::nullopt);
    if (turned != glm::vec2(0) || moved != glm::vec2(0) || nearer != 0) pad_points_ = true;
}

void DeskInput::let_go() {
    holds_key_ = holds_pad_ = shift_ = false;
    buttons_ = pressed_now_ = let_go_later_ = {};
    fingers_.clear();
    drag_ = Drag::None;
}

void DeskInput::finish(Step& step) {
    FrameInput& input = step.out.input;
    PanelInput& panel = step.out.panel;
    input.time = step.now.time;
    input.is_focused = is_focused_;
    input.head = pose_of(camera_);
    input.hold = holds_key_ || holds_pad_;
    input.pointer.shift = shift_;
    input.pointer.can_vibrate = step.now.pad.can_rumble;
    panel.seconds = step.seconds;
    panel.pointer = at_;
    const bool is_free = drag_ == Drag::None;
    if (is_free || drag_ == Drag::Panel) {
        panel.at = at_;
        panel.buttons = buttons_;
    }
    const bool points = drag_ == Drag::Probe || (is_free && !step.now.over_panel);
    const glm::vec2 middle =
        glm::vec2(step.stage[0], step.stage[1]) + glm::vec2(step.stage[2], step.stage[3]) / 2.0F;
    const std::optional<glm::vec2> at = pad_points_ ? middle : at_;
    if (points && at && (drag_ == Drag::Probe || step.on_stage(*at)))
        input.pointer.ray = step.ray(camera_, *at, aspect_);
    if (drag_ == Drag::Probe) input.pointer.primary = buttons_[0];
    input.pointer.secondary = drag_ == Drag::Pan;
    input.pointer.middle = drag_ == Drag::Turn;
}

}  // namespace feelem::viewer
