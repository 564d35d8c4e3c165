// SPDX-License-Identifier: Apache-2.0
// What panels are made of. A Pen holds the model, the wishes and the look; each widget that can be pressed
// says where it is, so that scripts and tests find it by name.
#pragma once

#include "viewer/ui/gui.hpp"
#include "viewer/ui/icons.hpp"
#include "viewer/ui/theme.hpp"
#include "viewer/ui/ui_model.hpp"

#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

struct Pen {
    const UiModel& model;
    UiWishes& wishes;
    std::vector<UiTarget>& targets;
    UiColours colours;
    UiFonts fonts;
    float unit = 1;         ///< Pixels a point.
    bool is_board = false;  ///< In the room: nothing can be typed.
    std::optional<glm::vec2> pointer = {};
    std::string group = {};  ///< What targets' names begin with.

    void wish(UiWish wanted) { wishes.push_back(std::move(wanted)); }
    float points(float count) const { return count * unit; }
    /// The last item is a target.
    void target(std::string_view name);
};

struct CellLook {
    bool on = false;
    bool enabled = true;
    std::string_view tip = {};
};
/// A square with an icon; filled while it is on.
bool icon_cell(Pen& pen, std::string_view name, Icon icon, const CellLook& look);
/// A word to press.
bool push(Pen& pen, std::string_view name, const char* word, const CellLook& look = {});
/// As wide as asked for, so that rows of several end alike.
bool wide_push(Pen& pen, std::string_view name, const char* word, float width, const CellLook& look = {});
/// Several words of which one is on; the one that was pressed.
std::optional<std::size_t> segments(
    Pen& pen,
    std::string_view name,
    std::span<const char* const> words,
    std::optional<std::size_t> on,
    bool enabled = true
);
bool check(Pen& pen, std::string_view name, const char* word, bool on);
/// A number to be typed, taken by Enter. On boards it is only shown.
std::optional<double> number_field(
    Pen& pen, std::string_view name, const std::optional<double>& value, float width
);
/// Set anew while it is dragged.
std::optional<float> slider(
    Pen& pen, std::string_view name, float value, float from, float to, const std::string& shown, float width
);
/// A list to choose of.
std::optional<std::size_t> choice(
    Pen& pen, std::string_view name, std::span<const std::string> words, std::size_t on, float width
);

void soft_text(const Pen& pen, std::string_view text);
/// In several lines where it is long.
void soft_lines(const Pen& pen, std::string_view text);
void small_text(const Pen& pen, std::string_view text, ImU32 colour);
void small_lines(const Pen& pen, std::string_view text, ImU32 colour);
void text(std::string_view text);
/// In several lines where it is long; broken between words only, so that no number is torn.
void lines(std::string_view text);
void lines_in(ImU32 colour, std::string_view text);
void bold_lines(const Pen& pen, std::string_view text);
void text_in(ImU32 colour, std::string_view text);
void bold_text(const Pen& pen, std::string_view text);
void text_to_the_right(std::string_view text, ImU32 colour);
void tip_of_last(std::string_view text);
/// A thin line across.
void rule(const Pen& pen);
/// A heading that folds what is under it away; true: it is open.
bool fold(
    Pen& pen, std::string_view name, const std::string& title, const std::string& note, bool open_first
);
/// Width that a text takes in the current font.
float width_of(std::string_view text);

}  // namespace feelem::viewer
