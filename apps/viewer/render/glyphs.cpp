// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/glyphs.hpp"

#include "scene/stroke_font.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr int kTexelsPerUnit = 4;
constexpr int kCellWidth = 56, kCellHeight = 68;
constexpr int kColumns = 18, kRows = 15;
constexpr float kAscent = 0, kDescent = 13;  ///< Units below the top of a capital.
constexpr char32_t kUnknown = 0xFFFD;

/// Next character of UTF-8 text; U+FFFD for wrong bytes.
char32_t next_of(std::string_view text, std::size_t& at) {
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    if (more == 0 || at + static_cast<std::size_t>(more) > text.size()) return kUnknown;
    char32_t character = first & (0x3FU >> more);
    for (int i = 0; i < more; ++i)
        character = character << 6 | (static_cast<unsigned char>(text[at++]) & 0x3FU);
    return character;
}

double to_segment(double x, double y, const StrokePoint& a, const StrokePoint& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

double to_strokes(double x, double y, const StrokeGlyph& glyph) {
    double least = kGlyphMargin;
    for (const auto& stroke : glyph.strokes)
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
            least = std::min(least, to_segment(x, y, stroke[i], stroke[i + 1]));
    return least;
}

}  // namespace

GlyphPicture glyph_picture(char32_t character) {
    const StrokeGlyph glyph = stroke_glyph(character);
    GlyphPicture out;
    out.advance = static_cast<float>(glyph.width);
    const double wide = (glyph.width + 2 * kGlyphMargin) * kTexelsPerUnit;
    out.width = std::min(static_cast<int>(std::ceil(wide)), kCellWidth);
    out.height = static_cast<int>(kDescent - kAscent + 2 * kGlyphMargin) * kTexelsPerUnit;
    out.height = std::min(out.height, kCellHeight);
    for (int row = 0; row < out.height; ++row) {
        for (int column = 0; column < out.width; ++column) {
            const double x = (column + 0.5) / kTexelsPerUnit - kGlyphMargin;
            const double y = (row + 0.5) / kTexelsPerUnit - kGlyphMargin + kAscent;
            const double share = 1 - to_strokes(x, y, glyph) / kGlyphMargin;
            out.distances.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
        }
    }
    return out;
}

GlyphAtlas::GlyphAtlas() : texture_(make_texture(GL_TEXTURE_2D)) {
    const GLuint name = texture_.get();
    glTextureStorage2D(name, 1, GL_R8, kColumns * kCellWidth, kRows * kCellHeight);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    constexpr std::uint8_t kNothing = 0;
    glClearTexImage(name, 0, GL_RED, GL_UNSIGNED_BYTE, &kNothing);
    cell_of(kUnknown);
}

const GlyphAtlas::Cell& GlyphAtlas::cell_of(char32_t character) {
    const auto found = cells_.find(character);
    if (found != cells_.end()) return found->second;
    const int number = static_cast<int>(cells_.size());
    if (number == kColumns * kRows) return cells_.at(kUnknown);
    Cell cell{number % kColumns, number / kColumns, glyph_picture(character)};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(
        texture_.get(),
        0,
        cell.column * kCellWidth,
        cell.row * kCellHeight,
        cell.picture.width,
        cell.picture.height,
        GL_RED,
        GL_UNSIGNED_BYTE,
        cell.picture.distances.data()
    );
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    cell.picture.distances.clear();
    return cells_.emplace(character, std::move(cell)).first->second;
}

PlacedText GlyphAtlas::place(std::string_view text) {
    PlacedText out;
    constexpr glm::vec2 kTexels(kColumns * kCellWidth, kRows * kCellHeight);
    for (std::size_t at = 0; at < text.size();) {
        const Cell& cell = cell_of(next_of(text, at));
        const glm::vec2 first(cell.column * kCellWidth, cell.row * kCellHeight);
        const glm::vec2 size(cell.picture.width, cell.picture.height);
        PlacedGlyph glyph;
        const float top = kCapitalUnits - kAscent + kGlyphMargin;
        glyph.low = {out.width - kGlyphMargin, top - size.y / kTexelsPerUnit};
        glyph.high = {glyph.low.x + size.x / kTexelsPerUnit, top};
        // The atlas' rows go down.
        glyph.low_texel = glm::vec2(first.x, first.y + size.y) / kTexels;
        glyph.high_texel = glm::vec2(first.x + size.x, first.y) / kTexels;
        out.glyphs.push_back(glyph);
        out.width += cell.picture.advance + kLetterGap;
    }
    if (!out.glyphs.empty()) out.width -= kLetterGap;
    for (PlacedGlyph& glyph : out.glyphs) {
        glyph.low.x -= out.width / 2;
        glyph.high.x -= out.width / 2;
    }
    return out;
}

}  // namespace feelem::viewer
