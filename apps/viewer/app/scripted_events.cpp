// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/scripted_events.hpp"

namespace feelem::viewer {
namespace {

int button_of(const std::string& word) {
    return word == "right" ? 1 : word == "middle" ? 2 : 0;
}

bool took(std::string& key, std::string_view prefix) {
    if (!key.starts_with(prefix)) return false;
    key.erase(0, prefix.size());
    return true;
}

}  // namespace

ScriptedFrame ScriptedHand::frame(std::span<const ScriptedDeed> deeds, glm::ivec2 pixels) {
    using Kind = DeskEvent::Kind;
    ScriptedFrame out;
    const auto add = [&](Kind kind) -> DeskEvent& {
        DeskEvent event;
        event.kind = kind;
        event.at = at_;
        return out.events.emplace_back(std::move(event));
    };
    const auto add_key = [&](Kind kind, std::string key) {
        DeskEvent& event = add(kind);
        event.control = took(key, "Ctrl+");
        event.shift = took(key, "Shift+");
        event.text = event.place = key;
    };
    for (const ScriptedDeed& deed : deeds) {
        switch (deed.deed) {
        case Deed::Move:
            at_ = glm::vec2(deed.x, deed.y) * glm::vec2(pixels);
            add(Kind::Moved);
            break;
        case Deed::Press: add(Kind::Pressed).button = button_of(deed.word); break;
        case Deed::Release: add(Kind::Released).button = button_of(deed.word); break;
        case Deed::Wheel: add(Kind::Wheel).wheel.y = static_cast<float>(deed.y); break;
        case Deed::Key:
            add_key(Kind::KeyDown, deed.word);
            add_key(Kind::KeyUp, deed.word);
            break;
        case Deed::HoldKey: add_key(Kind::KeyDown, deed.word); break;
        case Deed::LeaveKey: add_key(Kind::KeyUp, deed.word); break;
        case Deed::Screenshot: out.screenshots.push_back(deed.word); break;
        case Deed::Quit: out.quits = true; break;
        }
    }
    return out;
}

}  // namespace feelem::viewer
