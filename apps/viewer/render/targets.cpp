// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace feelem::viewer {
namespace {

/// Of antialiasing, the most that colour and depth both can.
int most_samples() {
    GLint colour = 1, depth = 1;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colour);
    glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
    return std::min(colour, depth);
}

Texture make_layers(GLenum format, int samples, int width, int height, std::size_t eyes) {
    const auto layers = static_cast<GLsizei>(eyes);
    Texture texture = make_texture(samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY);
    if (samples > 1)
        glTextureStorage3DMultisample(texture.get(), samples, format, width, height, layers, GL_TRUE);
    else
        glTextureStorage3D(texture.get(), 1, format, width, height, layers);
    return texture;
}

Program make_depth_copier(bool has_samples) {
    const std::array sources{
        ShaderSource{
            GL_VERTEX_SHADER,
            "#version 450 core\nvoid main() { gl_Position = vec4(4.0 * (gl_VertexID & 1) - 1.0, "
            "2.0 * (gl_VertexID & 2) - 1.0, 0.0, 1.0); }\n"},
        ShaderSource{
            GL_FRAGMENT_SHADER,
            fmt::format(
                "#version 450 core\nlayout(binding = 0) uniform {} depths;\nuniform int layer;\n"
                "void main() {{ gl_FragDepth = texelFetch(depths, ivec3(gl_FragCoord.xy, layer), 0).r; }}\n",
                has_samples ? "sampler2DMSArray" : "sampler2DArray"
            )}};
    return {"depth", sources};
}

}  // namespace

void Targets::resize(int width, int height, int samples, std::size_t eyes) {
    if (width == width_ && height == height_ && samples == samples_ && eyes == eyes_) return;
    const int allowed = std::max(1, std::min(samples, most_samples()));
    colour_ = make_layers(GL_RGBA8, allowed, width, height, eyes);
    depth_ = make_layers(GL_DEPTH32F_STENCIL8, allowed, width, height, eyes);
    finished_ = make_layers(GL_RGBA8, 1, width, height, eyes);
    check_memory("picture");
    all_ = make_framebuffer();
    glNamedFramebufferTexture(all_.get(), GL_COLOR_ATTACHMENT0, colour_.get(), 0);
    glNamedFramebufferTexture(all_.get(), GL_DEPTH_STENCIL_ATTACHMENT, depth_.get(), 0);
    check_framebuffer(all_.get(), "picture of both eyes");
    for (std::size_t eye = 0; eye < eyes; ++eye) {
        const auto layer = static_cast<GLint>(eye);
        layers_[eye] = make_framebuffer();
        glNamedFramebufferTextureLayer(layers_[eye].get(), GL_COLOR_ATTACHMENT0, colour_.get(), 0, layer);
        glNamedFramebufferTextureLayer(
            layers_[eye].get(), GL_DEPTH_STENCIL_ATTACHMENT, depth_.get(), 0, layer
        );
        pictures_[eye] = make_framebuffer();
        glNamedFramebufferTextureLayer(pictures_[eye].get(), GL_COLOR_ATTACHMENT0, finished_.get(), 0, layer);
        check_framebuffer(layers_[eye].get(), "picture of one eye");
        check_framebuffer(pictures_[eye].get(), "finished picture");
    }
    handed_over_ = make_framebuffer();
    nothing_ = make_vertex_array();
    depth_copier_ = make_depth_copier(allowed > 1);
    width_ = width;
    height_ = height;
    samples_ = samples;
    eyes_ = eyes;
}

void Targets::bind_all() const {
    glBindFramebuffer(GL_FRAMEBUFFER, all_.get());
    glViewport(0, 0, width_, height_);
}

void Targets::bind(std::size_t eye) const {
    glBindFramebuffer(GL_FRAMEBUFFER, layers_.at(eye).get());
    glViewport(0, 0, width_, height_);
}

void Targets::resolve(std::size_t eyes) const {
    for (std::size_t eye = 0; eye < eyes; ++eye) {
        glBlitNamedFramebuffer(
            layers_[eye].get(),
            pictures_[eye].get(),
            0,
            0,
            width_,
            height_,
            0,
            0,
            width_,
            height_,
            GL_COLOR_BUFFER_BIT,
            GL_NEAREST
        );
    }
}

void Targets::copy(std::size_t eye, const Target& target) const {
    GLuint to = target.framebuffer;
    if (target.texture != 0) {
        to = handed_over_.get();
        glNamedFramebufferTexture(to, GL_COLOR_ATTACHMENT0, target.texture, 0);
        check_framebuffer(to, "texture that was handed over");
    }
    // The bytes are sRGB already.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    const int low = target.is_top_first ? target.y + target.height : target.y;
    const int high = target.is_top_first ? target.y : target.y + target.height;
    const bool is_same = target.width == width_ && target.height == height_;
    glBlitNamedFramebuffer(
        pictures_.at(eye).get(),
        to,
        0,
        0,
        width_,
        height_,
        target.x,
        low,
        target.x + target.width,
        high,
        GL_COLOR_BUFFER_BIT,
        is_same ? GL_NEAREST : GL_LINEAR
    );
    if (target.texture != 0) glNamedFramebufferTexture(to, GL_COLOR_ATTACHMENT0, 0, 0);
    if (target.depth_texture != 0) copy_depth(eye, target.depth_texture);
}

/// A blit would need the same format on both sides, and ours holds a stencil too.
void Targets::copy_depth(std::size_t eye, GLuint texture) const {
    const GLuint to = handed_over_.get();
    glNamedFramebufferTexture(to, GL_DEPTH_ATTACHMENT, texture, 0);
    check_framebuffer(to, "depth that was handed over");
    glBindFramebuffer(GL_FRAMEBUFFER, to);
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glBindTextureUnit(0, depth_.get());
    depth_copier_.set("layer", static_cast<int>(eye));
    depth_copier_.use();
    glBindVertexArray(nothing_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glNamedFramebufferTexture(to, GL_DEPTH_ATTACHMENT, 0, 0);
}

Pixels Targets::read(std::size_t eye) const {
    Pixels out{width_, height_, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(width_);
    std::vector<std::uint8_t> upwards(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, pictures_.at(eye).get());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    out.rgb.resize(upwards.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
        const auto from =
            upwards.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height_) - 1 - y) * row);
        std::copy_n(from, row, out.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    return out;
}

}  // namespace feelem::viewer
