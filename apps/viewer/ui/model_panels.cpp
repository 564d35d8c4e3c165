// SPDX-License-Identifier: Apache-2.0
// Steps, deformation, parts and sections.
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

/// "1,234,567"
std::string thousands(std::uint64_t count) {
    std::string out = fmt::format("{}", count);
    for (std::size_t at = out.size(); at > 3;) {
        at -= 3;
        out.insert(at, ",");
    }
    return out;
}

void part_row(Pen& pen, std::size_t index) {
    const UiPart& part = pen.model.parts[index];
    const std::string name = fmt::format("{}", index);
    const bool is_hidden = part.look == PartLook::Hidden;
    const bool is_clear = part.look == PartLook::Clear;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (icon_cell(pen, name + "/show", Icon::Eye, {!is_hidden, true, is_hidden ? "show" : "hide"}))
        pen.wish(SetPart{index, is_hidden ? PartLook::Shown : PartLook::Hidden});
    ImGui::TableNextColumn();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {pen.points(6), 0});
    lines_in(is_hidden ? pen.colours.soft : pen.colours.ink, part.name);
    small_lines(
        pen, fmt::format("{} · {} triangles", part.kind, thousands(part.triangles)), pen.colours.soft
    );
    ImGui::PopStyleVar();
    ImGui::TableNextColumn();
    if (icon_cell(pen, name + "/clear", Icon::Glass, {is_clear, !is_hidden, "see through it"}))
        pen.wish(SetPart{index, is_clear ? PartLook::Shown : PartLook::Clear});
    ImGui::TableNextColumn();
    const bool has_others = pen.model.parts.size() > 1;
    if (icon_cell(pen, name + "/only", Icon::Target, {false, has_others, "this part alone"}))
        pen.wish(OnlyPart{index});
}

std::optional<std::size_t> axis_of(const glm::vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) > 0.999999F) return static_cast<std::size_t>(axis);
    return std::nullopt;
}

void cut_row(Pen& pen, std::size_t index) {
    const UiCut& cut = pen.model.cuts[index];
    const std::string name = fmt::format("plane {}", index + 1);
    if (icon_cell(pen, name + "/on", Icon::Cut, {cut.is_on, true, "cut, or not"}))
        pen.wish(SetCut{index, cut.plane, !cut.is_on});
    ImGui::SameLine();
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    if (const auto axis = segments(pen, name, kAxes, axis_of(cut.plane.normal)))
        pen.wish(TurnCut{index, *axis});
    ImGui::SameLine();
    if (push(pen, name + "/other side", "other side"))
        pen.wish(SetCut{index, {-cut.plane.normal, -cut.plane.offset}, cut.is_on});
    ImGui::SameLine();
    if (icon_cell(pen, name + "/remove", Icon::Close, {false, true, "remove"})) pen.wish(RemoveCut{index});
    const float room = ImGui::GetContentRegionAvail().x;
    const auto moved = slider(
        pen,
        name + "/place",
        cut.plane.offset,
        cut.from,
        cut.to,
        with_unit(static_cast<double>(cut.plane.offset) + cut.shift, pen.model.length_unit),
        room
    );
    if (moved) pen.wish(SetCut{index, {cut.plane.normal, *moved}, cut.is_on});
}

}  // namespace

void steps_panel(Pen& pen, float list_width, float slider_width) {
    const UiSteps& steps = pen.model.steps;
    if (steps.names.empty()) return;
    const bool many = steps.names.size() > 1;
    const bool can_play = many || steps.is_mode;
    if (icon_cell(pen, "steps/before", Icon::Back, {false, many, "step before  ,"}))
        pen.wish(Command::PreviousStep);
    ImGui::SameLine(0, pen.points(2));
    const Icon icon = steps.is_playing ? Icon::Pause : Icon::Play;
    if (icon_cell(pen, "steps/play", icon, {steps.is_playing, can_play, "play, pause  Space"}))
        pen.wish(Command::PlaySteps);
    ImGui::SameLine(0, pen.points(2));
    if (icon_cell(pen, "steps/after", Icon::Next, {false, many, "step after  ."}))
        pen.wish(Command::NextStep);
    ImGui::SameLine();
    if (const auto chosen = choice(pen, "steps/list", steps.names, steps.shown, list_width))
        if (*chosen != steps.shown) pen.wish(GoToStep{*chosen});
    if (!many) return;
    if (!pen.is_board) ImGui::SameLine();
    const auto last = static_cast<float>(steps.names.size() - 1);
    const auto moved = slider(
        pen,
        "steps/slider",
        static_cast<float>(steps.shown),
        0,
        last,
        fmt::format("{} of {}", steps.shown + 1, steps.names.size()),
        slider_width
    );
    if (!moved) return;
    const auto step = static_cast<std::size_t>(std::lround(std::clamp(*moved, 0.0F, last)));
    if (step != steps.shown) pen.wish(GoToStep{step});
}

void deformation_panel(Pen& pen) {
    const UiDeformation& now = pen.model.deformation;
    ImGui::AlignTextToFramePadding();
    soft_text(pen, "Deformation");
    if (!pen.is_board) ImGui::SameLine();
    constexpr std::array<const char*, 3> kFactors{"undeformed", "true", "5 %"};
    std::optional<std::size_t> on;
    if (now.is_there && now.is_automatic)
        on = 2;
    else if (now.factor == 0)
        on = 0;
    else if (now.factor == 1)
        on = 1;
    if (const auto chosen = segments(pen, "deformation", kFactors, on, now.is_there)) {
        if (*chosen == 0) pen.wish(Command::NoDeformation);
        if (*chosen == 1) pen.wish(Command::TrueDeformation);
        if (*chosen == 2) pen.wish(SetFactor{});
    }
    if (!now.is_there) return;
    ImGui::SameLine();
    soft_text(pen, "×");
    ImGui::SameLine(0, pen.points(4));
    if (const auto typed = number_field(pen, "deformation/factor", now.factor, pen.points(74)))
        pen.wish(SetFactor{*typed});
}

void parts_panel(Pen& pen) {
    if (ImGui::BeginTable("parts", 4, ImGuiTableFlags_None)) {
        const auto fixed = ImGuiTableColumnFlags_WidthFixed;
        ImGui::TableSetupColumn("", fixed, pen.points(30));
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("", fixed, pen.points(30));
        ImGui::TableSetupColumn("", fixed, pen.points(30));
        for (std::size_t i = 0; i < pen.model.parts.size(); ++i) part_row(pen, i);
        ImGui::EndTable();
    }
    const bool touched =
        std::ranges::any_of(pen.model.parts, [](const UiPart& part) { return part.look != PartLook::Shown; });
    if (push(pen, "show all", "Show everything", {.enabled = touched})) pen.wish(ShowAllParts{});
}

void cuts_panel(Pen& pen) {
    for (std::size_t i = 0; i < pen.model.cuts.size(); ++i) cut_row(pen, i);
    ImGui::AlignTextToFramePadding();
    soft_text(pen, "Add a plane across");
    ImGui::SameLine();
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    if (const auto axis = segments(pen, "add", kAxes, std::nullopt, pen.model.cuts.size() < kMostCuts)) {
        glm::vec3 normal(0);
        normal[static_cast<int>(*axis)] = 1;
        pen.wish(AddCut{normal});
    }
    if (pen.model.cuts.empty()) return;
    if (push(pen, "all", pen.model.cuts_are_on ? "Leave uncut" : "Cut again")) pen.wish(Command::ToggleClip);
    ImGui::SameLine();
    if (push(pen, "back", "Back")) pen.wish(Command::ClipBack);
    ImGui::SameLine();
    if (push(pen, "ahead", "Ahead")) pen.wish(Command::ClipForward);
    small_lines(
        pen, "A scene holds the skin alone: what a plane opens is hatched, without values.", pen.colours.soft
    );
}

}  // namespace feelem::viewer
