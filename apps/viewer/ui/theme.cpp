// SPDX-License-Identifier: Apache-2.0
// The look of the panels.
#include "viewer/ui/theme.hpp"

#include <array>
#include <filesystem>
#include <string>

namespace feelem::viewer {
namespace {

constexpr std::array<const char*, 2> kFontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"};
constexpr std::array<const char*, 2> kBoldFontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"};

/// Latin, Greek, Cyrillic, and the signs that panels and units use.
constexpr std::array<ImWchar, 19> kSigns{
    0x20,
    0x17F,
    0x370,
    0x4FF,
    0x2010,
    0x203A,
    0x2070,
    0x209C,
    0x2190,
    0x2193,
    0x21E7,
    0x21E7,
    0x2202,
    0x221E,
    0x2248,
    0x2265,
    0x25A0,
    0x25CF,
    0};

constexpr ImU32 rgb(unsigned hex) {
    return IM_COL32(hex >> 16U, (hex >> 8U) & 0xFFU, hex & 0xFFU, 0xFF);
}

ImFont* load_font(std::span<const char* const> files, float height) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2;
    for (const char* file : files)
        if (std::error_code none; std::filesystem::exists(file, none))
            return atlas.AddFontFromFileTTF(file, height, &config, kSigns.data());
    config.SizePixels = height;
    return atlas.AddFontDefault(&config);
}

}  // namespace

UiColours desk_colours(Theme theme) {
    if (theme == Theme::Dark)
        return {
            .paper = rgb(0x11161A),
            .panel = rgb(0x182025),
            .ink = rgb(0xE8ECED),
            .soft = rgb(0x98A7AF),
            .faint = rgb(0x748189),
            .line = rgb(0x2A353B),
            .accent = rgb(0x74C9C6),
            .accent_soft = rgb(0x1D3B3F),
            .alarm = rgb(0xFF7AC4),
            .hover = rgb(0x11161A)};
    return {
        .paper = rgb(0xEEF0EE),
        .panel = rgb(0xFAFAF8),
        .ink = rgb(0x182125),
        .soft = rgb(0x55626A),
        .faint = rgb(0x7D8990),
        .line = rgb(0xD5DAD8),
        .accent = rgb(0x0F5F66),
        .accent_soft = rgb(0xD8E8E7),
        .alarm = rgb(0xB3006B),
        .hover = rgb(0xEEF0EE)};
}

UiColours board_colours() {
    return {
        .paper = rgb(0x24323A),
        .panel = rgb(0x182025),
        .ink = rgb(0xEEF2F3),
        .soft = rgb(0xA5B4BC),
        .faint = rgb(0x74838B),
        .line = rgb(0x33414A),
        .accent = rgb(0x74C9C6),
        .accent_soft = rgb(0x1D3B3F),
        .alarm = rgb(0xFF7AC4),
        .hover = rgb(0x24323A)};
}

ImU32 colour_of(const Rgb& rgb) {
    return IM_COL32(rgb[0], rgb[1], rgb[2], 0xFF);
}

UiFonts load_fonts(float plain, float small, float title) {
    UiFonts fonts;
    fonts.plain = load_font(kFontFiles, plain);
    fonts.bold = load_font(kBoldFontFiles, plain);
    fonts.small = small == plain ? fonts.plain : load_font(kFontFiles, small);
    fonts.title = load_font(kBoldFontFiles, title);
    return fonts;
}

void apply_style(const UiColours& c, float unit) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = style.PopupBorderSize = 1;
    style.FrameRounding = 6;
    style.PopupRounding = 8;
    style.GrabRounding = style.ScrollbarRounding = style.TabRounding = 6;
    style.WindowPadding = {12, 10};
    style.FramePadding = {9, 5};
    style.ItemSpacing = {6, 6};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {3, 3};
    style.ScrollbarSize = 11;
    style.GrabMinSize = 13;
    style.WindowMinSize = {1, 1};
    style.DisabledAlpha = 0.5F;
    style.ScaleAllSizes(unit);
    const auto set = [&](ImGuiCol which, ImU32 colour) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
    };
    constexpr ImU32 kNothing = 0;
    set(ImGuiCol_Text, c.ink);
    set(ImGuiCol_TextDisabled, c.faint);
    set(ImGuiCol_WindowBg, c.panel);
    set(ImGuiCol_ChildBg, kNothing);
    set(ImGuiCol_PopupBg, c.panel);
    set(ImGuiCol_Border, c.line);
    set(ImGuiCol_BorderShadow, kNothing);
    set(ImGuiCol_FrameBg, c.panel);
    set(ImGuiCol_FrameBgHovered, c.hover);
    set(ImGuiCol_FrameBgActive, c.accent_soft);
    set(ImGuiCol_ScrollbarBg, kNothing);
    set(ImGuiCol_ScrollbarGrab, c.line);
    set(ImGuiCol_ScrollbarGrabHovered, c.faint);
    set(ImGuiCol_ScrollbarGrabActive, c.soft);
    set(ImGuiCol_CheckMark, c.accent);
    set(ImGuiCol_SliderGrab, c.accent);
    set(ImGuiCol_SliderGrabActive, c.accent);
    set(ImGuiCol_Button, kNothing);
    set(ImGuiCol_ButtonHovered, c.hover);
    set(ImGuiCol_ButtonActive, c.accent_soft);
    set(ImGuiCol_Header, kNothing);
    set(ImGuiCol_HeaderHovered, c.hover);
    set(ImGuiCol_HeaderActive, c.accent_soft);
    set(ImGuiCol_Separator, c.line);
    set(ImGuiCol_SeparatorHovered, c.line);
    set(ImGuiCol_SeparatorActive, c.line);
    set(ImGuiCol_Tab, kNothing);
    set(ImGuiCol_TabHovered, c.hover);
    set(ImGuiCol_TabActive, c.accent_soft);
    set(ImGuiCol_TabUnfocused, kNothing);
    set(ImGuiCol_TabUnfocusedActive, c.accent_soft);
    set(ImGuiCol_TextSelectedBg, c.accent_soft);
    set(ImGuiCol_NavHighlight, c.accent);
    set(ImGuiCol_TableRowBg, kNothing);
    set(ImGuiCol_TableBorderLight, c.line);
    set(ImGuiCol_TableBorderStrong, c.line);
}

}  // namespace feelem::viewer
