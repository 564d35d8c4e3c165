// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/renderer.hpp"

#include "scene/picture.hpp"
#include "viewer/render/model_drawer.hpp"
#include "viewer/render/overlay_drawer.hpp"
#include "viewer/render/programs.hpp"
#include "viewer/render/targets.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>

namespace feelem::viewer {
namespace {

const RendererOptions& checked(const RendererOptions& options) {
    const int version = epoxy_gl_version();
    if (version >= 45) return options;
    throw Error(
        Code::UnsupportedFormat,
        "OpenGL",
        fmt::format("the driver offers OpenGL {}.{}; 4.5 is needed", version / 10, version % 10)
    );
}

BothEyes matrices_of(const DrawInput& input) {
    BothEyes out;
    const glm::mat4 model = input.look ? input.look->model_to_world : glm::mat4(1);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Camera& eye = input.eyes[std::min(i, input.eyes.size() - 1)];
        out[i].view = eye.view;
        out[i].projection = eye.projection;
        out[i].model = eye.view * model;
        out[i].normal = glm::mat4(glm::transpose(glm::inverse(glm::mat3(out[i].model))));
        out[i].eye_in_model = glm::inverse(out[i].model)[3];
    }
    return out;
}

}  // namespace

struct Renderer::State {
    explicit State(const RendererOptions& wanted)
        : options(checked(wanted)), path(options.stereo.value_or(best_stereo())),
          programs(make_model_programs(path)), overlay(path), eyes(make_buffer(sizeof(BothEyes), "eyes")) {}

    RendererOptions options;
    StereoPath path;
    ModelPrograms programs;
    OverlayDrawer overlay;
    Buffer eyes;
    Targets targets;
    DrawCounts counts;
    std::optional<ModelDrawer> model;

    void draw_all(const DrawInput& input, const ModelDrawing& drawing);
};

Renderer::Renderer(const RendererOptions& options) : state_(std::make_unique<State>(options)) {}
Renderer::~Renderer() = default;

void Renderer::set_model(const DrawnModel& model) {
    state_->model.reset();
    state_->model.emplace(model, state_->options, state_->counts);
}

bool Renderer::is_complete() const noexcept {
    return !state_->model || state_->model->buffers().is_complete();
}

void Renderer::State::draw_all(const DrawInput& input, const ModelDrawing& drawing) {
    const auto share = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; };
    const Rgb& back = input.background;
    const GLsizei instances = drawing.passes.instances();
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(share(back[0]), share(back[1]), share(back[2]), 1);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glBindBufferBase(GL_UNIFORM_BUFFER, kEyesBinding, eyes.get());
    overlay.draw_floor(input, instances, counts);
    if (input.look && model) model->draw(drawing, programs);
    overlay.draw_panels(input, instances, counts);
    overlay.draw_marks(instances, counts);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
}

void Renderer::draw(const DrawInput& input) {
    State& state = *state_;
    if (input.eyes.empty() || input.eyes.size() > 2 || input.width < 1 || input.height < 1)
        throw Error(
            Code::BadOption,
            "OpenGL",
            fmt::format("cannot draw {} eyes of {} x {} pixels", input.eyes.size(), input.width, input.height)
        );
    state.targets.resize(input.width, input.height, state.options.samples, input.eyes.size());
    const DrawCounts::Uploaded uploaded = state.counts.uploaded;
    state.counts = {};
    state.counts.uploaded = uploaded;
    ModelDrawing drawing{
        input.look, input.eyes, input.height, {state.path, input.eyes.size()}, state.options.culling};
    if (input.look && state.model) state.model->prepare(drawing, state.options.upload_bytes);
    state.overlay.prepare(input);
    const BothEyes matrices = matrices_of(input);
    glNamedBufferSubData(state.eyes.get(), 0, sizeof(BothEyes), &matrices);
    if (state.path != StereoPath::TwoPass) {
        state.targets.bind_all();
        state.draw_all(input, drawing);
    } else {
        for (std::size_t eye = 0; eye < input.eyes.size(); ++eye) {
            state.targets.bind(eye);
            state.programs.set_eye(static_cast<int>(eye));
            state.overlay.set_eye(static_cast<int>(eye));
            state.draw_all(input, drawing);
        }
    }
    state.targets.resolve(input.eyes.size());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Renderer::copy(std::size_t eye, const Target& target) const {
    state_->targets.copy(eye, target);
}

Pixels Renderer::read(std::size_t eye) const {
    return state_->targets.read(eye);
}

StereoPath Renderer::stereo() const noexcept {
    return state_->path;
}

const DrawCounts& Renderer::counts() const noexcept {
    return state_->counts;
}

float Renderer::position_error() const noexcept {
    return state_->model ? state_->model->buffers().position_error() : 0;
}

Camera camera_of(const EyeView& eye, float near, float far) {
    return {glm::inverse(matrix_of(eye.pose)), projection_of(eye.field, near, far)};
}

DrawnModel drawn_model(LoadedScene& scene) {
    DrawnModel out;
    out.geometry = &scene.geometry();
    for (const ScenePart& part : scene.about().parts) out.solid.push_back(part.kind == "solid");
    out.values = [&scene](std::size_t result, std::size_t values) -> const FieldValues& {
        return scene.values(result, values);
    };
    out.level = [&scene](std::size_t level) -> const std::vector<std::array<std::uint32_t, 3>>& {
        return scene.level(level);
    };
    return out;
}

std::string png_of(const Pixels& pixels) {
    Picture picture(pixels.width, pixels.height, Rgb{});
    picture.rgb = pixels.rgb;
    return png_bytes(picture);
}

}  // namespace feelem::viewer
