// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/gl_context.hpp"
#include "viewer/render/renderer.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <optional>

namespace feelem::viewer {
namespace {

TEST(GlContext, opengl_4_5_is_there_without_a_window_and_goes_with_its_owner) {
    std::optional<GlContext> context;
    try {
        context.emplace();
    } catch (const std::exception& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }

    EXPECT_GE(epoxy_gl_version(), 45);
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace feelem::viewer
