// SPDX-License-Identifier: Apache-2.0
// The panels as they are seen: colours of the legend, the frame of a limit, sizes of letters, whole pictures.
#include "sample_ui.hpp"
#include "viewer/ui/theme.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace feelem::viewer {
namespace {

using namespace tests;  // NOLINT: helpers of this folder.

constexpr glm::ivec2 kDesk{1280, 800};
const Rgb kStageGrey{150, 155, 158};

class PanelsTest : public WithGl {
protected:
    /// What stands on the screen once lists and tables know their widths.
    static UiPicture settled(DeskGui& gui, const UiModel& model, glm::ivec2 pixels = kDesk) {
        Canvas canvas(pixels, kStageGrey);
        for (int i = 0; i < 3; ++i) {
            canvas.clear();
            gui.draw(model, {}, pixels);
        }
        return canvas.read();
    }
    static UiPicture settled(Board board, const UiModel& model) {
        BoardTexture texture(board);
        for (int i = 0; i < 3; ++i) texture.draw(model, {});
        return read_framebuffer(texture.framebuffer(), size_of(board).pixels);
    }
    static UiPicture settled(const UiModel& model, glm::ivec2 pixels = kDesk) {
        DeskGui gui(1);
        return settled(gui, model, pixels);
    }
};

/// The longest run down a column in colours of the palette, as it is seen from above.
std::vector<Rgb> bar_of(const UiPicture& picture, const ColourEffect& effect) {
    std::set<Rgb> known;
    const int steps = effect.bands > 0 ? effect.bands : 4096;
    for (int i = 0; i < steps; ++i) known.insert(palette_colour((i + 0.5) / steps, effect));
    std::vector<Rgb> best;
    for (int x = 0; x < picture.pixels.x; ++x) {
        std::vector<Rgb> run;
        for (int y = 0; y < picture.pixels.y; ++y) {
            if (known.contains(picture.at(x, y)))
                run.push_back(picture.at(x, y));
            else if (run.size() > best.size())
                best = std::exchange(run, {});
            else
                run.clear();
        }
        if (run.size() > best.size()) best = run;
    }
    return best;
}

UiModel only_colours(ColourEffect effect) {
    UiModel model;
    model.legend = boiler_ui().legend;
    model.legend->limit.reset();
    model.legend->probed.reset();
    model.legend->colour = std::move(effect);
    return model;
}

TEST_F(PanelsTest, legend_has_the_palettes_colour_in_every_row) {
    for (const ColourEffect& effect :
         {ColourEffect{},
          ColourEffect{.map = "ansys_rainbow", .bands = 9},
          ColourEffect{.map = "turbo", .bands = 13, .invert = true},
          ColourEffect{.map = "viridis", .bands = 1}}) {
        for (const bool in_room : {false, true}) {
            const UiModel model = only_colours(effect);
            const std::vector<Rgb> bar =
                bar_of(in_room ? settled(Board::Legend, model) : settled(model), effect);
            const auto rows = static_cast<int>(bar.size());
            ASSERT_GT(rows, 130) << effect.map;
            for (int row = 0; row < rows; ++row)
                ASSERT_EQ(
                    bar.at(static_cast<std::size_t>(row)), palette_colour(1 - (row + 0.5) / rows, effect)
                ) << effect.map
                  << " row " << row << " of " << rows;
        }
    }
}

TEST_F(PanelsTest, a_smooth_legend_rises_without_a_break) {
    const ColourEffect effect{.map = "viridis", .bands = 0};
    const UiModel model = only_colours(effect);
    const UiPicture picture = settled(model);
    DeskGui gui(1);
    const int x = gui.stage(kDesk)[0] + gui.stage(kDesk)[2] + 12 + 11 + 15;
    int from = 0;
    while (picture.at(x, from) != palette_colour(1 - 0.5 / 400, effect) && from < 400) ++from;
    ASSERT_LT(from, 400);
    int rows = 0;
    while (picture.at(x, from + rows) != Rgb{0xFA, 0xFA, 0xF8}) ++rows;
    ASSERT_GT(rows, 300);
    for (int row = 0; row < rows; ++row)
        ASSERT_EQ(picture.at(x, from + row), palette_colour(1 - (row + 0.5) / rows, effect)) << row;
}

std::size_t count_of(const UiPicture& picture, const Rgb& colour) {
    std::size_t count = 0;
    for (int y = 0; y < picture.pixels.y; ++y)
        for (int x = 0; x < picture.pixels.x; ++x) count += picture.at(x, y) == colour ? 1U : 0U;
    return count;
}

TEST_F(PanelsTest, card_beyond_its_limit_has_a_frame_of_magenta) {
    UiModel model = boiler_ui();
    model.hot_spots.clear();
    model.legend.reset();
    const Rgb alarm{0xB3, 0x00, 0x6B};
    const Rgb board_alarm{0xFF, 0x7A, 0xC4};
    // Both long sides of the frame alone are more than this.
    EXPECT_GT(count_of(settled(model), alarm), 1300U);
    EXPECT_GT(count_of(settled(Board::Card, model), board_alarm), 6000U);
    for (UiCardRow& row : model.card->rows) row.beyond = false;
    EXPECT_EQ(count_of(settled(model), alarm), 0U);
    EXPECT_EQ(count_of(settled(Board::Card, model), board_alarm), 0U);
}

TEST_F(PanelsTest, without_a_place_there_is_no_card) {
    UiModel model = boiler_ui();
    model.card.reset();
    const UiPicture picture = settled(Board::Card, model);
    const UiPicture desk = settled(model);
    DeskGui gui(1);
    const auto stage = gui.stage(kDesk);
    EXPECT_EQ(desk.at(stage[0] + 30, stage[1] + 60), kStageGrey);
    EXPECT_EQ(picture.at(300, 20), (Rgb{0, 0, 0})) << "nothing stands there";
}

TEST_F(PanelsTest, card_goes_out_of_the_pointers_way) {
    DeskGui gui(1);
    const auto [x, y, width, height] = gui.stage(kDesk);
    const auto has_card = [&, x = x, y = y, width = width, height = height](glm::vec2 share, float side) {
        Canvas canvas(kDesk, kStageGrey);
        PanelInput input;
        input.pointer = glm::vec2(x, y) + share * glm::vec2(width, height);
        for (int i = 0; i < 3; ++i) {
            canvas.clear();
            gui.draw(boiler_ui(), input, kDesk);
        }
        return canvas.read().at(x + static_cast<int>(side * static_cast<float>(width)), y + 30) != kStageGrey;
    };
    for (const glm::vec2 share : {glm::vec2(0.1F, 0.1F), glm::vec2(0.4F, 0.3F)}) {
        EXPECT_TRUE(has_card(share, 0.8F));
        EXPECT_FALSE(has_card(share, 0.2F));
    }
    for (const glm::vec2 share : {glm::vec2(0.1F, 0.9F), glm::vec2(0.8F, 0.2F)}) {
        EXPECT_TRUE(has_card(share, 0.2F));
        EXPECT_FALSE(has_card(share, 0.8F));
    }
}

TEST_F(PanelsTest, the_stage_is_left_to_the_model) {
    UiModel model = boiler_ui();
    model.card.reset();
    const UiPicture picture = settled(model);
    DeskGui gui(1);
    const auto [x, y, width, height] = gui.stage(kDesk);
    for (int row = y; row < y + height - 60; row += 7)
        for (int column = x; column < x + width; column += 7)
            ASSERT_EQ(picture.at(column, row), kStageGrey) << column << " " << row;
}

TEST_F(PanelsTest, letters_on_boards_are_half_a_degree_high_at_arms_length_and_a_half) {
    UiModel model;
    UiCard card;
    UiCardRow row;
    row.label = "HHHH";
    row.value = 1;
    card.rows = {row};
    model.card = card;
    const UiPicture picture = settled(Board::Card, model);
    const BoardSize size = size_of(Board::Card);
    // Rows of the label's first letter: those with its full ink.
    int high = 0;
    for (int x = 25; x < 40; ++x) {
        int run = 0;
        for (int y = 0; y < picture.pixels.y; ++y) {
            run = picture.at(x, y)[0] > 0xB0 ? run + 1 : 0;
            high = std::max(high, run);
        }
    }
    const double metres = static_cast<double>(high) * static_cast<double>(size.metres.y) / size.pixels.y;
    const double degrees = 2 * std::atan(metres / 2 / 1.2) * 180 / std::numbers::pi;
    EXPECT_GE(degrees, 0.5) << high << " pixels";
    EXPECT_LE(degrees, 0.62) << high << " pixels";
}

double channel_light(unsigned value) {
    const double share = value / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}
double light_of(ImU32 colour) {
    return 0.2126 * channel_light(colour & 0xFFU) + 0.7152 * channel_light((colour >> 8U) & 0xFFU) +
           0.0722 * channel_light((colour >> 16U) & 0xFFU);
}
double contrast(ImU32 a, ImU32 b) {
    const double one = light_of(a) + 0.05;
    const double other = light_of(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

TEST(Theme, words_stand_out_by_4_5_to_1_and_signs_by_3_to_1) {
    for (const UiColours& c : {desk_colours(Theme::Light), desk_colours(Theme::Dark), board_colours()}) {
        for (const ImU32 words : {c.ink, c.soft, c.accent, c.alarm}) {
            EXPECT_GE(contrast(words, c.panel), 4.5);
            EXPECT_GE(contrast(words, c.hover), 4.5);
        }
        EXPECT_GE(contrast(c.accent, c.accent_soft), 4.5) << "what is on";
        EXPECT_GE(contrast(c.panel, c.accent), 4.5) << "a cell that is on";
        EXPECT_GE(contrast(c.faint, c.panel), 3);
    }
}

TEST_F(PanelsTest, an_empty_model_and_a_small_window_are_drawn_too) {
    DeskGui gui(1);
    for (const glm::ivec2 pixels : {glm::ivec2(640, 400), glm::ivec2(300, 90), glm::ivec2(0, 0)}) {
        if (pixels.x > 0) settled(gui, {}, pixels);
        EXPECT_TRUE(gui.draw(boiler_ui(), {}, pixels).empty());
        const auto stage = gui.stage(pixels);
        EXPECT_GE(stage[2], 0);
        EXPECT_GE(stage[3], 0);
    }
    for (const Board board : {Board::Panel, Board::Legend, Board::Card}) settled(board, {});
}

TEST_F(PanelsTest, hostile_words_are_words) {
    UiModel model = boiler_ui();
    model.title = "%s%n##%d ### \xFF\xFE 100 %";
    model.legend->title = "a##b%n";
    model.results[0].label = "";
    model.results[1].key = model.results[0].key;
    model.parts[0].name = std::string(5000, 'x');
    model.steps.names = {"%n", "%n", ""};
    model.steps.shown = 77;
    model.legend->range = {std::nan(""), 1, Scale::Log};
    model.cuts[0].plane.offset = std::nanf("");
    model.message = "%s";
    model.trouble = std::string(3000, 'w');
    DeskGui gui(1);
    settled(gui, model);
    for (const Board board : {Board::Panel, Board::Legend, Board::Card}) settled(board, model);
}

TEST_F(PanelsTest, a_dense_screen_has_everything_twice_as_large) {
    DeskGui one(1);
    DeskGui two(2);
    const auto small = one.stage({1280, 800});
    const auto large = two.stage({2560, 1600});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(large.at(i), 2 * small.at(i), 1);
    settled(one, boiler_ui());
    settled(two, boiler_ui(), {2560, 1600});
    const glm::vec2 there = middle_of(one.targets(), "top/theme");
    EXPECT_NEAR(middle_of(two.targets(), "top/theme").x, 2 * there.x, 3);
    EXPECT_NEAR(middle_of(two.targets(), "top/theme").y, 2 * there.y, 3);
}

TEST(BoardRay, meets_a_board_from_its_front_alone) {
    const BoardSize size{{1000, 500}, {1, 0.5F}};
    // Two metres ahead, turned a quarter to the left: its front looks along +X.
    const Pose pose{{-2, 1, 0}, glm::angleAxis(glm::radians(90.0F), glm::vec3(0, 1, 0))};
    const auto hit = hit_board({{0, 1, 0}, {-1, 0, 0}}, pose, size);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->at.x, 500, 0.01F);
    EXPECT_NEAR(hit->at.y, 250, 0.01F);
    EXPECT_NEAR(hit->metres, 2, 1e-5F);
    // Its right end lies to the far side, upwards is up.
    const auto corner = hit_board({{0, 1.2F, -0.4F}, {-1, 0, 0}}, pose, size);
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->at.x, 900, 0.01F);
    EXPECT_NEAR(corner->at.y, 50, 0.01F);
    EXPECT_FALSE(hit_board({{0, 1.3F, 0}, {-1, 0, 0}}, pose, size)) << "above it";
    EXPECT_FALSE(hit_board({{-4, 1, 0}, {1, 0, 0}}, pose, size)) << "from behind";
    EXPECT_FALSE(hit_board({{0, 1, 0}, {1, 0, 0}}, pose, size)) << "away from it";
    EXPECT_FALSE(hit_board({{0, 1, 0}, {0, 0, -1}}, pose, size)) << "along it";
}

/// Every sixteenth pixel's surroundings, so that a letter that moved by a part of a pixel does not count.
std::vector<int> coarse(const UiPicture& picture) {
    constexpr int kCell = 16;
    std::vector<int> out;
    for (int y = 0; y + kCell <= picture.pixels.y; y += kCell)
        for (int x = 0; x + kCell <= picture.pixels.x; x += kCell)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int i = 0; i < kCell * kCell; ++i)
                    sum += picture.at(x + i % kCell, y + i / kCell).at(channel);
                out.push_back((sum + kCell * kCell / 2) / (kCell * kCell));
            }
    return out;
}

TEST_F(PanelsTest, look_as_they_were_agreed_to_look) {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"))
        GTEST_SKIP() << "the pictures are of DejaVu's letters: package fonts-dejavu-core";
    UiModel dark = boiler_ui();
    dark.theme = Theme::Dark;
    const std::vector<std::pair<std::string, UiPicture>> pictures{
        {"desk-light", settled(boiler_ui())},
        {"desk-dark", settled(dark)},
        {"board-panel", settled(Board::Panel, boiler_ui())},
        {"board-legend", settled(Board::Legend, boiler_ui())},
        {"board-card", settled(Board::Card, boiler_ui())}};
    for (const auto& [name, picture] : pictures) {
        keep_for_people(picture, name);
        compare_with_golden(coarse(picture), name);
    }
}

}  // namespace
}  // namespace feelem::viewer
