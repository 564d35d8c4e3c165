// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/model_drawer.hpp"

#include "viewer/render/feature_edges.hpp"
#include "viewer/render/shaders.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kClearOpacity = 0.22F;
constexpr GLuint kPaletteUnit = 0, kMovesUnit = 1;

glm::vec3 vec_of(const std::array<float, 3>& p) {
    return {p[0], p[1], p[2]};
}

bool has_clear(const Look& look) {
    return std::ranges::find(look.parts, PartLook::Clear) != look.parts.end();
}

}  // namespace

ModelDrawer::ModelDrawer(const DrawnModel& model, const RendererOptions& options, DrawCounts& counts)
    : model_(model), counts_(counts), buffers_(model, options.quantise_above, counts.uploaded) {
    const Geometry& geometry = *model_.geometry;
    const float diagonal = glm::distance(vec_of(geometry.low), vec_of(geometry.high));
    if (diagonal > 0) diagonal_ = diagonal;
    typical_edge_ = typical_edge(geometry);
    nothing_ = make_vertex_array();
}

ModelPrograms make_model_programs(StereoPath path) {
    return {make_program(skin_text(), path), make_program(edge_text(), path), make_program(cap_text(), path)};
}

void ModelPrograms::set_eye(int eye) const {
    for (const Program* program : {&skin, &edges, &caps}) program->set("only_eye", eye);
}

ModelDrawer::ClusterList& ModelDrawer::clusters_of(std::optional<std::size_t> level) {
    const auto [at, is_new] = lists_.try_emplace(level);
    ClusterList& list = at->second;
    const auto triangles = buffers_.triangles(level);
    if (is_new) list.clusters = make_clusters(*model_.geometry, triangles);
    if (list.moves.version != buffers_.shape_version()) {
        const auto moves_of = [&](std::span<const float> vectors) {
            return vectors.empty() ? std::vector<ClusterMove>{}
                                   : cluster_moves(triangles, list.clusters, vectors);
        };
        list.moves.real = moves_of(buffers_.vectors());
        list.moves.imaginary = moves_of(buffers_.imaginary_vectors());
        list.moves.version = buffers_.shape_version();
    }
    return list;
}

bool ModelDrawer::can_hide_backs(const ModelDrawing& drawing, std::span<const SeenFrom> eyes) {
    const Look& look = *drawing.look;
    const bool is_whole =
        std::ranges::all_of(look.parts, [](PartLook part) { return part == PartLook::Shown; });
    if (!is_whole || !look.cuts.empty() || factor_ != 0 || factor_im_ != 0 || buffers_.list().level)
        return false;
    const bool is_solid = std::ranges::all_of(model_.solid, [](bool solid) { return solid; });
    if (!is_solid || model_.solid.size() < model_.geometry->parts.size() || !is_closed(look)) return false;
    // From within, the backs are what one sees.
    const float margin = 0.02F * diagonal_;
    return std::ranges::none_of(eyes, [&](const SeenFrom& eye) {
        const glm::vec3 low = vec_of(model_.geometry->low) - margin,
                        high = vec_of(model_.geometry->high) + margin;
        return glm::all(glm::greaterThan(eye.eye, low)) && glm::all(glm::lessThan(eye.eye, high));
    });
}

/// The solids that are shown enclose volumes, all together.
bool ModelDrawer::is_closed(const Look& look) {
    if (open_edges_.empty()) open_edges_ = open_edges(*model_.geometry);
    std::uint64_t sum = 0;
    for (std::uint32_t p = 0; p < open_edges_.size(); ++p)
        if (is_solid(model_.solid, p) && look_of(look.parts, p) == PartLook::Shown) sum += open_edges_[p];
    return sum == 0;
}

bool ModelDrawer::can_fill_cuts(const Look& look) {
    // A reduced level keeps its rims, but nobody has counted them.
    return !look.cuts.empty() && !buffers_.list().level && is_closed(look);
}

void ModelDrawer::prepare(const ModelDrawing& drawing, std::uint64_t most_bytes) {
    const Look& look = *drawing.look;
    buffers_.want(look);
    buffers_.send(most_bytes);
    if (!buffers_.has_geometry()) return;
    const bool is_moved = look.shape && buffers_.has_shape();
    factor_ = is_moved ? look.shape->factor : 0;
    factor_im_ = is_moved && look.shape->imaginary ? look.shape->imaginary_factor : 0;
    is_coloured_ = look.field && buffers_.has_field();
    if (is_coloured_) palette_.set(look.colour);
    eyes_.clear();
    for (const Camera& eye : drawing.eyes) {
        const glm::mat4 model = eye.view * look.model_to_world;
        eyes_.push_back(seen_from(eye.projection * model, model));
    }
    hides_backs_ = can_hide_backs(drawing, eyes_);
    fills_cuts_ = can_fill_cuts(look);
    const ClusterList& list = clusters_of(buffers_.list().level);
    VisibleQuestion question{
        .clusters = list.clusters,
        .moves = list.moves.real,
        .moves_im = list.moves.imaginary,
        .factor = factor_,
        .factor_im = factor_im_,
        .eyes = eyes_,
        .parts = look.parts,
        .wanted = PartLook::Shown,
        .is_culled = drawing.is_culled,
        .hides_backs = hides_backs_,
        .instances = static_cast<std::uint32_t>(drawing.passes.instances()),
    };
    shown_ = find_visible(question);
    question.wanted = PartLook::Clear;
    clear_ = has_clear(look) ? find_visible(question) : Visible{};
    question.wanted = PartLook::Shown;
    question.solid = &model_.solid;
    cut_ = fills_cuts_ ? find_visible(question) : Visible{};
    send_commands();
    counts_.triangles = shown_.triangles + clear_.triangles;
    counts_.clusters = shown_.clusters + clear_.clusters;
    counts_.clusters_culled = shown_.culled + clear_.culled;
    if (look.ghost && !ghost_) make_ghost();
}

/// One after the other: what is shown, what is clear, what is cut.
void ModelDrawer::send_commands() {
    std::vector<DrawCommand> all(shown_.commands);
    for (const Visible* visible : {&clear_, &cut_})
        all.insert(all.end(), visible->commands.begin(), visible->commands.end());
    if (all.empty()) return;
    if (all.size() > command_room_) {
        command_room_ = 2 * all.size();
        commands_ = make_buffer(command_room_ * sizeof(DrawCommand), "commands");
    }
    glNamedBufferSubData(
        commands_.get(), 0, static_cast<GLsizeiptr>(all.size() * sizeof(DrawCommand)), all.data()
    );
}

void ModelDrawer::draw_range(std::size_t first, const Visible& visible, EyePasses passes) {
    if (visible.commands.empty()) return;
    glBindVertexArray(buffers_.skin(static_cast<std::size_t>(passes.instances())));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.get());
    const std::size_t offset = first * sizeof(DrawCommand);
    glMultiDrawElementsIndirect(
        GL_TRIANGLES,
        GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(offset),
        static_cast<GLsizei>(visible.commands.size()),
        sizeof(DrawCommand)
    );
    ++counts_.draw_calls;
}

void ModelDrawer::set_shape(const Program& program, float factor, float factor_im) const {
    program.set("factor", factor);
    program.set("factor_im", factor_im);
}

void ModelDrawer::set_cuts(const Program& program, const Look& look) const {
    std::array<glm::vec4, kMostCuts> planes{};
    const std::size_t count = std::min(look.cuts.size(), kMostCuts);
    for (std::size_t i = 0; i < count; ++i) planes[i] = glm::vec4(look.cuts[i].normal, look.cuts[i].offset);
    glProgramUniform4fv(program.get(), program.at("planes"), static_cast<GLsizei>(kMostCuts), &planes[0][0]);
    program.set("plane_count", static_cast<int>(count));
}

void ModelDrawer::draw(const ModelDrawing& drawing, const ModelPrograms& programs) {
    if (!buffers_.has_geometry()) return;
    const Look& look = *drawing.look;
    for (std::size_t i = 0; i < kMostCuts; ++i) {
        const GLenum distance = GL_CLIP_DISTANCE0 + static_cast<GLenum>(i);
        if (i < look.cuts.size())
            glEnable(distance);
        else
            glDisable(distance);
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glFrontFace(glm::determinant(glm::mat3(look.model_to_world)) < 0 ? GL_CW : GL_CCW);
    draw_skin(drawing, programs.skin);
    glDisable(GL_CULL_FACE);
    if (fills_cuts_) draw_caps(drawing, programs);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (look.edges) draw_edges(drawing, programs.edges);
    if (!clear_.commands.empty()) {
        programs.skin.use();
        programs.skin.set("opacity", kClearOpacity);
        glBindTextureUnit(kPaletteUnit, palette_.texture());
        draw_range(shown_.commands.size(), clear_, drawing.passes);
    }
    if (look.ghost) draw_ghost(drawing, programs.edges);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    for (std::size_t i = 0; i < kMostCuts; ++i) glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    glFrontFace(GL_CCW);
    glBindVertexArray(0);
}

void ModelDrawer::draw_skin(const ModelDrawing& drawing, const Program& skin) {
    if (hides_backs_) glEnable(GL_CULL_FACE);
    set_colours(skin, *drawing.look, is_coloured_, palette_);
    set_shape(skin, factor_, factor_im_);
    set_cuts(skin, *drawing.look);
    skin.set("hatch_scale", 60 / diagonal_);
    skin.set("cap_hatch", 90 / diagonal_);
    skin.set("opacity", 1.0F);
    skin.use();
    glBindTextureUnit(kPaletteUnit, palette_.texture());
    draw_range(0, shown_, drawing.passes);
}

float ModelDrawer::edge_opacity(const ModelDrawing& drawing) const {
    const Look& look = *drawing.look;
    const glm::vec3 middle = 0.5F * (vec_of(model_.geometry->low) + vec_of(model_.geometry->high));
    const glm::vec3 seen(drawing.eyes[0].view * look.model_to_world * glm::vec4(middle, 1));
    const float distance = std::max(glm::length(seen), 0.1F);
    const float pixel =
        2 * distance / (drawing.eyes[0].projection[1][1] * static_cast<float>(drawing.height));
    const float pixels = typical_edge_ * glm::length(glm::vec3(look.model_to_world[0])) / pixel;
    return 0.55F * std::clamp((pixels - 2) / 18, 0.0F, 1.0F);
}

void ModelDrawer::draw_edges(const ModelDrawing& drawing, const Program& edges) {
    const float opacity = edge_opacity(drawing);
    const bool can_move = buffers_.bind_moves(kMovesUnit);
    if (buffers_.edges() == 0 || opacity <= 0.02F * 0.55F || (!can_move && (factor_ != 0 || factor_im_ != 0)))
        return;
    set_shape(edges, factor_, factor_im_);
    set_cuts(edges, *drawing.look);
    edges.set("moves", static_cast<int>(kMovesUnit));
    edges.set("moves_im", static_cast<int>(kMovesUnit) + 1);
    glProgramUniform4f(edges.get(), edges.at("line_colour"), 0.0033F, 0.004F, 0.0052F, opacity);
    edges.use();
    glBindVertexArray(buffers_.edges());
    const std::vector<PartRange>& parts = model_.geometry->parts;
    std::uint32_t first = 0, count = 0;
    const auto draw_run = [&] {
        if (count == 0) return;
        const std::size_t offset = 8 * std::size_t{first};
        glDrawElementsInstanced(
            GL_LINES,
            static_cast<GLsizei>(2 * count),
            GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(offset),
            drawing.passes.instances()
        );
        ++counts_.draw_calls;
        count = 0;
    };
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
        if (parts[p].edges == 0 || look_of(drawing.look->parts, p) == PartLook::Hidden) continue;
        // Neighbours that are drawn are one call.
        if (parts[p].first_edge != first + count) draw_run();
        if (count == 0) first = parts[p].first_edge;
        count += parts[p].edges;
    }
    draw_run();
}

void ModelDrawer::make_ghost() {
    const Geometry& geometry = *model_.geometry;
    std::vector<std::array<float, 3>> ends;
    ghost_.emplace();
    for (const PartRange& part : geometry.parts) {
        ghost_->first.push_back(static_cast<GLint>(ends.size()));
        for (const auto& [a, b] : feature_edges(geometry, part)) {
            ends.push_back(geometry.positions[a]);
            ends.push_back(geometry.positions[b]);
        }
    }
    ghost_->first.push_back(static_cast<GLint>(ends.size()));
    ghost_->positions = make_buffer(std::span<const std::array<float, 3>>(ends), "ghost");
    ghost_->array = make_vertex_array();
    const GLuint array = ghost_->array.get();
    glVertexArrayVertexBuffer(array, 0, ghost_->positions.get(), 0, 12);
    glEnableVertexArrayAttrib(array, kPosition);
    glVertexArrayAttribFormat(array, kPosition, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(array, kPosition, 0);
}

void ModelDrawer::draw_ghost(const ModelDrawing& drawing, const Program& edges) {
    if (!ghost_ || ghost_->first.back() == 0) return;
    set_shape(edges, 0, 0);
    set_cuts(edges, *drawing.look);
    edges.set("moves", static_cast<int>(kMovesUnit));
    edges.set("moves_im", static_cast<int>(kMovesUnit) + 1);
    glProgramUniform4f(edges.get(), edges.at("line_colour"), 0.144F, 0.188F, 0.216F, 0.75F);
    edges.use();
    glBindVertexArray(ghost_->array.get());
    // What is hidden has no ghost; neighbours that have one are one call.
    const auto is_hidden = [&](std::size_t part) {
        return look_of(drawing.look->parts, static_cast<std::uint32_t>(part)) == PartLook::Hidden;
    };
    const std::size_t parts = ghost_->first.size() - 1;
    for (std::size_t from = 0; from < parts;) {
        std::size_t end = from;
        while (end < parts && !is_hidden(end)) ++end;
        if (const GLsizei count = ghost_->first[end] - ghost_->first[from]; count > 0) {
            glDrawArraysInstanced(GL_LINES, ghost_->first[from], count, drawing.passes.instances());
            ++counts_.draw_calls;
        }
        from = end + 1;
    }
}

}  // namespace feelem::viewer
