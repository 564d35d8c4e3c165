// SPDX-License-Identifier: Apache-2.0
#include "inside/section_checks.hpp"

#include "model/vector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace feelem::test {
namespace {

using Key = std::array<std::int64_t, 3>;

/// Places nearer than this are the same; no two that differ are so near in our meshes.
constexpr double kSame = 1e-7;

Key key_of(const Point3& place) {
    return {
        std::llround(place[0] / kSame + 0.31),
        std::llround(place[1] / kSame + 0.31),
        std::llround(place[2] / kSame + 0.31)};
}

using Segments = std::map<std::pair<Key, Key>, int>;

void add(Segments& segments, const Key& a, const Key& b) {
    if (a == b) return;
    int& count = a < b ? segments[{a, b}] : segments[{b, a}];
    count += a < b ? 1 : -1;
}

std::string text(const Key& key) {
    return fmt::format("({} {} {})", kSame * double(key[0]), kSame * double(key[1]), kSame * double(key[2]));
}

}  // namespace

std::vector<RimPoint> rim_of_skin(const Surface& skin, const SurfaceField& field, const Plane& plane) {
    const double size = length(plane.normal);
    std::vector<RimPoint> rim;
    for (const auto& triangle : skin.triangles) {
        std::array<double, 3> level{};
        for (std::size_t i = 0; i < 3; ++i)
            level[i] = (dot(plane.normal, skin.positions[raw(triangle[i])]) - plane.offset) / size;
        std::array<RimPoint, 2> ends;  // where it goes down, where it comes up
        bool is_cut = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = (i + 1) % 3;
            if ((level[i] >= 0) == (level[k] >= 0)) continue;
            is_cut = true;
            const double t = level[i] / (level[i] - level[k]);
            RimPoint& end = ends[level[i] >= 0 ? 0 : 1];
            const auto a = raw(triangle[i]), b = raw(triangle[k]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                end.place[axis] = (1 - t) * skin.positions[a][axis] + t * skin.positions[b][axis];
            end.value = (1 - t) * double(field.values[a]) + t * double(field.values[b]);
        }
        if (!is_cut) continue;
        // Above the plane the outward triangle goes anticlockwise from up to down: below, the material is
        // left.
        rim.push_back(ends[0]);
        rim.push_back(ends[1]);
    }
    return rim;
}

double area_within(const std::vector<RimPoint>& rim, const Plane& plane) {
    const Point3 normal = direction(plane.normal).value();
    double twice = 0;
    for (std::size_t i = 0; i + 1 < rim.size(); i += 2) {
        const Point3 a = minus(rim[i].place, rim[0].place), b = minus(rim[i + 1].place, rim[0].place);
        twice += dot(cross(a, b), normal);
    }
    return twice / 2;
}

std::string rim_difference(const Section& section, const std::vector<RimPoint>& rim) {
    Segments mine, skins;
    for (const auto& triangle : section.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            add(mine, key_of(section.positions[triangle[i]]), key_of(section.positions[triangle[(i + 1) % 3]])
            );
    }
    for (std::size_t i = 0; i + 1 < rim.size(); i += 2)
        add(skins, key_of(rim[i].place), key_of(rim[i + 1].place));
    std::erase_if(mine, [](const auto& segment) { return segment.second == 0; });
    std::erase_if(skins, [](const auto& segment) { return segment.second == 0; });
    for (const auto& [segment, count] : mine) {
        const auto found = skins.find(segment);
        if (found == skins.end() || found->second != count)
            return "not on the skin: " + text(segment.first) + " " + text(segment.second);
    }
    for (const auto& [segment, count] : skins) {
        if (!mine.contains(segment))
            return "not on the section: " + text(segment.first) + " " + text(segment.second);
    }
    return {};
}

std::string rim_value_difference(const Section& section, const std::vector<RimPoint>& rim, double tolerance) {
    std::multimap<Key, std::size_t> vertices;
    for (std::size_t v = 0; v < section.positions.size(); ++v)
        vertices.emplace(key_of(section.positions[v]), v);
    for (const RimPoint& point : rim) {
        const auto [first, last] = vertices.equal_range(key_of(point.place));
        if (first == last) return "no vertex at " + text(key_of(point.place));
        // Where parts meet each has its own value: one of them is the skin's.
        double nearest = std::numeric_limits<double>::infinity();
        for (auto i = first; i != last; ++i)
            nearest = std::min(nearest, std::abs(double(section.values[i->second]) - point.value));
        if (!(nearest <= tolerance)) return fmt::format("{} off at {}", nearest, text(key_of(point.place)));
    }
    return {};
}

Result nodal(std::vector<float> values) {
    Result result;
    result.info.components = {"value"};
    result.values = std::move(values);
    return result;
}

}  // namespace feelem::test
