// SPDX-License-Identifier: Apache-2.0
// The colour bar with its numbers, and the form that changes it.
#include "viewer/ui/numbers.hpp"
#include "viewer/ui/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kBarWidth = 30, kLabelGap = 10, kSwatch = 12;
constexpr int kMostBands = 64;
/// A label so near to the limit's, as a part of the scale, makes room for it.
constexpr double kTooNear = 0.03;

/// Row by row in the colour that the model takes there; rows of one colour in one piece.
void paint_bar(ImDrawList& list, ImVec2 corner, ImVec2 size, const ColourEffect& effect) {
    const int rows = std::max(1, static_cast<int>(size.y));
    const auto colour_at = [&](int row) { return palette_colour(1 - (row + 0.5) / rows, effect); };
    int from = 0;
    Rgb colour = colour_at(0);
    for (int row = 1; row <= rows; ++row) {
        const Rgb next = row < rows ? colour_at(row) : colour;
        if (row < rows && next == colour) continue;
        list.AddRectFilled(
            {corner.x, corner.y + static_cast<float>(from)},
            {corner.x + size.x, corner.y + static_cast<float>(row)},
            colour_of(colour)
        );
        from = row;
        colour = next;
    }
}

/// Where a value stands on the bar; empty: nowhere.
std::optional<double> position_of(const std::optional<double>& value, const ValueRange& range) {
    if (!value) return std::nullopt;
    const Normalised at = normalise(*value, range);
    return at.missing ? std::nullopt : std::optional(at.position);
}

struct Bar {
    ImVec2 corner, size;
    float at(double position) const { return corner.y + size.y * static_cast<float>(1 - position); }
};

void paint_limit(const Pen& pen, const Bar& bar, double position) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thick = std::max(2.0F, std::round(pen.points(2)));
    const float y = std::round(bar.at(position));
    const float left = bar.corner.x - pen.points(3);
    const float right = bar.corner.x + bar.size.x + pen.points(9);
    list.AddRectFilled({left, y - thick}, {right, y}, IM_COL32_WHITE);
    list.AddRectFilled({left, y}, {right, y + thick}, IM_COL32_BLACK);
}

void paint_probe(const Pen& pen, const Bar& bar, double position) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = bar.at(position);
    const float left = bar.corner.x - pen.points(7);
    const float tall = pen.points(5);
    list.AddLine({left, y}, {bar.corner.x + bar.size.x + pen.points(5), y}, pen.colours.ink, pen.points(2));
    list.AddTriangleFilled(
        {left - pen.points(4), y - tall},
        {left - pen.points(4), y + tall},
        {left + pen.points(2), y},
        pen.colours.ink
    );
}

void paint_label(const Pen& pen, const Bar& bar, double position, const std::string& text, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = bar.at(position);
    const float left = bar.corner.x + bar.size.x;
    list.AddLine({left, y}, {left + pen.points(6), y}, pen.colours.soft, std::max(1.0F, pen.unit));
    const float high = ImGui::GetFontSize();
    list.AddText({left + pen.points(kLabelGap), y - high / 2}, colour, text.c_str());
}

/// So many labels are left out that those that stay do not touch.
std::size_t label_stride(std::size_t count, float height) {
    const float room = ImGui::GetFontSize() * 1.25F;
    std::size_t stride = 1;
    while (stride < count && height / static_cast<float>(count - 1) * static_cast<float>(stride) < room)
        ++stride;
    return stride;
}

std::string limit_word(const UiLegend& legend) {
    const std::string number = number_text(*legend.limit);
    const bool is_number_again = legend.limit_label.starts_with(number);
    return fmt::format(
        "{} {}", number, legend.limit_label.empty() || is_number_again ? "limit" : legend.limit_label
    );
}

void paint_labels(const Pen& pen, const Bar& bar, const UiLegend& legend, std::optional<double> limit) {
    const std::vector<double> positions = label_positions(legend.colour.bands);
    std::vector<double> values;
    for (const double t : positions) values.push_back(value_at_position(t, legend.range));
    const std::vector<std::string> texts = axis_texts(values);
    const std::size_t last = positions.size() - 1;
    const std::size_t stride = label_stride(positions.size(), bar.size.y);
    const double too_near = std::max(kTooNear, 1.1 * static_cast<double>(ImGui::GetFontSize() / bar.size.y));
    for (std::size_t i = 0; i <= last; ++i) {
        const bool is_spare = i != last && (i % stride != 0 || last - i < stride);
        const bool makes_room = limit && std::abs(positions[i] - *limit) <= too_near;
        if (!is_spare && !makes_room) paint_label(pen, bar, positions[i], texts[i], pen.colours.ink);
    }
    if (!limit) return;
    ImGui::PushFont(pen.fonts.bold);
    paint_label(pen, bar, *limit, limit_word(legend), pen.colours.alarm);
    ImGui::PopFont();
}

void swatch(const Pen& pen, const Rgb& colour, const char* word) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = std::round(pen.points(kSwatch));
    const float down = std::round((ImGui::GetTextLineHeight() - side) / 2);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x, corner.y + down}, {corner.x + side, corner.y + down + side}, colour_of(colour)
    );
    ImGui::Dummy({side, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0, pen.points(5));
    small_text(pen, word, pen.colours.soft);
}

void swatches(const Pen& pen, const ColourEffect& effect) {
    swatch(pen, effect.above, "above");
    ImGui::SameLine(0, pen.points(11));
    swatch(pen, effect.below, "below");
    if (!pen.is_board) ImGui::SameLine(0, pen.points(11));
    const float room = ImGui::GetContentRegionAvail().x;
    if (room < pen.points(kSwatch + 5) + width_of("no value")) ImGui::NewLine();
    swatch(pen, effect.missing, "no value");
}

/// The scale with what is marked on it; the cursor comes to stand below.
void scale(Pen& pen, const UiLegend& legend, float height) {
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    const float half_line = std::round(ImGui::GetFontSize() / 2);
    const Bar bar{
        {std::round(begin.x + pen.points(11)), std::round(begin.y) + half_line},
        {std::round(pen.points(kBarWidth)), std::round(height)}};
    paint_bar(*ImGui::GetWindowDrawList(), bar.corner, bar.size, legend.colour);
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, bar.size.y + 2 * half_line});
    std::optional<double> limit;
    if (legend.limit) {
        const Normalised at = normalise(*legend.limit, legend.range);
        if (!at.missing && !at.above && !at.below) limit = at.position;
    }
    paint_labels(pen, bar, legend, limit);
    if (limit) paint_limit(pen, bar, *limit);
    if (const auto probed = position_of(legend.probed, legend.range)) paint_probe(pen, bar, *probed);
}

void limit_outside(Pen& pen, const UiLegend& legend) {
    if (!legend.limit) return;
    const Normalised at = normalise(*legend.limit, legend.range);
    if (at.missing || (!at.above && !at.below)) return;
    small_lines(
        pen,
        fmt::format("limit {}: {} this range", number_text(*legend.limit), at.above ? "above" : "below"),
        pen.colours.soft
    );
}

/// Of what stands under the scale.
float height_below(const Pen& pen, const UiLegend& legend) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    float lines = pen.is_board ? 3 : 4;
    if (!legend.deformation.empty()) lines += 1;
    if (!legend.origin.empty() && !pen.is_board) lines += 2;
    return lines * line;
}

void range_form(Pen& pen, const UiLegend& legend) {
    const float width = pen.points(92);
    for (const bool is_upper : {true, false}) {
        ImGui::AlignTextToFramePadding();
        soft_text(pen, is_upper ? "to" : "from");
        ImGui::SameLine(pen.points(52));
        const double now = is_upper ? legend.range.hi : legend.range.lo;
        const auto typed = number_field(pen, is_upper ? "range/to" : "range/from", now, width);
        if (!typed) continue;
        ValueRange range = legend.range;
        (is_upper ? range.hi : range.lo) = *typed;
        pen.wish(SetRange{legend.key, range});
    }
    if (push(pen, "range/auto", "this step")) pen.wish(SetRangeMode{legend.key, "auto"});
    ImGui::SameLine();
    if (push(pen, "range/allSteps", "all steps")) pen.wish(SetRangeMode{legend.key, "allSteps"});
}

void outside_form(Pen& pen, const UiLegend& legend) {
    const auto one = [&](const char* name, Rgb ColourEffect::*which, const char* word) {
        const Rgb& rgb = legend.colour.*which;
        std::array<float, 3> now{};
        for (std::size_t i = 0; i < 3; ++i) now.at(i) = static_cast<float>(rgb.at(i)) / 255.0F;
        const std::string id = fmt::format("##{}{}", pen.group, name);
        const bool changed = ImGui::ColorEdit3(
            id.c_str(), now.data(), ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip
        );
        pen.target(name);
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        soft_text(pen, word);
        if (!changed) return;
        ColourEffect effect = legend.colour;
        for (std::size_t i = 0; i < 3; ++i)
            (effect.*which).at(i) = static_cast<std::uint8_t>(std::lround(now.at(i) * 255.0F));
        pen.wish(SetColour{effect});
    };
    one("colour/above", &ColourEffect::above, "above");
    one("colour/below", &ColourEffect::below, "below");
    one("colour/missing", &ColourEffect::missing, "no value");
}

}  // namespace

void legend_panel(Pen& pen, float height) {
    const float begin = ImGui::GetCursorPosY();
    if (!pen.model.legend) {
        bold_text(pen, "No result is seen");
        soft_lines(pen, "Choose one under Colour.");
        return;
    }
    const UiLegend& legend = *pen.model.legend;
    bold_lines(pen, legend.title);
    const std::string unit = unit_text(legend.unit);
    soft_text(pen, unit.empty() ? "unit not given" : unit);
    small_lines(pen, legend.step, pen.colours.soft);
    if (!legend.within.empty()) small_lines(pen, "drawn with " + legend.within, pen.colours.soft);
    const float above = ImGui::GetCursorPosY() - begin;
    scale(
        pen, legend, std::clamp(height - above - height_below(pen, legend), pen.points(140), pen.points(440))
    );
    swatches(pen, legend.colour);
    limit_outside(pen, legend);
    if (!legend.deformation.empty()) small_lines(pen, legend.deformation, pen.colours.soft);
    if (!legend.origin.empty() && !pen.is_board) small_lines(pen, legend.origin, pen.colours.soft);
}

void legend_settings(Pen& pen) {
    if (!pen.model.legend) return;
    const UiLegend& legend = *pen.model.legend;
    if (!fold(pen, "settings", "Range, colours", "", false)) return;
    range_form(pen, legend);
    std::vector<std::string> maps;
    std::size_t on = 0;
    for (const std::string_view map : colour_maps()) {
        if (map == legend.colour.map) on = maps.size();
        maps.emplace_back(map);
        std::ranges::replace(maps.back(), '_', ' ');
    }
    ColourEffect effect = legend.colour;
    ImGui::AlignTextToFramePadding();
    soft_text(pen, "map");
    ImGui::SameLine(pen.points(52));
    if (const auto chosen = choice(pen, "map", maps, on, pen.points(112))) {
        effect.map = std::string(colour_maps()[*chosen]);
        pen.wish(SetColour{effect});
    }
    ImGui::AlignTextToFramePadding();
    soft_text(pen, "bands");
    ImGui::SameLine(pen.points(52));
    if (const auto typed = number_field(pen, "bands", effect.bands, pen.points(92))) {
        effect.bands = static_cast<int>(std::lround(std::clamp(*typed, 0.0, double{kMostBands})));
        pen.wish(SetColour{effect});
    }
    if (check(pen, "reversed", "reversed", effect.invert)) {
        effect.invert = !effect.invert;
        pen.wish(SetColour{effect});
    }
    if (check(pen, "isolines", "lines between bands", legend.isolines)) pen.wish(Command::ToggleIsolines);
    outside_form(pen, legend);
}

}  // namespace feelem::viewer
