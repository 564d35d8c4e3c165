// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/model_buffers.hpp"

#include "viewer/render/clusters.hpp"
#include "viewer/render/shaders.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace feelem::viewer {
namespace {

template <typename T>
std::span<const std::byte> bytes_of(const std::vector<T>& all) {
    return std::as_bytes(std::span(all));
}

template <typename T>
std::vector<std::byte> copied(std::span<const T> all) {
    const auto bytes = std::as_bytes(all);
    return {bytes.begin(), bytes.end()};
}

/// -1..1 as a signed number of ten bits.
std::uint32_t ten_bits(float number) {
    const float held = std::isfinite(number) ? std::clamp(number, -1.0F, 1.0F) : 0;
    return static_cast<std::uint32_t>(std::lround(511 * held)) & 0x3FFU;
}

std::vector<std::byte> packed_normals(const std::vector<std::array<float, 3>>& normals) {
    std::vector<std::uint32_t> out;
    out.reserve(normals.size());
    for (const auto& [x, y, z] : normals) out.push_back(ten_bits(x) | ten_bits(y) << 10 | ten_bits(z) << 20);
    return copied(std::span<const std::uint32_t>(out));
}

constexpr float kSteps = 65535;  ///< Of a place with 16 bits a coordinate.

struct PartBox {
    std::array<float, 3> low{};
    float solid = 0;
    std::array<float, 3> size{1, 1, 1};
    float unused = 0;
};

PartBox box_of(const Geometry& geometry, const PartRange& part) {
    PartBox box;
    if (part.vertices == 0) return box;
    box.low = geometry.positions[part.first_vertex];
    std::array<float, 3> high = box.low;
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = std::min(box.low[k], geometry.positions[v][k]);
            high[k] = std::max(high[k], geometry.positions[v][k]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) box.size[k] = high[k] - box.low[k];
    return box;
}

void connect(GLuint array, GLuint binding, GLuint attribute, GLint size, GLenum type, bool is_normalised) {
    glEnableVertexArrayAttrib(array, attribute);
    glVertexArrayAttribFormat(array, attribute, size, type, is_normalised ? GL_TRUE : GL_FALSE, 0);
    glVertexArrayAttribBinding(array, attribute, binding);
}

}  // namespace

void UploadQueue::add(GLuint buffer, std::span<const std::byte> bytes, std::uint64_t& sent) {
    if (!bytes.empty()) waiting_.push_back({buffer, {}, bytes, 0, &sent});
}

void UploadQueue::add(GLuint buffer, std::vector<std::byte> bytes, std::uint64_t& sent) {
    if (bytes.empty()) return;
    waiting_.push_back({buffer, std::move(bytes), {}, 0, &sent});
    waiting_.back().bytes = waiting_.back().own;
}

std::uint64_t UploadQueue::send(std::uint64_t most) {
    std::uint64_t left = most;
    while (!waiting_.empty() && left > 0) {
        Slice& slice = waiting_.front();
        const std::uint64_t now = std::min<std::uint64_t>(left, slice.bytes.size() - slice.done);
        glNamedBufferSubData(
            slice.buffer,
            static_cast<GLintptr>(slice.done),
            static_cast<GLsizeiptr>(now),
            slice.bytes.data() + slice.done
        );
        slice.done += now;
        *slice.sent += now;
        left -= now;
        if (slice.done == slice.bytes.size()) waiting_.pop_front();
    }
    return most - left;
}

ModelBuffers::ModelBuffers(
    const DrawnModel& model, std::size_t quantise_above, DrawCounts::Uploaded& uploaded
)
    : model_(model), uploaded_(uploaded) {
    const Geometry& geometry = *model_.geometry;
    vertices_ = geometry.positions.size();
    is_quantised_ = vertices_ > quantise_above;
    if (geometry.normals.size() != vertices_)
        throw Error(
            Code::BadScene,
            "OpenGL",
            fmt::format("{} normals for {} vertices", geometry.normals.size(), vertices_)
        );
    const auto part_bytes = part_boxes();
    parts_ = make_buffer(std::span<const std::byte>(part_bytes), "parts");
    if (is_quantised_) {
        positions_ = make_buffer(8 * vertices_, "places");
        geometry_queue_.add(positions_.get(), quantised(), uploaded_.geometry);
    } else {
        positions_ = make_buffer(12 * vertices_, "places");
        geometry_queue_.add(positions_.get(), bytes_of(geometry.positions), uploaded_.geometry);
    }
    normals_ = make_buffer(4 * vertices_, "normals");
    geometry_queue_.add(normals_.get(), packed_normals(geometry.normals), uploaded_.geometry);
    values_ = make_buffer(4 * vertices_, "values");
    missing_ = make_buffer(vertices_, "marks of missing values");
    IndexList& full = lists_[std::nullopt];
    full.triangles = clustered_order(geometry, geometry.triangles);
    full.buffer = make_buffer(12 * full.triangles.size(), "triangles");
    geometry_queue_.add(full.buffer.get(), bytes_of(full.triangles), uploaded_.geometry);
    make_skin_array();
    make_edge_array();
}

std::vector<std::byte> ModelBuffers::part_boxes() const {
    const Geometry& geometry = *model_.geometry;
    std::vector<PartBox> boxes;
    for (std::size_t p = 0; p < geometry.parts.size(); ++p) {
        PartBox box;
        if (is_quantised_) box = box_of(geometry, geometry.parts[p]);
        box.solid = p < model_.solid.size() && model_.solid[p] ? 1 : 0;
        boxes.push_back(box);
    }
    return copied(std::span<const PartBox>(boxes));
}

std::vector<std::byte> ModelBuffers::quantised() const {
    const Geometry& geometry = *model_.geometry;
    std::vector<std::array<std::uint16_t, 4>> out(vertices_);
    for (const PartRange& part : geometry.parts) {
        const PartBox box = box_of(geometry, part);
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                const float along =
                    box.size[k] > 0 ? (geometry.positions[v][k] - box.low[k]) / box.size[k] : 0;
                out[v][k] = static_cast<std::uint16_t>(std::lround(kSteps * std::clamp(along, 0.0F, 1.0F)));
            }
        }
    }
    return copied(std::span<const std::array<std::uint16_t, 4>>(out));
}

void ModelBuffers::make_skin_array() {
    skin_array_ = make_vertex_array();
    const GLuint array = skin_array_.get();
    const auto feed = [&](GLuint binding, const Buffer& buffer, GLsizei stride) {
        glVertexArrayVertexBuffer(array, binding, buffer.get(), 0, stride);
    };
    feed(kPosition, positions_, is_quantised_ ? 8 : 12);
    connect(array, kPosition, kPosition, 3, is_quantised_ ? GL_UNSIGNED_SHORT : GL_FLOAT, is_quantised_);
    feed(kNormal, normals_, 4);
    connect(array, kNormal, kNormal, 4, GL_INT_2_10_10_10_REV, true);
    feed(kValue, values_, 4);
    connect(array, kValue, kValue, 1, GL_FLOAT, false);
    feed(kMissing, missing_, 1);
    connect(array, kMissing, kMissing, 1, GL_UNSIGNED_BYTE, true);
    feed(kPartLow, parts_, sizeof(PartBox));
    connect(array, kPartLow, kPartLow, 4, GL_FLOAT, false);
    connect(array, kPartLow, kPartSize, 4, GL_FLOAT, false);
    glVertexArrayAttribFormat(array, kPartSize, 4, GL_FLOAT, GL_FALSE, 16);
    if (is_quantised_) {
        const Geometry& geometry = *model_.geometry;
        for (const PartRange& part : geometry.parts) {
            const PartBox box = box_of(geometry, part);
            const float diagonal = std::hypot(box.size[0], box.size[1], box.size[2]);
            // Half a step, and what the shader's float32 rounds.
            position_error_ = std::max(position_error_, diagonal * (0.5F / kSteps + 2.0e-7F));
        }
    }
}

void ModelBuffers::make_edge_array() {
    const Geometry& geometry = *model_.geometry;
    if (geometry.edges.empty()) return;
    edge_positions_ = make_buffer(12 * geometry.edge_positions.size(), "edges");
    edge_vertices_ = make_buffer(4 * geometry.edge_vertices.size(), "edges");
    edge_index_ = make_buffer(8 * geometry.edges.size(), "edges");
    geometry_queue_.add(edge_positions_.get(), bytes_of(geometry.edge_positions), uploaded_.geometry);
    geometry_queue_.add(edge_vertices_.get(), bytes_of(geometry.edge_vertices), uploaded_.geometry);
    geometry_queue_.add(edge_index_.get(), bytes_of(geometry.edges), uploaded_.geometry);
    moves_texture_ = make_texture(GL_TEXTURE_BUFFER);
    moves_im_texture_ = make_texture(GL_TEXTURE_BUFFER);
    edge_array_ = make_vertex_array();
    const GLuint array = edge_array_.get();
    glVertexArrayVertexBuffer(array, 0, edge_positions_.get(), 0, 12);
    connect(array, 0, kPosition, 3, GL_FLOAT, false);
    glVertexArrayVertexBuffer(array, 1, edge_vertices_.get(), 0, 4);
    glEnableVertexArrayAttrib(array, kMovedWith);
    glVertexArrayAttribIFormat(array, kMovedWith, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(array, kMovedWith, 1);
    glVertexArrayElementBuffer(array, edge_index_.get());
}

void ModelBuffers::want(const Look& look) {
    want_field(look.field);
    want_vectors(shape_, look.shape ? std::optional(look.shape->field) : std::nullopt, moves_, vectors_);
    want_vectors(
        imaginary_, look.shape ? look.shape->imaginary : std::nullopt, moves_im_, imaginary_vectors_
    );
    want_level(look.level);
}

void ModelBuffers::want_field(const std::optional<FieldChoice>& field) {
    if (field == field_.choice) return;
    // A field that was asked for is kept when none is asked for: it may come back.
    if (!field) return;
    const FieldValues& all = model_.values(field->result, field->values);
    if (field->component >= all.components || all.values.size() != vertices_ * all.components)
        throw Error(Code::BadScene, "OpenGL", "a result has not a value a vertex, or not that component");
    std::vector<float> values(vertices_);
    std::vector<std::uint8_t> missing(vertices_);
    for (std::size_t v = 0; v < vertices_; ++v) {
        const float value = all.values[v * all.components + field->component];
        const bool is_missing = all.validity[v] == Validity::Missing || !std::isfinite(value);
        values[v] = is_missing ? 0 : value;
        missing[v] = is_missing ? 255 : 0;
    }
    field_queue_.clear();
    field_queue_.add(values_.get(), copied(std::span<const float>(values)), uploaded_.field);
    field_queue_.add(missing_.get(), copied(std::span<const std::uint8_t>(missing)), uploaded_.field);
    field_ = {field, field_queue_.is_empty()};
}

void ModelBuffers::want_vectors(
    Sent& sent, const std::optional<FieldChoice>& wanted, Buffer& buffer, std::span<const float>& vectors
) {
    const auto is_same = [](const FieldChoice& a, const FieldChoice& b) {
        return a.result == b.result && a.values == b.values;
    };
    if (!wanted || (sent.choice && is_same(*sent.choice, *wanted))) return;
    const FieldValues& all = model_.values(wanted->result, wanted->values);
    if (all.components != 3 || all.values.size() != 3 * vertices_)
        throw Error(Code::BadScene, "OpenGL", "a displacement has not three components a vertex");
    if (!buffer) buffer = make_buffer(12 * vertices_, "displacements");
    std::vector<float> moves(all.values);
    for (float& number : moves)
        if (!std::isfinite(number)) number = 0;
    shape_queue_.add(buffer.get(), copied(std::span<const float>(moves)), uploaded_.displacement);
    vectors = all.values;
    ++shape_version_;
    sent = {wanted, shape_queue_.is_empty()};
}

void ModelBuffers::want_level(const std::optional<std::size_t>& level) {
    if (level == wanted_) return;
    wanted_ = level;
    const auto [at, is_new] = lists_.try_emplace(level);
    IndexList& list = at->second;
    if (is_new) {
        list.triangles = clustered_order(*model_.geometry, model_.level(level.value_or(0)));
        list.buffer = make_buffer(12 * list.triangles.size(), "triangles of a level");
        level_queue_.add(list.buffer.get(), bytes_of(list.triangles), uploaded_.level);
    }
    if (list.is_here) drawn_ = level;
}

void ModelBuffers::send(std::uint64_t most) {
    for (UploadQueue* queue : {&geometry_queue_, &shape_queue_, &field_queue_, &level_queue_})
        most -= queue->send(most);
    mark_arrived();
}

void ModelBuffers::mark_arrived() {
    if (geometry_queue_.is_empty()) {
        geometry_sent_ = true;
        lists_[std::nullopt].is_here = true;
    }
    if (shape_queue_.is_empty()) shape_.is_here = imaginary_.is_here = true;
    if (field_queue_.is_empty()) field_.is_here = true;
    if (!level_queue_.is_empty()) return;
    for (auto& [level, list] : lists_)
        if (level) list.is_here = true;
    if (lists_[wanted_].is_here) drawn_ = wanted_;
}

bool ModelBuffers::is_complete() const noexcept {
    return geometry_queue_.is_empty() && shape_queue_.is_empty() && field_queue_.is_empty() &&
           level_queue_.is_empty();
}

GLuint ModelBuffers::skin(std::size_t eyes) {
    const GLuint array = skin_array_.get();
    glVertexArrayBindingDivisor(array, kPartLow, static_cast<GLuint>(eyes));
    glVertexArrayElementBuffer(array, lists_.at(drawn_).buffer.get());
    const auto move = [&](GLuint attribute, const Buffer& buffer) {
        if (!buffer) return glDisableVertexArrayAttrib(array, attribute);
        glVertexArrayVertexBuffer(array, attribute, buffer.get(), 0, 12);
        connect(array, attribute, attribute, 3, GL_FLOAT, false);
    };
    move(kDisplacement, moves_);
    move(kDisplacementIm, moves_im_);
    return array;
}

bool ModelBuffers::bind_moves(GLuint unit) const {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (3 * vertices_ > static_cast<std::size_t>(most)) return false;
    const auto bind = [](const Texture& texture, const Buffer& buffer, GLuint at) {
        if (!buffer) return;
        glTextureBuffer(texture.get(), GL_R32F, buffer.get());
        glBindTextureUnit(at, texture.get());
    };
    bind(moves_texture_, moves_, unit);
    bind(moves_im_texture_, moves_im_, unit + 1);
    return true;
}

}  // namespace feelem::viewer
