// SPDX-License-Identifier: Apache-2.0
// Buttons, fields and texts of the panels.
#include "viewer/ui/widgets.hpp"

#include "viewer/ui/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kCellSide = 30, kIconPoints = 18, kButtonHeight = 28, kSliderWords = 62;

const char* begin_of(std::string_view text) {
    return text.data();
}
const char* end_of(std::string_view text) {
    return text.data() + text.size();
}

/// Buttons that are on look it: accent on its pale shade.
class PushLook {
public:
    PushLook(const Pen& pen, const CellLook& look) : enabled_(look.enabled) {
        if (look.on) {
            ImGui::PushStyleColor(ImGuiCol_Button, pen.colours.accent_soft);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, pen.colours.accent_soft);
            ImGui::PushStyleColor(ImGuiCol_Border, pen.colours.accent);
            ImGui::PushStyleColor(ImGuiCol_Text, pen.colours.accent);
            count_ = 4;
        }
        if (!enabled_) ImGui::BeginDisabled();
    }
    ~PushLook() {
        if (!enabled_) ImGui::EndDisabled();
        ImGui::PopStyleColor(count_);
    }
    PushLook(const PushLook&) = delete;
    PushLook& operator=(const PushLook&) = delete;

private:
    bool enabled_;
    int count_ = 0;
};

/// Bytes of the longest part from the front that is not wider; at least one letter.
std::size_t part_that_fits(std::string_view word, float width) {
    std::size_t end = 0;
    while (end < word.size()) {
        std::size_t next = end + 1;
        while (next < word.size() && (static_cast<unsigned char>(word[next]) & 0xC0U) == 0x80U) ++next;
        if (end > 0 && width_of(word.substr(0, next)) > width) break;
        end = next;
    }
    return end;
}

/// With line breaks where a line of this width is full.
std::string broken(std::string_view line, float width) {
    std::string out;
    float used = 0;
    const float space = width_of(" ");
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        const std::string_view word = line.substr(0, end);
        const float wide = width_of(word);
        if (!out.empty()) {
            // These belong to what stands before them.
            const bool clings = word == "%" || word == "·";
            const bool fits = clings || used + space + wide <= width;
            out += fits ? ' ' : '\n';
            used = fits ? used + space : 0;
        }
        line.remove_prefix(std::min(end + 1, line.size()));
        std::string_view rest = word;
        for (; width_of(rest) > width; used = 0) {
            const std::size_t fits = part_that_fits(rest, width);
            if (fits == rest.size()) break;
            out.append(rest.substr(0, fits)) += '\n';
            rest.remove_prefix(fits);
        }
        out += rest;
        used += width_of(rest);
    }
    return out;
}

std::optional<double> parse_number(std::string text) {
    std::ranges::replace(text, ',', '.');
    const auto from = text.find_first_not_of(" \t+");
    if (from == std::string::npos) return std::nullopt;
    const auto to = text.find_last_not_of(" \t") + 1;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    const bool is_whole = error == std::errc() && end == text.data() + to;
    return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

void Pen::target(std::string_view name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    if (!ImGui::IsItemVisible()) return;
    targets.push_back({group + std::string(name), {low.x, low.y}, {high.x, high.y}});
}

void tip_of_last(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(begin_of(text), end_of(text));
    ImGui::EndTooltip();
}

bool icon_cell(Pen& pen, std::string_view name, Icon icon, const CellLook& look) {
    const float side = pen.points(kCellSide);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::string id(name);
    if (!look.enabled) ImGui::BeginDisabled();
    const bool pressed = ImGui::InvisibleButton(id.c_str(), {side, side});
    const bool hovered = ImGui::IsItemHovered();
    if (!look.enabled) ImGui::EndDisabled();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + side, corner.y + side};
    const float round = pen.points(7);
    if (look.on && look.enabled) list.AddRectFilled(corner, end, pen.colours.accent, round);
    if (hovered) list.AddRect(corner, end, pen.colours.faint, round, 0, std::max(1.0F, pen.unit));
    const ImU32 ink = !look.enabled ? pen.colours.line
                      : look.on     ? pen.colours.panel
                      : hovered     ? pen.colours.ink
                                    : pen.colours.soft;
    const float inset = pen.points((kCellSide - kIconPoints) / 2);
    draw_icon(list, icon, {corner.x + inset, corner.y + inset}, pen.points(kIconPoints), ink);
    pen.target(name);
    tip_of_last(look.tip);
    return pressed;
}

bool push(Pen& pen, std::string_view name, const char* word, const CellLook& look) {
    return wide_push(pen, name, word, 0, look);
}

bool wide_push(Pen& pen, std::string_view name, const char* word, float width, const CellLook& look) {
    const std::string id = std::string(word) + "##" + pen.group + std::string(name);
    bool pressed = false;
    {
        const PushLook shown(pen, look);
        pressed = ImGui::Button(id.c_str(), {width, pen.points(kButtonHeight)});
    }
    pen.target(name);
    tip_of_last(look.tip);
    return pressed;
}

std::optional<std::size_t> segments(
    Pen& pen,
    std::string_view name,
    std::span<const char* const> words,
    std::optional<std::size_t> on,
    bool enabled
) {
    std::optional<std::size_t> pressed;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {pen.points(3), pen.points(3)});
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const std::string id = std::string(name) + "/" + words[i];
        if (push(pen, id, words[i], {.on = on == i, .enabled = enabled})) pressed = i;
    }
    ImGui::PopStyleVar();
    return pressed;
}

bool check(Pen& pen, std::string_view name, const char* word, bool on) {
    const std::string id = std::string(word) + "##" + pen.group + std::string(name);
    bool now = on;
    const bool pressed = ImGui::Checkbox(id.c_str(), &now);
    pen.target(name);
    return pressed;
}

std::optional<double> number_field(
    Pen& pen, std::string_view name, const std::optional<double>& value, float width
) {
    const std::string shown = value ? number_text(*value) : "";
    if (pen.is_board) {
        text(shown);
        return std::nullopt;
    }
    std::array<char, 40> buffer{};
    shown.copy(buffer.data(), buffer.size() - 1);
    const std::string id = "##" + pen.group + std::string(name);
    ImGui::SetNextItemWidth(width);
    const bool taken = ImGui::InputText(
        id.c_str(),
        buffer.data(),
        buffer.size(),
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll
    );
    pen.target(name);
    if (!taken) tip_of_last("Enter takes it");
    // What was not changed stays what it is, digits that are not shown included.
    return taken && shown != buffer.data() ? parse_number(buffer.data()) : std::nullopt;
}

std::optional<float> slider(
    Pen& pen, std::string_view name, float value, float from, float to, const std::string& shown, float width
) {
    const std::string id = "##" + pen.group + std::string(name);
    const float words = std::max(width_of(shown), pen.points(kSliderWords));
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::max(width - words - gap, pen.points(40)));
    float now = value;
    const bool changed = ImGui::SliderFloat(
        id.c_str(), &now, from, to, "", ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_NoInput
    );
    pen.target(name);
    // Beside it: upon it the knob would hide the number.
    ImGui::SameLine(0, gap);
    text(shown);
    return changed ? std::optional(now) : std::nullopt;
}

std::optional<std::size_t> choice(
    Pen& pen, std::string_view name, std::span<const std::string> words, std::size_t on, float width
) {
    std::optional<std::size_t> chosen;
    const std::string id = "##" + pen.group + std::string(name);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo(
        id.c_str(), on < words.size() ? words[on].c_str() : "", ImGuiComboFlags_HeightLarge
    );
    pen.target(name);
    if (!is_open) return std::nullopt;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i] + "##" + std::to_string(i);
        if (ImGui::Selectable(word.c_str(), i == on)) chosen = i;
        pen.target(std::string(name) + "/" + words[i]);
        if (i == on && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    }
    ImGui::EndCombo();
    return chosen;
}

void text(std::string_view text) {
    ImGui::TextUnformatted(begin_of(text), end_of(text));
}

void text_in(ImU32 colour, std::string_view line) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    text(line);
    ImGui::PopStyleColor();
}

void soft_text(const Pen& pen, std::string_view line) {
    text_in(pen.colours.soft, line);
}

void lines(std::string_view line) {
    text(broken(line, ImGui::GetContentRegionAvail().x));
}

void lines_in(ImU32 colour, std::string_view line) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    lines(line);
    ImGui::PopStyleColor();
}

void soft_lines(const Pen& pen, std::string_view line) {
    lines_in(pen.colours.soft, line);
}

void small_text(const Pen& pen, std::string_view line, ImU32 colour) {
    ImGui::PushFont(pen.fonts.small);
    text_in(colour, line);
    ImGui::PopFont();
}

void small_lines(const Pen& pen, std::string_view line, ImU32 colour) {
    ImGui::PushFont(pen.fonts.small);
    lines_in(colour, line);
    ImGui::PopFont();
}

void bold_lines(const Pen& pen, std::string_view line) {
    ImGui::PushFont(pen.fonts.bold);
    lines(line);
    ImGui::PopFont();
}

void bold_text(const Pen& pen, std::string_view line) {
    ImGui::PushFont(pen.fonts.bold);
    text(line);
    ImGui::PopFont();
}

float width_of(std::string_view line) {
    return ImGui::CalcTextSize(begin_of(line), end_of(line)).x;
}

void text_to_the_right(std::string_view line, ImU32 colour) {
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room - width_of(line)));
    text_in(colour, line);
}

void rule(const Pen& pen) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine(
        from, {from.x + width, from.y}, pen.colours.line, std::max(1.0F, pen.unit)
    );
    ImGui::Dummy({width, pen.points(1)});
}

bool fold(
    Pen& pen, std::string_view name, const std::string& title, const std::string& note, bool open_first
) {
    rule(pen);
    ImGui::PushFont(pen.fonts.bold);
    const std::string id = title + "##" + pen.group + std::string(name);
    ImGui::SetNextItemOpen(open_first, ImGuiCond_Once);
    const bool is_open = ImGui::TreeNodeEx(
        id.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth
    );
    ImGui::PopFont();
    pen.target(name);
    if (note.empty()) return is_open;
    ImGui::PushFont(pen.fonts.small);
    const float room = ImGui::GetWindowContentRegionMax().x - width_of(note);
    ImGui::SameLine(std::max(room, 0.0F));
    soft_text(pen, note);
    ImGui::PopFont();
    return is_open;
}

}  // namespace feelem::viewer
