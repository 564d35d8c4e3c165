// SPDX-License-Identifier: Apache-2.0
// What comes of pressing: every wish can be made, and each thing that can be pressed makes its own.
#include "sample_ui.hpp"

#include <epoxy/gl.h>

#include <cstdlib>
#include <set>

namespace feelem::viewer {
namespace {

using namespace tests;  // NOLINT: helpers of this folder.

/// High enough that no section has to be scrolled to.
constexpr glm::ivec2 kTall{1600, 2600};

/// A hand with a mouse over the window, or with a ray on a board.
template <class Surface>
class Presser {
public:
    Presser(Surface& surface, UiModel& model) : surface_(surface), model_(model) { frames(3); }

    UiWishes click(std::string_view name) {
        const glm::vec2 at = middle_of(surface_.targets(), name);
        UiWishes out = press(at);
        append(out, release());
        return out;
    }
    UiWishes drag(std::string_view name, float share) {
        for (const UiTarget& target : surface_.targets()) {
            if (target.name != name) continue;
            UiWishes out = press((target.low + target.high) / 2.0F);
            input_.at = glm::vec2(
                target.low.x + share * (target.high.x - target.low.x), (target.low.y + target.high.y) / 2
            );
            append(out, frames(2));
            append(out, release());
            return out;
        }
        ADD_FAILURE() << "nothing to drag is called " << name;
        return {};
    }
    UiWishes type(std::string_view name, const std::string& text) {
        click(name);
        input_.keys = {PanelKey::All};
        input_.text = "";
        frames(1);
        input_.text = text;
        frames(2);
        input_.keys = {PanelKey::Enter};
        return frames(4);
    }
    UiWishes frames(int count) {
        UiWishes out;
        for (int i = 0; i < count; ++i) {
            append(out, draw());
            input_.text.clear();
            input_.keys.clear();
            input_.wheel = 0;
        }
        return out;
    }
    PanelInput& input() { return input_; }

private:
    UiWishes draw() {
        if constexpr (std::is_same_v<Surface, DeskGui>)
            return surface_.draw(model_, input_, kTall);
        else
            return surface_.draw(model_, input_);
    }
    UiWishes press(glm::vec2 at) {
        input_.at = at;
        UiWishes out = frames(2);
        input_.buttons[0] = true;
        append(out, frames(1));
        return out;
    }
    UiWishes release() {
        input_.buttons[0] = false;
        return frames(2);
    }
    static void append(UiWishes& out, UiWishes more) { out.insert(out.end(), more.begin(), more.end()); }

    Surface& surface_;
    UiModel& model_;
    PanelInput input_;
};

class WishesTest : public WithGl {
protected:
    void SetUp() override {
        WithGl::SetUp();
        if (IsSkipped()) return;
        glEnable(GL_RASTERIZER_DISCARD);  // Nobody looks.
        model = boiler_ui();
        model.card->is_pinned = true;
        gui = std::make_unique<DeskGui>(1.0F);
        hand = std::make_unique<Presser<DeskGui>>(*gui, model);
        for (const char* section :
             {"limits/fold", "section/fold", "notes/fold", "certificate/fold", "legend/settings"})
            hand->click(section);
        if (std::getenv("FEELEM_UI_PICTURES") != nullptr) keep_unfolded();
    }
    void keep_unfolded() {
        glDisable(GL_RASTERIZER_DISCARD);
        Canvas canvas(kTall, {150, 155, 158});
        model.show_help = true;
        hand->frames(3);
        keep_for_people(canvas.read(), "unfolded");
        model.show_help = false;
        hand->frames(2);
        glEnable(GL_RASTERIZER_DISCARD);
    }

    UiModel model;
    std::unique_ptr<DeskGui> gui;
    std::unique_ptr<Presser<DeskGui>> hand;
};

/// The only wish, of this kind.
template <class Wish>
Wish only(const UiWishes& wishes) {
    EXPECT_EQ(wishes.size(), 1U);
    if (wishes.size() == 1 && std::holds_alternative<Wish>(wishes[0])) return std::get<Wish>(wishes[0]);
    ADD_FAILURE() << "another wish, of kind " << (wishes.empty() ? -1 : static_cast<int>(wishes[0].index()));
    return {};
}

TEST_F(WishesTest, table_of_results_assigns_and_releases_senses) {
    const auto assign = only<AssignSense>(hand->click("results/S/colour"));
    EXPECT_EQ(assign.key, "S");
    EXPECT_EQ(assign.sense, Sense::Colour);
    EXPECT_TRUE(assign.on);
    const auto release = only<AssignSense>(hand->click("results/T/colour"));
    EXPECT_FALSE(release.on);
    EXPECT_EQ(only<ReleaseAll>(hand->click("results/U/off")).key, "U");
    EXPECT_TRUE(hand->click("results/P/pitch").empty()) << "not in this scene";
    EXPECT_TRUE(hand->click("results/S/shape").empty()) << "a stress moves nothing";
}

TEST_F(WishesTest, limits_are_typed_turned_and_taken_away) {
    const auto typed = only<SetLimit>(hand->type("limits/S/limit", "240,5"));
    EXPECT_EQ(typed.key, "S");
    EXPECT_EQ(typed.limit, 240.5);
    EXPECT_TRUE(typed.is_upper);
    EXPECT_FALSE(only<SetLimit>(hand->click("limits/S/way/at least")).is_upper);
    EXPECT_EQ(only<SetLimit>(hand->click("limits/S/no limit")).limit, std::nullopt);
    EXPECT_TRUE(hand->type("limits/S/limit", "soon").empty()) << "no number, no wish";
    EXPECT_TRUE(hand->type("limits/S/limit", "250").empty()) << "what it was";
}

TEST_F(WishesTest, steps_are_gone_to) {
    EXPECT_EQ(only<Command>(hand->click("steps/before")), Command::PreviousStep);
    EXPECT_EQ(only<Command>(hand->click("steps/play")), Command::PlaySteps);
    EXPECT_EQ(only<Command>(hand->click("steps/after")), Command::NextStep);
    hand->click("steps/list");
    EXPECT_EQ(only<GoToStep>(hand->click("steps/list/Mode 1 · 41.2 Hz")).step, 1U);
    const UiWishes dragged = hand->drag("steps/slider", 0.99F);
    ASSERT_FALSE(dragged.empty());
    EXPECT_EQ(std::get<GoToStep>(dragged.back()).step, 2U);
}

TEST_F(WishesTest, deformation_is_chosen_and_typed) {
    EXPECT_EQ(only<Command>(hand->click("deformation/undeformed")), Command::NoDeformation);
    EXPECT_EQ(only<Command>(hand->click("deformation/true")), Command::TrueDeformation);
    EXPECT_EQ(only<SetFactor>(hand->click("deformation/5 %")).factor, std::nullopt);
    EXPECT_EQ(only<SetFactor>(hand->type("deformation/factor", "2.5e1")).factor, 25);
}

TEST_F(WishesTest, parts_are_hidden_cleared_and_left_alone) {
    const auto hidden = only<SetPart>(hand->click("parts/0/show"));
    EXPECT_EQ(hidden.part, 0U);
    EXPECT_EQ(hidden.look, PartLook::Hidden);
    EXPECT_EQ(only<SetPart>(hand->click("parts/1/clear")).look, PartLook::Shown);
    EXPECT_EQ(only<OnlyPart>(hand->click("parts/1/only")).part, 1U);
    only<ShowAllParts>(hand->click("parts/show all"));
}

TEST_F(WishesTest, planes_are_added_moved_turned_and_removed) {
    EXPECT_EQ(only<AddCut>(hand->click("section/add/y")).normal, glm::vec3(0, 1, 0));
    EXPECT_FALSE(only<SetCut>(hand->click("section/plane 1/on")).is_on);
    EXPECT_EQ(only<TurnCut>(hand->click("section/plane 1/z")).axis, 2U);
    const auto other = only<SetCut>(hand->click("section/plane 1/other side"));
    EXPECT_EQ(other.plane.normal, glm::vec3(-1, 0, 0));
    EXPECT_EQ(other.plane.offset, -120.5F);
    const UiWishes moved = hand->drag("section/plane 1/place", 0.5F);
    ASSERT_FALSE(moved.empty());
    EXPECT_NEAR(std::get<SetCut>(moved.back()).plane.offset, 0, 30);
    EXPECT_EQ(only<RemoveCut>(hand->click("section/plane 1/remove")).cut, 0U);
    EXPECT_EQ(only<Command>(hand->click("section/all")), Command::ToggleClip);
    EXPECT_EQ(only<Command>(hand->click("section/back")), Command::ClipBack);
    EXPECT_EQ(only<Command>(hand->click("section/ahead")), Command::ClipForward);
}

TEST_F(WishesTest, places_are_gone_to) {
    EXPECT_EQ(only<GoToHotSpot>(hand->click("places/hot spot 2")).spot, 1U);
    EXPECT_EQ(only<Command>(hand->click("places/hot spots/next")), Command::NextHotSpot);
    EXPECT_EQ(only<Command>(hand->click("places/hot spots/before")), Command::PreviousHotSpot);
    EXPECT_EQ(only<GoToMarker>(hand->click("notes/note 1")).marker, 0U);
    EXPECT_EQ(only<RemoveMarker>(hand->click("notes/note 1/remove")).marker, 0U);
    EXPECT_EQ(only<Command>(hand->click("notes/note here")), Command::PlaceMarker);
    EXPECT_EQ(only<Command>(hand->click("notes/notes/remove")), Command::RemoveMarkers);
    only<ReleasePin>(hand->click("card/let go"));
}

TEST_F(WishesTest, views_are_looked_from) {
    EXPECT_EQ(only<LookFrom>(hand->click("views/home")).direction, glm::vec3(0));
    EXPECT_EQ(only<LookFrom>(hand->click("views/z")).direction, glm::vec3(0, 0, 1));
    EXPECT_EQ(only<LookFrom>(hand->click("views/−x")).direction, glm::vec3(-1, 0, 0));
    EXPECT_EQ(only<LookFrom>(hand->click("views/iso")).direction, glm::vec3(1));
    EXPECT_EQ(only<Command>(hand->click("views/fit")), Command::Fit);
}

TEST_F(WishesTest, legend_is_set) {
    EXPECT_EQ(only<SetRange>(hand->type("legend/range/to", "200")).range.hi, 200);
    EXPECT_EQ(only<SetRange>(hand->type("legend/range/from", "-5")).range.lo, -5);
    EXPECT_EQ(only<SetRangeMode>(hand->click("legend/range/allSteps")).mode, "allSteps");
    EXPECT_EQ(only<SetRangeMode>(hand->click("legend/range/auto")).mode, "auto");
    EXPECT_EQ(only<SetColour>(hand->type("legend/bands", "12")).colour.bands, 12);
    EXPECT_EQ(only<SetColour>(hand->type("legend/bands", "1e99")).colour.bands, 64);
    EXPECT_TRUE(only<SetColour>(hand->click("legend/reversed")).colour.invert);
    EXPECT_EQ(only<Command>(hand->click("legend/isolines")), Command::ToggleIsolines);
    hand->click("legend/map");
    EXPECT_EQ(only<SetColour>(hand->click("legend/map/ansys rainbow")).colour.map, "ansys_rainbow");
}

TEST_F(WishesTest, senses_are_the_persons) {
    EXPECT_EQ(only<Command>(hand->click("sound/sound/mute")), Command::ToggleMute);
    EXPECT_TRUE(only<SetMono>(hand->click("sound/sound/mono")).on);
    const UiWishes louder = hand->drag("sound/sound/volume", 0.9F);
    ASSERT_FALSE(louder.empty());
    EXPECT_NEAR(std::get<SetVolume>(louder.back()).volume, 0.9, 0.05);
    EXPECT_EQ(only<Command>(hand->click("touch/touch/still")), Command::ToggleStill);
    const UiWishes weaker = hand->drag("touch/touch/strength", 0.2F);
    ASSERT_FALSE(weaker.empty());
    EXPECT_NEAR(std::get<SetStrength>(weaker.back()).strength, 0.3, 0.08);
}

TEST_F(WishesTest, the_bar_above_has_what_is_always_wanted) {
    EXPECT_EQ(only<Command>(hand->click("top/edges")), Command::ToggleEdges);
    EXPECT_EQ(only<Command>(hand->click("top/ghost")), Command::ToggleGhost);
    EXPECT_EQ(only<Command>(hand->click("top/sound")), Command::ToggleMute);
    EXPECT_EQ(only<Command>(hand->click("top/touch")), Command::ToggleStill);
    EXPECT_EQ(only<SetTheme>(hand->click("top/theme")).theme, Theme::Dark);
    EXPECT_TRUE(only<SetHelp>(hand->click("top/help")).on);
    only<TryHeadset>(hand->click("headset/headset/try"));
    model.show_help = true;
    hand->frames(3);
    EXPECT_FALSE(only<SetHelp>(hand->click("help/close")).on);
}

TEST_F(WishesTest, hovering_wishes_nothing_and_everything_that_can_be_pressed_has_a_name_of_its_own) {
    std::set<std::string> names;
    const std::vector<UiTarget> targets = gui->targets();
    for (const UiTarget& target : targets) {
        EXPECT_TRUE(names.insert(target.name).second) << target.name;
        hand->input().at = (target.low + target.high) / 2.0F;
        EXPECT_TRUE(hand->frames(1).empty()) << target.name;
        EXPECT_GE(target.high.y - target.low.y, 15) << target.name << " is hard to meet";
    }
    EXPECT_GT(names.size(), 80U);
}

TEST_F(WishesTest, the_pointer_is_wanted_over_panels_and_not_over_the_model) {
    const auto [x, y, width, height] = gui->stage(kTall);
    hand->input().at = glm::vec2(x + width / 2, y + height / 2);
    hand->frames(2);
    EXPECT_FALSE(gui->wants_pointer());
    hand->input().at = glm::vec2(100, 300);
    hand->frames(2);
    EXPECT_TRUE(gui->wants_pointer());
    EXPECT_FALSE(gui->wants_keys());
    hand->click("limits/S/limit");
    EXPECT_TRUE(gui->wants_keys());
    hand->input().keys = {PanelKey::Escape};
    hand->frames(3);
    EXPECT_FALSE(gui->wants_keys());
}

/// Presses everything of a board's tabs.
class BoardWishesTest : public WithGl {};

TEST_F(BoardWishesTest, every_tab_of_the_panel_can_be_opened_and_pressed_by_a_ray) {
    UiModel model = boiler_ui();
    BoardTexture board(Board::Panel);
    Presser hand(board, model);
    std::set<std::size_t> kinds;
    const bool shows = std::getenv("FEELEM_UI_PICTURES") != nullptr;
    if (!shows) glEnable(GL_RASTERIZER_DISCARD);
    for (const char* tab : {"Results", "Steps", "Parts", "Section", "Places", "Senses", "About"}) {
        hand.click(std::string("tab/") + tab);
        if (shows)
            keep_for_people(
                read_framebuffer(board.framebuffer(), size_of(Board::Panel).pixels), std::string("tab-") + tab
            );
        std::size_t pressed = 0;
        const std::vector<UiTarget> targets = board.targets();
        for (const UiTarget& target : targets) {
            EXPECT_LE(target.high.x, 1024) << target.name;
            EXPECT_LE(target.high.y, 1130) << target.name;
            if (target.name.starts_with("tab/") || target.name == "steps/list") continue;
            for (const UiWish& wish : hand.click(target.name)) kinds.insert(wish.index());
            ++pressed;
        }
        EXPECT_GE(pressed, 6U) << tab;
    }
    // Command AssignSense ReleaseAll GoToStep SetFactor SetPart OnlyPart ShowAllParts AddCut SetCut RemoveCut
    // GoToHotSpot GoToMarker RemoveMarker, then volume, mono and strength.
    for (const std::size_t kind : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 19U, 20U, 21U})
        EXPECT_TRUE(kinds.contains(kind)) << "wish " << kind;
}

TEST_F(BoardWishesTest, the_foot_is_there_on_every_tab) {
    UiModel model = boiler_ui();
    BoardTexture board(Board::Panel);
    Presser hand(board, model);
    hand.click("tab/Places");
    EXPECT_EQ(only<Command>(hand.click("foot/home")), Command::Home);
    EXPECT_EQ(only<Command>(hand.click("foot/fit")), Command::Fit);
    EXPECT_EQ(only<Command>(hand.click("foot/true scale")), Command::TrueScale);
    EXPECT_EQ(only<Command>(hand.click("foot/mute")), Command::ToggleMute);
    EXPECT_EQ(only<Command>(hand.click("foot/still")), Command::ToggleStill);
    EXPECT_EQ(only<Command>(hand.click("foot/leave")), Command::Leave);
}

TEST_F(WishesTest, every_kind_of_wish_can_be_made_in_the_window) {
    std::set<std::size_t> kinds;
    const auto note = [&](const UiWishes& wishes) {
        for (const UiWish& wish : wishes) kinds.insert(wish.index());
    };
    const std::vector<UiTarget> targets = gui->targets();
    for (const UiTarget& target : targets) {
        // Lists hang over what is pressed next.
        const bool folds = target.name.ends_with("fold") || target.name == "legend/settings";
        if (folds || target.name == "steps/list" || target.name == "legend/map") continue;
        note(hand->click(target.name));
        hand->input().keys = {PanelKey::Escape};
        hand->frames(3);
    }
    for (const char* field : {"legend/range/to", "limits/S/limit"}) note(hand->type(field, "7"));
    hand->click("legend/map");
    note(hand->click("legend/map/turbo"));
    for (std::size_t kind = 0; kind < std::variant_size_v<UiWish>; ++kind)
        EXPECT_TRUE(kinds.contains(kind)) << "wish " << kind << " of UiWish";
}

}  // namespace
}  // namespace feelem::viewer
