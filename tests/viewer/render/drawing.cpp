// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/drawing.hpp"

#include "support/paths.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace feelem::viewer::tests {
namespace {

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
    return out;
}

/// Of the pictures that png_of() writes: RGB, 8 bit, no filters.
std::optional<Pixels> read_png(const std::string& bytes) {
    Pixels out;
    std::string packed;
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = big_endian(bytes, at);
        const std::string type = bytes.substr(at + 4, 4);
        if (type == "IHDR") {
            out.width = static_cast<int>(big_endian(bytes, at + 8));
            out.height = static_cast<int>(big_endian(bytes, at + 12));
        }
        if (type == "IDAT") packed += bytes.substr(at + 8, length);
        at += 12 + length;
    }
    const std::size_t row = 3 * static_cast<std::size_t>(out.width);
    uLongf size = (row + 1) * static_cast<std::size_t>(out.height);
    std::vector<std::uint8_t> rows(size);
    const auto* from = reinterpret_cast<const Bytef*>(packed.data());
    if (uncompress(rows.data(), &size, from, packed.size()) != Z_OK) return std::nullopt;
    for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
        const auto first = rows.begin() + static_cast<std::ptrdiff_t>(y * (row + 1) + 1);
        out.rgb.insert(out.rgb.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    return out;
}

/// A side of the box: corner, and the two ways to go from there, whose cross product points outwards.
struct BoxSide {
    glm::vec3 corner, right, up;
};

void add_side(const BoxSide& side, int cells, Geometry& out) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    const auto cell = static_cast<std::uint32_t>(cells);
    const glm::vec3 normal = glm::normalize(glm::cross(side.right, side.up));
    for (std::uint32_t y = 0; y <= cell; ++y) {
        for (std::uint32_t x = 0; x <= cell; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(cells);
            const float v = static_cast<float>(y) / static_cast<float>(cells);
            const glm::vec3 p = side.corner + u * side.right + v * side.up;
            out.positions.push_back({p.x, p.y, p.z});
            out.normals.push_back({normal.x, normal.y, normal.z});
            const auto whole = [](float number) {
                return static_cast<std::int64_t>(std::lround(number * 1000));
            };
            out.node_ids.push_back(
                1 + (whole(p.x) + 5000) + 20000 * ((whole(p.y) + 5000) + 20000 * (whole(p.z) + 5000))
            );
            const glm::vec3 raised = p + 0.0005F * normal;
            out.edge_vertices.push_back(static_cast<std::uint32_t>(out.edge_positions.size()));
            out.edge_positions.push_back({raised.x, raised.y, raised.z});
        }
    }
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return first + y * (cell + 1) + x; };
    for (std::uint32_t y = 0; y <= cell; ++y) {
        for (std::uint32_t x = 0; x <= cell; ++x) {
            if (x < cell) out.edges.push_back({at(x, y), at(x + 1, y)});
            if (y < cell) out.edges.push_back({at(x, y), at(x, y + 1)});
            if (x == cell || y == cell) continue;
            out.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            out.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    }
}

void finish(SmallModel& model) {
    Geometry& g = model.geometry;
    g.low = g.high = g.positions.front();
    for (const auto& place : g.positions) {
        for (std::size_t k = 0; k < 3; ++k) {
            g.low[k] = std::min(g.low[k], place[k]);
            g.high[k] = std::max(g.high[k], place[k]);
        }
    }
    g.element_ids.assign(g.triangles.size(), 1);
    PartRange part;
    part.vertices = static_cast<std::uint32_t>(g.positions.size());
    part.triangles = static_cast<std::uint32_t>(g.triangles.size());
    part.edges = static_cast<std::uint32_t>(g.edges.size());
    g.parts = {part};
    model.solid = {true};
}

}  // namespace

void WithGl::SetUp() {
    try {
        context_ = std::make_unique<GlContext>();
    } catch (const std::exception& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
}

void WithGl::TearDown() {
    context_.reset();
}

DrawnModel SmallModel::drawn() const {
    DrawnModel out;
    out.geometry = &geometry;
    out.solid = solid;
    out.values = [this](std::size_t result, std::size_t) -> const FieldValues& { return fields.at(result); };
    out.level = [this](std::size_t level) -> const std::vector<std::array<std::uint32_t, 3>>& {
        return levels.at(level);
    };
    return out;
}

SmallModel box_model(std::array<float, 3> size, int cells) {
    const glm::vec3 s(size[0], size[1], size[2]);
    const glm::vec3 x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z), low = -0.5F * s, high = 0.5F * s;
    SmallModel model;
    for (const BoxSide& side : {
             BoxSide{low + z, x, y},
             BoxSide{low, y, x},
             BoxSide{high, -y, -z},
             BoxSide{low, z, y},
             BoxSide{low + y, z, x},
             BoxSide{low, x, z},
         })
        add_side(side, cells, model.geometry);
    finish(model);
    return model;
}

SmallModel ball_model(int rings) {
    SmallModel model;
    Geometry& g = model.geometry;
    const auto columns = static_cast<std::uint32_t>(2 * rings);
    const auto rows = static_cast<std::uint32_t>(rings);
    for (std::uint32_t r = 0; r <= rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const double a = 3.14159265358979 * r / rows, b = 2 * 3.14159265358979 * c / columns;
            const std::array<float, 3> p{
                static_cast<float>(std::sin(a) * std::cos(b)),
                static_cast<float>(std::cos(a)),
                static_cast<float>(-std::sin(a) * std::sin(b))};
            g.positions.push_back(p);
            g.normals.push_back(p);
            const bool is_pole = r == 0 || r == rows;
            g.node_ids.push_back(is_pole ? 1 + r : 1000 + std::int64_t{r} * columns + c);
        }
    }
    const auto at = [&](std::uint32_t r, std::uint32_t c) { return r * columns + c % columns; };
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            if (r > 0) g.triangles.push_back({at(r, c), at(r + 1, c), at(r, c + 1)});
            if (r + 1 < rows) g.triangles.push_back({at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)});
        }
    }
    finish(model);
    return model;
}

void append(SmallModel& one, const SmallModel& two) {
    Geometry& g = one.geometry;
    const auto vertices = static_cast<std::uint32_t>(g.positions.size());
    const auto triangles = static_cast<std::uint32_t>(g.triangles.size());
    const auto edges = static_cast<std::uint32_t>(g.edges.size());
    const auto edge_places = static_cast<std::uint32_t>(g.edge_positions.size());
    const Geometry& other = two.geometry;
    const auto join = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    join(g.positions, other.positions);
    join(g.normals, other.normals);
    join(g.edge_positions, other.edge_positions);
    for (const std::int64_t id : other.node_ids) g.node_ids.push_back(id == 0 ? 0 : -id - 1);
    join(g.element_ids, other.element_ids);
    for (const std::uint32_t vertex : other.edge_vertices) g.edge_vertices.push_back(vertex + vertices);
    for (const auto& [a, b, c] : other.triangles)
        g.triangles.push_back({a + vertices, b + vertices, c + vertices});
    for (const auto& [a, b] : other.edges) g.edges.push_back({a + edge_places, b + edge_places});
    for (PartRange part : other.parts) {
        part.first_vertex += vertices;
        part.first_triangle += triangles;
        part.first_edge += edges;
        g.parts.push_back(part);
    }
    for (const bool solid : two.solid) one.solid.push_back(solid);
    for (std::size_t k = 0; k < 3; ++k) {
        g.low[k] = std::min(g.low[k], other.low[k]);
        g.high[k] = std::max(g.high[k], other.high[k]);
    }
}

Camera looking(const glm::vec3& from, const glm::vec3& to, float degrees, float aspect) {
    const float angle = glm::radians(degrees);
    return {glm::lookAt(from, to, glm::vec3(0, 1, 0)), glm::perspective(angle, aspect, 0.02F, 50.0F)};
}

void draw_whole(Renderer& renderer, const DrawInput& input) {
    do renderer.draw(input);
    while (!renderer.is_complete());
}

Rgb pixel(const Pixels& picture, int x, int y) {
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(x));
    return {picture.rgb.at(at), picture.rgb.at(at + 1), picture.rgb.at(at + 2)};
}

Difference compare(const Pixels& one, const Pixels& two) {
    if (one.rgb.size() != two.rgb.size()) return {255, std::max(one.rgb.size(), two.rgb.size())};
    Difference out;
    for (std::size_t at = 0; at < one.rgb.size(); at += 3) {
        int most = 0;
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(int{one.rgb[at + k]} - int{two.rgb[at + k]}));
        out.largest = std::max(out.largest, most);
        if (most > 0) ++out.pixels;
    }
    return out;
}

void expect_golden(const std::string& name, const Pixels& picture) {
    constexpr int kTolerance = 12;
    constexpr double kShare = 0.002;
    const std::string path = test::project_file(fmt::format("tests/viewer/render/golden/{}.png", name));
    if (std::getenv("FEELEM_UPDATE_GOLDEN")) test::write_file(path, png_of(picture));
    ASSERT_TRUE(std::filesystem::exists(path)) << path << ": FEELEM_UPDATE_GOLDEN=1 writes it";
    const auto golden = read_png(test::read_file(path));
    ASSERT_TRUE(golden) << path << " is no picture of ours";
    ASSERT_EQ(golden->width, picture.width);
    ASSERT_EQ(golden->height, picture.height);
    std::size_t off = 0;
    for (std::size_t at = 0; at < picture.rgb.size(); at += 3) {
        int most = 0;
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(int{golden->rgb[at + k]} - int{picture.rgb[at + k]}));
        if (most > kTolerance) ++off;
    }
    const double share = static_cast<double>(off) / (static_cast<double>(picture.rgb.size()) / 3);
    if (share <= kShare) return;
    const std::string seen = test::scratch_folder("golden_" + name) + "/" + name + ".png";
    test::write_file(seen, png_of(picture));
    ADD_FAILURE() << name << ": " << off << " pixels differ by more than " << kTolerance
                  << "; seen: " << seen;
}

}  // namespace feelem::viewer::tests
