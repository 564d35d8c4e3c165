// SPDX-License-Identifier: Apache-2.0
// Feelem's own letters, drawn with strokes: the legend must look the same on a machine without fonts.
#pragma once

#include <vector>

namespace feelem {

struct StrokePoint {
    double x = 0, y = 0;
};
/// Capitals reach from y = 0 down to the baseline y = 9, small letters start at 3, descenders end at 12.
struct StrokeGlyph {
    double width = 0;
    std::vector<std::vector<StrokePoint>> strokes;  ///< Two equal points make a dot.
};
/// A box for characters that are not drawn.
StrokeGlyph stroke_glyph(char32_t character);

}  // namespace feelem
