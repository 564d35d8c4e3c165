// SPDX-License-Identifier: Apache-2.0
// The headset: comes and goes while the program lives, and hands out what core and render need in a frame.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/haptics/haptic_sink.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem::viewer {

enum class XrState : std::uint8_t {
    NoRuntime,  ///< Nothing is installed that speaks OpenXR.
    NoService,  ///< Installed, but it does not answer; asked again every few seconds.
    NoHeadset,  ///< It answers, but no headset is there; asked again every two seconds.
    Unusable,   ///< A headset that we cannot draw for: `why` says what is missing.
    Starting,   ///< The headset is ours, but has not asked for pictures yet.
    Asleep,     ///< It wants frames but shows none: taken off, for example.
    Visible,    ///< Its own menu stands before ours: nothing is heard, felt or moved.
    Focused,
    Ended,  ///< The person left through the headset's menu, or leave() was called; enter() comes back.
};
std::string_view word(XrState state);  ///< "no-runtime"

struct XrStatus {
    XrState state = XrState::Starting;
    bool is_asking = false;           ///< The runtime is being asked just now, beside the program's loop.
    std::string what, why, hint;      ///< Sentences for people; `why` and `hint` may be empty.
    std::string runtime, headset;     ///< As they name themselves; empty: not known yet.
    std::string input;                ///< What is in the hands: "Oculus Touch controllers", "bare hands".
    std::vector<std::string> quirks;  ///< What the runtime does amiss and we mended; each said once.
};

struct XrOptions {
    std::string application = "feelem-xr";
    bool is_required = false;  ///< Go on asking even where no runtime is installed.
};

/// Where one eye's picture goes.
struct XrEye {
    EyeView view;
    /// Of OpenGL, complete, colour only. Its texture is GL_SRGB8_ALPHA8 and wants sRGB bytes: blit from
    /// GL_RGBA8 with GL_FRAMEBUFFER_SRGB disabled, and they arrive unchanged.
    unsigned framebuffer = 0;
    unsigned depth_texture = 0;  ///< GL_DEPTH_COMPONENT32F of the same size; 0: the headset takes none.
    int width = 0, height = 0;
};

struct XrFrame {
    bool should_render = false;  ///< False: draw nothing, but call end_frame() all the same.
    std::array<XrEye, 2> eyes;   ///< Left, right; framebuffers only where should_render.
    FrameInput input;            ///< Poses as predicted for the moment when the picture is shown.
    double shown_at = 0;         ///< That moment, seconds of the runtime's clock.
    double period = 0;           ///< From one picture to the next, seconds.
};

/// A panel that the headset draws itself, sharper than a panel in our picture.
struct XrQuad {
    int name = 0;  ///< Whose picture is kept between frames.
    unsigned texture =
        0;  ///< GL_TEXTURE_2D, GL_RGBA8, sRGB bytes, alpha premultiplied, first row at the bottom.
    int width = 0, height = 0;
    bool has_changed = true;  ///< Since the last frame in which this name was shown.
    Pose pose;                ///< Of its middle, looking along its +Z.
    glm::vec2 size{0.5F};     ///< Metres.
};

struct XrDepth {
    float near = 0, far = 0;  ///< Metres, as given to projection_of().
};

struct XrPictures {
    std::span<const XrQuad> quads;
    std::optional<XrDepth> depth;  ///< Set when the eyes' depth textures were written too.
};

/// Uses the OpenGL context (EGL, or GLX as SDL makes it on X11) that is current on the thread of its calls,
/// and leaves it current. Never throws for what a runtime does: it says so in the status, and the desk goes
/// on.
class XrSystem {
public:
    explicit XrSystem(XrOptions options = {});
    ~XrSystem();
    XrSystem(const XrSystem&) = delete;
    XrSystem& operator=(const XrSystem&) = delete;

    /// Once a frame, first of all, with seconds of a clock that never goes back. Connects, listens, retries;
    /// costs nothing to speak of while there is nothing to do.
    const XrStatus& poll(double time);
    const XrStatus& status() const noexcept;

    /// Waits for the headset's next frame. Empty: there is none to draw; the desk keeps its own time.
    std::optional<XrFrame> begin_frame();
    /// Exactly once after each frame that begin_frame() gave.
    void end_frame(const XrPictures& pictures = {});

    /// Of that hand's controller; lives as long as this. Its pulses come to nothing while there is no
    /// controller.
    HapticSink& haptics(Side side) noexcept;

    /// The person's place and direction become the room's middle and its -Z; the floor stays where it is.
    void recentre();
    void leave();
    void enter();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace feelem::viewer
