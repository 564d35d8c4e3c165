// SPDX-License-Identifier: Apache-2.0
// The boiler as a person sees it: its colours against the formulas, and pictures beside golden ones.
#include "support/paths.hpp"
#include "viewer/render/colouring.hpp"
#include "viewer/render/drawing.hpp"

#include "feelem/convert.hpp"
#include "feelem/pick.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace feelem::viewer::tests {
namespace {

constexpr Rgb kDesk{227, 231, 231};

/// The shipped boiler, 0.8 m large, its middle in the origin.
class Boilers : public WithGl {
protected:
    void SetUp() override {
        WithGl::SetUp();
        if (IsSkipped()) return;
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        Job job;
        job.inputs = {test::project_file("examples/boiler/boiler.frd")};
        job.output = test::scratch_folder("viewer_render_" + name) + "/boiler.glb";
        job.length_unit = "mm";
        job.presentation_file = test::project_file("examples/boiler/boiler.presentation.json");
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        scene_ = std::make_unique<LoadedScene>(job.output);
        renderer_ = std::make_unique<Renderer>();
        renderer_->set_model(drawn_model(*scene_));
        const Geometry& g = scene_->geometry();
        const glm::vec3 low(g.low[0], g.low[1], g.low[2]), high(g.high[0], g.high[1], g.high[2]);
        const glm::mat4& metres = scene_->to_metres();
        const glm::vec3 middle(metres * glm::vec4(0.5F * (low + high), 1));
        const glm::vec3 size = glm::abs(glm::mat3(metres) * (high - low));
        const float scale = 0.8F / std::max({size.x, size.y, size.z});
        look_.model_to_world = glm::translate(glm::scale(glm::mat4(1), glm::vec3(scale)), -middle) * metres;
        middle_ = 0.5F * (low + high);
        size_ = high - low;
    }
    void TearDown() override {
        renderer_.reset();
        scene_.reset();
        WithGl::TearDown();
    }

    void show(const std::string& key) {
        for (const PresentedResult& result : scene_->about().presentation.results) {
            if (result.key != key) continue;
            look_.field = scene_->find(result, 0);
            look_.range = value_range(result);
        }
        ASSERT_TRUE(look_.field) << key;
    }
    void deform(float factor) {
        for (std::size_t r = 0; r < scene_->about().results.size(); ++r)
            if (scene_->about().results[r].id == "displacement")
                look_.shape = Shape{{r, 0, 0}, std::nullopt, factor, 0};
        ASSERT_TRUE(look_.shape);
    }
    Pixels drawn(const Camera& eye, int width = 320, int height = 240) {
        DrawInput input;
        input.eyes = {&eye, 1};
        input.width = width;
        input.height = height;
        input.look = &look_;
        input.background = kDesk;
        input.marks = marks_;
        input.labels = labels_;
        draw_whole(*renderer_, input);
        return renderer_->read(0);
    }
    glm::vec3 world(const std::array<float, 3>& place) const {
        return glm::vec3(look_.model_to_world * glm::vec4(place[0], place[1], place[2], 1));
    }

    std::unique_ptr<LoadedScene> scene_;
    std::unique_ptr<Renderer> renderer_;
    Look look_;
    glm::vec3 middle_{0}, size_{1};
    std::vector<Mark> marks_;
    std::vector<Label> labels_;
};

const glm::vec3 kFromFront(0.55F, 0.4F, 0.85F);

/// Which texel of the palette a pixel shows; -1: none.
int texel_of(const std::vector<std::uint8_t>& texels, const Rgb& colour) {
    for (std::size_t i = 0; i < texels.size() / 4; ++i)
        if (std::equal(colour.begin(), colour.end(), texels.begin() + static_cast<std::ptrdiff_t>(4 * i)))
            return static_cast<int>(i);
    return -1;
}

struct SeenPlace {
    int x = 0, y = 0;
    double value = 0;
};

/// Where rays through the middles of pixels meet the skin, away from silhouettes.
std::vector<SeenPlace> seen_places(
    const LoadedScene& scene, const FieldValues& field, const glm::mat4& clip_from_model, glm::ivec2 size
) {
    const Geometry& g = scene.geometry();
    const Picker picker(g.positions, g.triangles);
    const glm::dmat4 back = glm::inverse(glm::dmat4(clip_from_model));
    const auto hit = [&](double x, double y) {
        const auto unproject = [&](double z) {
            const glm::dvec4 p = back * glm::dvec4(2 * x / size.x - 1, 1 - 2 * y / size.y, z, 1);
            return glm::dvec3(p) / p.w;
        };
        const glm::dvec3 from = unproject(-1), along = glm::normalize(unproject(1) - from);
        return picker.ray({from.x, from.y, from.z}, {along.x, along.y, along.z});
    };
    std::vector<SeenPlace> out;
    std::mt19937 random(6);
    while (out.size() < 200) {
        const auto x = static_cast<int>(random() % static_cast<unsigned>(size.x));
        const auto y = static_cast<int>(random() % static_cast<unsigned>(size.y));
        const auto middle = hit(x + 0.5, y + 0.5);
        if (!middle) continue;
        const bool is_rim = std::ranges::any_of(
            std::array{glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)},
            [&](const glm::ivec2& corner) {
                const auto beside = hit(x + corner.x, y + corner.y);
                return !beside || std::abs(beside->distance - middle->distance) > 0.01 * middle->distance;
            }
        );
        if (is_rim) continue;
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value += middle->weights[k] * double{field.values[g.triangles[middle->triangle][k]]};
        out.push_back({x, y, value});
    }
    return out;
}

TEST_F(Boilers, two_hundred_places_have_the_colours_of_their_values) {
    const Camera eye = looking(kFromFront, {0, 0, 0});
    look_.edges = false;
    look_.shade_floor = 1;
    for (const std::string key : {"T", "U", "S"}) {
        show(key);
        const FieldValues& field = scene_->values(look_.field->result, look_.field->values);
        ASSERT_EQ(field.components, 1U);
        const auto places =
            seen_places(*scene_, field, eye.projection * eye.view * look_.model_to_world, {640, 480});
        for (const int bands : {9, 0}) {
            look_.colour.bands = bands;
            const Pixels picture = drawn(eye, 640, 480);
            const auto texels = palette_texels(look_.colour);
            int exact = 0, beyond = 0;
            for (const SeenPlace& place : places) {
                const Rgb seen = pixel(picture, place.x, place.y);
                const Normalised at = normalise(place.value, look_.range);
                if (at.above || at.below) {
                    beyond += seen == colour_of(place.value, look_.range, look_.colour);
                    continue;
                }
                const int count = bands > 0 ? bands : kSmoothPalette;
                const int expected = std::min(static_cast<int>(at.position * count), count - 1);
                if (bands == 0) {
                    // Neighbouring texels may have the same bytes.
                    const Rgb wanted = palette_colour(at.position, look_.colour);
                    int most = 0;
                    for (std::size_t k = 0; k < 3; ++k)
                        most = std::max(most, std::abs(int{seen[k]} - int{wanted[k]}));
                    exact += most <= 2;
                    EXPECT_LE(most, 4) << key << " " << place.x << " " << place.y;
                    continue;
                }
                const int texel = texel_of(texels, seen);
                exact += texel == expected;
                // At a border of bands a pixel mixes the two.
                if (texel < 0) continue;
                EXPECT_LE(std::abs(texel - expected), 1) << key << " " << place.value;
            }
            EXPECT_GE(exact + beyond, 194) << key << " " << bands;
        }
    }
}

TEST_F(Boilers, desk_shows_bands_edges_and_shading) {
    show("T");
    expect_golden("desk", drawn(looking(kFromFront, {0, 0, 0})));
    // Its elements are numbered without order; what turns its back is left out all the same.
    EXPECT_GT(renderer_->counts().clusters_culled, renderer_->counts().clusters / 10);
}

TEST_F(Boilers, isolines_and_the_limits_double_line_follow_the_values) {
    show("U");
    look_.limit = look_.range.lo + 0.6 * (look_.range.hi - look_.range.lo);
    look_.isolines = true;
    look_.edges = false;
    look_.colour.map = "viridis";
    expect_golden("limit", drawn(looking(kFromFront, {0, 0, 0})));
}

TEST_F(Boilers, a_cut_shows_hatched_material_and_the_inside) {
    show("T");
    look_.cuts = {{{0, 0, 1}, middle_.z + 0.02F * size_.z}};
    expect_golden("cut", drawn(looking({0.35F, 0.75F, 0.55F}, {0, 0, 0})));
}

TEST_F(Boilers, a_deformed_shape_stands_beside_its_ghost) {
    show("U");
    deform(250);
    look_.ghost = true;
    expect_golden("deformed", drawn(looking({0.9F, 0.6F, 1.3F}, {0.1F, 0, 0})));
}

TEST_F(Boilers, both_eyes_see_model_marks_and_labels_in_depth) {
    show("T");
    const auto& places = scene_->geometry().positions;
    const auto pointed = *std::ranges::min_element(places, {}, [&](const std::array<float, 3>& place) {
        return glm::distance(world(place), {0.12F, 0.12F, 0.4F});
    });
    marks_ = {
        {Mark::Kind::Line, {0.25F, -0.1F, 0.7F}, world(pointed), 0.004F, {235, 240, 245}},
        {Mark::Kind::Ring, world(pointed), {0, 0.4F, 1}, 0.016F, {255, 255, 255}}};
    labels_ = {{world(pointed) + glm::vec3(0, 0.045F, 0), "251.4 °C", {255, 255, 255}, 0.02F}};
    std::array<Camera, 2> eyes;
    for (std::size_t i = 0; i < 2; ++i) {
        EyeView eye;
        eye.pose.position = {i == 0 ? -0.032F : 0.032F, 0.35F, 1.1F};
        eye.pose.orientation = glm::angleAxis(-0.28F, glm::vec3(1, 0, 0));
        eye.field = {i == 0 ? -0.5F : -0.42F, i == 0 ? 0.42F : 0.5F, 0.4F, -0.4F};
        eyes[i] = camera_of(eye);
    }
    DrawInput input;
    input.eyes = eyes;
    input.width = 280;
    input.height = 240;
    input.look = &look_;
    input.marks = marks_;
    input.labels = labels_;
    input.floor = -0.6F;
    draw_whole(*renderer_, input);

    expect_golden("left-eye", renderer_->read(0));
    expect_golden("right-eye", renderer_->read(1));
}

using Pictures = WithGl;

TEST_F(Pictures, every_colour_map_runs_from_below_to_above) {
    SmallModel model = box_model({1.2F, 1, 0.01F}, 1);
    model.add_field(0, [](const auto& p) { return p[0] + 0.5F; });
    const Camera eye{glm::mat4(1), glm::ortho(-0.6F, 0.6F, -0.5F, 0.5F, -1.0F, 1.0F)};
    Look look;
    look.field = FieldChoice{};
    look.edges = false;
    look.shade_floor = 1;
    Renderer renderer;
    renderer.set_model(model.drawn());
    DrawInput input;
    input.eyes = {&eye, 1};
    input.width = 320;
    input.height = 20;
    input.look = &look;
    Pixels all{320, 0, {}};
    for (const std::string_view map : colour_maps()) {
        for (const int bands : {9, 0}) {
            look.colour.map = map;
            look.colour.bands = bands;
            draw_whole(renderer, input);
            const Pixels strip = renderer.read(0);
            all.rgb.insert(all.rgb.end(), strip.rgb.begin(), strip.rgb.end());
            all.height += strip.height;
        }
    }
    expect_golden("maps", all);
}

TEST_F(Pictures, missing_values_clear_parts_and_sizes_of_text_are_told_apart) {
    SmallModel model = box_model({0.5F, 0.5F, 0.5F}, 5);
    for (const float shift : {0.7F, 1.4F}) {
        SmallModel next = box_model({0.5F, 0.5F, 0.5F}, 5);
        for (auto* places : {&next.geometry.positions, &next.geometry.edge_positions})
            for (auto& place : *places) place[0] += shift;
        next.geometry.low[0] += shift;
        next.geometry.high[0] += shift;
        append(model, next);
    }
    model.add_field(0, [](const auto& p) {
        if (p[0] > 0.5F && p[0] < 1 && p[1] > 0.1F) return std::numeric_limits<float>::quiet_NaN();
        return 1.15F * p[0] / 1.9F + 0.1F + 0.2F * p[1];
    });
    Look look;
    look.field = FieldChoice{};
    look.parts = {PartLook::Shown, PartLook::Shown, PartLook::Clear};
    look.isolines = true;
    look.model_to_world = glm::translate(glm::mat4(1), {-0.7F, 0, 0});
    const Camera eye = looking({0.5F, 0.8F, 2.2F}, {0, 0.05F, 0}, 45);
    const std::vector<Mark> marks{
        {Mark::Kind::Dot, {-0.7F, 0.25F, 0.25F}, {0, 1, 0}, 0.012F, {255, 170, 0}},
        {Mark::Kind::Dot, {0.25F, -0.25F, 0.25F}, {0, 1, 0}, 0.012F, {90, 200, 255}},
        {Mark::Kind::Ring, {0.1F, 0.05F, 0.25F}, {0, 0, 1}, 0.05F, {255, 255, 255}}};
    const std::vector<Label> labels{
        {{-0.7F, 0.33F, 0.25F}, "min −12.5 °C", {255, 255, 255}, 0.022F},
        {{0.25F, -0.18F, 0.25F}, "node 9041: σ = 251.4 N/mm²", {255, 220, 130}, 0.016F}};
    DrawInput input;
    input.eyes = {&eye, 1};
    input.width = 480;
    input.height = 320;
    input.look = &look;
    input.marks = marks;
    input.labels = labels;
    input.background = kDesk;
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input);

    expect_golden("parts-and-labels", renderer.read(0));
}

}  // namespace
}  // namespace feelem::viewer::tests
