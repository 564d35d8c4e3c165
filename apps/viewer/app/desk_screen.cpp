// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/desk_screen.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace feelem::viewer {
namespace {

/// Box of the drawn (undeformed) model, world.
WorldBox box_of(const Viewer& viewer) {
    const ModelArrays& arrays = viewer.model.arrays();
    const glm::mat4 matrix = model_to_world(viewer.state, viewer.model);
    WorldBox box;
    for (int corner = 0; corner < 8; ++corner) {
        glm::vec4 place{0, 0, 0, 1};
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            place[axis] = ((corner >> axis) & 1) != 0 ? arrays.high[a] : arrays.low[a];
        }
        const glm::vec3 world(matrix * place);
        box.low = corner == 0 ? world : glm::min(box.low, world);
        box.high = corner == 0 ? world : glm::max(box.high, world);
    }
    return box;
}

bool is_pushed(const PadState& pad) {
    return pad.left != glm::vec2(0) || pad.right != glm::vec2(0) || pad.left_trigger > 0 ||
           pad.right_trigger > 0;
}

void act(DeskAction action, Window* window, DeviceWords& devices) {
    switch (action) {
    case DeskAction::Theme: devices.theme = devices.theme == Theme::Dark ? Theme::Light : Theme::Dark; return;
    case DeskAction::Help: devices.show_help = !devices.show_help; return;
    case DeskAction::FullScreen:
        if (window != nullptr) window->set_full_screen(!window->is_full_screen());
        return;
    default: return;
    }
}

}  // namespace

DeskScreen::DeskScreen(const Options& options, bool has_window) : size_(options.size[0], options.size[1]) {
    if (has_window) {
        WindowOptions wanted;
        wanted.width = options.size[0];
        wanted.height = options.size[1];
        wanted.samples = 0;  // The renderer and the panels smooth their own edges.
        window_ = std::make_unique<Window>(wanted);
        motors_.emplace(*window_);
    } else {
        context_ = std::make_unique<GlContext>();
    }
    gui_ = std::make_unique<DeskGui>(window_ ? window_->density() : 1.0F);
}

DeskScreen::~DeskScreen() = default;

glm::ivec2 DeskScreen::pixels() const {
    return window_ ? window_->pixels() : size_;
}
std::array<int, 4> DeskScreen::stage_rectangle() const {
    return gui_->stage(pixels());
}

DeskFrame DeskScreen::poll(Stage& stage, double time, std::span<const DeskEvent> scripted) {
    std::vector<DeskEvent> events = window_ ? window_->poll() : std::vector<DeskEvent>{};
    events.insert(events.end(), scripted.begin(), scripted.end());
    const Viewer& viewer = stage.viewer();
    DeskSituation now;
    now.time = time;
    now.pixels = pixels();
    now.density = window_ ? window_->density() : 1.0F;
    now.stage = stage_rectangle();
    if (window_) now.pad = window_->pad();
    was_used_ = !events.empty() || is_pushed(now.pad);
    now.over_panel = gui_->wants_pointer();
    now.is_typing = gui_->wants_keys();
    now.box = box_of(viewer);
    now.to_world = glm::mat3(model_to_world(viewer.state, viewer.model));
    now.hit = [&viewer](const Ray& ray) { return pressable(viewer, ray); };
    DeskFrame frame = input_.step(events, now);
    for (const DeskAction action : frame.actions) act(action, window_.get(), stage.devices());
    panel_input_ = frame.panel;
    look_where_wished(stage);
    return frame;
}

void DeskScreen::look_where_wished(Stage& stage) {
    ViewerState& state = stage.viewer().state;
    if (const auto wish = std::exchange(state.look_at, std::nullopt))
        go_to(camera(), wish->place, wish->distance);
    const glm::mat3 to_world(model_to_world(state, stage.viewer().model));
    for (const LookFrom& look : std::exchange(wishes_.looks, {})) {
        const WorldBox box = box_of(stage.viewer());
        const auto [x, y, width, height] = stage_rectangle();
        const float aspect = static_cast<float>(width) / static_cast<float>(std::max(height, 1));
        go_home(camera(), box, aspect);
        if (glm::length(look.direction) > 0) look_from(camera(), glm::normalize(to_world * look.direction));
        fit(camera(), box, aspect);
    }
}

void DeskScreen::draw(Stage& stage, bool headset_shows) {
    wishes_.try_headset = false;
    picture_.begin(pixels(), background_of(stage.devices().theme));
    const auto [x, y, width, height] = stage_rectangle();
    if (width > 0 && height > 0) {
        const glm::ivec2 size{width, height};
        // Hands may have carried the model anywhere.
        const float aspect = static_cast<float>(width) / static_cast<float>(height);
        if (std::exchange(was_mirror_, headset_shows) && !headset_shows)
            fit(camera(), box_of(stage.viewer()), aspect);
        if (!headset_shows) {
            const auto [near, far] = depth_of(camera());
            const EyeView eye{pose_of(camera()), field_of(camera(), aspect)};
            const Camera looks = camera_of(eye, near, far);
            stage.draw({&looks, 1}, size);
        }
        Target target;
        target.framebuffer = picture_.framebuffer();
        target.x = x;
        target.y = picture_.pixels().y - y - height;
        target.width = width;
        target.height = height;
        stage.renderer().copy(0, target);
    }
    picture_.bind();
    const UiWishes wishes = gui_->draw(stage.panels(), panel_input_, picture_.pixels());
    grant(wishes, stage.viewer(), stage.devices(), wishes_);
}

void DeskScreen::lend_motors(SenseOutputs& senses) {
    const bool is_there = motors_ && window_->pad().can_rumble;
    senses.set_sink(Side::Left, nullptr);
    senses.set_sink(Side::Right, is_there ? &*motors_ : nullptr);
}

void DeskScreen::show(bool headset_gives_beat) {
    if (!window_) return;
    window_->set_vsync(!headset_gives_beat);
    picture_.show();
    window_->swap();
}

}  // namespace feelem::viewer
