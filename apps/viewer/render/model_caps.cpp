// SPDX-License-Identifier: Apache-2.0
// Fills what a cut opens. Along a line of sight that enters through a plane, backs of closed solids less
// their fronts are the solids that it is in at the plane: counted in the stencil, with that plane alone,
// whatever the others take away.
#include "viewer/render/model_drawer.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

glm::vec3 corner_of(const std::array<float, 3>& p) {
    return {p[0], p[1], p[2]};
}

void enable_clips(std::size_t count) {
    for (std::size_t i = 0; i < kMostCuts; ++i) {
        const GLenum distance = GL_CLIP_DISTANCE0 + static_cast<GLenum>(i);
        if (i < count)
            glEnable(distance);
        else
            glDisable(distance);
    }
}

float most_of(std::span<const ClusterMove> moves) {
    float most = 0;
    for (const ClusterMove& move : moves) most = std::max(most, glm::length(move.middle) + move.radius);
    return most;
}

void set_planes(const Program& program, const std::array<glm::vec4, kMostCuts>& planes) {
    glProgramUniform4fv(program.get(), program.at("planes"), static_cast<GLsizei>(kMostCuts), &planes[0][0]);
}

}  // namespace

void ModelDrawer::draw_caps(const ModelDrawing& drawing, const ModelPrograms& programs) {
    const Look& look = *drawing.look;
    const std::size_t count = std::min(look.cuts.size(), kMostCuts);
    for (std::size_t i = 0; i < count; ++i) {
        const CutPlane& cut = look.cuts[i];
        const bool is_seen = std::ranges::any_of(eyes_, [&](const SeenFrom& eye) {
            return glm::dot(cut.normal, eye.eye) > cut.offset;
        });
        if (is_seen) draw_cap(drawing, programs, i);
    }
    set_cuts(programs.skin, look);
    enable_clips(count);
}

void ModelDrawer::draw_cap(const ModelDrawing& drawing, const ModelPrograms& programs, std::size_t plane) {
    const Look& look = *drawing.look;
    const CutPlane& cut = look.cuts[plane];
    const glm::vec4 nowhere(0, 0, 0, 1);
    std::array<glm::vec4, kMostCuts> alone{nowhere, nowhere, nowhere}, others = alone;
    alone[0] = glm::vec4(cut.normal, cut.offset);
    for (std::size_t i = 0; i < std::min(look.cuts.size(), kMostCuts); ++i)
        if (i != plane) others[i] = glm::vec4(look.cuts[i].normal, look.cuts[i].offset);
    glEnable(GL_STENCIL_TEST);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_DECR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_INCR_WRAP);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    set_planes(programs.skin, alone);
    enable_clips(1);
    programs.skin.use();
    draw_range(shown_.commands.size() + clear_.commands.size(), cut_, drawing.passes);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);

    const glm::vec3 middle = 0.5F * (corner_of(model_.geometry->low) + corner_of(model_.geometry->high));
    const glm::vec3 normal = glm::normalize(cut.normal);
    const glm::vec3 aside = std::abs(normal.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 right = glm::normalize(glm::cross(aside, normal));
    const ClusterList& list = lists_.at(buffers_.list().level);
    const float moved =
        std::abs(factor_) * most_of(list.moves.real) + std::abs(factor_im_) * most_of(list.moves.imaginary);
    const float reach = 0.51F * diagonal_ + moved;
    const float off = (cut.offset - glm::dot(cut.normal, middle)) / glm::length(cut.normal);
    const auto set = [&](const char* name, const glm::vec3& value) {
        glProgramUniform3f(programs.caps.get(), programs.caps.at(name), value.x, value.y, value.z);
    };
    set("cap_middle", middle + off * normal);
    set("cap_right", reach * right);
    set("cap_up", reach * glm::cross(normal, right));
    programs.caps.set("cap_hatch", 90 / diagonal_);
    set_planes(programs.caps, others);
    enable_clips(kMostCuts);
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    programs.caps.use();
    glBindVertexArray(nothing_.get());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, drawing.passes.instances());
    ++counts_.draw_calls;
    glDisable(GL_STENCIL_TEST);
}

}  // namespace feelem::viewer
