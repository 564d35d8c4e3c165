// SPDX-License-Identifier: Apache-2.0
// The boards of the room: a panel with one tab a section, the legend, the card.
#include "viewer/ui/layouts.hpp"
#include "viewer/ui/panels.hpp"

#include <algorithm>
#include <array>

namespace feelem::viewer {
namespace {

constexpr ImGuiWindowFlags kWholeBoard = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                         ImGuiWindowFlags_NoSavedSettings;

struct BoardTab {
    const char* word;
    void (*draw)(Pen&);
};

void steps_tab(Pen& pen) {
    const float room = ImGui::GetContentRegionAvail().x;
    pen.group = "";
    steps_panel(pen, room - pen.points(110), room);
    deformation_panel(pen);
    ImGui::Dummy({0, pen.points(6)});
    soft_text(pen, "Drawn too");
    drawing_panel(pen);
}

void places_tab(Pen& pen) {
    pen.group = "places/";
    bold_text(pen, "Hot spots");
    hot_spots_panel(pen);
    ImGui::Dummy({0, pen.points(6)});
    pen.group = "notes/";
    bold_text(pen, "Notes");
    markers_panel(pen);
}

void senses_tab(Pen& pen) {
    bold_text(pen, "Sound");
    pen.group = "sound/";
    sound_panel(pen);
    ImGui::Dummy({0, pen.points(6)});
    bold_text(pen, "Touch");
    pen.group = "touch/";
    touch_panel(pen);
}

void about_tab(Pen& pen) {
    headset_panel(pen);
    ImGui::Dummy({0, pen.points(6)});
    bold_text(pen, pen.model.title);
    certificate_panel(pen);
}

constexpr std::array<BoardTab, 7> kTabs{
    {{"Results", results_panel},
     {"Steps", steps_tab},
     {"Parts", parts_panel},
     {"Section", cuts_panel},
     {"Places", places_tab},
     {"Senses", senses_tab},
     {"About", about_tab}}};

struct FootButton {
    const char* word;
    Command command;
};

/// Always in reach, whatever tab is open.
void foot(Pen& pen) {
    const std::array<FootButton, 6> buttons{
        {{"Home", Command::Home},
         {"Fit", Command::Fit},
         {"1 : 1", Command::TrueScale},
         {pen.model.sound.is_muted ? "Sound" : "Mute", Command::ToggleMute},
         {pen.model.touch.is_still ? "Touch" : "Still", Command::ToggleStill},
         {"Leave", Command::Leave}}};
    constexpr std::array<const char*, 6> kNames{"home", "fit", "true scale", "mute", "still", "leave"};
    const float gap = pen.points(4);
    const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(buttons.size() - 1)) /
                        static_cast<float>(buttons.size());
    pen.group = "foot/";
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        const bool is_on = (i == 3 && pen.model.sound.is_muted) || (i == 4 && pen.model.touch.is_still);
        if (wide_push(pen, kNames.at(i), buttons.at(i).word, width, {.on = is_on}))
            pen.wish(buttons.at(i).command);
    }
}

void panel_board(Pen& pen) {
    const float foot_height = pen.points(28) + ImGui::GetStyle().ItemSpacing.y + pen.points(4);
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyResizeDown)) {
        for (const BoardTab& tab : kTabs) {
            pen.group = "tab/";
            const bool is_open = ImGui::BeginTabItem(tab.word);
            pen.target(tab.word);
            if (!is_open) continue;
            ImGui::BeginChild("page", {0, -foot_height});
            pen.group = std::string(tab.word) + "/";
            tab.draw(pen);
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    foot(pen);
}

}  // namespace

void draw_board(Pen& pen, Board board, glm::ivec2 pixels) {
    const bool is_beyond = pen.model.card && std::ranges::any_of(pen.model.card->rows, &UiCardRow::beyond);
    const bool alarms = board == Board::Card && is_beyond;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, pen.points(9));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, pen.points(alarms ? 3 : 1));
    ImGui::PushStyleColor(ImGuiCol_Border, alarms ? pen.colours.alarm : pen.colours.line);
    const bool is_panel = board == Board::Panel;
    const bool is_card = board == Board::Card;
    const ImVec2 size{static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
    if (is_card) {
        // As high as what it says, and down to the place that it stands above.
        ImGui::SetNextWindowPos({0, size.y}, 0, {0, 1});
        ImGui::SetNextWindowSizeConstraints({size.x, 0}, size);
    } else {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(size);
    }
    const ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin("board", nullptr, kWholeBoard | still | (is_card ? ImGuiWindowFlags_AlwaysAutoResize : 0));
    if (is_panel) panel_board(pen);
    pen.group = "legend/";
    if (board == Board::Legend) legend_panel(pen, ImGui::GetContentRegionAvail().y);
    if (is_card && pen.model.card) card_panel(pen, *pen.model.card);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace feelem::viewer
