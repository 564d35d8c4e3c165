// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/overlay_drawer.hpp"

#include "viewer/render/shaders.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstddef>

namespace feelem::viewer {
namespace {

constexpr GLuint kTextureUnit = 0;
constexpr std::array<float, 4> kPlate{0.055F, 0.067F, 0.078F, 0.82F};
/// Round a text, font units.
constexpr glm::vec2 kPlateMargin(5, 4);
constexpr float kHiddenStrength = 0.25F;  ///< Of what stands behind something.

struct MarkVertex {
    glm::vec3 begin, end;
    glm::vec2 corner;
    std::array<float, 4> tint{};
    glm::vec2 kind_size;
};

struct LabelVertex {
    glm::vec3 anchor;
    glm::vec2 offset, texel;
    std::array<float, 4> tint{};
    glm::vec3 plate{0};
    float height = 0;
};

constexpr std::array<std::array<int, 2>, 6> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};

std::array<float, 4> tint_of(const Rgb& colour) {
    const auto share = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; };
    return {share(colour[0]), share(colour[1]), share(colour[2]), 1};
}

void add_mark(const Mark& mark, std::vector<MarkVertex>& out) {
    for (const auto& [x, y] : kCorners) {
        const glm::vec2 corner(2 * x - 1, 2 * y - 1);
        out.push_back(
            {mark.from, mark.to, corner, tint_of(mark.colour), {static_cast<float>(mark.kind), mark.size}}
        );
    }
}

/// The middle of the text is at its place: plate first, then letters.
void add_label(const Label& label, const PlacedText& text, std::vector<LabelVertex>& out) {
    const glm::vec2 half(text.width / 2 + kPlateMargin.x, kCapitalUnits / 2 + kPlateMargin.y);
    const float baseline = -kCapitalUnits / 2;
    const glm::vec2 reach = half + 0.5F;
    for (const auto& [x, y] : kCorners) {
        const glm::vec2 corner = reach * glm::vec2(2 * x - 1, 2 * y - 1);
        out.push_back({label.place, corner, corner, kPlate, {half.x, half.y, 1}, label.height});
    }
    for (const PlacedGlyph& glyph : text.glyphs) {
        for (const auto& [x, y] : kCorners) {
            const glm::vec2 offset(
                x ? glyph.high.x : glyph.low.x, (y ? glyph.high.y : glyph.low.y) + baseline
            );
            const glm::vec2 texel(
                x ? glyph.high_texel.x : glyph.low_texel.x, y ? glyph.high_texel.y : glyph.low_texel.y
            );
            out.push_back({label.place, offset, texel, tint_of(label.colour), {0, 0, 0}, label.height});
        }
    }
}

void feed(GLuint array, GLuint attribute, GLint size, std::size_t offset) {
    glEnableVertexArrayAttrib(array, attribute);
    glVertexArrayAttribFormat(array, attribute, size, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, attribute, 0);
}

/// Between the eyes, and what is up; of the first eye's picture how large a pixel is a metre away.
void set_person(const Program& program, const DrawInput& input) {
    glm::vec3 person(0);
    for (const Camera& eye : input.eyes) person += glm::vec3(glm::inverse(eye.view)[3]);
    person /= static_cast<float>(input.eyes.size());
    glProgramUniform3fv(program.get(), program.at("person"), 1, glm::value_ptr(person));
    const bool is_screen = input.eyes.size() == 1;
    const glm::mat4 to_world = glm::inverse(input.eyes[0].view);
    const glm::vec3 up = is_screen ? glm::vec3(to_world[1]) : glm::vec3(0, 1, 0);
    const glm::vec3 screen = is_screen ? glm::vec3(to_world[2]) : glm::vec3(0);
    glProgramUniform3fv(program.get(), program.at("up"), 1, glm::value_ptr(up));
    glProgramUniform3fv(program.get(), program.at("screen"), 1, glm::value_ptr(screen));
    program.set(
        "pixel", 2 / (input.eyes[0].projection[1][1] * static_cast<float>(std::max(input.height, 1)))
    );
}

}  // namespace

void OverlayDrawer::Stream::send(std::span<const std::byte> bytes, std::size_t stride) {
    count = static_cast<GLsizei>(bytes.size() / stride);
    if (bytes.empty()) return;
    if (bytes.size() > room) {
        room = 2 * bytes.size();
        buffer = make_buffer(room, "marks and labels");
        glVertexArrayVertexBuffer(array.get(), 0, buffer.get(), 0, static_cast<GLsizei>(stride));
    }
    glNamedBufferSubData(buffer.get(), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

OverlayDrawer::OverlayDrawer(StereoPath path)
    : marks_(make_program(mark_text(), path)), labels_(make_program(label_text(), path)),
      panels_(make_program(panel_text(), path)), floor_(make_program(floor_text(), path)),
      nothing_(make_vertex_array()), panel_sampler_(make_sampler()) {
    make_arrays();
    const GLuint sampler = panel_sampler_.get();
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    // Bytes go through as they are, also of an sRGB texture.
    if (epoxy_has_gl_extension("GL_EXT_texture_sRGB_decode"))
        glSamplerParameteri(sampler, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
}

void OverlayDrawer::make_arrays() {
    mark_stream_.array = make_vertex_array();
    const GLuint marks = mark_stream_.array.get();
    feed(marks, 0, 3, offsetof(MarkVertex, begin));
    feed(marks, 1, 3, offsetof(MarkVertex, end));
    feed(marks, 2, 2, offsetof(MarkVertex, corner));
    feed(marks, 3, 4, offsetof(MarkVertex, tint));
    feed(marks, 4, 2, offsetof(MarkVertex, kind_size));
    label_stream_.array = make_vertex_array();
    const GLuint labels = label_stream_.array.get();
    feed(labels, 0, 3, offsetof(LabelVertex, anchor));
    feed(labels, 1, 2, offsetof(LabelVertex, offset));
    feed(labels, 2, 2, offsetof(LabelVertex, texel));
    feed(labels, 3, 4, offsetof(LabelVertex, tint));
    feed(labels, 4, 3, offsetof(LabelVertex, plate));
    feed(labels, 5, 1, offsetof(LabelVertex, height));
}

void OverlayDrawer::prepare(const DrawInput& input) {
    std::vector<MarkVertex> marks;
    for (const Mark& mark : input.marks) add_mark(mark, marks);
    mark_stream_.send(std::as_bytes(std::span(marks)), sizeof(MarkVertex));
    // The nearer one lies over the farther one.
    std::vector<const Label*> order;
    for (const Label& label : input.labels) order.push_back(&label);
    const glm::vec3 eye(glm::inverse(input.eyes[0].view)[3]);
    std::ranges::stable_sort(order, std::greater<>{}, [&](const Label* label) {
        return glm::distance(eye, label->place);
    });
    std::vector<LabelVertex> letters;
    for (const Label* label : order) add_label(*label, atlas_.place(label->text), letters);
    label_stream_.send(std::as_bytes(std::span(letters)), sizeof(LabelVertex));
    set_person(marks_, input);
    set_person(labels_, input);
}

void OverlayDrawer::set_eye(int eye) const {
    for (const Program* program : {&marks_, &labels_, &panels_, &floor_}) program->set("only_eye", eye);
}

void OverlayDrawer::draw_floor(const DrawInput& input, GLsizei instances, DrawCounts& counts) const {
    if (!input.floor) return;
    floor_.set("level", *input.floor);
    floor_.use();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(nothing_.get());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    ++counts.draw_calls;
}

void OverlayDrawer::draw_panels(const DrawInput& input, GLsizei instances, DrawCounts& counts) const {
    if (input.panels.empty()) return;
    panels_.use();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindSampler(kTextureUnit, panel_sampler_.get());
    glBindVertexArray(nothing_.get());
    for (const Panel& panel : input.panels) {
        const glm::mat4 world = matrix_of(panel.pose);
        glProgramUniformMatrix4fv(
            panels_.get(), panels_.at("world_from_panel"), 1, GL_FALSE, glm::value_ptr(world)
        );
        glProgramUniform2f(panels_.get(), panels_.at("size"), panel.size.x, panel.size.y);
        panels_.set("top_first", panel.is_top_first ? 1 : 0);
        glBindTextureUnit(kTextureUnit, panel.texture);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
        ++counts.draw_calls;
    }
    glBindSampler(kTextureUnit, 0);
    glDisable(GL_BLEND);
}

void OverlayDrawer::draw_marks(GLsizei instances, DrawCounts& counts) const {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const auto draw = [&](const Program& program, const Stream& stream) {
        if (stream.count == 0) return;
        program.use();
        glBindVertexArray(stream.array.get());
        // Faintly through what hides it, then plainly.
        for (const bool is_hidden : {true, false}) {
            glDepthFunc(is_hidden ? GL_GREATER : GL_LEQUAL);
            program.set("strength", is_hidden ? kHiddenStrength : 1.0F);
            glDrawArraysInstanced(GL_TRIANGLES, 0, stream.count, instances);
            ++counts.draw_calls;
        }
    };
    draw(marks_, mark_stream_);
    glBindTextureUnit(kTextureUnit, atlas_.texture());
    draw(labels_, label_stream_);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glBindVertexArray(0);
}

}  // namespace feelem::viewer
