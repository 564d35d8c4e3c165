// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/frame_timer.hpp"

#include <epoxy/gl.h>

namespace feelem::viewer {

FrameTimer::~FrameTimer() {
    if (queries_[0] != 0) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void FrameTimer::begin() {
    if (queries_[0] == 0)
        glCreateQueries(GL_TIMESTAMP, static_cast<GLsizei>(queries_.size()), queries_.data());
    is_open_ = begun_ - taken_ < kFrames;
    if (is_open_) glQueryCounter(queries_[2 * (begun_ % kFrames)], GL_TIMESTAMP);
}

void FrameTimer::end() {
    if (!is_open_) return;
    glQueryCounter(queries_[2 * (begun_ % kFrames) + 1], GL_TIMESTAMP);
    ++begun_;
    is_open_ = false;
}

std::optional<double> FrameTimer::take() {
    if (taken_ == begun_) return std::nullopt;
    const unsigned from = queries_[2 * (taken_ % kFrames)], to = queries_[2 * (taken_ % kFrames) + 1];
    GLuint is_there = 0;
    glGetQueryObjectuiv(to, GL_QUERY_RESULT_AVAILABLE, &is_there);
    if (is_there == 0) return std::nullopt;
    GLuint64 began = 0, ended = 0;  // Nanoseconds.
    glGetQueryObjectui64v(from, GL_QUERY_RESULT, &began);
    glGetQueryObjectui64v(to, GL_QUERY_RESULT, &ended);
    ++taken_;
    return static_cast<double>(ended - began) * 1e-9;
}

}  // namespace feelem::viewer
