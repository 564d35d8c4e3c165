// SPDX-License-Identifier: Apache-2.0
// Draws the model as a look says: skin, clear parts, edges, ghost.
#pragma once

#include "viewer/render/clusters.hpp"
#include "viewer/render/colouring.hpp"
#include "viewer/render/model_buffers.hpp"
#include "viewer/render/programs.hpp"
#include "viewer/render/visible.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// Runs what draws once for each pass over the eyes: once in all, or once an eye.
struct EyePasses {
    StereoPath path = StereoPath::VertexLayer;
    std::size_t eyes = 1;
    GLsizei instances() const { return path == StereoPath::TwoPass ? 1 : static_cast<GLsizei>(eyes); }
};

struct ModelDrawing {
    const Look* look = nullptr;
    std::span<const Camera> eyes;
    int height = 0;  ///< Pixels.
    EyePasses passes;
    bool is_culled = true;
};

struct ModelPrograms {
    Program skin, edges, caps;
    /// Says the eye to all of them, where each eye has a pass of its own.
    void set_eye(int eye) const;
};
ModelPrograms make_model_programs(StereoPath path);

/// Pairs of places.
struct GhostLines {
    Buffer positions;
    VertexArray array;
    std::vector<GLint> first;  ///< Of the ends of each part, and one past the last.
};

class ModelDrawer {
public:
    ModelDrawer(const DrawnModel& model, const RendererOptions& options, DrawCounts& counts);

    /// Sends what the look needs; then, what is worked out once a frame.
    void prepare(const ModelDrawing& drawing, std::uint64_t most_bytes);
    /// Into the framebuffer that is bound.
    void draw(const ModelDrawing& drawing, const ModelPrograms& programs);

    const ModelBuffers& buffers() const noexcept { return buffers_; }

private:
    struct Moves {
        std::uint64_t version = ~std::uint64_t{0};
        std::vector<ClusterMove> real, imaginary;
    };
    struct ClusterList {
        std::vector<Cluster> clusters;
        Moves moves;
    };
    ClusterList& clusters_of(std::optional<std::size_t> level);
    bool can_hide_backs(const ModelDrawing& drawing, std::span<const SeenFrom> eyes);
    bool is_closed(const Look& look);
    bool can_fill_cuts(const Look& look);
    void send_commands();
    void draw_range(std::size_t first, const Visible& visible, EyePasses passes);
    void set_shape(const Program& program, float factor, float factor_im) const;
    void set_cuts(const Program& program, const Look& look) const;
    void draw_skin(const ModelDrawing& drawing, const Program& skin);
    void draw_caps(const ModelDrawing& drawing, const ModelPrograms& programs);
    void draw_cap(const ModelDrawing& drawing, const ModelPrograms& programs, std::size_t plane);
    void draw_edges(const ModelDrawing& drawing, const Program& edges);
    void draw_ghost(const ModelDrawing& drawing, const Program& edges);
    void make_ghost();
    float edge_opacity(const ModelDrawing& drawing) const;

    DrawnModel model_;
    DrawCounts& counts_;
    ModelBuffers buffers_;
    Palette palette_;
    std::map<std::optional<std::size_t>, ClusterList> lists_;
    std::vector<std::uint64_t> open_edges_;  ///< Per part; empty: not asked yet.
    float diagonal_ = 1, typical_edge_ = 0;
    float factor_ = 0, factor_im_ = 0;
    bool is_coloured_ = false, hides_backs_ = false, fills_cuts_ = false;
    Visible shown_, clear_, cut_;  ///< `cut_`: of solids, what may be cut.
    std::vector<SeenFrom> eyes_;
    VertexArray nothing_;
    Buffer commands_;
    std::size_t command_room_ = 0;
    std::optional<GhostLines> ghost_;
};

}  // namespace feelem::viewer
