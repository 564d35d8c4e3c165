// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/stage.hpp"

#include "viewer/app/scene_source.hpp"
#include "viewer/ui/numbers.hpp"

#include <glm/common.hpp>

namespace feelem::viewer {
namespace {

// The page's --stage.
constexpr Rgb kLightBackground{227, 231, 231}, kDarkBackground{12, 16, 19};
constexpr Rgb kHeadsetBackground{32, 40, 45};

}  // namespace

Rgb background_of(Theme theme) {
    return theme == Theme::Dark ? kDarkBackground : kLightBackground;
}

Stage::Stage(const std::string& scene_path, const SoundOutputOptions& sound)
    : scene_(scene_path), viewer_(source_of(scene_)), senses_(sound),
      growing_([this] { viewer_.prober.grow(); }) {
    renderer_.set_model(drawn_model(scene_));
    viewer_.value_text = with_unit;
}

Stage::~Stage() {
    senses_.stop();
}

const Frame& Stage::step(const FrameInput& input) {
    frame_.input = input;
    update(viewer_, input);
    while (const auto seconds = timer_.take())
        if (budget_ > 0) govern(governor_, *seconds, budget_);
    if (!(budget_ > 0)) governor_ = {};
    viewer_.state.most_triangles = fineness().triangles;
    frame_.look = look_of(viewer_, input);
    frame_.look.edges = frame_.look.edges && fineness().edges;
    frame_.snapshot = snapshot_of(viewer_, input);
    frame_.overlay = overlay_of(viewer_, frame_.snapshot, input);
    frame_.pulses = senses_.play(frame_.snapshot, viewer_.state, input.is_focused);
    devices_.sound_trouble = senses_.sound_trouble();
    devices_.touch_trouble = senses_.touch_trouble();
    return frame_;
}

void Stage::draw(std::span<const Camera> eyes, glm::ivec2 pixels, std::span<const Panel> panels) {
    DrawInput input;
    input.eyes = eyes;
    const glm::vec2 drawn = glm::max(glm::round(glm::vec2(pixels) * fineness().resolution), glm::vec2(1));
    input.width = static_cast<int>(drawn.x);
    input.height = static_cast<int>(drawn.y);
    input.look = &frame_.look;
    input.marks = frame_.overlay.marks;
    input.labels = frame_.overlay.labels;
    input.panels = panels;
    // As on the page: a light room would dazzle, and its boards are dark.
    input.background = frame_.input.is_headset ? kHeadsetBackground : background_of(devices_.theme);
    if (frame_.input.is_headset) input.floor = 0.0F;
    timer_.begin();
    renderer_.draw(input);
    timer_.end();
}

}  // namespace feelem::viewer
