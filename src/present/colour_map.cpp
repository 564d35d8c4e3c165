// SPDX-License-Identifier: Apache-2.0
// Value -> colour: the maps, bands, and the colours beside the map.
#include "present/colour_tables.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace feelem {
namespace {

Rgb unpack(std::uint32_t row) {
    return {
        static_cast<std::uint8_t>(row >> 16 & 0xFF),
        static_cast<std::uint8_t>(row >> 8 & 0xFF),
        static_cast<std::uint8_t>(row & 0xFF)};
}

/// t within 0..1, and 0 for anything that is no number.
double unit(double t) {
    return t > 0 ? std::min(t, 1.0) : 0;
}

const ColourTable& table_of(std::string_view map) {
    const auto tables = colour_tables();
    const auto found = std::ranges::find(tables, map, &ColourTable::name);
    if (found == tables.end()) {
        std::string names;
        for (const ColourTable& table : tables) {
            names += fmt::format(" {}", table.name);
        }
        throw Error(
            Code::UnknownName, {}, fmt::format("there is no colour map '{}'; the maps are:{}", map, names)
        );
    }
    return *found;
}

}  // namespace

std::span<const std::string_view> colour_maps() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const ColourTable& table : colour_tables()) {
            all.push_back(table.name);
        }
        return all;
    }();
    return names;
}

Rgb map_colour(std::string_view map, double t) {
    const auto rows = table_of(map).rows;
    const double place = unit(t) * static_cast<double>(rows.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), rows.size() - 2);
    const double share = place - static_cast<double>(first);
    const Rgb a = unpack(rows[first]);
    const Rgb b = unpack(rows[first + 1]);
    Rgb mixed{};
    for (std::size_t i = 0; i < 3; ++i) {
        mixed[i] = static_cast<std::uint8_t>(std::floor(a[i] * (1 - share) + b[i] * share + 0.5));
    }
    return mixed;
}

int band_of(double t, int bands) {
    return std::clamp(static_cast<int>(unit(t) * bands), 0, std::max(bands - 1, 0));
}

Rgb palette_colour(double t, const ColourEffect& effect) {
    double place = t;
    if (effect.bands == 1) {
        place = 0.5;
    } else if (effect.bands > 1) {
        // The outer bands take the ends of the map: further apart for the eye than the bands' middles.
        place = band_of(t, effect.bands) / static_cast<double>(effect.bands - 1);
    }
    return map_colour(effect.map, effect.invert ? 1 - place : place);
}

Rgb colour_of(double value, const ValueRange& range, const ColourEffect& effect) {
    const Normalised place = normalise(value, range);
    if (place.missing) {
        return effect.missing;
    }
    if (place.below) {
        return effect.below;
    }
    return place.above ? effect.above : palette_colour(place.position, effect);
}

}  // namespace feelem
