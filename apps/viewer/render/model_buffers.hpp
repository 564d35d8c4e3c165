// SPDX-License-Identifier: Apache-2.0
// The model on the graphics card: geometry once, a result's values and displacements in buffers of their own.
// All of it goes up in slices.
#pragma once

#include "viewer/render/gl_objects.hpp"
#include "viewer/render/renderer.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace feelem::viewer {

/// Bytes on their way to a buffer, in turn, at most so many at a time.
class UploadQueue {
public:
    /// Bytes that stay where they are until they are sent. `sent` is counted up.
    void add(GLuint buffer, std::span<const std::byte> bytes, std::uint64_t& sent);
    /// Bytes that are made now and kept until they are sent.
    void add(GLuint buffer, std::vector<std::byte> bytes, std::uint64_t& sent);
    /// Gives how many were sent.
    std::uint64_t send(std::uint64_t most);
    bool is_empty() const noexcept { return waiting_.empty(); }
    void clear() { waiting_.clear(); }

private:
    struct Slice {
        GLuint buffer = 0;
        std::vector<std::byte> own;
        std::span<const std::byte> bytes;
        std::uint64_t done = 0;
        std::uint64_t* sent = nullptr;
    };
    std::deque<Slice> waiting_;
};

class ModelBuffers {
public:
    ModelBuffers(const DrawnModel& model, std::size_t quantise_above, DrawCounts::Uploaded& uploaded);

    /// What the look needs is sent for, if it is not here or on its way.
    void want(const Look& look);
    /// At most so many bytes.
    void send(std::uint64_t most);

    bool has_geometry() const noexcept { return geometry_sent_; }
    bool has_field() const noexcept { return field_.is_here; }
    /// Displacement and its imaginary part, as the last look wants them.
    bool has_shape() const noexcept { return shape_.is_here && imaginary_.is_here; }
    bool is_complete() const noexcept;
    float position_error() const noexcept { return position_error_; }

    /// The list of triangles that is drawn: that of the level once it is here, else the last one.
    struct List {
        GLuint indices = 0;
        std::optional<std::size_t> level;  ///< Empty: the full one.
    };
    List list() const noexcept { return {lists_.at(drawn_).buffer.get(), drawn_}; }
    std::span<const std::array<std::uint32_t, 3>> triangles(std::optional<std::size_t> level) const {
        return lists_.at(level).triangles;
    }

    /// `eyes`: instances that are drawn of each triangle.
    GLuint skin(std::size_t eyes);
    GLuint edges() const noexcept { return edge_array_.get(); }
    GLuint edge_indices() const noexcept { return edge_index_.get(); }
    /// Sends displacements to the shader of edges; false: they are too many for this card.
    bool bind_moves(GLuint unit) const;
    /// Of the shown displacement, 3 a vertex; empty: none.
    std::span<const float> vectors() const noexcept { return vectors_; }
    std::span<const float> imaginary_vectors() const noexcept { return imaginary_vectors_; }
    /// Counts up when the vectors change.
    std::uint64_t shape_version() const noexcept { return shape_version_; }

private:
    struct Sent {
        std::optional<FieldChoice> choice;
        bool is_here = true;
    };
    struct IndexList {
        Buffer buffer;
        bool is_here = false;
        std::vector<std::array<std::uint32_t, 3>> triangles;  ///< In the order that they are drawn in.
    };
    void make_skin_array();
    void make_edge_array();
    std::vector<std::byte> part_boxes() const;
    std::vector<std::byte> quantised() const;
    void want_field(const std::optional<FieldChoice>& field);
    void want_vectors(
        Sent& sent, const std::optional<FieldChoice>& wanted, Buffer& buffer, std::span<const float>& vectors
    );
    void want_level(const std::optional<std::size_t>& level);
    void mark_arrived();

    DrawnModel model_;
    DrawCounts::Uploaded& uploaded_;
    std::size_t vertices_ = 0;
    bool is_quantised_ = false;
    float position_error_ = 0;
    bool geometry_sent_ = false;
    Buffer positions_, normals_, values_, missing_, moves_, moves_im_, parts_;
    Buffer edge_positions_, edge_vertices_, edge_index_;
    VertexArray skin_array_, edge_array_;
    Texture moves_texture_, moves_im_texture_;
    std::map<std::optional<std::size_t>, IndexList> lists_;
    std::optional<std::size_t> drawn_, wanted_;
    Sent field_, shape_, imaginary_;
    std::span<const float> vectors_, imaginary_vectors_;
    std::uint64_t shape_version_ = 0;
    UploadQueue geometry_queue_, field_queue_, shape_queue_, level_queue_;
};

}  // namespace feelem::viewer
