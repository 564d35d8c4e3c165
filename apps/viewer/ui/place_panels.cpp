// SPDX-License-Identifier: Apache-2.0
// Hot spots, notes, views, and what is drawn beside the colours.
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

bool has_limit(const UiModel& model) {
    for (const UiHotSpot& spot : model.hot_spots)
        if (spot.utilisation) return true;
    return false;
}

void hot_row(Pen& pen, std::size_t index, bool with_use) {
    const UiHotSpot& spot = pen.model.hot_spots[index];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string number = fmt::format("{}", index + 1);
    if (push(
            pen,
            fmt::format("hot spot {}", index + 1),
            number.c_str(),
            {.on = spot.is_chosen, .tip = spot.label}
        ))
        pen.wish(GoToHotSpot{index});
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const bool is_past = spot.utilisation && *spot.utilisation > 1;
    text_in(is_past ? pen.colours.alarm : pen.colours.ink, with_unit(spot.value, spot.unit));
    if (with_use) {
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        soft_text(pen, spot.utilisation ? fmt::format("{} %", number_text(100 * *spot.utilisation, 4)) : "–");
    }
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    soft_text(pen, fmt::format("node {}", spot.node));
}

}  // namespace

void hot_spots_panel(Pen& pen) {
    if (pen.model.hot_spots.empty()) {
        soft_lines(pen, "No peaks of the visible skin: no result is seen, or all of it is hidden.");
        return;
    }
    const bool with_use = has_limit(pen.model);
    if (ImGui::BeginTable("hot", with_use ? 4 : 3, ImGuiTableFlags_SizingFixedFit)) {
        for (std::size_t i = 0; i < pen.model.hot_spots.size(); ++i) hot_row(pen, i, with_use);
        ImGui::EndTable();
    }
    if (push(pen, "hot spots/before", "Before")) pen.wish(Command::PreviousHotSpot);
    ImGui::SameLine();
    if (push(pen, "hot spots/next", "Next")) pen.wish(Command::NextHotSpot);
}

void markers_panel(Pen& pen) {
    for (std::size_t i = 0; i < pen.model.markers.size(); ++i) {
        const UiMarker& marker = pen.model.markers[i];
        const std::string number = fmt::format("{}", i + 1);
        if (push(pen, "note " + number, number.c_str(), {.tip = "go there"})) pen.wish(GoToMarker{i});
        ImGui::SameLine();
        std::string words = marker.node ? fmt::format("node {}", *marker.node) : std::string("no node");
        if (!std::isnan(marker.value)) words += " · " + with_unit(marker.value, marker.unit);
        if (!marker.text.empty()) words += " · " + marker.text;
        ImGui::AlignTextToFramePadding();
        text(words);
        const float side = pen.points(30);
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - side);
        if (icon_cell(pen, "note " + number + "/remove", Icon::Close, {false, true, "remove"}))
            pen.wish(RemoveMarker{i});
    }
    if (push(pen, "note here", "Note here", {.tip = "P"})) pen.wish(Command::PlaceMarker);
    ImGui::SameLine();
    if (push(pen, "notes/remove", "Remove all", {.enabled = !pen.model.markers.empty()}))
        pen.wish(Command::RemoveMarkers);
}

void views_panel(Pen& pen) {
    if (icon_cell(pen, "views/home", Icon::Home, {false, true, "first view  Home"})) pen.wish(LookFrom{});
    ImGui::SameLine(0, pen.points(2));
    if (icon_cell(pen, "views/fit", Icon::Fit, {false, true, "fit  F"})) pen.wish(Command::Fit);
    struct View {
        const char* word;
        glm::vec3 from;
    };
    const std::array<View, 7> views{
        {{"x", {1, 0, 0}},
         {"y", {0, 1, 0}},
         {"z", {0, 0, 1}},
         {"−x", {-1, 0, 0}},
         {"−y", {0, -1, 0}},
         {"−z", {0, 0, -1}},
         {"iso", {1, 1, 1}}}};
    for (const View& view : views) {
        ImGui::SameLine(0, pen.points(2));
        if (wide_push(pen, std::string("views/") + view.word, view.word, pen.points(34)))
            pen.wish(LookFrom{view.from});
    }
}

void drawing_panel(Pen& pen) {
    if (icon_cell(pen, "edges", Icon::Mesh, {pen.model.edges, true, "element edges  E"}))
        pen.wish(Command::ToggleEdges);
    ImGui::SameLine(0, pen.points(2));
    if (icon_cell(pen, "ghost", Icon::Ghost, {pen.model.ghost, true, "undeformed shape as lines  U"}))
        pen.wish(Command::ToggleGhost);
}

}  // namespace feelem::viewer
