// SPDX-License-Identifier: Apache-2.0
// One scene, one state, and frames that may take too long.
#include "support/paths.hpp"
#include "viewer/app/stage.hpp"
#include "viewer/render/gl_context.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace feelem::viewer {
namespace {

class Stages : public testing::Test {
protected:
    void SetUp() override {
        try {
            context_.emplace();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        Job job;
        job.inputs = {test::project_file("examples/boiler/boiler.frd")};
        job.output = test::scratch_folder("viewer_stage_" + test) + "/boiler.glb";
        job.levels = "8000";
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        stage_.emplace(job.output, SoundOutputOptions{SoundDevice::None, true});
    }
    void TearDown() override {
        stage_.reset();
        context_.reset();
    }
    void frame() {
        FrameInput input;
        input.time = ++frames_ / 60.0;
        stage_->step(input);
        const Camera eye = camera_of(EyeView{{{0, 1.2F, 0.6F}, {1, 0, 0, 0}}, {-0.5F, 0.5F, 0.4F, -0.4F}});
        stage_->draw({&eye, 1}, {64, 48});
        (void)stage_->renderer().read(0);
    }

    std::optional<GlContext> context_;
    std::optional<Stage> stage_;
    int frames_ = 0;
};

TEST_F(Stages, frames_over_their_budget_are_drawn_coarser_and_the_finest_again_at_rest) {
    stage_->set_budget(1e-9);
    for (int i = 0; i < 200 && stage_->fineness().resolution > 0.5F; ++i) frame();
    EXPECT_LT(stage_->fineness().resolution, 0.5F);
    EXPECT_FALSE(stage_->frame().look.edges);
    EXPECT_EQ(stage_->viewer().state.most_triangles, 125'000U);
    EXPECT_TRUE(stage_->viewer().state.edges) << "what the person chose stays";
    stage_->set_rest(true);
    frame();
    EXPECT_EQ(stage_->fineness().resolution, 1);
    EXPECT_TRUE(stage_->frame().look.edges);
}

/// A packed scene with damage somewhere behind its geometry: it opens, but the stress cannot be read. Empty:
/// none was found.
std::string damaged_scene(const std::string& folder) {
    Job job;
    job.inputs = {test::project_file("examples/boiler/boiler.frd")};
    job.output = folder + "/boiler.glb";
    job.presentation_file = test::project_file("examples/boiler/boiler.presentation.json");
    job.compress = true;
    Diagnostics diagnostics;
    convert(job, diagnostics, {});
    constexpr std::size_t kDamage = 2048;
    const std::string whole = test::read_file(job.output), path = folder + "/damaged.bin";
    for (std::size_t percent = 98; percent > 20; --percent) {
        std::string bytes = whole;
        bytes.replace(bytes.size() * percent / 100, kDamage, std::string(kDamage, '\xFF'));
        test::write_file(path, bytes);
        try {
            LoadedScene scene(path);
            const auto stress = scene.find(scene.about().presentation.results[2], 0);
            try {
                (void)scene.values(stress.value().result, stress.value().values);
            } catch (const Error&) {
                return path;
            }
        } catch (const Error&) {
            continue;
        }
    }
    return {};
}

TEST_F(Stages, a_scene_that_is_damaged_behind_its_geometry_is_drawn_without_what_cannot_be_read) {
    const std::string path = damaged_scene(test::scratch_folder("viewer_stage_damaged"));
    ASSERT_NE(path, "");
    stage_.emplace(path, SoundOutputOptions{SoundDevice::None, false});
    assign(stage_->viewer().state, "S", Sense::Colour);
    for (int i = 0; i < 20; ++i) frame();
    EXPECT_NE(stage_->panels().trouble, "");
    EXPECT_GT(stage_->renderer().counts().triangles, 0U);
}

TEST_F(Stages, without_a_budget_pictures_do_not_depend_on_the_machine) {
    for (int i = 0; i < 40; ++i) frame();
    EXPECT_EQ(stage_->fineness().resolution, 1);
    EXPECT_EQ(stage_->viewer().state.most_triangles, UINT64_MAX);
}

TEST_F(Stages, a_scene_is_ready_after_some_frames_and_its_sound_can_be_kept) {
    for (int i = 0; i < 2000 && !stage_->is_ready(); ++i) frame();
    EXPECT_TRUE(stage_->is_ready());
    for (int i = 0; i < 3; ++i) frame();
    EXPECT_FALSE(stage_->senses().take_sound().empty());
    EXPECT_TRUE(stage_->senses().take_sound().empty());
}

}  // namespace
}  // namespace feelem::viewer
