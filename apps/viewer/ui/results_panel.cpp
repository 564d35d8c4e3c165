// SPDX-License-Identifier: Apache-2.0
// Each result is seen, heard, felt, shapes the model, or is off; and its limit.
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

struct SenseColumn {
    Sense sense;
    Icon icon;
    const char* word;
    const char* verb;
    const char* name;
};
constexpr std::array<SenseColumn, 5> kSenseColumns{
    {{Sense::Colour, Icon::Eye, "Colour", "seen as colour", "colour"},
     {Sense::Pitch, Icon::Ear, "Tone", "heard as pitch", "pitch"},
     {Sense::Ticks, Icon::Ticks, "Ticks", "heard as ticks", "ticks"},
     {Sense::Pulses, Icon::Hand, "Touch", "felt as pulses", "pulses"},
     {Sense::Shape, Icon::Shape, "Shape", "shown as shape", "shape"}}};

const SenseColumn& column_of(Sense sense) {
    return *std::ranges::find(kSenseColumns, sense, &SenseColumn::sense);
}

bool drives(const UiResult& result, Sense sense) {
    return std::ranges::find(result.senses, sense) != result.senses.end();
}

void middle_text(const Pen& pen, const char* word, float width) {
    ImGui::PushFont(pen.fonts.small);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, (width - width_of(word)) / 2));
    soft_text(pen, word);
    ImGui::PopFont();
}

void head_row(const Pen& pen, float side) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    small_text(pen, "Result", pen.colours.soft);
    for (const SenseColumn& column : kSenseColumns) {
        ImGui::TableNextColumn();
        middle_text(pen, column.word, side);
    }
    ImGui::TableNextColumn();
    middle_text(pen, "Off", side);
}

void result_row(Pen& pen, const UiResult& result, float width) {
    const auto to_middle = [&] {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::round((width - pen.points(30)) / 2));
    };
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {pen.points(6), pen.points(1)});
    bold_lines(pen, result.label);
    const std::string range =
        result.range
            ? fmt::format("{} … {}", number_text(result.range->lo), with_unit(result.range->hi, result.unit))
            : "not in this scene";
    small_lines(pen, range, pen.colours.soft);
    ImGui::PopStyleVar();
    for (const SenseColumn& column : kSenseColumns) {
        ImGui::TableNextColumn();
        to_middle();
        const bool on = drives(result, column.sense);
        const bool enabled =
            result.range.has_value() && (column.sense != Sense::Shape || result.can_shape || on);
        if (icon_cell(
                pen, fmt::format("{}/{}", result.key, column.name), column.icon, {on, enabled, column.verb}
            ))
            pen.wish(AssignSense{result.key, column.sense, !on});
    }
    ImGui::TableNextColumn();
    to_middle();
    const CellLook off{result.senses.empty(), true, "off: on the card alone"};
    if (icon_cell(pen, result.key + "/off", Icon::Off, off)) pen.wish(ReleaseAll{result.key});
}

}  // namespace

const char* verb_of(Sense sense) {
    return column_of(sense).verb;
}

Icon icon_of(Sense sense) {
    return column_of(sense).icon;
}

void results_panel(Pen& pen) {
    if (pen.model.results.empty()) {
        soft_lines(pen, "This scene holds no results: only the shape can be looked at.");
        return;
    }
    // Words over the cells need more room in the room's large letters.
    const float column = pen.points(pen.is_board ? 47 : 38);
    const auto table = [&](const char* name, ImGuiTableFlags flags, auto rows) {
        constexpr int kColumns = static_cast<int>(kSenseColumns.size()) + 2;
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0, pen.points(5)});
        if (ImGui::BeginTable(name, kColumns, flags)) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
            for (int i = 1; i < kColumns; ++i)
                ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, column);
            rows();
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
    };
    // The line above a table's first row parts the heads from the results.
    table("heads", ImGuiTableFlags_None, [&] { head_row(pen, column); });
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    table("results", ImGuiTableFlags_BordersInnerH, [&] {
        for (const UiResult& result : pen.model.results) result_row(pen, result, column);
    });
}

void limits_panel(Pen& pen) {
    for (const UiResult& result : pen.model.results) {
        ImGui::PushID(result.key.c_str());
        ImGui::AlignTextToFramePadding();
        text(result.label);
        const float width = pen.points(84);
        const auto typed = number_field(pen, result.key + "/limit", result.limit, width);
        if (typed) pen.wish(SetLimit{result.key, *typed, result.limit_is_upper});
        ImGui::SameLine();
        soft_text(pen, unit_text(result.unit));
        constexpr std::array<const char*, 2> kWays{"at most", "at least"};
        ImGui::SameLine();
        const auto way = segments(
            pen, result.key + "/way", kWays, result.limit_is_upper ? 0U : 1U, result.limit.has_value()
        );
        if (way) pen.wish(SetLimit{result.key, result.limit, *way == 0});
        ImGui::SameLine();
        if (icon_cell(
                pen, result.key + "/no limit", Icon::Close, {false, result.limit.has_value(), "no limit"}
            ))
            pen.wish(SetLimit{result.key, std::nullopt, result.limit_is_upper});
        ImGui::PopID();
    }
}

}  // namespace feelem::viewer
