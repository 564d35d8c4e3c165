// SPDX-License-Identifier: Apache-2.0
// Dear ImGui's contexts: input in, triangles to OpenGL.
#include "viewer/ui/gui.hpp"

#include "viewer/ui/layouts.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>
#include <utility>

namespace feelem::viewer {
namespace {

/// Line heights of letters in points: DejaVu's lines are 1.164 of the page's sizes of 13, 11.5 and 15.
constexpr float kPlainPoints = 15, kSmallPoints = 13.4F, kTitlePoints = 17.5F;
/// On boards: a capital of 0.729 / 1.164 of the line is 10.5 mm high, half a degree at 1.2 m.
constexpr float kBoardPixelsAMetre = 1829;
constexpr float kBoardLetters = 32, kBoardTitle = 36;
constexpr float kLeastSeconds = 1e-4F, kMostSeconds = 0.2F;

constexpr std::array<glm::ivec2, kBoards> kBoardPixels{{{1024, 1130}, {512, 940}, {780, 680}}};

ImGuiKey key_of(PanelKey key) {
    constexpr std::array<ImGuiKey_, 12> kKeys{
        ImGuiKey_Tab,
        ImGuiKey_LeftArrow,
        ImGuiKey_RightArrow,
        ImGuiKey_UpArrow,
        ImGuiKey_DownArrow,
        ImGuiKey_Home,
        ImGuiKey_End,
        ImGuiKey_Delete,
        ImGuiKey_Backspace,
        ImGuiKey_Enter,
        ImGuiKey_Escape,
        ImGuiKey_A};
    return kKeys.at(static_cast<std::size_t>(key));
}

}  // namespace

/// One context of Dear ImGui with its font texture. Makes itself the current one for as long as it draws.
class UiSurface {
public:
    struct Letters {
        float plain, small, title, unit;
    };
    explicit UiSurface(const Letters& letters) : unit_(letters.unit), context_(ImGui::CreateContext()) {
        const Current current(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = io.LogFilename = nullptr;
        io.BackendPlatformName = "feelem";
        for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
        fonts_ = load_fonts(letters.plain, letters.small, letters.title);
        if (!ImGui_ImplOpenGL3_Init("#version 450 core")) {
            ImGui::DestroyContext(context_);
            throw std::runtime_error("the panels find no OpenGL: is a context current?");
        }
    }
    ~UiSurface() {
        {
            const Current current(context_);
            ImGui_ImplOpenGL3_Shutdown();
        }
        ImGui::DestroyContext(context_);
    }
    UiSurface(const UiSurface&) = delete;
    UiSurface& operator=(const UiSurface&) = delete;

    /// `panels` draws with a pen on this surface.
    template <class Panels>
    UiWishes draw(
        const UiModel& model,
        const PanelInput& input,
        glm::ivec2 pixels,
        const UiColours& colours,
        bool is_board,
        Panels panels
    ) {
        const Current current(context_);
        UiWishes wishes;
        if (pixels.x <= 0 || pixels.y <= 0) return wishes;
        feed(input, pixels);
        apply_style(colours, unit_);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        targets_.clear();
        ImGui::PushFont(fonts_.plain);
        Pen pen{model, wishes, targets_, colours, fonts_, unit_, is_board, input.pointer};
        panels(pen);
        ImGui::PopFont();
        ImGui::Render();
        const GLboolean encodes = glIsEnabled(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_FRAMEBUFFER_SRGB);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        if (encodes == GL_TRUE) glEnable(GL_FRAMEBUFFER_SRGB);
        wants_pointer_ = ImGui::GetIO().WantCaptureMouse;
        wants_keys_ = ImGui::GetIO().WantTextInput;
        return wishes;
    }
    bool wants_pointer() const { return wants_pointer_; }
    bool wants_keys() const { return wants_keys_; }
    const std::vector<UiTarget>& targets() const { return targets_; }

private:
    class Current {
    public:
        explicit Current(ImGuiContext* wanted) : before_(ImGui::GetCurrentContext()) {
            ImGui::SetCurrentContext(wanted);
        }
        ~Current() { ImGui::SetCurrentContext(before_); }
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

    private:
        ImGuiContext* before_;
    };

    void feed(const PanelInput& input, glm::ivec2 pixels) {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
        io.DeltaTime = std::clamp(static_cast<float>(input.seconds), kLeastSeconds, kMostSeconds);
        constexpr float kNowhere = -std::numeric_limits<float>::max();
        io.MousePos = input.at ? ImVec2(input.at->x, input.at->y) : ImVec2(kNowhere, kNowhere);
        for (std::size_t i = 0; i < input.buttons.size(); ++i) io.MouseDown[i] = input.buttons.at(i);
        io.MouseWheel = input.wheel;
        io.AddInputCharactersUTF8(input.text.c_str());
        feed_keys(input.keys);
    }

    /// Each key is down for one frame and up for one, so that none is lost or taken for a held one.
    void feed_keys(const std::vector<PanelKey>& keys) {
        ImGuiIO& io = ImGui::GetIO();
        std::ranges::fill(io.KeysDown, false);
        io.KeyCtrl = false;
        waiting_.insert(waiting_.end(), keys.begin(), keys.end());
        if (std::exchange(rests_, false) || waiting_.empty()) return;
        const PanelKey key = waiting_.front();
        waiting_.pop_front();
        io.KeysDown[key_of(key)] = true;
        io.KeyCtrl = key == PanelKey::All;
        rests_ = true;
    }

    float unit_;
    ImGuiContext* context_;
    UiFonts fonts_;
    std::vector<UiTarget> targets_;
    std::deque<PanelKey> waiting_;
    bool rests_ = false, wants_pointer_ = false, wants_keys_ = false;
};

struct DeskGui::State {
    explicit State(float density)
        : unit(std::max(density, 0.5F)), surface(
                                             {std::round(kPlainPoints * unit),
                                              std::round(kSmallPoints * unit),
                                              std::round(kTitlePoints * unit),
                                              unit}
                                         ) {}
    float unit;
    UiSurface surface;
};

DeskGui::DeskGui(float density) : state_(std::make_unique<State>(density)) {}
DeskGui::~DeskGui() = default;

UiWishes DeskGui::draw(const UiModel& model, const PanelInput& input, glm::ivec2 pixels) {
    return state_->surface.draw(model, input, pixels, desk_colours(model.theme), false, [&](Pen& pen) {
        draw_desk(pen, pixels);
    });
}

std::array<int, 4> DeskGui::stage(glm::ivec2 pixels) const {
    const UiRect stage = desk_rects(pixels, state_->unit).stage;
    return {
        static_cast<int>(stage.x),
        static_cast<int>(stage.y),
        static_cast<int>(stage.width),
        static_cast<int>(stage.height)};
}

bool DeskGui::wants_pointer() const {
    return state_->surface.wants_pointer();
}
bool DeskGui::wants_keys() const {
    return state_->surface.wants_keys();
}
const std::vector<UiTarget>& DeskGui::targets() const {
    return state_->surface.targets();
}

BoardSize size_of(Board board) {
    const glm::ivec2 pixels = kBoardPixels.at(static_cast<std::size_t>(board));
    return {pixels, glm::vec2(pixels) / kBoardPixelsAMetre};
}

struct BoardTexture::State {
    explicit State(Board which)
        : board(which), surface({kBoardLetters, kBoardLetters, kBoardTitle, kBoardLetters / kPlainPoints}) {
        const glm::ivec2 pixels = size_of(board).pixels;
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGBA8, pixels.x, pixels.y);
        glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glCreateFramebuffers(1, &framebuffer);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
    }
    ~State() {
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteTextures(1, &texture);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    Board board;
    UiSurface surface;
    GLuint texture = 0, framebuffer = 0;
};

BoardTexture::BoardTexture(Board board) : state_(std::make_unique<State>(board)) {}
BoardTexture::~BoardTexture() = default;

UiWishes BoardTexture::draw(const UiModel& model, const PanelInput& input) {
    const glm::ivec2 pixels = size_of(state_->board).pixels;
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    constexpr std::array<float, 4> kNothing{};
    glClearNamedFramebufferfv(state_->framebuffer, GL_COLOR, 0, kNothing.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, state_->framebuffer);
    UiWishes wishes = state_->surface.draw(model, input, pixels, board_colours(), true, [&](Pen& pen) {
        draw_board(pen, state_->board, pixels);
    });
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
    return wishes;
}

std::uint32_t BoardTexture::texture() const {
    return state_->texture;
}
std::uint32_t BoardTexture::framebuffer() const {
    return state_->framebuffer;
}
bool BoardTexture::wants_pointer() const {
    return state_->surface.wants_pointer();
}
const std::vector<UiTarget>& BoardTexture::targets() const {
    return state_->surface.targets();
}

std::optional<BoardHit> hit_board(const Ray& ray, const Pose& pose, const BoardSize& size) {
    const glm::quat back = glm::conjugate(pose.orientation);
    const glm::vec3 origin = back * (ray.origin - pose.position);
    const glm::vec3 direction = back * ray.direction;
    if (!(origin.z > 0) || !(direction.z < 0)) return std::nullopt;
    const float along = -origin.z / direction.z;
    const glm::vec2 at = glm::vec2(origin + along * direction) / size.metres;
    if (!(std::abs(at.x) <= 0.5F) || !(std::abs(at.y) <= 0.5F)) return std::nullopt;
    return BoardHit{glm::vec2(at.x + 0.5F, 0.5F - at.y) * glm::vec2(size.pixels), along};
}

}  // namespace feelem::viewer
