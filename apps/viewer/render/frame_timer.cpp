// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/frame_timer.hpp"

#include <epoxy/gl.h>

namespace feelem::viewer {

FrameTimer::~FrameTimer() {
    if (queries_[0] != 0) glDeleteQueries(kFrames, queries_.data());
}

void FrameTimer::begin() {
    if (queries_[0] == 0) glCreateQueries(GL_TIME_ELAPSED, kFrames, queries_.data());
    is_open_ = begun_ - taken_ < kFrames;
    if (is_open_) glBeginQuery(GL_TIME_ELAPSED, queries_[begun_ % kFrames]);
}

void FrameTimer::end() {
    if (!is_open_) return;
    glEndQuery(GL_TIME_ELAPSED);
    ++begun_;
    is_open_ = false;
}

std::optional<double> FrameTimer::take() {
    if (taken_ == begun_) return std::nullopt;
    const unsigned query = queries_[taken_ % kFrames];
    GLuint is_there = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &is_there);
    if (is_there == 0) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    ++taken_;
    return static_cast<double>(nanoseconds) * 1e-9;
}

}  // namespace feelem::viewer
