// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/gl_objects.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace feelem::viewer {
namespace {

/// What the compiler says, without the zero at its end.
template <typename Get>
std::string log_of(GLuint name, GLint length, Get get) {
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    get(name, static_cast<GLsizei>(text.size()), &written, text.data());
    text.resize(static_cast<std::size_t>(std::max(written, 0)));
    return text;
}

[[noreturn]] void refused(std::string_view program, std::string_view step, const std::string& words) {
    throw Error(
        Code::UnsupportedFormat,
        "OpenGL",
        fmt::format(
            "the shader '{}' does not {}: {} (the driver must offer OpenGL 4.5)", program, step, words
        )
    );
}

/// A shader while a program is made of it.
struct ShaderKind {
    static void destroy(GLuint name) { glDeleteShader(name); }
};

GlName<ShaderKind> compile(std::string_view program, const ShaderSource& source) {
    GlName<ShaderKind> shader(glCreateShader(source.stage));
    const char* text = source.text.c_str();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    GLint good = GL_FALSE, length = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &good);
    glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
    if (good == GL_FALSE) refused(program, "compile", log_of(shader.get(), length, glGetShaderInfoLog));
    return shader;
}

}  // namespace

Texture make_texture(GLenum target) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return Texture(name);
}

Framebuffer make_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return Framebuffer(name);
}

VertexArray make_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

Sampler make_sampler() {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    return Sampler(name);
}

Buffer make_buffer(std::size_t bytes, std::string_view what, const void* data) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    Buffer buffer(name);
    // OpenGL knows no buffer without room.
    const auto room = static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 4));
    glNamedBufferStorage(name, room, bytes >= 4 ? data : nullptr, GL_DYNAMIC_STORAGE_BIT);
    if (data && bytes > 0 && bytes < 4) glNamedBufferSubData(name, 0, static_cast<GLsizeiptr>(bytes), data);
    check_memory(what);
    return buffer;
}

void check_memory(std::string_view what) {
    if (glGetError() != GL_OUT_OF_MEMORY) return;
    throw Error(
        Code::TooLarge,
        "OpenGL",
        fmt::format("the graphics card has no room for the {}: convert with levels of detail", what)
    );
}

void check_framebuffer(GLuint framebuffer, std::string_view what) {
    const GLenum state = glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
    if (state == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(
        Code::UnsupportedFormat,
        "OpenGL",
        fmt::format("cannot draw into the {} (status {:#06x})", what, state)
    );
}

Program::Program(std::string_view name, std::span<const ShaderSource> sources) : name_(glCreateProgram()) {
    std::vector<GlName<ShaderKind>> shaders;
    for (const ShaderSource& source : sources) {
        shaders.push_back(compile(name, source));
        glAttachShader(get(), shaders.back().get());
    }
    glLinkProgram(get());
    for (const auto& shader : shaders) glDetachShader(get(), shader.get());
    GLint good = GL_FALSE, length = 0;
    glGetProgramiv(get(), GL_LINK_STATUS, &good);
    glGetProgramiv(get(), GL_INFO_LOG_LENGTH, &length);
    if (good == GL_FALSE) refused(name, "link", log_of(get(), length, glGetProgramInfoLog));
}

}  // namespace feelem::viewer
