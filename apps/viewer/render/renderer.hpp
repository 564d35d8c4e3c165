// SPDX-License-Identifier: Apache-2.0
// Draws model, marks, labels and panels for one eye or two, in OpenGL 4.5. Knows no window and no headset:
// pictures go to the textures or framebuffers that are handed over, or are read back.
#pragma once

#include "viewer/core/look.hpp"
#include "viewer/scene/loaded_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Where the renderer finds what it draws; all of it outlives the renderer or the next set_model().
struct DrawnModel {
    const Geometry* geometry = nullptr;
    std::vector<bool> solid;  ///< Per part: it encloses a volume, so its cut shows a cap.
    std::function<const FieldValues&(std::size_t result, std::size_t values)> values;
    std::function<const std::vector<std::array<std::uint32_t, 3>>&(std::size_t level)> level;
};
DrawnModel drawn_model(LoadedScene& scene);

/// World -> eye -> clip space.
struct Camera {
    glm::mat4 view{1}, projection{1};
};
/// `near` and `far` in metres.
Camera camera_of(const EyeView& eye, float near = 0.02F, float far = 200.0F);

/// A texture that stands in the world, such as a page of text.
struct Panel {
    unsigned texture = 0;       ///< 2-D, sRGB bytes, alpha multiplied in.
    Pose pose;                  ///< Of its centre; its front looks along +Z.
    glm::vec2 size{1};          ///< Metres.
    bool is_top_first = false;  ///< Its first row is the picture's highest; OpenGL draws the lowest first.
};

struct DrawInput {
    std::span<const Camera> eyes;  ///< One, or the left and the right.
    int width = 0, height = 0;     ///< Of each eye's picture, pixels.
    const Look* look = nullptr;    ///< Null: no model.
    std::span<const Mark> marks;
    std::span<const Label> labels;
    std::span<const Panel> panels;
    Rgb background{24, 27, 31};
    std::optional<float> floor;  ///< Height of a grid for the eyes to hold on to, metres.
};

/// Where a finished picture goes: a 2-D texture (a swapchain's image), or a framebuffer, 0 being the
/// window's. It is scaled to the rectangle where sizes differ. Bytes are sRGB, written as they are, also into
/// an sRGB format.
struct Target {
    unsigned texture = 0;
    unsigned framebuffer = 0;  ///< Only when `texture` is 0.
    int x = 0, y = 0, width = 0, height = 0;
    bool is_top_first = false;   ///< The picture's highest row becomes the first.
    unsigned depth_texture = 0;  ///< GL_DEPTH_COMPONENT32F of the eyes' size; 0: depth is not wanted.
};

/// How both eyes are drawn; all give the same pixels.
enum class StereoPath : std::uint8_t {
    VertexLayer,     ///< Once, the vertex shader says which eye (ARB_shader_viewport_layer_array).
    GeometryShader,  ///< Once, a geometry shader says it.
    TwoPass,
};

struct RendererOptions {
    std::optional<StereoPath> stereo{};  ///< Empty: the best there is.
    int samples = 4;                     ///< Of antialiasing; fewer where the card has fewer.
    bool culling = true;
    std::uint64_t upload_bytes = 64U << 20;  ///< At most so many in one draw().
    /// Models of more vertices keep their places as 16 bits a coordinate: see Renderer::position_error().
    std::size_t quantise_above = 16'000'000;
};

/// Of the last draw() but for `uploaded`, which never starts again.
struct DrawCounts {
    std::uint64_t triangles = 0;  ///< Sent for drawing, once for both eyes.
    std::uint64_t clusters = 0, clusters_culled = 0;
    std::uint64_t draw_calls = 0;
    struct Uploaded {
        std::uint64_t geometry = 0, field = 0, displacement = 0, level = 0;
    } uploaded;
};

/// Rows from the top, RGB.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};
std::string png_of(const Pixels& pixels);

/// All calls with the same OpenGL 4.5 core context current, also the destructor. State of the context that
/// others use is left as OpenGL has it at first, but for the framebuffer that is bound. Throws
/// Error(UnsupportedFormat) where the context lacks something, Error(TooLarge) when the card's memory is
/// full.
class Renderer {
public:
    explicit Renderer(const RendererOptions& options = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Its arrays go to the card bit by bit, with each draw().
    void set_model(const DrawnModel& model);
    /// All that the last look needs has reached the card. Until then the model is drawn without its colours,
    /// or not at all.
    bool is_complete() const noexcept;

    void draw(const DrawInput& input);
    /// The last picture of eye 0 or 1.
    void copy(std::size_t eye, const Target& target) const;
    Pixels read(std::size_t eye) const;

    StereoPath stereo() const noexcept;
    const DrawCounts& counts() const noexcept;
    /// Largest distance between a vertex and where it is drawn, model units; 0: exact.
    float position_error() const noexcept;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
