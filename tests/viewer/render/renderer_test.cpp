// SPDX-License-Identifier: Apache-2.0
// What is drawn, by its pixels: eyes, colours, parts, shapes, and what is sent to the card for it.
#include "viewer/render/clusters.hpp"
#include "viewer/render/drawing.hpp"

#include "feelem/error.hpp"

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace feelem::viewer::tests {
namespace {

using Renderers = WithGl;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// True colours, so that a pixel's bytes are the palette's.
Look plain_look() {
    Look look;
    look.field = FieldChoice{0, 0, 0};
    look.range = {0, 1, Scale::Linear};
    look.shade_floor = 1;
    look.edges = false;
    return look;
}

DrawInput input_of(std::span<const Camera> eyes, const Look& look, int width = 160, int height = 120) {
    DrawInput input;
    input.eyes = eyes;
    input.width = width;
    input.height = height;
    input.look = &look;
    return input;
}

/// Two eyes 64 mm apart that look along -Z from `from`, as a headset's: each sees more outwards.
std::array<Camera, 2> two_eyes(const glm::vec3& from) {
    std::array<Camera, 2> out;
    for (std::size_t i = 0; i < 2; ++i) {
        EyeView eye;
        eye.pose.position = from + glm::vec3(i == 0 ? -0.032F : 0.032F, 0, 0);
        eye.field = {i == 0 ? -0.75F : -0.65F, i == 0 ? 0.65F : 0.75F, 0.6F, -0.6F};
        out[i] = camera_of(eye);
    }
    return out;
}

TEST_F(Renderers, three_ways_to_draw_two_eyes_give_the_same_pixels) {
    SmallModel model = box_model({0.5F, 0.4F, 0.3F}, 6);
    model.add_field(0, [](const auto& p) { return p[0] + 0.5F; });
    model.add_vectors(1, [](const auto& p) { return std::array<float, 3>{0, p[0] * p[0], 0}; });
    Look look = plain_look();
    look.shade_floor = 0.75F;
    look.edges = look.ghost = look.isolines = true;
    look.limit = 0.55;
    look.shape = Shape{{1, 0, 0}, std::nullopt, 0.4F, 0};
    look.cuts = {{{0, 0, 1}, 0.1F}};
    look.model_to_world = glm::rotate(glm::translate(glm::mat4(1), {0, 0, -1.2F}), 0.5F, {0.3F, 1, 0});
    const auto eyes = two_eyes({0, 0, 0});
    const std::vector<Mark> marks{
        {Mark::Kind::Dot, {0.1F, 0.1F, -1}, {0, 0, 1}, 0.01F, {255, 80, 0}},
        {Mark::Kind::Ring, {-0.1F, 0.1F, -0.9F}, {0, 0.5F, 1}, 0.03F, {255, 255, 255}},
        {Mark::Kind::Line, {0.3F, -0.3F, -0.6F}, {0, 0, -1.2F}, 0.004F, {0, 200, 255}}};
    const std::vector<Label> labels{{{0.1F, 0.1F, -1}, "251.4 °C", {255, 255, 255}, 0.012F}};

    std::vector<Pixels> pictures;
    for (const StereoPath path : {StereoPath::VertexLayer, StereoPath::GeometryShader, StereoPath::TwoPass}) {
        Renderer renderer({.stereo = path});
        renderer.set_model(model.drawn());
        DrawInput input = input_of(eyes, look, 240, 200);
        input.marks = marks;
        input.labels = labels;
        input.floor = -0.5F;
        draw_whole(renderer, input);
        pictures.push_back(renderer.read(0));
        pictures.push_back(renderer.read(1));
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

    EXPECT_GT(compare(pictures[0], pictures[1]).pixels, 2000U) << "both eyes see the same";
    for (std::size_t other = 2; other < pictures.size(); ++other)
        EXPECT_EQ(compare(pictures[other % 2], pictures[other]).pixels, 0U) << "picture " << other;
}

/// Middle of all pixels of a colour, x.
double middle_of(const Pixels& picture, const Rgb& colour) {
    double sum = 0, count = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (pixel(picture, x, y) != colour) continue;
            sum += x + 0.5;
            ++count;
        }
    }
    return count > 0 ? sum / count : -1e9;
}

TEST_F(Renderers, a_point_is_as_far_apart_in_both_eyes_as_their_projections_say) {
    for (const float distance : {0.6F, 1.2F, 4.0F}) {
        const glm::vec3 place(0.05F, 0.02F, -distance);
        SmallModel model = box_model({0.06F * distance, 0.06F * distance, 0.001F}, 1);
        model.add_field(0, [](const auto&) { return 0.5F; });
        Look look = plain_look();
        look.model_to_world = glm::translate(glm::mat4(1), place);
        const auto eyes = two_eyes({0, 0, 0});
        Renderer renderer;
        renderer.set_model(model.drawn());
        const DrawInput input = input_of(eyes, look, 480, 400);
        draw_whole(renderer, input);

        const Rgb colour = colour_of(0.5, look.range, look.colour);
        std::array<double, 2> expected{};
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::vec4 clip = eyes[i].projection * eyes[i].view * glm::vec4(place, 1);
            expected[i] = (0.5 + 0.5 * double(clip.x / clip.w)) * input.width;
        }

        const double left = middle_of(renderer.read(0), colour), right = middle_of(renderer.read(1), colour);
        EXPECT_NEAR(left, expected[0], 0.5) << distance;
        EXPECT_NEAR(left - right, expected[0] - expected[1], 0.5) << distance;
    }
}

TEST_F(Renderers, bands_are_the_formulas_inside_triangles) {
    // Two triangles fill the picture; the value runs from -0.1 to 1.1 over them.
    SmallModel model = box_model({1.2F, 1, 0.01F}, 1);
    model.add_field(0, [](const auto& p) { return p[0] + 0.5F; });
    Look look = plain_look();
    const Camera eye{glm::mat4(1), glm::ortho(-0.6F, 0.6F, -0.5F, 0.5F, -1.0F, 1.0F)};
    for (const Scale scale : {Scale::Linear, Scale::Log, Scale::Signed, Scale::SymLog}) {
        for (const int bands : {9, 4, 0}) {
            look.range = {scale == Scale::Log ? 0.05 : 0, 1, scale};
            look.colour.bands = bands;
            look.colour.map = bands == 4 ? "ansys_rainbow" : "batlow";
            Renderer renderer;
            renderer.set_model(model.drawn());
            draw_whole(renderer, input_of({&eye, 1}, look, 600, 8));
            const Pixels picture = renderer.read(0);
            int wrong = 0;
            for (int x = 0; x < picture.width; ++x) {
                const double value = -0.1 + 1.2 * (x + 0.5) / picture.width;
                // A border of bands may fall to either side by the last bits of float32.
                const Rgb near[]{
                    colour_of(value - 1e-3, look.range, look.colour),
                    colour_of(value, look.range, look.colour),
                    colour_of(value + 1e-3, look.range, look.colour)};
                const Rgb seen = pixel(picture, x, 4);
                if (std::ranges::find(near, seen) == std::end(near)) ++wrong;
            }
            // Where the triangles' common side meets a border, two bands share a pixel; between the rows of a
            // smooth map a byte may be off by one.
            EXPECT_LE(wrong, bands == 0 ? picture.width / 3 : 1) << int(scale) << " " << bands;
            EXPECT_EQ(
                pixel(picture, 0, 4), scale == Scale::Signed ? pixel(picture, 0, 4) : look.colour.below
            );
            EXPECT_EQ(pixel(picture, picture.width - 1, 4), look.colour.above);
        }
    }
}

TEST_F(Renderers, triangles_smaller_than_a_pixel_show_nothing_beyond_the_range) {
    SmallModel model = box_model({1, 1, 1}, 300);
    model.add_field(0, [](const auto& p) { return 1 - 1e-4F * std::abs(std::sin(900 * p[0] + 700 * p[1])); });
    Look look = plain_look();
    look.range = {0.9999, 1, Scale::Linear};
    const Camera eye = looking({0.9F, 0.7F, 1.9F}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of({&eye, 1}, look, 320, 240));

    const Pixels picture = renderer.read(0);
    int beyond = 0;
    for (std::size_t at = 0; at < picture.rgb.size(); at += 3) {
        // A share of the colours above and below, which no band has.
        const int r = picture.rgb[at], g = picture.rgb[at + 1], b = picture.rgb[at + 2];
        beyond += (r > 240 && g < 150 && b > 200) || (r > 240 && g > 200 && b < 80);
    }
    EXPECT_EQ(beyond, 0);
}

TEST_F(Renderers, a_triangle_with_a_missing_corner_is_missing_whole) {
    SmallModel model = box_model({1, 1, 0.01F}, 1);
    model.add_field(0, [](const auto& p) { return p[0] > 0 && p[1] > 0 ? kNan : 0.5F; });
    Look look = plain_look();
    look.colour.missing = {10, 200, 30};
    const Camera eye{glm::mat4(1), glm::ortho(-0.5F, 0.5F, -0.5F, 0.5F, -1.0F, 1.0F)};
    Renderer renderer;
    renderer.set_model(model.drawn());

    draw_whole(renderer, input_of({&eye, 1}, look, 100, 100));

    const Pixels picture = renderer.read(0);
    const Rgb dark{7, 144, 22};  // The hatch.
    std::size_t missing = 0, hatched = 0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            missing += pixel(picture, x, y) == look.colour.missing;
            hatched += pixel(picture, x, y) == dark;
        }
    }
    // Both triangles of this side meet in the corner: all of it but the rims without weight.
    EXPECT_GT(missing + hatched, 9700U);
    EXPECT_GT(hatched, 1500U);
}

TEST_F(Renderers, what_is_out_of_sight_is_left_out_and_not_missed) {
    SmallModel model = ball_model(90);
    model.add_field(0, [](const auto& p) { return 0.5F + 0.5F * p[1]; });
    ASSERT_EQ(open_edges(model.geometry).at(0), 0U);
    Look look = plain_look();
    look.shade_floor = 0.5F;
    const Camera eye = looking({0.9F, 0.4F, 1.3F}, {0.9F, 0.3F, 0});
    std::vector<Pixels> pictures;
    std::array<DrawCounts, 2> counts;
    for (const bool culling : {true, false}) {
        Renderer renderer({.culling = culling});
        renderer.set_model(model.drawn());
        draw_whole(renderer, input_of({&eye, 1}, look, 320, 240));
        pictures.push_back(renderer.read(0));
        counts[culling ? 0 : 1] = renderer.counts();
    }

    EXPECT_EQ(compare(pictures[0], pictures[1]).pixels, 0U);
    EXPECT_EQ(counts[1].triangles, model.geometry.triangles.size());
    EXPECT_EQ(counts[1].clusters_culled, 0U);
    EXPECT_LT(counts[0].triangles, model.geometry.triangles.size() * 7 / 10);
    EXPECT_GT(counts[0].clusters_culled, counts[0].clusters * 3 / 10);
}

TEST_F(Renderers, what_moves_into_sight_is_drawn) {
    SmallModel model = ball_model(40);
    model.add_field(0, [](const auto&) { return 0.5F; });
    model.add_vectors(1, [](const auto&) { return std::array<float, 3>{-1, 0, 0}; });
    model.add_vectors(2, [](const auto&) { return std::array<float, 3>{0, 1, 0}; });
    Look look = plain_look();
    // Beside the picture, until the displacement brings it there.
    look.model_to_world = glm::translate(glm::mat4(1), {30, -20, 0});
    look.shape = Shape{{1, 0, 0}, FieldChoice{2, 0, 0}, 0, 0};
    const Camera eye = looking({0, 0, 6}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of({&eye, 1}, look));
    EXPECT_EQ(renderer.counts().triangles, 0U);

    look.shape->factor = 30;
    look.shape->imaginary_factor = 20;
    draw_whole(renderer, input_of({&eye, 1}, look));

    EXPECT_GT(renderer.counts().triangles, 0U);
    EXPECT_EQ(pixel(renderer.read(0), 80, 60), colour_of(0.5, look.range, look.colour));
}

TEST_F(Renderers, from_inside_a_ball_its_inner_side_is_seen) {
    SmallModel model = ball_model(40);
    model.add_field(0, [](const auto&) { return 0.5F; });
    const Look look = plain_look();
    const Camera eye = looking({0, 0, 0.1F}, {0, 0, -1});
    Renderer renderer;
    renderer.set_model(model.drawn());

    draw_whole(renderer, input_of({&eye, 1}, look));

    EXPECT_EQ(pixel(renderer.read(0), 80, 60), colour_of(0.5, look.range, look.colour));
}

TEST_F(Renderers, another_result_sends_five_bytes_a_vertex_and_nothing_else) {
    SmallModel model = box_model({1, 1, 1}, 10);
    model.add_field(0, [](const auto& p) { return p[0]; });
    model.add_field(1, [](const auto& p) { return p[1]; });
    model.add_vectors(2, [](const auto& p) { return p; });
    Look look = plain_look();
    look.shape = Shape{{2, 0, 0}, std::nullopt, 0.1F, 0};
    const Camera eye = looking({1, 1, 3}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of({&eye, 1}, look));
    const DrawCounts before = renderer.counts();

    look.field = FieldChoice{1, 0, 0};
    look.colour.bands = 5;
    look.shape->factor = 0.2F;
    draw_whole(renderer, input_of({&eye, 1}, look));
    const DrawCounts after = renderer.counts();

    EXPECT_EQ(after.uploaded.field - before.uploaded.field, 5 * model.geometry.positions.size());
    EXPECT_EQ(after.uploaded.geometry, before.uploaded.geometry);
    EXPECT_EQ(after.uploaded.displacement, before.uploaded.displacement);
    EXPECT_EQ(before.uploaded.displacement, 12 * model.geometry.positions.size());
}

TEST_F(Renderers, no_more_is_sent_in_a_frame_than_was_allowed) {
    SmallModel model = box_model({1, 1, 1}, 10);
    model.add_field(0, [](const auto&) { return 0.5F; });
    const Look look = plain_look();
    const Camera eye = looking({0, 0, 3}, {0, 0, 0});
    Renderer renderer({.upload_bytes = 1000});
    renderer.set_model(model.drawn());
    std::uint64_t last = 0;
    int frames = 0;
    do {
        renderer.draw(input_of({&eye, 1}, look));
        const DrawCounts::Uploaded& sent = renderer.counts().uploaded;
        const std::uint64_t all = sent.geometry + sent.field + sent.displacement + sent.level;
        EXPECT_LE(all - last, 1000U);
        last = all;
        ++frames;
        const Rgb middle = pixel(renderer.read(0), 80, 60);
        if (sent.geometry < 16 * model.geometry.positions.size() + 12 * model.geometry.triangles.size()) {
            EXPECT_EQ(middle, DrawInput{}.background) << "half a model is drawn";
        } else if (!renderer.is_complete()) {
            EXPECT_NE(middle, colour_of(0.5, look.range, look.colour)) << "half a result is shown";
        }
    } while (!renderer.is_complete() && frames < 1000);

    EXPECT_GT(frames, 20);
    EXPECT_EQ(pixel(renderer.read(0), 80, 60), colour_of(0.5, look.range, look.colour));
}

TEST_F(Renderers, a_cut_solid_shows_material_and_a_cut_shell_its_inside) {
    SmallModel model = box_model({1, 1, 1}, 2);
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = plain_look();
    look.cuts = {{{0, 0, 1}, 0.0F}};
    const Camera eye = looking({0, 0, 3}, {0, 0, 0});
    const auto middle = [&] {
        Renderer renderer;
        renderer.set_model(model.drawn());
        draw_whole(renderer, input_of({&eye, 1}, look));
        return pixel(renderer.read(0), 80, 60);
    };

    const Rgb solid = middle();
    EXPECT_NEAR(solid[0], solid[1], 6);
    EXPECT_GT(solid[0], 110);
    model.solid = {false};
    EXPECT_EQ(middle(), colour_of(0.5, look.range, look.colour));
}

bool is_grey(const Rgb& colour) {
    return std::abs(colour[0] - colour[1]) < 8 && std::abs(colour[1] - colour[2]) < 8 && colour[0] > 110 &&
           colour[0] < 180;
}

TEST_F(Renderers, what_is_left_between_two_cuts_is_not_seen_through) {
    SmallModel model = box_model({1, 1, 1}, 2);
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = plain_look();
    // A slab; the line of sight enters by one plane and leaves by the other, and meets no skin.
    look.cuts = {{{0, 0, 1}, 0.1F}, {{0, 0, -1}, 0.1F}};
    const Camera eye = looking({0.2F, 0.1F, 2}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of({&eye, 1}, look));

    EXPECT_TRUE(is_grey(pixel(renderer.read(0), 80, 60)));
    EXPECT_EQ(pixel(renderer.read(0), 5, 5), DrawInput{}.background);
}

TEST_F(Renderers, a_cut_through_a_hollow_body_is_filled_where_material_is_alone) {
    // A ball in a box, with its inside turned out: a cavity.
    SmallModel model = box_model({3, 3, 3}, 2), hole = ball_model(30);
    for (auto& triangle : hole.geometry.triangles) std::swap(triangle[0], triangle[1]);
    append(model, hole);
    model.geometry.parts[0].vertices += model.geometry.parts[1].vertices;
    model.geometry.parts[0].triangles += model.geometry.parts[1].triangles;
    model.geometry.parts.pop_back();
    model.solid = {true};
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = plain_look();
    look.cuts = {{{0, 0, 1}, 0.2F}};
    const Camera eye = looking({0, 0, 7}, {0, 0, 0});
    const Mark behind{Mark::Kind::Dot, {1.2F, 0, 0}, {0, 0, 1}, 0.1F, {255, 0, 0}};
    Renderer renderer;
    renderer.set_model(model.drawn());
    DrawInput input = input_of({&eye, 1}, look);
    input.marks = {&behind, 1};
    draw_whole(renderer, input);
    const Pixels picture = renderer.read(0);

    EXPECT_EQ(pixel(picture, 80, 60), colour_of(0.5, look.range, look.colour)) << "the cavity's wall";
    EXPECT_TRUE(is_grey(pixel(picture, 80, 35)));
    // 1.2 to the right is 29 pixels; the mark lies within the material, behind the plane.
    const Rgb hidden = pixel(picture, 80 + 29, 60);
    EXPECT_LT(hidden[0] - hidden[1], 90);
    EXPECT_GT(hidden[0] - hidden[1], 15);
}

TEST_F(Renderers, where_a_solid_is_open_no_material_is_made_up) {
    // Its side +x was shared with a neighbour that is gone: the third side that was added.
    SmallModel model = box_model({1, 1, 1}, 1);
    Geometry& g = model.geometry;
    g.triangles.erase(g.triangles.begin() + 4, g.triangles.begin() + 6);
    g.parts[0].triangles = 10;
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = plain_look();
    look.cuts = {{{0, 0, 1}, 0.0F}};
    // The line of sight meets the plane beside the box, enters by the open side and leaves by the bottom;
    // before it does, it meets the mark.
    const Camera eye = looking({1.4F, 0, 0.6F}, {0.8F, 0, 0}, 20);
    const Mark within{Mark::Kind::Dot, {0.45F, 0, -0.35F}, {0, 0, 1}, 0.04F, {255, 0, 0}};
    Renderer renderer;
    renderer.set_model(model.drawn());
    DrawInput input = input_of({&eye, 1}, look);
    input.marks = {&within, 1};
    draw_whole(renderer, input);

    EXPECT_EQ(pixel(renderer.read(0), 80, 60), within.colour) << "the air before the open side is filled";
}

TEST_F(Renderers, a_level_is_drawn_from_its_own_list_and_the_full_one_comes_back_at_no_cost) {
    SmallModel model = box_model({1, 1, 1}, 4);
    model.add_field(0, [](const auto&) { return 0.5F; });
    const auto& all = model.geometry.triangles;
    model.levels[0] = {all.begin(), all.begin() + 32};
    Look look = plain_look();
    look.level = 0;
    const Camera eye = looking({0, 0, 3}, {0, 0, 0});
    Renderer renderer({.culling = false});
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of({&eye, 1}, look));
    EXPECT_EQ(renderer.counts().triangles, 32U);
    EXPECT_EQ(renderer.counts().uploaded.level, 32U * 12);

    look.level.reset();
    draw_whole(renderer, input_of({&eye, 1}, look));
    EXPECT_EQ(renderer.counts().triangles, all.size());
    EXPECT_EQ(renderer.counts().uploaded.level, 32U * 12);
}

TEST_F(Renderers, places_of_sixteen_bits_are_off_by_no_more_than_is_said) {
    SmallModel model = box_model({1, 0.7F, 0.3F}, 7);
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = plain_look();
    look.model_to_world = glm::translate(glm::mat4(1), {0.1F, 0, 0});
    const Camera eye = looking({1, 1, 2}, {0, 0, 0});
    Renderer exact, coarse({.quantise_above = 10});
    std::vector<Pixels> pictures;
    for (Renderer* renderer : {&exact, &coarse}) {
        renderer->set_model(model.drawn());
        draw_whole(*renderer, input_of({&eye, 1}, look));
        pictures.push_back(renderer->read(0));
    }

    EXPECT_EQ(exact.position_error(), 0);
    EXPECT_GT(coarse.position_error(), 0.3F / 65535 / 2);
    EXPECT_LT(coarse.position_error(), 1.3F / 65535);
    EXPECT_LT(coarse.counts().uploaded.geometry, exact.counts().uploaded.geometry);
    // A silhouette may change a sample; the shape may not.
    EXPECT_LT(compare(pictures[0], pictures[1]).pixels, 20U);
    EXPECT_GT(pixel(pictures[1], 80, 60)[1], 60);
}

TEST_F(Renderers, bytes_arrive_unchanged_in_an_srgb_texture_and_scaled_in_another_size) {
    SmallModel model = box_model({1, 1, 1}, 2);
    model.add_field(0, [](const auto& p) { return p[0] + 0.5F; });
    const Look look = plain_look();
    const auto eyes = two_eyes({0, 0, 2});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, input_of(eyes, look));
    const Pixels seen = renderer.read(1);
    GLuint texture = 0, depth = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_SRGB8_ALPHA8, 160, 120);
    glCreateTextures(GL_TEXTURE_2D, 1, &depth);
    glTextureStorage2D(depth, 1, GL_DEPTH_COMPONENT32F, 160, 120);
    glEnable(GL_FRAMEBUFFER_SRGB);

    renderer.copy(
        1, {.texture = texture, .width = 160, .height = 120, .is_top_first = true, .depth_texture = depth}
    );

    std::vector<std::uint8_t> bytes(160 * 120 * 4);
    glGetTextureImage(
        texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()), bytes.data()
    );
    std::size_t differ = 0;
    for (std::size_t i = 0; i < 160U * 120; ++i)
        for (std::size_t k = 0; k < 3; ++k) differ += bytes[4 * i + k] != seen.rgb[3 * i + k];
    EXPECT_EQ(differ, 0U);
    std::vector<float> depths(160 * 120);
    glGetTextureImage(
        depth, 0, GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(4 * depths.size()), depths.data()
    );
    const glm::vec4 front = eyes[1].projection * eyes[1].view * glm::vec4(0, 0, 0.5F, 1);
    EXPECT_NEAR(depths[160 * 60 + 78], 0.5F + 0.5F * front.z / front.w, 1e-4);
    EXPECT_EQ(depths[0], 1);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glDeleteTextures(1, &texture);
    glDeleteTextures(1, &depth);
}

TEST_F(Renderers, a_panel_shows_its_texture_where_it_stands_and_hides_behind_the_model) {
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_SRGB8_ALPHA8, 2, 2);
    constexpr std::array<std::uint8_t, 16> kTexels{
        200, 10, 20, 255, 200, 10, 20, 255, 30, 150, 40, 255, 30, 150, 40, 255};
    glTextureSubImage2D(texture, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, kTexels.data());
    const Camera eye = looking({0, 0, 2}, {0, 0, 0}, 60);
    Panel panel{.texture = texture, .pose = {}, .size = {1, 1}};
    DrawInput input;
    input.eyes = {&eye, 1};
    input.width = 160;
    input.height = 120;
    input.panels = {&panel, 1};
    Renderer renderer;

    renderer.draw(input);
    EXPECT_EQ(pixel(renderer.read(0), 80, 85), (Rgb{200, 10, 20})) << "the first row is the lowest";
    EXPECT_EQ(pixel(renderer.read(0), 80, 35), (Rgb{30, 150, 40}));
    EXPECT_EQ(pixel(renderer.read(0), 5, 60), input.background);
    panel.is_top_first = true;
    renderer.draw(input);
    EXPECT_EQ(pixel(renderer.read(0), 80, 35), (Rgb{200, 10, 20}));

    SmallModel model = box_model({2, 2, 0.1F}, 1);
    for (auto& place : model.geometry.positions) place[2] += 0.5F;
    model.add_field(0, [](const auto&) { return 0.5F; });
    const Look look = plain_look();
    renderer.set_model(model.drawn());
    input.look = &look;
    draw_whole(renderer, input);
    EXPECT_EQ(pixel(renderer.read(0), 80, 85), colour_of(0.5, look.range, look.colour));
    glDeleteTextures(1, &texture);
}

TEST_F(Renderers, what_cannot_be_drawn_is_refused_in_words) {
    Renderer renderer;
    DrawInput input;
    input.width = input.height = 10;
    EXPECT_THROW(renderer.draw(input), Error);

    SmallModel model = box_model({1, 1, 1}, 1);
    model.add_field(0, [](const auto&) { return 0.5F; });
    model.fields[0].values.pop_back();
    const Look look = plain_look();
    const Camera eye = looking({0, 0, 2}, {0, 0, 0});
    renderer.set_model(model.drawn());
    EXPECT_THROW(renderer.draw(input_of({&eye, 1}, look)), Error);
}

}  // namespace
}  // namespace feelem::viewer::tests
