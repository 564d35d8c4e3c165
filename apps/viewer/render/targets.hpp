// SPDX-License-Identifier: Apache-2.0
// What both eyes are drawn into: antialiased colour and depth, two layers, and the finished pictures.
#pragma once

#include "viewer/render/gl_objects.hpp"
#include "viewer/render/renderer.hpp"

#include <array>

namespace feelem::viewer {

class Targets {
public:
    /// Makes room where the size has changed.
    void resize(int width, int height, int samples, std::size_t eyes);
    /// Both layers at once, or one.
    void bind_all() const;
    void bind(std::size_t eye) const;
    /// Antialiased -> finished.
    void resolve(std::size_t eyes) const;
    void copy(std::size_t eye, const Target& target) const;
    Pixels read(std::size_t eye) const;

private:
    void copy_depth(std::size_t eye, GLuint texture) const;

    int width_ = 0, height_ = 0, samples_ = 0;
    std::size_t eyes_ = 0;
    Texture colour_, depth_, finished_;
    Framebuffer all_;
    std::array<Framebuffer, 2> layers_, pictures_;
    Framebuffer handed_over_;  ///< For a texture of somebody else.
    Program depth_copier_;
    VertexArray nothing_;
};

}  // namespace feelem::viewer
