// SPDX-License-Identifier: Apache-2.0
// What the panels show of the boiler, and what comes of what they wish.
#include "support/paths.hpp"
#include "viewer/app/panel_model.hpp"
#include "viewer/app/scene_source.hpp"
#include "viewer/app/wishes.hpp"

#include "feelem/convert.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PanelModel : public testing::Test {
protected:
    PanelModel() : scene_(made_scene()), viewer_(source_of(scene_)) { viewer_.prober.grow(); }

    static std::string made_scene() {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        Job job;
        job.inputs = {test::project_file("examples/boiler/boiler.frd")};
        job.output = test::scratch_folder("viewer_app_" + test) + "/boiler.glb";
        job.length_unit = "mm";
        job.units = {{"temperature", "degC"}, {"displacement", "mm"}, {"stress", "MPa"}};
        job.presentation_file = test::project_file("examples/boiler/boiler.presentation.json");
        job.levels = "8000";
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        return job.output;
    }

    /// Points at the model's middle, from ahead of it.
    UiModel model(bool is_held = false) {
        FrameInput input;
        input.time = time_ += 1.0 / 60;
        input.pointer.ray = Ray{{0, 1.4F, 1}, glm::normalize(glm::vec3(0, -0.4F, -2.2F))};
        input.pointer.primary = is_held;
        update(viewer_, input);
        look_ = look_of(viewer_, input);
        return panel_model(viewer_, look_, snapshot_of(viewer_, input), devices_);
    }
    void wish(const UiWish& wish) { grant({wish}, viewer_, devices_, window_); }

    LoadedScene scene_;
    Viewer viewer_;
    DeviceWords devices_;
    WindowWishes window_;
    Look look_;
    double time_ = 0;
};

TEST_F(PanelModel, legend_and_table_say_what_drives_what_with_units) {
    const UiModel shown = model();
    ASSERT_TRUE(shown.legend);
    EXPECT_EQ(shown.legend->unit, "degC");
    EXPECT_NEAR(shown.legend->range.lo, 131.143, 1e-3);
    EXPECT_NEAR(shown.legend->range.hi, 235.154, 1e-3);
    EXPECT_THAT(shown.legend->deformation, HasSubstr("22.02"));
    EXPECT_EQ(shown.legend->within, "") << "all triangles are drawn";
    ASSERT_EQ(shown.results.size(), 3U);
    EXPECT_THAT(shown.results[0].senses, ElementsAre(Sense::Colour));
    EXPECT_THAT(shown.results[1].senses, ElementsAre(Sense::Pitch, Sense::Shape));
    EXPECT_THAT(shown.results[2].senses, ElementsAre(Sense::Pulses));
    EXPECT_EQ(shown.results[2].limit, 250);
}

TEST_F(PanelModel, a_finished_scene_with_another_presentation_shows_open_ranges_from_end_to_end) {
    const std::string scene = made_scene(), other = scene + ".presentation.json";
    const auto range_of = [&](const std::string& range) {
        test::write_file(
            other,
            R"({"format": "feelem-presentation", "version": 1, "results": [{"key": "T", "name": "temperature",
             "component": "value", "location": "nodal", "range": )" +
                range +
                R"(}], "effects": [{"result": "T", "sense": "visual", "type": "colour", "map": "batlow"}]})"
        );
        LoadedScene loaded(scene, other);
        Viewer viewer(source_of(loaded));
        const Look look = look_of(viewer, FrameInput{});
        const UiModel shown = panel_model(viewer, look, snapshot_of(viewer, FrameInput{}), devices_);
        EXPECT_TRUE(shown.legend) << range;
        return shown.legend ? shown.legend->range : ValueRange{};
    };
    const auto& results = scene_.about().results;
    const auto temperature = std::ranges::find(results, "temperature", &SceneResult::quantity);
    ASSERT_NE(temperature, results.end());
    const SceneValues& stated = temperature->values.at(0);
    const double lo = stated.min.value().value, hi = stated.max.value().value;
    ASSERT_LT(lo, 140);
    for (const char* open :
         {R"({"mode": "percentile", "p": [2, 98]})",
          R"({"mode": "percentile", "p": [2, 98], "lo": 140})",
          R"({"mode": "auto", "lo": 140, "hi": 200})"}) {
        EXPECT_EQ(range_of(open).lo, lo) << open;
        EXPECT_EQ(range_of(open).hi, hi) << open;
    }
    const ValueRange found = range_of(R"({"mode": "percentile", "p": [2, 98], "lo": 140, "hi": 200})");
    EXPECT_EQ(found.lo, 140);
    EXPECT_EQ(found.hi, 200);
}

TEST_F(PanelModel, card_and_legend_show_the_values_of_one_snapshot) {
    const UiModel shown = model(true);
    ASSERT_TRUE(shown.card);
    ASSERT_EQ(shown.card->rows.size(), 3U);
    EXPECT_EQ(shown.card->rows[0].key, "T");
    EXPECT_EQ(shown.card->rows[0].unit, "degC");
    EXPECT_EQ(shown.card->rows[0].value, shown.legend->probed);
    EXPECT_EQ(shown.card->length_unit, "mm");
    EXPECT_TRUE(shown.card->node);
    EXPECT_THAT(shown.card->sounding, HasSubstr("Hz"));
    EXPECT_THAT(shown.card->sounding, HasSubstr("ticks/s")) << "nothing here can shake";
}

TEST_F(PanelModel, a_reduced_level_says_what_the_picture_may_be_off) {
    viewer_.state.most_triangles = 9000;
    const UiModel shown = model();
    ASSERT_TRUE(look_.level);
    EXPECT_THAT(shown.legend->within, testing::StartsWith("values within ±"));
    EXPECT_THAT(shown.legend->within, HasSubstr("°C"));
}

TEST_F(PanelModel, a_sense_goes_to_another_result_and_back_to_none) {
    wish(AssignSense{"S", Sense::Colour, true});
    EXPECT_EQ(model().legend->key, "S");
    wish(AssignSense{"S", Sense::Colour, false});
    EXPECT_FALSE(model().legend);
    wish(ReleaseAll{"U"});
    EXPECT_TRUE(model().results[1].senses.empty());
}

TEST_F(PanelModel, every_other_wish_is_granted_too) {
    wish(SetFactor{1.0});
    EXPECT_EQ(model().deformation.factor, 1);
    wish(SetFactor{});
    EXPECT_TRUE(model().deformation.is_automatic);
    wish(AddCut{{0, 0, 1}});
    ASSERT_EQ(model().cuts.size(), 1U);
    EXPECT_EQ(model().cuts[0].plane.normal, glm::vec3(0, 0, 1));
    EXPECT_LT(model().cuts[0].from, model().cuts[0].to);
    wish(SetCut{0, {{0, 1, 0}, 12}, false});
    EXPECT_FALSE(model().cuts[0].is_on);
    wish(RemoveCut{0});
    wish(RemoveCut{7});
    EXPECT_TRUE(model().cuts.empty());
    wish(SetPart{0, PartLook::Hidden});
    EXPECT_EQ(model().parts[0].look, PartLook::Hidden);
    wish(ShowAllParts{});
    EXPECT_EQ(model().parts[0].look, PartLook::Shown);
    wish(SetLimit{"S", 400.0, true});
    EXPECT_EQ(model().results[2].limit, 400);
    wish(SetRange{"T", {100, 200, Scale::Linear}});
    EXPECT_EQ(model().legend->range.hi, 200);
    wish(SetVolume{0.25});
    wish(SetMono{true});
    wish(SetStrength{1.5});
    EXPECT_EQ(model().sound.volume, 0.25);
    EXPECT_TRUE(model().sound.is_mono);
    EXPECT_EQ(model().touch.strength, 1.5);
    wish(Command::ToggleMute);
    EXPECT_TRUE(model().sound.is_muted);
    wish(SetTheme{Theme::Dark});
    EXPECT_EQ(model().theme, Theme::Dark);
    wish(LookFrom{{1, 0, 0}});
    wish(TryHeadset{});
    EXPECT_EQ(window_.looks.size(), 1U);
    EXPECT_TRUE(window_.try_headset);
}

TEST_F(PanelModel, hot_spots_are_listed_and_gone_to) {
    const UiModel shown = model();
    ASSERT_FALSE(shown.hot_spots.empty());
    EXPECT_EQ(shown.hot_spots[0].unit, "degC");
    EXPECT_NEAR(shown.hot_spots[0].value, 235.154, 1e-3);
    wish(GoToHotSpot{0});
    EXPECT_EQ(viewer_.state.pin, shown.hot_spots[0].node);
    EXPECT_TRUE(model().hot_spots[0].is_chosen);
    wish(Command::NextHotSpot);
    EXPECT_EQ(viewer_.state.pin, shown.hot_spots.at(1).node) << "from the one that was gone to";
    wish(GoToHotSpot{99});
    wish(ReleasePin{});
    EXPECT_FALSE(viewer_.state.pin);
}

TEST_F(PanelModel, planes_say_whether_they_cut_and_where_in_the_solvers_own_axes) {
    wish(AddCut{{1, 0, 0}});
    UiModel shown = model();
    EXPECT_TRUE(shown.cuts_are_on);
    EXPECT_EQ(shown.cuts.at(0).shift, scene_.about().origin[0]);
    wish(SetCut{0, {{0, 0, -1}, 3}, true});
    EXPECT_EQ(model().cuts.at(0).shift, -scene_.about().origin[2]);
    wish(TurnCut{0, 1});
    shown = model();
    EXPECT_NEAR(shown.cuts.at(0).plane.offset, (shown.cuts.at(0).from + shown.cuts.at(0).to) / 2, 1e-3F)
        << "a plane that was turned stands in the model, wherever the solver has its zero";
    EXPECT_EQ(shown.cuts.at(0).plane.normal, glm::vec3(0, 1, 0));
    wish(Command::ToggleClip);
    EXPECT_FALSE(model().cuts_are_on) << "the button offers to cut again";
}

TEST_F(PanelModel, a_note_shows_the_coloured_results_value_at_its_node) {
    const HotSpot spot = viewer_.spots.of(viewer_.state, viewer_.model).at(0);
    place_marker(viewer_.state, spot.node);
    UiModel shown = model();
    EXPECT_EQ(shown.markers.at(0).value, spot.value);
    EXPECT_EQ(shown.markers.at(0).unit, "degC");
    wish(AssignSense{"T", Sense::Colour, false});
    EXPECT_TRUE(std::isnan(model().markers.at(0).value)) << "no result is seen";
}

TEST_F(PanelModel, what_happened_last_is_said_for_a_while) {
    place_marker(viewer_.state, std::nullopt);
    EXPECT_THAT(model().message, HasSubstr("Point at a node"));
    time_ += 5;
    EXPECT_THAT(model().message, HasSubstr("Point at a node"));
    time_ += 2;
    EXPECT_EQ(model().message, "");
}

}  // namespace
}  // namespace feelem::viewer
