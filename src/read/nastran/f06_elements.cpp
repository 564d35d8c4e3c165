// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/f06_elements.hpp"

#include "base/number.hpp"
#include "read/text_lines.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace feelem::nastran {
namespace {

using op2::RowShape;

/// Nastran's number of an element by its name on the page; of shells with a column of corners another one.
struct PrintedElement {
    std::string_view name;
    int type = 0;
    int with_grids = 0;
};
constexpr PrintedElement kPrintedElements[]{
    {"ROD", 1, 0},
    {"TUBE", 3, 0},
    {"CONROD", 10, 0},
    {"BAR", 34, 0},
    {"BEAM", 2, 2},
    {"TETRA", 39, 39},
    {"HEXA", 67, 67},
    {"PENTA", 68, 68},
    {"PYRAM", 255, 255},
    {"PYRA", 255, 255},
    {"QUAD4", 33, 144},
    {"TRIA3", 74, 0},
    {"QUADR", 228, 82},
    {"TRIAR", 227, 70},
    {"QUAD8", 0, 64},
    {"TRIA6", 0, 75},
};

/// The words of a line: whole numbers as the file has them, and reals.
struct LineWords {
    static constexpr std::size_t kMost = 16;
    std::array<std::string_view, kMost> words{};
    std::size_t count = 0;

    explicit LineWords(std::string_view rest) {
        for (auto word = take_word(rest); !word.empty() && count < kMost; word = take_word(rest))
            words[count++] = word;
    }
    std::optional<std::int64_t> whole(std::size_t i) const {
        return i < count ? parse_integer(words[i]) : std::nullopt;
    }
    bool is_real(std::size_t i) const { return i < count && !whole(i) && parse_float(words[i]).has_value(); }
    bool are_reals(std::size_t first, std::size_t number) const {
        for (std::size_t i = first; i < first + number; ++i) {
            if (!is_real(i)) return false;
        }
        return true;
    }
    float real(std::size_t i) const {
        constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
        return i < count ? parse_float(words[i]).value_or(kNone) : kNone;
    }
};

/// A carriage control stands in the first column.
std::string_view without_control(std::string_view line) {
    return line.substr(std::min<std::size_t>(line.size(), 1));
}

/// Puts the lines of one element together.
class ElementLines {
public:
    ElementLines(const op2::ElementLayout& layout, const EachElementRow& each)
        : layout_(layout), each_(each), row_(layout) {}

    void read(std::string_view line) {
        const std::string_view rest = without_control(line);
        switch (layout_.shape) {
        case RowShape::Solid: read_solid(rest); break;
        case RowShape::ShellCorner: read_shell(LineWords(rest)); break;
        case RowShape::ShellCentre: read_centre(LineWords(rest)); break;
        default: read_bar(LineWords(rest)); break;
        }
    }
    void end() {
        if (element_ != 0) each_(element_, row_.words());
        element_ = 0;
    }

private:
    void start(std::int64_t element) {
        end();
        element_ = element;
        point_ = 0;
        has_fibre_ = false;
        row_.clear();
    }

    void put(std::size_t word, const LineWords& line, std::size_t first, std::size_t number) {
        for (std::size_t i = 0; i < number; ++i) row_.set_real(word + i, line.real(first + i));
    }

    /// X, Y and Z lines of the centre and of each corner.
    void read_solid(std::string_view rest) {
        const LineWords line(rest);
        if (const std::size_t at = rest.find("GRID CS"); at != std::string_view::npos) {
            std::string_view system = rest.substr(0, at);
            const auto element = take_integer(system);
            if (!element || *element <= 0) return;
            start(*element);
            row_.set_integer(1, take_integer(system).value_or(0));
            return;
        }
        if (element_ == 0) return;
        const auto grid = line.whole(0);
        if (grid || (line.count > 0 && line.words[0] == "CENTER")) {
            if (line.count < 9 || line.words[1] != "X" || line.words[3] != "XY") return;
            const std::size_t at = op2::kSolidHead + point_ * op2::kSolidPoint;
            if (++point_ > layout_.corners + 1) return;
            row_.set_integer(at, grid.value_or(0));
            row_.set_real(at + 1, line.real(2));
            row_.set_real(at + 2, line.real(4));
            row_.set_real(at + 8, line.real(line.count - 1));
        } else if (line.count >= 4 && point_ > 0 && point_ <= layout_.corners + 1) {
            const bool is_y = line.words[0] == "Y" && line.words[2] == "YZ";
            const bool is_z = line.words[0] == "Z" && line.words[2] == "ZX";
            if (!is_y && !is_z) return;
            const std::size_t at = op2::kSolidHead + (point_ - 1) * op2::kSolidPoint + (is_y ? 9 : 15);
            row_.set_real(at, line.real(1));
            row_.set_real(at + 1, line.real(3));
        }
    }

    /// The second fibre of a shell's point is a line of its own.
    bool read_second_fibre(const LineWords& line, std::size_t point) {
        if (!line.are_reals(0, op2::kFibreWords)) return false;
        if (element_ != 0 && std::exchange(has_fibre_, false))
            put(point + 1 + op2::kFibreWords, line, 0, op2::kFibreWords);
        return true;
    }

    void read_shell(const LineWords& line) {
        const std::size_t last_point = op2::kShellHead + (point_ - 1) * op2::kShellPoint;
        if (point_ > 0 && read_second_fibre(line, last_point)) return;
        const auto number = line.whole(0);
        const bool starts = line.count > 1 && line.words[1].starts_with("CEN/");
        if (!number || !line.are_reals(starts ? 2 : 1, op2::kFibreWords)) return;
        if (starts) start(*number);
        if (element_ == 0 || point_ > layout_.corners) return;
        const std::size_t point = op2::kShellHead + point_ * op2::kShellPoint;
        row_.set_integer(point, starts ? 0 : *number);
        put(point + 1, line, starts ? 2 : 1, op2::kFibreWords);
        ++point_;
        has_fibre_ = true;
    }

    void read_centre(const LineWords& line) {
        if (read_second_fibre(line, 0)) return;
        const auto number = line.whole(0);
        if (!number || !line.are_reals(1, op2::kFibreWords)) return;
        start(*number);
        put(1, line, 1, op2::kFibreWords);
        has_fibre_ = true;
    }

    void read_bar(const LineWords& line) {
        constexpr int kBeam = 2, kBar = 34;
        if (layout_.type == kBeam) {
            read_beam(line);
        } else if (layout_.type == kBar) {
            // Four points, the axial stress, largest and smallest; at the other end without the axial one.
            if (line.whole(0) && line.are_reals(1, 7)) {
                start(*line.whole(0));
                put(1, line, 1, 7);
            } else if (element_ != 0 && line.are_reals(0, 6)) {
                put(9, line, 0, 6);
            }
        } else {
            // Two rods a line; margins of safety may be blank.
            for (std::size_t i = 0; i + 1 < line.count; ++i) {
                if (!line.whole(i) || !line.is_real(i + 1)) continue;
                start(*line.whole(i));
                row_.set_real(1, line.real(i + 1));
            }
        }
    }

    /// The element, then a line a station.
    void read_beam(const LineWords& line) {
        const auto number = line.whole(0);
        if (!number) return;
        if (line.count == 1) {
            start(*number);
        } else if (element_ != 0 && point_ < layout_.corners && line.are_reals(1, 7)) {
            const std::size_t station = 1 + op2::kBeamStation * point_++;
            row_.set_integer(station, *number);
            put(station + 1, line, 1, 7);
        }
    }

    const op2::ElementLayout& layout_;
    const EachElementRow& each_;
    WordRow row_;
    std::int64_t element_ = 0;
    std::size_t point_ = 0;  ///< Points seen.
    bool has_fibre_ = false;
};

}  // namespace

std::optional<ElementHead> element_head(const std::string& title) {
    ElementHead head;
    head.title = title;
    head.kind.strain = title.starts_with("STRAINS IN ");
    if (!head.kind.strain && !title.starts_with("STRESSES IN ")) return {};
    if (title.find("COMPOSITE") != std::string::npos) return {};
    const std::size_t first = title.find('('), last = title.find(')');
    if (first == std::string::npos || last == std::string::npos || last < first) return {};
    head.element = trim(std::string_view(title).substr(first + 1, last - first - 1));
    const auto is_known = [&] {
        return std::ranges::find(kPrintedElements, head.element, &PrintedElement::name) !=
               std::end(kPrintedElements);
    };
    if (!is_known() && head.element.starts_with('C')) head.element.erase(0, 1);
    return is_known() ? std::optional(head) : std::nullopt;
}

void read_element_columns(std::string_view line, ElementHead& head) {
    const auto has = [&](const char* word) { return line.find(word) != std::string_view::npos; };
    if (has("VON MISES")) head.kind.von_mises = true;
    if (has("CURVATURE")) head.kind.curvature = true;
    if (has("GRID")) head.has_grids = true;
    std::string_view rest = without_control(line);
    const std::string_view first = take_word(rest);
    if (first == "TIME" || first == "FREQUENCY") head.by_step = true;
}

const op2::ElementLayout* printed_layout(const ElementHead& head) {
    if (head.by_step) return nullptr;
    const auto* const found = std::ranges::find(kPrintedElements, head.element, &PrintedElement::name);
    const int type = head.has_grids ? found->with_grids : found->type;
    return type == 0 ? nullptr : op2::layout_of_type(type);
}

ElementLine element_line(std::string_view line, const ElementHead& head) {
    const LineWords words(without_control(line));
    if (words.count == 0) return {};
    if (const auto number = words.whole(0)) {
        const std::string_view second = words.count > 1 ? words.words[1] : std::string_view{};
        const bool starts =
            !head.has_grids || words.count == 1 || second.starts_with("CEN/") || second.ends_with("GRID");
        return {true, starts ? *number : 0};
    }
    const std::string_view first = words.words[0];
    return {words.is_real(0) || first == "CENTER" || first == "Y" || first == "Z", 0};
}

void read_f06_elements(const Input& input, const PrintedElements& table, const EachElementRow& each) {
    const std::string_view text = input.text();
    ElementLines lines(*table.layout, each);
    for (const PrintedRows& rows : table.rows) {
        for (std::size_t at = rows.first; at < rows.last;) {
            const std::size_t end = std::min(text.find('\n', at), rows.last);
            lines.read(text.substr(at, end - at));
            at = std::min(end + 1, rows.last);
        }
    }
    lines.end();
}

}  // namespace feelem::nastran
