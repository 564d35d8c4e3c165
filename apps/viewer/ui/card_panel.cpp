// SPDX-License-Identifier: Apache-2.0
// What is at the place that is pointed at: every result with number and unit, and the solver's own at the
// node.
#include "viewer/core/viewer_state.hpp"
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

std::string id_text(const std::optional<std::int64_t>& id) {
    return id ? fmt::format("{}", *id) : "–";
}

/// "above the limit 250 MPa (yield) · 104.2 %"; empty: it is kept, or there is none.
std::string alarm_text(const UiCardRow& row) {
    if (!row.beyond || !row.limit) return {};
    const std::string limit = with_unit(*row.limit, row.unit);
    const std::string label =
        row.limit_label.empty() || row.limit_label == limit ? "" : fmt::format(" ({})", row.limit_label);
    const auto used = utilisation(row.value, row.limit, row.limit_is_upper);
    return fmt::format(
        "{} the limit {}{}{}",
        row.limit_is_upper ? "above" : "below",
        limit,
        label,
        used ? fmt::format(" · {} %", number_text(100 * *used, 4)) : ""
    );
}

std::string value_text(const UiCardRow& row) {
    if (std::isnan(row.value)) return "no value";
    return (row.state == "interpolated" ? "~" : "") + with_unit(row.value, row.unit);
}

std::string node_text(const UiCardRow& row) {
    return row.node_value ? number_text(static_cast<double>(*row.node_value)) : "–";
}

void icons_of(const Pen& pen, const UiCardRow& row) {
    const float side = ImGui::GetFontSize();
    for (const Sense sense : row.senses) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        draw_icon(*ImGui::GetWindowDrawList(), icon_of(sense), corner, side, pen.colours.soft);
        ImGui::Dummy({side, side});
        ImGui::SameLine(0, pen.points(3));
    }
}

/// Icons before the label, or under it where they would tear its words.
void label_of_row(const Pen& pen, const UiCardRow& row) {
    const float icons = static_cast<float>(row.senses.size()) * (ImGui::GetFontSize() + pen.points(3));
    std::string_view rest = row.label;
    float longest = 0;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        longest = std::max(longest, width_of(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool fits = icons + longest <= ImGui::GetContentRegionAvail().x;
    if (fits) icons_of(pen, row);
    lines(row.label);
    if (fits || row.senses.empty()) return;
    icons_of(pen, row);
    ImGui::NewLine();
}

void right_cell(std::string_view line, ImU32 colour, ImFont* font) {
    ImGui::PushFont(font);
    text_to_the_right(line, colour);
    ImGui::PopFont();
}

void card_row(Pen& pen, const UiCardRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    label_of_row(pen, row);
    ImGui::TableNextColumn();
    const bool is_missing = std::isnan(row.value);
    const ImU32 ink = row.beyond ? pen.colours.alarm : is_missing ? pen.colours.soft : pen.colours.ink;
    right_cell(value_text(row), ink, is_missing ? pen.fonts.plain : pen.fonts.bold);
    if (!is_missing && row.bound > 0)
        right_cell(fmt::format("± {}", bound_text(row.bound)), pen.colours.soft, pen.fonts.small);
    ImGui::TableNextColumn();
    right_cell(node_text(row), pen.colours.ink, pen.fonts.plain);
}

/// Of the columns of numbers: heads and values stand in tables of their own.
std::array<float, 2> widths_of(const Pen& pen, const UiCard& card, const std::string& node) {
    std::array<float, 2> out{};
    ImGui::PushFont(pen.fonts.small);
    out[1] = width_of("node " + node);
    ImGui::PopFont();
    for (const UiCardRow& row : card.rows) {
        ImGui::PushFont(pen.fonts.bold);
        out[0] = std::max(out[0], width_of(value_text(row)));
        ImGui::PopFont();
        out[1] = std::max(out[1], width_of(node_text(row)));
    }
    return {out[0] + pen.points(4), out[1] + pen.points(4)};
}

void line_of_limit(const Pen& pen, const UiCardRow& row) {
    if (const std::string alarm = alarm_text(row); !alarm.empty()) {
        lines_in(pen.colours.alarm, fmt::format("{} {}", row.label, alarm));
        return;
    }
    if (const auto used = utilisation(row.value, row.limit, row.limit_is_upper))
        small_lines(
            pen,
            fmt::format("{}: {} % of the limit", row.label, number_text(100 * *used, 3)),
            pen.colours.soft
        );
}

}  // namespace

void card_panel(Pen& pen, const UiCard& card) {
    const std::string node = id_text(card.node);
    const std::array<float, 2> widths = widths_of(pen, card, node);
    const auto table = [&](const char* name, ImGuiTableFlags flags, auto rows) {
        if (!ImGui::BeginTable(name, 3, flags)) return;
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        for (const float width : widths) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, width);
        rows();
        ImGui::EndTable();
    };
    table("heads", ImGuiTableFlags_None, [&] {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TableNextColumn();
        right_cell("here", pen.colours.soft, pen.fonts.small);
        ImGui::TableNextColumn();
        right_cell("node " + node, pen.colours.soft, pen.fonts.small);
    });
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    table("values", ImGuiTableFlags_BordersInnerH, [&] {
        for (const UiCardRow& row : card.rows) card_row(pen, row);
    });
    for (const UiCardRow& row : card.rows) line_of_limit(pen, row);
    small_text(pen, fmt::format("node {} · element {}", node, card.element), pen.colours.ink);
    small_lines(
        pen,
        fmt::format(
            "{} · {} · {} {}",
            number_text(card.place[0], 5),
            number_text(card.place[1], 5),
            number_text(card.place[2], 5),
            unit_text(card.length_unit)
        ),
        pen.colours.soft
    );
    if (!card.sounding.empty()) small_lines(pen, card.sounding, pen.colours.accent);
    if (!card.is_pinned) return;
    if (push(pen, "card/let go", "Let go of this place")) pen.wish(ReleasePin{});
}

}  // namespace feelem::viewer
