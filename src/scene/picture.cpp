// SPDX-License-Identifier: Apache-2.0
#include "scene/picture.hpp"

#include "scene/stroke_font.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace feelem {
namespace {

/// Next character of UTF-8 text; U+FFFD for wrong bytes.
char32_t next_character(std::string_view text, std::size_t& at) {
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    if (more == 0 || at + static_cast<std::size_t>(more) > text.size()) return 0xFFFD;
    char32_t character = first & (0x3Fu >> more);
    for (int i = 0; i < more; ++i)
        character = character << 6 | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
    return character;
}

constexpr double kCapital = 9;  ///< Height of a capital in the font's units.
constexpr double kGap = 2.6;    ///< Between letters.

double distance_to_segment(double x, double y, const StrokePoint& a, const StrokePoint& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0) : 0;
    const double ex = x - (a.x + t * dx), ey = y - (a.y + t * dy);
    return std::sqrt(ex * ex + ey * ey);
}

void blend(Picture& picture, int x, int y, const Rgb& colour, double share) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height || share <= 0) return;
    const Rgb under = picture.at(x, y);
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = static_cast<std::uint8_t>(std::floor(under[c] * (1 - share) + colour[c] * share + 0.5));
    picture.set(x, y, mixed);
}

/// One segment, in pixels, with round ends. Only the darkest share of a glyph counts where segments meet: the
/// small overlaps of blending twice do not show at these sizes.
void draw_segment(Picture& picture, const StrokePoint& a, const StrokePoint& b, const TextStyle& style) {
    const double reach = style.weight / 2 + 1;
    const int left = static_cast<int>(std::floor(std::min(a.x, b.x) - reach));
    const int right = static_cast<int>(std::ceil(std::max(a.x, b.x) + reach));
    const int top = static_cast<int>(std::floor(std::min(a.y, b.y) - reach));
    const int bottom = static_cast<int>(std::ceil(std::max(a.y, b.y) + reach));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const double distance = distance_to_segment(x + 0.5, y + 0.5, a, b);
            blend(picture, x, y, style.colour, std::clamp(style.weight / 2 + 0.5 - distance, 0.0, 1.0));
        }
    }
}

void append_u32(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xFF);
}

void append_chunk(std::string& out, std::string_view type, std::string_view data) {
    append_u32(out, static_cast<std::uint32_t>(data.size()));
    const std::string body = std::string(type) + std::string(data);
    out += body;
    const uLong check = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    append_u32(out, static_cast<std::uint32_t>(check));
}

}  // namespace

Picture::Picture(int w, int h, const Rgb& colour) : width(w), height(h) {
    rgb.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3);
    fill(0, 0, w, h, colour);
}

void Picture::set(int x, int y, const Rgb& colour) {
    const auto at = static_cast<std::ptrdiff_t>(y) * width + x;
    std::ranges::copy(colour, rgb.begin() + 3 * at);
}

Rgb Picture::at(int x, int y) const {
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[at], rgb[at + 1], rgb[at + 2]};
}

void Picture::fill(int x, int y, int w, int h, const Rgb& colour) {
    for (int row = std::max(y, 0); row < std::min(y + h, height); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + w, width); ++column) set(column, row, colour);
    }
}

double text_width(std::string_view text, const TextStyle& style) {
    double width = 0;
    for (std::size_t at = 0; at < text.size();) width += stroke_glyph(next_character(text, at)).width + kGap;
    return width * style.size / kCapital;
}

void draw_text(Picture& picture, double x, double baseline, std::string_view text, const TextStyle& style) {
    const double scale = style.size / kCapital;
    for (std::size_t at = 0; at < text.size();) {
        const StrokeGlyph glyph = stroke_glyph(next_character(text, at));
        const auto place = [&](const StrokePoint& point) {
            return StrokePoint{x + point.x * scale, baseline + (point.y - kCapital) * scale};
        };
        for (const std::vector<StrokePoint>& stroke : glyph.strokes) {
            for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
                draw_segment(picture, place(stroke[i]), place(stroke[i + 1]), style);
        }
        x += (glyph.width + kGap) * scale;
    }
}

std::string png_bytes(const Picture& picture) {
    const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
    std::string rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
        rows += '\0';  // filter: none
        rows.append(reinterpret_cast<const char*>(picture.rgb.data()) + y * row, row);
    }
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string packed(size, '\0');
    const int status = compress2(
        reinterpret_cast<Bytef*>(packed.data()),
        &size,
        reinterpret_cast<const Bytef*>(rows.data()),
        static_cast<uLong>(rows.size()),
        Z_DEFAULT_COMPRESSION
    );
    if (status != Z_OK) throw std::runtime_error("zlib cannot compress a picture");
    packed.resize(size);
    std::string png = "\x89PNG\r\n\x1A\n";
    std::string head;
    append_u32(head, static_cast<std::uint32_t>(picture.width));
    append_u32(head, static_cast<std::uint32_t>(picture.height));
    head.append("\x08\x02\0\0\0", 5);  // 8 bit, RGB
    append_chunk(png, "IHDR", head);
    append_chunk(png, "IDAT", packed);
    append_chunk(png, "IEND", "");
    return png;
}

}  // namespace feelem
