// SPDX-License-Identifier: Apache-2.0
#include "scene/legend.hpp"

#include "scene/scene_colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace feelem {
namespace {

constexpr Rgb kPaper{247, 247, 247}, kInk{24, 24, 24}, kQuiet{96, 96, 96};
constexpr int kSmoothTexels = 64;  ///< k of a palette without bands.
constexpr int kMargin = 14;

/// Cuts text that is too long, with an ellipsis.
void draw_fitted(Picture& picture, double baseline, std::string text, TextStyle style) {
    const double room = picture.width - 2 * kMargin;
    if (text_width(text, style) > room)
        style.size = std::max(9.0, style.size * room / text_width(text, style));
    bool cut = false;
    while (text_width(text + (cut ? "..." : ""), style) > room && !text.empty()) {
        do text.pop_back();
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80);
        cut = true;
    }
    draw_text(picture, kMargin, baseline, text + (cut ? "..." : ""), style);
}

/// Enough digits to tell the numbers of the scale apart, not more.
std::string tick_text(double value, double step) {
    if (std::abs(value) < 1e-9 * std::abs(step)) return "0";
    int digits = 4;
    if (step > 0) digits = static_cast<int>(std::floor(std::log10(std::abs(value) / step))) + 3;
    return fmt::format("{:.{}g}", value, std::clamp(digits, 3, 9));
}

/// Positions of the numbers: the edges of the bands, or tenths.
std::vector<double> tick_places(int bands) {
    int count = bands > 0 ? bands : 8;
    if (bands > 12) count = 8;
    while (count < 5) count *= 2;
    std::vector<double> places;
    for (int i = 0; i <= count; ++i) places.push_back(static_cast<double>(i) / count);
    return places;
}

void draw_bar(Picture& picture, const ValueRange& range, const ColourEffect& effect) {
    picture.fill(kBarLeft - 1, kBarTop - 1, kBarWidth + 2, kBarHeight + 2, kInk);
    for (int y = 0; y < kBarHeight; ++y) {
        const double t = 1 - (y + 0.5) / kBarHeight;
        picture.fill(kBarLeft, kBarTop + y, kBarWidth, 1, palette_colour(t, effect));
    }
    const std::vector<double> places = tick_places(effect.bands);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t near = i > 0 ? i - 1 : i + 1;
        const double value = value_at(places[i], range);
        const double step = std::abs(value - value_at(places[near], range));
        const double y = kBarTop + (1 - places[i]) * kBarHeight;
        picture.fill(kBarLeft + kBarWidth + 1, static_cast<int>(std::lround(y - 0.5)), 6, 1, kInk);
        draw_text(picture, kBarLeft + kBarWidth + 12, y + 5, tick_text(value, step), {10.5, 1.4, kInk});
    }
}

void draw_specials(Picture& picture, const ColourEffect& effect) {
    struct Row {
        const char* name;
        Rgb colour;
    };
    int y = kBarTop + kBarHeight + 24;
    for (const Row& row :
         {Row{"above", effect.above}, Row{"below", effect.below}, Row{"no value", effect.missing}}) {
        picture.fill(kBarLeft - 1, y - 1, kBarWidth + 2, 16, kInk);
        picture.fill(kBarLeft, y, kBarWidth, 14, row.colour);
        draw_text(picture, kBarLeft + kBarWidth + 12, y + 12, row.name, {10.5, 1.4, kInk});
        y += 22;
    }
}

}  // namespace

Picture palette_picture(const ColourEffect& effect) {
    const int k = effect.bands > 0 ? effect.bands / std::gcd(effect.bands, 14) : kSmoothTexels;
    constexpr int kHeight = 64;
    Picture picture(16 * k, kHeight, effect.missing);
    picture.fill(0, 0, k, 1, effect.below);
    picture.fill(15 * k, 0, k, 1, effect.above);
    for (int i = 0; i < 14 * k; ++i) picture.set(k + i, 0, palette_colour((i + 0.5) / (14 * k), effect));
    return picture;
}

Picture legend_picture(const LegendText& text, const ValueRange& range, const ColourEffect& effect) {
    Picture picture(kLegendWidth, kLegendHeight, kPaper);
    const std::string unit = text.unit.empty() ? "unit not given" : "[" + text.unit + "]";
    draw_fitted(picture, 34, text.title, {16, 2.2, kInk});
    const std::string component = text.component == "value" ? "" : text.component + "  ";
    draw_fitted(picture, 62, component + unit, {13, 1.7, kInk});
    draw_fitted(picture, 86, text.step, {11, 1.4, kQuiet});
    draw_bar(picture, range, effect);
    draw_specials(picture, effect);
    if (!text.deformation.empty())
        draw_fitted(picture, 478, "deformation " + text.deformation, {11, 1.4, kInk});
    if (text.animated) draw_fitted(picture, 498, "edges: undeformed", {11, 1.4, kQuiet});
    return picture;
}

}  // namespace feelem
