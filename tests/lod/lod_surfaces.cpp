// SPDX-License-Identifier: Apache-2.0
#include "lod_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace feelem::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Adds a grid of nu x nv quads; place(i, j) and value(i, j) say what is there. Returns its first vertex.
template <class Place, class Value>
std::uint32_t add_grid(
    LodModel& model, std::uint32_t nu, std::uint32_t nv, const Place& place, const Value& value
) {
    const auto first = static_cast<std::uint32_t>(model.positions.size());
    model.fields.resize(1);
    for (std::uint32_t j = 0; j <= nv; ++j) {
        for (std::uint32_t i = 0; i <= nu; ++i) {
            model.positions.push_back(place(i, j));
            model.fields[0].push_back(static_cast<float>(value(i, j)));
        }
    }
    for (std::uint32_t j = 0; j < nv; ++j) {
        for (std::uint32_t i = 0; i < nu; ++i) {
            const std::uint32_t a = first + j * (nu + 1) + i, b = a + 1, d = a + nu + 1, c = d + 1;
            model.triangles.push_back({VertexIndex{a}, VertexIndex{b}, VertexIndex{c}});
            model.triangles.push_back({VertexIndex{a}, VertexIndex{c}, VertexIndex{d}});
        }
    }
    return first;
}

/// Places by equal positions.
void weld(LodModel& model) {
    std::map<Point3, std::uint32_t> first;
    model.places.clear();
    for (std::uint32_t v = 0; v < model.positions.size(); ++v)
        model.places.push_back(first.emplace(model.positions[v], v).first->second);
}

/// Vertices of one place become one vertex, the first.
void merge(LodModel& model) {
    weld(model);
    for (auto& t : model.triangles) {
        for (VertexIndex& v : t) v = VertexIndex{model.places[raw(v)]};
    }
    model.places.clear();
}

}  // namespace

LodModel thin_plate(std::uint32_t side, double thickness) {
    LodModel model;
    const double n = side;
    const auto front = [&](std::uint32_t i, std::uint32_t j) {
        return std::sin(2 * kPi * i / n) +
               std::exp(-((i - 0.3 * n) * (i - 0.3 * n) + (j - 0.4 * n) * (j - 0.4 * n)) / 9);
    };
    const auto back = [&](std::uint32_t i, std::uint32_t j) {
        return 2 + std::cos(3 * kPi * j / n) * (i / n);
    };
    add_grid(
        model,
        side,
        side,
        [&](auto i, auto j) {
            return Point3{i / n, j / n, thickness};
        },
        front
    );
    add_grid(
        model,
        side,
        side,
        [&](auto i, auto j) {
            return Point3{1 - i / n, j / n, 0};
        },
        back
    );
    // Four narrow walls, outward.
    const auto wall = [&](auto place) {
        add_grid(
            model,
            side,
            1,
            [&](auto i, auto j) { return place(i / n, j == 0 ? 0.0 : thickness); },
            [&](auto i, auto j) { return j + 0.1 * i / n; }
        );
    };
    wall([](double s, double z) { return Point3{s, 0, z}; });
    wall([](double s, double z) { return Point3{1, s, z}; });
    wall([](double s, double z) { return Point3{1 - s, 1, z}; });
    wall([](double s, double z) { return Point3{0, 1 - s, z}; });
    // 1 - (i / n) and (n - i) / n may differ in the last bit: one place, one position.
    for (Point3& p : model.positions) {
        for (double& x : p) x = std::round(x * 1e12) / 1e12;
    }
    weld(model);
    return model;
}

LodModel capped_tube(std::uint32_t round, std::uint32_t along, bool split) {
    LodModel model;
    const auto on_circle = [&](std::uint32_t i, double radius, double z) {
        const double angle = 2 * kPi * (i % round) / round;
        return Point3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    const double length = 3, n = along;
    const auto field = [&](const Point3& p) { return std::sin(2 * p[2]) + 0.3 * p[0] * p[1] + p[2] * 0.2; };
    const auto add = [&](std::uint32_t rows, const auto& place) {
        add_grid(model, round, rows, place, [&](auto i, auto j) { return field(place(i, j)); });
    };
    const std::uint32_t rings = std::max(2U, round / 8);
    add(along, [&](std::uint32_t i, std::uint32_t j) { return on_circle(i, 1, length * j / n); });
    add(rings, [&](std::uint32_t i, std::uint32_t j) { return on_circle(i, 1 - double(j) / rings, length); });
    add(rings, [&](std::uint32_t i, std::uint32_t j) { return on_circle(i, double(j) / rings, 0); });
    for (Point3& p : model.positions) {
        for (double& x : p) x = std::round(x * 1e12) / 1e12 + 0.0;
    }
    if (split) {
        // The seam of the tube is no crease: one vertex there.
        const std::uint32_t per_row = round + 1;
        for (auto& t : model.triangles) {
            for (VertexIndex& v : t) {
                if (raw(v) % per_row == round) v = VertexIndex{raw(v) - round};
            }
        }
        weld(model);
    } else {
        merge(model);
    }
    return model;
}

LodModel flat_ring(std::uint32_t round, std::uint32_t rings) {
    LodModel model;
    const auto place = [&](std::uint32_t i, std::uint32_t j) {
        const double angle = 2 * kPi * (i % round) / round, radius = 1 + 2.0 * j / rings;
        return Point3{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    add_grid(model, round, rings, place, [](auto, auto) { return 1; });
    merge(model);
    return model;
}

LodModel two_parts(std::uint32_t side) {
    LodModel model;
    const double n = side;
    const auto height = [](double x, double y) { return 0.05 * std::sin(5 * x) * std::cos(4 * y); };
    for (std::uint32_t part = 0; part < 2; ++part) {
        const auto place = [&](std::uint32_t i, std::uint32_t j) {
            const double x = (i + part * n) / (2 * n), y = j / n;
            return Point3{x, y, height(x, y)};
        };
        add_grid(model, side, side, place, [&](auto i, auto j) {
            const Point3 p = place(i, j);
            return 10.0 * part + std::sin(3 * p[0]) * std::cos(2 * p[1]);
        });
        model.parts.resize(model.positions.size(), part);
    }
    weld(model);
    return model;
}

LodModel three_wings(std::uint32_t side) {
    LodModel model;
    const double n = side;
    for (int wing = 0; wing < 3; ++wing) {
        const double angle = 2 * kPi * wing / 3;
        const auto place = [&](std::uint32_t i, std::uint32_t j) {
            return Point3{i / n * std::cos(angle), i / n * std::sin(angle), j / n};
        };
        add_grid(model, side, side, place, [&](auto i, auto) { return i / n; });
    }
    merge(model);
    return model;
}

std::vector<LodField> bounded(const LodModel& model, double share) {
    std::vector<LodField> fields;
    for (const auto& values : model.fields) {
        float low = std::numeric_limits<float>::max(), high = -low;
        for (const float f : values) {
            if (!std::isfinite(f)) continue;
            low = std::min(low, f);
            high = std::max(high, f);
        }
        const double range = static_cast<double>(high) - static_cast<double>(low);
        fields.push_back({values, range > 0 ? share * range : share});
    }
    return fields;
}

std::vector<std::uint32_t> lasting_extremes(
    std::span<const float> values,
    std::span<const std::array<VertexIndex, 3>> triangles,
    double threshold,
    float sign
) {
    std::vector<std::vector<std::uint32_t>> neighbours(values.size());
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            neighbours[raw(t[k])].push_back(raw(t[(k + 1) % 3]));
            neighbours[raw(t[(k + 1) % 3])].push_back(raw(t[k]));
        }
    }
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < values.size(); ++v) {
        if (!neighbours[v].empty()) order.push_back(v);
    }
    std::ranges::stable_sort(order, [&](auto a, auto b) { return sign * values[a] > sign * values[b]; });
    constexpr std::uint32_t kNotYet = 0xffffffffU;
    std::vector<std::uint32_t> parent(values.size(), kNotYet);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    std::vector<std::size_t> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    std::vector<std::uint32_t> lasting;
    for (const std::uint32_t v : order) {
        parent[v] = v;
        for (const std::uint32_t w : neighbours[v]) {
            if (parent[w] == kNotYet) continue;
            std::uint32_t a = root(v), b = root(w);
            if (a == b) continue;
            if (rank[a] > rank[b]) std::swap(a, b);
            // b is the younger: it ends here.
            const double rise = std::abs(static_cast<double>(values[b]) - static_cast<double>(values[v]));
            if (rise > threshold) lasting.push_back(b);
            parent[b] = a;
        }
    }
    for (const std::uint32_t v : order) {
        if (root(v) == v) lasting.push_back(v);
    }
    std::ranges::sort(lasting);
    return lasting;
}

EdgeUse edge_use(const LodSurface& surface, std::span<const std::array<VertexIndex, 3>> triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
    const auto place = [&](VertexIndex v) {
        return surface.places.empty() ? raw(v) : surface.places[raw(v)];
    };
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = place(t[k]), b = place(t[(k + 1) % 3]);
            auto& [up, down] = uses[{std::min(a, b), std::max(a, b)}];
            ++(a < b ? up : down);
        }
    }
    EdgeUse use;
    for (const auto& [edge, count] : uses) {
        ++use.edges;
        if (count.first + count.second == 1) ++use.borders;
        if (count.first > 1 || count.second > 1) ++use.non_manifold;
    }
    return use;
}

void expect_sound(
    const LodSurface& surface,
    std::span<const LodField> fields,
    const LodResult& result,
    const LodOptions& options
) {
    ASSERT_EQ(result.levels.size(), options.targets.size());
    const EdgeUse before = edge_use(surface, surface.triangles);
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
        const LodLevel& level = result.levels[i];
        SCOPED_TRACE(testing::Message() << "level " << i << " of " << level.triangles.size() << " triangles");
        const LodCertificate& certificate = level.certificate;
        EXPECT_LE(certificate.worst, 1.0);
        EXPECT_LE(certificate.bound, options.targets[i].bound);
        EXPECT_LE(certificate.max_distance, certificate.distance_bound);
        EXPECT_LE(certificate.max_border_distance, certificate.distance_bound);
        const LodCheck check = check_level(surface, fields, level.triangles, certificate.distance_bound);
        EXPECT_EQ(check.without_place, 0U);
        EXPECT_EQ(check.invented, 0U);
        EXPECT_EQ(check.lost, 0U);
        EXPECT_LE(check.max_distance, certificate.distance_bound * (1 + 1e-9));
        for (std::size_t k = 0; k < fields.size(); ++k) {
            EXPECT_LE(certificate.fields[k].max, certificate.fields[k].bound);
            EXPECT_LE(certificate.fields[k].rms, certificate.fields[k].max);
            EXPECT_LE(check.fields[k].max, certificate.fields[k].bound * (1 + 1e-9))
                << "at vertex " << raw(check.fields[k].worst);
        }
        for (std::uint32_t v = 0; v < level.witness.size(); ++v) {
            if (level.witness[v] == 0xffffffffU) continue;
            ASSERT_LT(level.witness[v], level.triangles.size());
        }
        const EdgeUse after = edge_use(surface, level.triangles);
        EXPECT_LE(after.non_manifold, before.non_manifold);
        EXPECT_TRUE(before.borders > 0 || after.borders == 0);
    }
}

}  // namespace feelem::test
