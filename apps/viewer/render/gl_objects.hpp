// SPDX-License-Identifier: Apache-2.0
// Owners of OpenGL's names. Each is deleted with its owner, while the context that made it is current.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace feelem::viewer {

/// A name that `Kind::destroy` gives back; 0: none.
template <typename Kind>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_ != 0) Kind::destroy(name_);
    }
    GLuint get() const noexcept { return name_; }
    explicit operator bool() const noexcept { return name_ != 0; }

private:
    GLuint name_ = 0;
};

struct TextureKind {
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferKind {
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct SamplerKind {
    static void destroy(GLuint name) { glDeleteSamplers(1, &name); }
};
struct BufferKind {
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct ProgramKind {
    static void destroy(GLuint name) { glDeleteProgram(name); }
};
using Texture = GlName<TextureKind>;
using Framebuffer = GlName<FramebufferKind>;
using VertexArray = GlName<VertexArrayKind>;
using Sampler = GlName<SamplerKind>;
using Buffer = GlName<BufferKind>;

Texture make_texture(GLenum target);
Framebuffer make_framebuffer();
VertexArray make_vertex_array();
Sampler make_sampler();
/// Of fixed size, filled later or now. `what` is for people: "normals". Throws Error(TooLarge).
Buffer make_buffer(std::size_t bytes, std::string_view what, const void* data = nullptr);

template <typename T>
Buffer make_buffer(std::span<const T> data, std::string_view what) {
    return make_buffer(data.size_bytes(), what, data.data());
}

/// Throws Error(TooLarge) when the card had no room for `what`.
void check_memory(std::string_view what);
/// Throws Error(UnsupportedFormat) with `what` when the one that is bound cannot be drawn into.
void check_framebuffer(GLuint framebuffer, std::string_view what);

/// The source of one stage of a program.
struct ShaderSource {
    GLenum stage = GL_VERTEX_SHADER;
    std::string text;
};

/// Compiled and linked. Throws Error(UnsupportedFormat) with the compiler's words.
class Program {
public:
    Program() = default;
    Program(std::string_view name, std::span<const ShaderSource> sources);
    void use() const { glUseProgram(name_.get()); }
    /// -1, which OpenGL ignores, where the program has no use for it.
    GLint at(const char* uniform) const { return glGetUniformLocation(name_.get(), uniform); }
    void set(const char* uniform, float value) const { glProgramUniform1f(name_.get(), at(uniform), value); }
    void set(const char* uniform, int value) const { glProgramUniform1i(name_.get(), at(uniform), value); }
    GLuint get() const noexcept { return name_.get(); }

private:
    GlName<ProgramKind> name_;
};

}  // namespace feelem::viewer
