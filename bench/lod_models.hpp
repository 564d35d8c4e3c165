// SPDX-License-Identifier: Apache-2.0
// Surfaces with results for measuring levels of detail: made the same way every time.
#pragma once

#include "feelem/lod.hpp"
#include "feelem/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace feelem::bench {

struct LodModel {
    std::string name;
    std::vector<Point3> positions;
    std::vector<std::array<VertexIndex, 3>> triangles;
    std::vector<std::vector<float>> fields;
    std::vector<std::uint32_t> places, parts;

    LodSurface surface() const { return {positions, triangles, places, parts}; }
    double range(std::size_t k) const {
        const auto [low, high] = std::minmax_element(fields[k].begin(), fields[k].end());
        return static_cast<double>(*high) - static_cast<double>(*low);
    }
};

/// A square sheet of `side` x `side` quads, two triangles each: z is a sum of waves, the field a smooth wave
/// with 12 hot spots of about 1 % of the side. `jitter` moves inner vertices by up to that share of a quad.
inline LodModel wavy_sheet(std::uint32_t side, double jitter = 0) {
    LodModel model;
    model.name = "wavy sheet";
    std::uint64_t state = 12345;
    const auto random = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 40U) / static_cast<double>(1U << 24U);
    };
    struct Spot {
        double x, y, height, width;
    };
    std::vector<Spot> spots;
    for (int i = 0; i < 12; ++i)
        spots.push_back({random(), random(), 0.3 + 0.4 * random(), 0.006 + 0.008 * random()});
    const double n = side;
    model.fields.resize(1);
    for (std::uint32_t j = 0; j <= side; ++j) {
        for (std::uint32_t i = 0; i <= side; ++i) {
            const bool is_inner = i > 0 && j > 0 && i < side && j < side;
            const double x = (i + (is_inner ? jitter * (random() - 0.5) : 0)) / n;
            const double y = (j + (is_inner ? jitter * (random() - 0.5) : 0)) / n;
            const double pi = std::numbers::pi;
            model.positions.push_back(
                {x,
                 y,
                 0.05 * std::sin(2 * pi * x) * std::cos(2 * pi * y) +
                     0.01 * std::sin(6 * pi * x + 4 * pi * y)}
            );
            double f = 0.2 + 0.1 * std::sin(3 * pi * x) * std::cos(2 * pi * y);
            for (const Spot& s : spots) {
                const double r = ((x - s.x) * (x - s.x) + (y - s.y) * (y - s.y)) / (s.width * s.width);
                f += s.height * std::exp(-r);
            }
            model.fields[0].push_back(static_cast<float>(f));
        }
    }
    const auto at = [side](std::uint32_t i, std::uint32_t j) { return VertexIndex{j * (side + 1) + i}; };
    for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) {
            const VertexIndex a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (jitter > 0 && random() < 0.5) {
                model.triangles.push_back({a, b, d});
                model.triangles.push_back({b, c, d});
            } else {
                model.triangles.push_back({a, b, c});
                model.triangles.push_back({a, c, d});
            }
        }
    }
    return model;
}

/// The skin of a solver's file with every facet cut into 16 x 16 by its shape functions, and von Mises
/// stress.
LodModel refined_model(const std::string& path);

}  // namespace feelem::bench
