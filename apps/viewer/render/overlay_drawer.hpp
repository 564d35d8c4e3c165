// SPDX-License-Identifier: Apache-2.0
// Draws what stands in the room besides the model: floor, marks, labels, panels.
#pragma once

#include "viewer/render/glyphs.hpp"
#include "viewer/render/model_drawer.hpp"
#include "viewer/render/programs.hpp"

#include <optional>
#include <vector>

namespace feelem::viewer {

class OverlayDrawer {
public:
    explicit OverlayDrawer(StereoPath path);

    /// Sends this frame's marks and letters.
    void prepare(const DrawInput& input);
    /// Sets the eye that is drawn, where each has a pass of its own.
    void set_eye(int eye) const;
    void draw_floor(const DrawInput& input, GLsizei instances, DrawCounts& counts) const;
    void draw_panels(const DrawInput& input, GLsizei instances, DrawCounts& counts) const;
    void draw_marks(GLsizei instances, DrawCounts& counts) const;

private:
    /// A growing buffer of vertices that is filled anew each frame.
    struct Stream {
        Buffer buffer;
        VertexArray array;
        std::size_t room = 0;
        GLsizei count = 0;
        void send(std::span<const std::byte> bytes, std::size_t stride);
    };
    void make_arrays();

    Program marks_, labels_, panels_, floor_;
    GlyphAtlas atlas_;
    Stream mark_stream_, label_stream_;
    VertexArray nothing_;
    Sampler panel_sampler_;
};

}  // namespace feelem::viewer
