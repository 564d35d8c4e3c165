// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/gl_words.hpp"

#include <epoxy/gl.h>

namespace feelem::viewer {
namespace {

std::string gl_word(GLenum name) {
    const GLubyte* word = glGetString(name);
    return word == nullptr ? "" : reinterpret_cast<const char*>(word);
}

}  // namespace

std::string gl_version() {
    return gl_word(GL_VERSION);
}

std::string gl_renderer() {
    return gl_word(GL_RENDERER);
}

}  // namespace feelem::viewer
