// SPDX-License-Identifier: Apache-2.0
// The time of frames.
#include "viewer/render/drawing.hpp"
#include "viewer/render/frame_timer.hpp"

#include <epoxy/gl.h>

namespace feelem::viewer::tests {
namespace {

class FrameTimers : public WithGl {};

TEST_F(FrameTimers, each_frame_is_told_once_and_a_full_list_waits) {
    FrameTimer timer;
    EXPECT_FALSE(timer.take());
    for (int i = 0; i < 9; ++i) {
        timer.begin();
        timer.end();
    }
    glFinish();
    int told = 0;
    while (const auto seconds = timer.take()) {
        EXPECT_GE(*seconds, 0);
        EXPECT_LT(*seconds, 60);
        ++told;
    }
    EXPECT_EQ(told, 4);
    timer.begin();
    timer.end();
    glFinish();
    EXPECT_TRUE(timer.take());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace feelem::viewer::tests
