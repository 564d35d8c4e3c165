// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/stage.hpp"

#include "viewer/app/scene_source.hpp"
#include "viewer/ui/numbers.hpp"

#include "feelem/error.hpp"

#include <glm/common.hpp>

#include <limits>

namespace feelem::viewer {
namespace {

// The page's --stage.
constexpr Rgb kLightBackground{227, 231, 231}, kDarkBackground{12, 16, 19};
constexpr Rgb kHeadsetBackground{32, 40, 45};

}  // namespace

Rgb background_of(Theme theme) {
    return theme == Theme::Dark ? kDarkBackground : kLightBackground;
}

Stage::Stage(
    const std::string& scene_path, const SoundOutputOptions& sound, const std::string& presentation_file
)
    : scene_(scene_path, presentation_file), viewer_(source_of(scene_)), senses_(sound),
      growing_([this] { viewer_.prober.grow(); }) {
    renderer_.set_model(drawn());
    viewer_.value_text = with_unit;
}

/// Of a scene whose file is damaged further on, what cannot be read is left out, and the panels say so.
DrawnModel Stage::drawn() {
    DrawnModel model = drawn_model(scene_);
    model.values = [this, read = model.values](std::size_t result, std::size_t values) -> const FieldValues& {
        try {
            return read(result, values);
        } catch (const Error& error) {
            devices_.trouble = error.what();
            const std::size_t rows = scene_.geometry().positions.size();
            missing_.components = scene_.about().results.at(result).components.size();
            missing_.values.assign(rows * missing_.components, std::numeric_limits<float>::quiet_NaN());
            missing_.validity.assign(rows, Validity::Missing);
            return missing_;
        }
    };
    model.level = [this, read = model.level](std::size_t level
                  ) -> const std::vector<std::array<std::uint32_t, 3>>& {
        try {
            return read(level);
        } catch (const Error& error) {
            devices_.trouble = error.what();
            return scene_.geometry().triangles;
        }
    };
    return model;
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
