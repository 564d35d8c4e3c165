// SPDX-License-Identifier: Apache-2.0
// Look -> uniforms of the skin's shader. Colours come from present's formulas alone.
#pragma once

#include "viewer/core/look.hpp"
#include "viewer/render/gl_objects.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// Texels of a smooth palette: no step between neighbours is visible.
inline constexpr int kSmoothPalette = 1024;

/// RGBA, lowest value first; one texel a band, or kSmoothPalette of them.
std::vector<std::uint8_t> palette_texels(const ColourEffect& effect);

/// The range as the shader takes it.
struct ShaderRange {
    float lo = 0, hi = 1, magnitude = 1;
    int scale = 0;  ///< 0 linear, 1 log, 2 signed, 3 symlog.
};
ShaderRange shader_range(const ValueRange& range);

/// The palette's texture; made again when the effect changes.
class Palette {
public:
    void set(const ColourEffect& effect);
    GLuint texture() const noexcept { return texture_.get(); }
    int count() const noexcept { return count_; }

private:
    std::optional<ColourEffect> effect_;
    Texture texture_;
    int count_ = 1;
};

/// All of the skin's uniforms that say how values become colours.
void set_colours(const Program& program, const Look& look, bool is_coloured, const Palette& palette);

}  // namespace feelem::viewer
