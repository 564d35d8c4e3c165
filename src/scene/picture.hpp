// SPDX-License-Identifier: Apache-2.0
// Small RGB pictures: rectangles, text, PNG. The same bytes everywhere: no font of the system is used.
#pragma once

#include "feelem/present.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< Row by row from the top.

    Picture(int w, int h, const Rgb& fill);
    void set(int x, int y, const Rgb& colour);
    Rgb at(int x, int y) const;
    void fill(int x, int y, int w, int h, const Rgb& colour);
};

struct TextStyle {
    double size = 12;     ///< Height of a capital letter, pixels.
    double weight = 1.4;  ///< Width of a stroke, pixels.
    Rgb colour{20, 20, 20};
};
/// Width in pixels of UTF-8 text.
double text_width(std::string_view text, const TextStyle& style);
/// Left end and baseline.
void draw_text(Picture& picture, double x, double baseline, std::string_view text, const TextStyle& style);

/// 8 bit RGB without colour chunks, as docs/scene-format.md wants palettes.
std::string png_bytes(const Picture& picture);

}  // namespace feelem
