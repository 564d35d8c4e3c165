// SPDX-License-Identifier: Apache-2.0
// A reader of SVG paths: lines, cubic curves and arcs, as strokes.
#include "viewer/ui/icons.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace feelem::viewer {
namespace {

constexpr float kIconSide = 20, kStroke = 1.5F;

constexpr std::array<std::string_view, 25> kIconPaths{
    "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5ZM7.6 10a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0",
    "M6.5 8a4 4 0 1 1 7 2.6c-1.2 1.3-1.7 1.8-1.7 3.2a2.3 2.3 0 0 1-4.3 1M8.6 8a1.8 1.8 0 1 1 3 1.5",
    "M3 7v6M7 4.5v11M11 7v6M15 4.5v11",
    "M6 10V5.2a1.2 1.2 0 0 1 2.4 0V9M8.4 9V3.7a1.2 1.2 0 0 1 2.4 0V9M10.8 9V4.6a1.2 1.2 0 0 1 2.4 0V12c0 "
    "3-1.8 5-4.4 5-2 0-3.2-1-4.2-2.8L3 11.4a1.2 1.2 0 0 1 2-1.2l1 1.2",
    "M3 15c3.5 0 4-9 7-9s3.500 5 7 5M3 15h14",
    "M4 10a6 6 0 1 0 12 0a6 6 0 1 0-12 0M5.8 14.2 14.2 5.8",
    "M6.5 4.5v11l9-5.5Z",
    "M6.5 4.5v11M13.5 4.5v11",
    "m12 5-5 5 5 5",
    "m8 5 5 5-5 5",
    "M3 7V3h4M17 7V3h-4M3 13v4h4M17 13v4h-4",
    "M3 3h14v14H3ZM3 10h14M10 3v14",
    "M10 17s5-4.6 5-8.5a5 5 0 0 0-10 0C5 12.4 10 17 10 17ZM8.3 8.5a1.7 1.7 0 1 0 3.4 0a1.7 1.7 0 1 0-3.4 0",
    "M3.5 10a6.5 6.5 0 1 0 13 0a6.5 6.5 0 1 0-13 0M10 3.5v13M12 4v12M14 5.200v9.600",
    "M3 8v4h3l4 3.5v-11L6 8ZM13 7.5a3.5 3.5 0 0 1 0 5M15 5a7 7 0 0 1 0 10",
    "M3 8v4h3l4 3.5v-11L6 8ZM13 8l4 4M17 8l-4 4",
    "M3 7.5h14v6h-4l-1.5-2h-3L7 13.5H3ZM6 7.5V5.5h8v2",
    "m5 5 10 10M15 5 5 15",
    "M10 4v12M4 10h12",
    "M4 4h12v12H4ZM4 12l8-8M4 16 16 4M8 16l8-8",
    "M4 10a6 6 0 1 0 12 0a6 6 0 1 0-12 0M10 2v3M10 15v3M2 10h3M15 10h3",
    "M4 7l6-3 6 3v6l-6 3-6-3ZM2 15 18 5",
    "M2.5 5.5h15v9h-15ZM5 8.500h1M8 8.500h1M11 8.500h1M14 8.500h1M6.500 11.500h7",
    "M3 10 10 4l7 6M5 9v7h10V9",
    "M4 8h8v8H4ZM8 4h8v8h-2",
};

struct Reader {
    std::string_view text;

    void skip() {
        const auto from = text.find_first_not_of(" ,");
        text.remove_prefix(std::min(from, text.size()));
    }
    bool has_number() {
        skip();
        return !text.empty() && (std::string_view("+-.0123456789").find(text[0]) != std::string_view::npos);
    }
    float number() {
        skip();
        float value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        text.remove_prefix(error == std::errc() ? static_cast<std::size_t>(end - text.data()) : text.size());
        return value;
    }
    ImVec2 point() {
        const float x = number();
        return {x, number()};
    }
};

ImVec2 plus(ImVec2 a, ImVec2 b) {
    return {a.x + b.x, a.y + b.y};
}

/// Strokes of one path, at one scale.
class Stroker {
public:
    Stroker(ImDrawList& list, ImVec2 corner, float scale, ImU32 colour, float width)
        : list_(list), corner_(corner), scale_(scale), colour_(colour), width_(width) {}

    void run(std::string_view path) {
        Reader reader{path};
        char command = 'M';
        for (reader.skip(); !reader.text.empty(); reader.skip()) {
            if (!reader.has_number()) {
                command = reader.text[0];
                reader.text.remove_prefix(1);
            }
            take(command, reader);
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        stroke(false);
    }

private:
    ImVec2 seen(ImVec2 p) const { return {corner_.x + p.x * scale_, corner_.y + p.y * scale_}; }
    void line_to(ImVec2 p) {
        at_ = p;
        list_.PathLineTo(seen(p));
    }
    void stroke(bool closed) {
        if (list_._Path.Size > 1)
            list_.PathStroke(colour_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
        else
            list_.PathClear();
    }
    void curve_to(ImVec2 a, ImVec2 b, ImVec2 end) {
        list_.PathBezierCubicCurveTo(seen(a), seen(b), seen(end));
        control_ = b;
        at_ = end;
    }

    void take(char command, Reader& reader) {
        const bool relative = command >= 'a';
        const ImVec2 from = relative ? at_ : ImVec2(0, 0);
        switch (command) {
        case 'M':
        case 'm':
            stroke(false);
            start_ = plus(from, reader.point());
            line_to(start_);
            break;
        case 'L':
        case 'l': line_to(plus(from, reader.point())); break;
        case 'H': line_to({reader.number(), at_.y}); break;
        case 'h': line_to({at_.x + reader.number(), at_.y}); break;
        case 'V': line_to({at_.x, reader.number()}); break;
        case 'v': line_to({at_.x, at_.y + reader.number()}); break;
        case 'C':
        case 'c': {
            const ImVec2 a = plus(from, reader.point());
            const ImVec2 b = plus(from, reader.point());
            curve_to(a, b, plus(from, reader.point()));
            break;
        }
        case 'S':
        case 's': {
            const ImVec2 a = curves_ ? ImVec2(2 * at_.x - control_.x, 2 * at_.y - control_.y) : at_;
            const ImVec2 b = plus(from, reader.point());
            curve_to(a, b, plus(from, reader.point()));
            break;
        }
        case 'A':
        case 'a': arc(reader, from); break;
        default:
            stroke(true);
            at_ = start_;
            break;
        }
        curves_ = command == 'C' || command == 'c' || command == 'S' || command == 's';
    }

    /// A circle's arc by its ends: both radii of our icons are equal.
    void arc(Reader& reader, ImVec2 from) {
        float radius = reader.number();
        reader.number();
        reader.number();
        const bool is_large = reader.number() != 0;
        const bool is_clockwise = reader.number() != 0;
        const ImVec2 end = plus(from, reader.point());
        const ImVec2 half{(end.x - at_.x) / 2, (end.y - at_.y) / 2};
        const float length = std::hypot(half.x, half.y);
        if (!(length > 0)) return;
        radius = std::max(radius, length);
        const float aside = std::sqrt(std::max(radius * radius - length * length, 0.0F)) / length;
        const float side = is_large == is_clockwise ? 1.0F : -1.0F;
        const ImVec2 middle{at_.x + half.x + side * aside * half.y, at_.y + half.y - side * aside * half.x};
        const float begin = std::atan2(at_.y - middle.y, at_.x - middle.x);
        float sweep = std::atan2(end.y - middle.y, end.x - middle.x) - begin;
        constexpr float kTurn = 2 * std::numbers::pi_v<float>;
        if (is_clockwise && sweep < 0) sweep += kTurn;
        if (!is_clockwise && sweep > 0) sweep -= kTurn;
        const int pieces = std::max(4, static_cast<int>(std::abs(sweep) * radius * scale_ / 2));
        for (int i = 1; i <= pieces; ++i) {
            const float angle = begin + sweep * static_cast<float>(i) / static_cast<float>(pieces);
            list_.PathLineTo(seen({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)})
            );
        }
        at_ = end;
    }

    ImDrawList& list_;
    ImVec2 corner_;
    float scale_;
    ImU32 colour_;
    float width_;
    ImVec2 at_{0, 0}, start_{0, 0}, control_{0, 0};
    bool curves_ = false;
};

}  // namespace

std::string_view path_of(Icon icon) {
    return kIconPaths.at(static_cast<std::size_t>(icon));
}

void draw_icon(ImDrawList& list, Icon icon, ImVec2 corner, float side, ImU32 colour) {
    const float scale = side / kIconSide;
    if (icon == Icon::Play) {
        const auto at = [&](float x, float y) { return ImVec2(corner.x + x * scale, corner.y + y * scale); };
        list.AddTriangleFilled(at(6, 4), at(6, 16), at(16, 10), colour);
        return;
    }
    const float width = (icon == Icon::Pause ? 2.6F : kStroke) * scale;
    Stroker(list, corner, scale, colour, width).run(path_of(icon));
}

}  // namespace feelem::viewer
