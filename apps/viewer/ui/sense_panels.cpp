// SPDX-License-Identifier: Apache-2.0
// Sound, touch, the headset, and what is known of the scene.
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kStrongest = 1.5F;

std::string percent(double share) {
    return fmt::format("{} %", std::lround(100 * share));
}

}  // namespace

void sound_panel(Pen& pen) {
    const UiSound& sound = pen.model.sound;
    const CellLook mute{!sound.is_muted, true, sound.is_muted ? "sound on  M" : "mute  M"};
    if (icon_cell(pen, "sound/mute", sound.is_muted ? Icon::Mute : Icon::Sound, mute))
        pen.wish(Command::ToggleMute);
    ImGui::SameLine();
    const float width = ImGui::GetContentRegionAvail().x;
    const auto volume = slider(
        pen, "sound/volume", static_cast<float>(sound.volume), 0, 1, "volume " + percent(sound.volume), width
    );
    if (volume) pen.wish(SetVolume{*volume});
    if (check(pen, "sound/mono", "the same in both ears", sound.is_mono)) pen.wish(SetMono{!sound.is_mono});
    if (check(pen, "sound/guide", "find the largest by ear", sound.is_guided)) pen.wish(Command::ToggleGuide);
    if (!sound.trouble.empty()) soft_lines(pen, sound.trouble);
}

void touch_panel(Pen& pen) {
    const UiTouch& touch = pen.model.touch;
    const CellLook still{!touch.is_still, true, touch.is_still ? "touch on  V" : "no vibration  V"};
    if (icon_cell(pen, "touch/still", Icon::Hand, still)) pen.wish(Command::ToggleStill);
    ImGui::SameLine();
    const float width = ImGui::GetContentRegionAvail().x;
    const auto strength = slider(
        pen,
        "touch/strength",
        static_cast<float>(touch.strength),
        0,
        kStrongest,
        "vibration " + percent(touch.strength),
        width
    );
    if (strength) pen.wish(SetStrength{*strength});
    if (!touch.trouble.empty()) soft_lines(pen, touch.trouble);
}

void headset_panel(Pen& pen) {
    const UiHeadset& headset = pen.model.headset;
    lines(headset.what.empty() ? "No headset was looked for." : headset.what);
    if (!headset.why.empty()) soft_lines(pen, headset.why);
    if (!headset.todo.empty()) lines_in(pen.colours.accent, headset.todo);
    if (headset.is_running || pen.is_board) return;
    if (push(pen, "headset/try", "Look for it again")) pen.wish(TryHeadset{});
}

void certificate_panel(Pen& pen) {
    if (!pen.model.solver.empty()) text(pen.model.solver);
    if (!ImGui::BeginTable("facts", 2, ImGuiTableFlags_None)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.45F);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.55F);
    for (const UiFact& fact : pen.model.certificate) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        small_lines(pen, fact.name, pen.colours.soft);
        ImGui::TableNextColumn();
        small_lines(pen, fact.value, pen.colours.ink);
    }
    ImGui::EndTable();
}

void keys_panel(Pen& pen) {
    const std::size_t rows = (pen.model.keys.size() + 1) / 2;
    if (!ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) return;
    const auto cell = [&](std::size_t index) {
        if (index >= pen.model.keys.size()) return;
        ImGui::TableNextColumn();
        bold_text(pen, pen.model.keys[index].shown);
        ImGui::TableNextColumn();
        soft_text(pen, pen.model.keys[index].text);
    };
    for (std::size_t row = 0; row < rows; ++row) {
        ImGui::TableNextRow();
        cell(row);
        cell(row + rows);
    }
    ImGui::EndTable();
}

}  // namespace feelem::viewer
