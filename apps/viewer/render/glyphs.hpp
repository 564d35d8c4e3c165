// SPDX-License-Identifier: Apache-2.0
// Feelem's stroke letters as distances, so that they stay sharp at any size. Made when first used.
#pragma once

#include "viewer/render/gl_objects.hpp"

#include <glm/vec2.hpp>

#include <map>
#include <string_view>
#include <vector>

namespace feelem::viewer {

/// The font's own measures (src/scene/stroke_font.hpp): a capital is nine units high.
inline constexpr float kCapitalUnits = 9, kLetterGap = 2.6F;
/// Room around a letter, units; also the largest distance that the atlas tells.
inline constexpr float kGlyphMargin = 2;

/// One letter of a line of text. Units of the font; x to the right from the middle of the line, y up from its
/// baseline.
struct PlacedGlyph {
    glm::vec2 low{0}, high{0};              ///< Corners of the quad.
    glm::vec2 low_texel{0}, high_texel{0};  ///< Of the atlas, 0..1.
};
struct PlacedText {
    std::vector<PlacedGlyph> glyphs;
    float width = 0;  ///< Units.
};

/// Distances from a letter's strokes, row by row from the top, 255 on the stroke, 0 at kGlyphMargin from it.
struct GlyphPicture {
    int width = 0, height = 0;
    float advance = 0;  ///< Units.
    std::vector<std::uint8_t> distances;
};
GlyphPicture glyph_picture(char32_t character);

class GlyphAtlas {
public:
    GlyphAtlas();
    /// UTF-8; what the font does not know is a box.
    PlacedText place(std::string_view text);
    GLuint texture() const noexcept { return texture_.get(); }

private:
    struct Cell {
        int column = 0, row = 0;
        GlyphPicture picture;
    };
    const Cell& cell_of(char32_t character);

    Texture texture_;
    std::map<char32_t, Cell> cells_;
};

}  // namespace feelem::viewer
