// SPDX-License-Identifier: Apache-2.0
// The pictures of a coloured result: its palette as a texture, and its legend with numbers.
#pragma once

#include "scene/picture.hpp"

#include "feelem/present.hpp"

#include <string>

namespace feelem {

/// docs/scene-format.md "Colour": below | palette | above in row 0, the missing colour in the rows below.
Picture palette_picture(const ColourEffect& effect);

struct LegendText {
    std::string title, component, unit, step;
    std::string deformation;  ///< "x50"; empty: none.
    bool animated = false;
};
/// Pixels of the legend in which the palette is drawn, for tests that compare colours.
inline constexpr int kLegendWidth = 256, kLegendHeight = 512;
inline constexpr int kBarLeft = 20, kBarTop = 120, kBarWidth = 52, kBarHeight = 252;
Picture legend_picture(const LegendText& text, const ValueRange& range, const ColourEffect& effect);

}  // namespace feelem
