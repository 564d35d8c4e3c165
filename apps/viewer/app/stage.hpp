// SPDX-License-Identifier: Apache-2.0
// What the window and the headset have in common: one scene, one state, one snapshot a frame, and what is
// played of it.
#pragma once

#include "viewer/app/panel_model.hpp"
#include "viewer/app/sense_outputs.hpp"
#include "viewer/core/governor.hpp"
#include "viewer/render/frame_timer.hpp"
#include "viewer/render/renderer.hpp"
#include "viewer/scene/loaded_scene.hpp"

#include <string>
#include <thread>
#include <vector>

namespace feelem::viewer {

/// Behind the model.
Rgb background_of(Theme theme);

/// A frame as it was: what is drawn, said, and recorded of it.
struct Frame {
    FrameInput input;
    Look look;
    Snapshot snapshot;
    Overlay overlay;
    std::vector<SentPulse> pulses;
};

/// Needs a current OpenGL context from the first to the last.
class Stage {
public:
    Stage(
        const std::string& scene_path,
        const SoundOutputOptions& sound,
        const std::string& presentation_file = {}
    );
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// The state goes on, the senses play.
    const Frame& step(const FrameInput& input);
    const Frame& frame() const noexcept { return frame_; }
    /// Draws the last frame for one eye or two.
    void draw(std::span<const Camera> eyes, glm::ivec2 pixels, std::span<const Panel> panels = {});

    /// Frames that take longer than `budget` seconds are drawn coarser; 0: always at the finest, as pictures
    /// are that must not depend on the machine.
    void set_budget(double budget) noexcept { budget_ = budget; }
    /// Nothing moves: the finest picture, however long it takes.
    void set_rest(bool rests) noexcept { rests_ = rests; }
    const Fineness& fineness() const noexcept { return kFineness[rests_ ? 0 : governor_.level]; }
    Viewer& viewer() noexcept { return viewer_; }
    const Viewer& viewer() const noexcept { return viewer_; }
    Renderer& renderer() noexcept { return renderer_; }
    SenseOutputs& senses() noexcept { return senses_; }
    DeviceWords& devices() noexcept { return devices_; }
    UiModel panels() { return panel_model(viewer_, frame_.look, frame_.snapshot, devices_); }
    /// Rays meet the model: until then it is drawn, but nothing is read.
    bool is_ready() const { return viewer_.prober.is_ready() && renderer_.is_complete(); }

private:
    DrawnModel drawn();

    LoadedScene scene_;
    Viewer viewer_;
    Renderer renderer_;
    SenseOutputs senses_;
    DeviceWords devices_;
    Frame frame_;
    FieldValues missing_;  ///< Stands for values that cannot be read.
    Governor governor_;
    FrameTimer timer_;
    double budget_ = 0;
    bool rests_ = false;
    std::jthread growing_;  ///< Makes the hierarchies for rays while the first pictures are drawn.
};

}  // namespace feelem::viewer
