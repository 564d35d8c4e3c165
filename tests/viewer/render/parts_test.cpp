// SPDX-License-Identifier: Apache-2.0
// Parts that are hidden or clear, and the lines that each part has of its own.
#include "viewer/render/drawing.hpp"

#include <array>

namespace feelem::viewer::tests {
namespace {

using Parts = WithGl;

/// True colours, so that a pixel's bytes are the palette's.
Look parts_look() {
    Look look;
    look.field = FieldChoice{0, 0, 0};
    look.range = {0, 1, Scale::Linear};
    look.shade_floor = 1;
    look.edges = false;
    return look;
}

DrawInput parts_input(const Camera& eye, const Look& look) {
    DrawInput input;
    input.eyes = {&eye, 1};
    input.width = 160;
    input.height = 120;
    input.look = &look;
    return input;
}

TEST_F(Parts, hidden_parts_are_gone_and_clear_ones_are_seen_through) {
    SmallModel model = box_model({1, 1, 0.1F}, 2);
    SmallModel front = box_model({0.5F, 0.5F, 0.1F}, 2);
    for (auto& place : front.geometry.positions) place[2] += 0.5F;
    append(model, front);
    model.add_field(0, [](const auto& p) { return p[2] > 0.3F ? 0.95F : 0.05F; });
    Look look = parts_look();
    const Camera eye = looking({0, 0, 3}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    const auto middle = [&](std::vector<PartLook> parts) {
        look.parts = std::move(parts);
        draw_whole(renderer, parts_input(eye, look));
        return pixel(renderer.read(0), 80, 60);
    };
    const Rgb back = colour_of(0.05, look.range, look.colour),
              high = colour_of(0.95, look.range, look.colour);

    EXPECT_EQ(middle({}), high);
    EXPECT_EQ(middle({PartLook::Shown, PartLook::Hidden}), back);
    EXPECT_EQ(middle({PartLook::Hidden, PartLook::Hidden}), DrawInput{}.background);
    const Rgb mixed = middle({PartLook::Shown, PartLook::Clear});
    // Two sides of the clear part lie one behind the other.
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(mixed[k], high[k] + (back[k] - high[k]) * 0.78 * 0.78, 2) << k;
}

TEST_F(Parts, a_hidden_part_has_no_ghost) {
    SmallModel model = box_model({0.4F, 0.4F, 0.4F}, 1);
    for (const float x : {-0.8F, 0.8F}) {
        SmallModel beside = box_model({0.4F, 0.4F, 0.4F}, 1);
        for (auto& place : beside.geometry.positions) place[0] += x;
        append(model, beside);
    }
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = parts_look();
    const Camera eye = looking({0, 0.3F, 3}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    const auto draws = [&](bool ghost) {
        look.ghost = ghost;
        draw_whole(renderer, parts_input(eye, look));
        return renderer.read(0);
    };
    // Of three boxes that stand side by side, in each third of the picture.
    const auto ghosts = [&] {
        const Pixels with = draws(true), without = draws(false);
        std::array<int, 3> found{};
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x)
                found[static_cast<std::size_t>(3 * x / with.width)] +=
                    pixel(with, x, y) != pixel(without, x, y);
        return found;
    };
    const auto all = ghosts();
    for (const int seen : all) EXPECT_GT(seen, 20);
    // The part in the middle is the first.
    for (std::size_t hidden = 0; hidden < 3; ++hidden) {
        look.parts.assign(3, PartLook::Shown);
        look.parts[hidden] = PartLook::Hidden;
        const auto left = ghosts();
        constexpr std::array<std::size_t, 3> kThirdOf{1, 0, 2};
        for (std::size_t part = 0; part < 3; ++part)
            EXPECT_EQ(left[kThirdOf[part]], part == hidden ? 0 : all[kThirdOf[part]]) << part << hidden;
    }
    look.parts.assign(3, PartLook::Hidden);
    EXPECT_EQ(ghosts(), (std::array<int, 3>{}));
}

TEST_F(Parts, a_part_without_element_edges_takes_none_from_the_part_after_it) {
    SmallModel bare = box_model({0.1F, 0.1F, 0.1F}, 1);
    bare.geometry.edges.clear();
    bare.geometry.parts[0].edges = 0;
    SmallModel model = box_model({0.1F, 0.1F, 0.1F}, 1);
    append(model, bare);
    model.geometry.parts[1].first_edge = 0;  // As a scene has it.
    append(model, box_model({1, 1, 1}, 4));  // Hides both.
    model.add_field(0, [](const auto&) { return 0.5F; });
    Look look = parts_look();
    const Camera eye = looking({0, 0, 3}, {0, 0, 0});
    Renderer renderer;
    renderer.set_model(model.drawn());
    draw_whole(renderer, parts_input(eye, look));
    const Pixels without = renderer.read(0);
    look.edges = true;
    draw_whole(renderer, parts_input(eye, look));
    EXPECT_GT(compare(without, renderer.read(0)).pixels, 200U);
}

}  // namespace
}  // namespace feelem::viewer::tests
