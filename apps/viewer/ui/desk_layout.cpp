// SPDX-License-Identifier: Apache-2.0
// The window: a bar above, results and sections to the left, the legend to the right, steps below, the model
// between them.
#include "viewer/ui/layouts.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// As fold() names it.
constexpr const char* kSettingsId = "Range, colours##legend/settings";
constexpr float kTopHeight = 48, kBottomHeight = 46;
constexpr float kLeftShare = 0.3F, kLeftLeast = 280, kLeftMost = 384;
constexpr float kRightShare = 0.155F, kRightLeast = 150, kRightMost = 200;
constexpr float kCardWidth = 350, kCardLeast = 260, kDeformationWidth = 400;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus;
constexpr ImGuiWindowFlags kStill = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
constexpr ImGuiWindowFlags kFloating =
    (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_AlwaysAutoResize;

bool begin_at(const char* name, const UiRect& rect, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    return ImGui::Begin(name, nullptr, kFixed | flags);
}

void line_between(const Pen& pen, ImVec2 from, ImVec2 to) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddLine(from, to, pen.colours.line, std::max(1.0F, std::round(pen.unit)));
    list.PopClipRect();
}

/// The program's sign: three bars.
void mark(const Pen& pen) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr std::array<float, 3> kHeights{10, 22, 15};
    constexpr std::array<unsigned, 3> kStrengths{255, 191, 128};
    const float floor = corner.y + pen.points(25);
    for (std::size_t i = 0; i < 3; ++i) {
        const float x = corner.x + pen.points(8.0F * static_cast<float>(i));
        list.AddRectFilled(
            {x, floor - pen.points(kHeights.at(i))},
            {x + pen.points(5), floor},
            with_alpha(pen.colours.accent, kStrengths.at(i)),
            pen.points(2)
        );
    }
    ImGui::Dummy({pen.points(24), pen.points(30)});
}

void top_bar(Pen& pen, const UiRect& rect) {
    begin_at("top", rect, kStill);
    pen.group = "top/";
    mark(pen);
    ImGui::SameLine(0, pen.points(12));
    ImGui::BeginGroup();
    ImGui::SetCursorPosY(pen.points(14));
    ImGui::PushFont(pen.fonts.title);
    text(pen.model.title.empty() ? "Feelem" : pen.model.title);
    ImGui::PopFont();
    ImGui::EndGroup();
    ImGui::SameLine(0, pen.points(12));
    ImGui::SetCursorPosY(pen.points(16));
    soft_text(pen, pen.model.solver);
    constexpr int kTools = 6;
    const float tools = kTools * pen.points(32) + pen.points(20);
    const std::string& headset = pen.model.headset.what;
    ImGui::PushFont(pen.fonts.small);
    const float words = width_of(headset) + pen.points(30);
    ImGui::PopFont();
    const bool has_room = rect.width - tools - words > ImGui::GetItemRectMax().x - rect.x + pen.points(20);
    const float tools_at = rect.width - tools;
    if (has_room && !headset.empty()) {
        ImGui::SameLine(tools_at - words);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImU32 colour = pen.model.headset.is_running ? pen.colours.accent : pen.colours.soft;
        draw_icon(
            *ImGui::GetWindowDrawList(),
            Icon::Headset,
            {at.x, rect.y + pen.points(15)},
            pen.points(18),
            colour
        );
        ImGui::SetCursorPos({tools_at - words + pen.points(23), pen.points(17)});
        small_text(pen, headset, colour);
    }
    ImGui::SetCursorPos({tools_at, pen.points(9)});
    drawing_panel(pen);
    ImGui::SameLine(0, pen.points(2));
    const UiSound& sound = pen.model.sound;
    if (icon_cell(
            pen,
            "sound",
            sound.is_muted ? Icon::Mute : Icon::Sound,
            {!sound.is_muted, true, "sound on, off  M"}
        ))
        pen.wish(Command::ToggleMute);
    ImGui::SameLine(0, pen.points(2));
    if (icon_cell(pen, "touch", Icon::Hand, {!pen.model.touch.is_still, true, "touch on, off  V"}))
        pen.wish(Command::ToggleStill);
    ImGui::SameLine(0, pen.points(10));
    const bool is_dark = pen.model.theme == Theme::Dark;
    if (icon_cell(pen, "theme", Icon::Theme, {false, true, "dark, light  T"}))
        pen.wish(SetTheme{is_dark ? Theme::Light : Theme::Dark});
    ImGui::SameLine(0, pen.points(2));
    if (icon_cell(pen, "help", Icon::Keys, {pen.model.show_help, true, "keys  F1"}))
        pen.wish(SetHelp{!pen.model.show_help});
    line_between(pen, {rect.x, rect.y + rect.height - 1}, {rect.x + rect.width, rect.y + rect.height - 1});
    ImGui::End();
}

float slider_width(const Pen& pen, const UiRect& bottom) {
    return std::clamp(bottom.width * 0.14F, pen.points(60), pen.points(180));
}
float list_width(const Pen& pen, const UiRect& bottom) {
    return std::clamp(bottom.width * 0.24F, pen.points(90), pen.points(240));
}
/// Beside the steps; else it is a section on the left.
bool deformation_fits(const Pen& pen, const UiRect& bottom) {
    const float steps = pen.points(3 * 32 + 40) + slider_width(pen, bottom) + list_width(pen, bottom);
    return bottom.width > steps + pen.points(kDeformationWidth);
}

std::string count_note(std::size_t count) {
    return count == 0 ? std::string() : fmt::format("{}", count);
}

void left_column(Pen& pen, const UiRect& rect, bool with_deformation) {
    const UiModel& model = pen.model;
    begin_at("left", rect, 0);
    const auto section =
        [&](const char* group, const char* title, const std::string& note, bool open, void (*panel)(Pen&)) {
            pen.group = std::string(group) + "/";
            const bool is_open = fold(pen, "fold", title, note, open);
            if (!is_open) return;
            panel(pen);
            ImGui::Dummy({0, pen.points(4)});
        };
    pen.group = "results/";
    results_panel(pen);
    ImGui::Dummy({0, pen.points(4)});
    const bool needs_help = !model.headset.todo.empty() && !model.headset.is_running;
    if (needs_help) section("headset", "Headset", "", true, headset_panel);
    if (with_deformation) section("shape", "Deformation", "", true, deformation_panel);
    section("limits", "Limits", "", false, limits_panel);
    section("parts", "Parts", count_note(model.parts.size()), model.parts.size() > 1, parts_panel);
    section("section", "Section", count_note(model.cuts.size()), false, cuts_panel);
    section("places", "Hot spots", "", true, hot_spots_panel);
    section("notes", "Notes", count_note(model.markers.size()), false, markers_panel);
    section("sound", "Sound", "", true, sound_panel);
    section("touch", "Touch", "", true, touch_panel);
    if (!needs_help) section("headset", "Headset", "", false, headset_panel);
    section("certificate", "Certificate", "", false, certificate_panel);
    const float edge = rect.x + rect.width - 1;
    line_between(pen, {edge, rect.y}, {edge, rect.y + rect.height});
    ImGui::End();
}

void right_column(Pen& pen, const UiRect& rect) {
    begin_at("right", rect, 0);
    pen.group = "legend/";
    // The scale makes room for the form once that is open.
    const ImGuiID form = ImGui::GetID(kSettingsId);
    const bool is_open = ImGui::GetStateStorage()->GetInt(form) != 0;
    legend_panel(pen, ImGui::GetContentRegionAvail().y - pen.points(is_open ? 420 : 44));
    ImGui::Dummy({0, pen.points(4)});
    legend_settings(pen);
    line_between(pen, {rect.x, rect.y}, {rect.x, rect.y + rect.height});
    ImGui::End();
}

void bottom_bar(Pen& pen, const UiRect& rect) {
    begin_at("bottom", rect, kStill);
    pen.group = "";
    ImGui::SetCursorPosY(pen.points(8));
    ImGui::BeginGroup();
    steps_panel(pen, list_width(pen, rect), slider_width(pen, rect));
    ImGui::EndGroup();
    if (deformation_fits(pen, rect)) {
        ImGui::SameLine(rect.width - pen.points(kDeformationWidth));
        deformation_panel(pen);
    }
    line_between(pen, {rect.x, rect.y}, {rect.x + rect.width, rect.y});
    ImGui::End();
}

/// What floats over the stage looks like a sheet upon it.
class Sheet {
public:
    Sheet(const Pen& pen, ImU32 border, float thickness) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, pen.points(9));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, thickness);
        ImGui::PushStyleColor(ImGuiCol_Border, border);
    }
    ~Sheet() {
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(2);
    }
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;
};

void card_sheet(Pen& pen, const UiRect& stage) {
    if (!pen.model.card) return;
    const UiCard& card = *pen.model.card;
    const bool is_beyond = std::ranges::any_of(card.rows, &UiCardRow::beyond);
    const Sheet sheet(pen, is_beyond ? pen.colours.alarm : pen.colours.line, pen.points(is_beyond ? 2 : 1));
    const float half = stage.width / 2 - pen.points(20);
    const float width = std::min(std::max(half, pen.points(kCardLeast)), pen.points(kCardWidth));
    // On the other side while the pointer is near: what is pointed at stays in sight.
    const float gap = pen.points(10);
    const bool is_near = pen.pointer && pen.pointer->x < stage.x + stage.width / 2 &&
                         pen.pointer->y < stage.y + stage.height * 0.6F;
    const float x = is_near ? stage.x + stage.width - width - gap : stage.x + gap;
    ImGui::SetNextWindowPos({x, stage.y + gap});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, stage.height});
    // Only what can be let go of can be pressed; the rest lets the pointer through.
    const ImGuiWindowFlags flags = card.is_pinned ? kFloating : kFloating | ImGuiWindowFlags_NoInputs;
    ImGui::Begin("card", nullptr, flags);
    pen.group = "";
    ImGui::PushStyleColor(ImGuiCol_Border, pen.colours.line);
    card_panel(pen, card);
    ImGui::PopStyleColor();
    ImGui::End();
}

void views_sheet(Pen& pen, const UiRect& stage) {
    const Sheet sheet(pen, pen.colours.line, pen.points(1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pen.points(4), pen.points(4)});
    const float below = stage.y + stage.height - pen.points(10);
    ImGui::SetNextWindowPos({stage.x + pen.points(10), below}, 0, {0, 1});
    ImGui::Begin("views", nullptr, kFloating);
    pen.group = "";
    views_panel(pen);
    ImGui::End();
    ImGui::PopStyleVar();
}

void said_at_the_edge(Pen& pen, const UiRect& stage) {
    const float middle = stage.x + stage.width / 2;
    if (!pen.model.trouble.empty()) {
        const Sheet sheet(pen, pen.colours.alarm, pen.points(1));
        ImGui::SetNextWindowPos({middle, stage.y + pen.points(14)}, 0, {0.5F, 0});
        ImGui::Begin("trouble", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
        ImGui::PushTextWrapPos(stage.width * 0.8F);
        ImGui::TextUnformatted(pen.model.trouble.c_str());
        ImGui::PopTextWrapPos();
        ImGui::End();
    }
    if (pen.model.message.empty()) return;
    const Sheet sheet(pen, pen.colours.ink, 0);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, pen.colours.ink);
    ImGui::SetNextWindowPos({middle, stage.y + stage.height - pen.points(52)}, 0, {0.5F, 1});
    ImGui::Begin("message", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
    ImGui::PushTextWrapPos(stage.width * 0.8F);
    text_in(pen.colours.panel, pen.model.message);
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleColor();
}

void help_sheet(Pen& pen, glm::ivec2 pixels) {
    if (!pen.model.show_help) return;
    const Sheet sheet(pen, pen.colours.line, pen.points(1));
    ImGui::SetNextWindowPos(
        {static_cast<float>(pixels.x) / 2, static_cast<float>(pixels.y) / 2}, 0, {0.5F, 0.5F}
    );
    ImGui::SetNextWindowSizeConstraints({0, 0}, {static_cast<float>(pixels.x), static_cast<float>(pixels.y)});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("help", nullptr, kFloating);
    pen.group = "help/";
    ImGui::PushFont(pen.fonts.title);
    text("Keys");
    ImGui::PopFont();
    keys_panel(pen);
    if (push(pen, "close", "Close")) pen.wish(SetHelp{false});
    ImGui::End();
}

}  // namespace

DeskRects desk_rects(glm::ivec2 pixels, float unit) {
    const auto width = static_cast<float>(std::max(pixels.x, 1));
    const auto height = static_cast<float>(std::max(pixels.y, 1));
    const auto clamped = [&](float share, float least, float most) {
        return std::round(std::clamp(width * share, least * unit, most * unit));
    };
    const float top = std::min(std::round(kTopHeight * unit), height);
    const float bottom = std::min(std::round(kBottomHeight * unit), height - top);
    const float left = std::min(clamped(kLeftShare, kLeftLeast, kLeftMost), width);
    const float right = std::min(clamped(kRightShare, kRightLeast, kRightMost), width - left);
    const float high = height - top - bottom;
    const float wide = width - left - right;
    return {
        .top = {0, 0, width, top},
        .left = {0, top, left, height - top},
        .stage = {left, top, wide, high},
        .right = {left + wide, top, right, high},
        .bottom = {left, top + high, wide + right, bottom}};
}

void draw_desk(Pen& pen, glm::ivec2 pixels) {
    const DeskRects rects = desk_rects(pixels, pen.unit);
    left_column(pen, rects.left, !deformation_fits(pen, rects.bottom));
    right_column(pen, rects.right);
    bottom_bar(pen, rects.bottom);
    top_bar(pen, rects.top);
    views_sheet(pen, rects.stage);
    card_sheet(pen, rects.stage);
    said_at_the_edge(pen, rects.stage);
    help_sheet(pen, pixels);
}

}  // namespace feelem::viewer
