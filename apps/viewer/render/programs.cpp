// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/programs.hpp"

#include <fmt/format.h>

#include <string>

namespace feelem::viewer {
namespace {

constexpr std::string_view kEyes = R"(
struct EyeMatrices { mat4 view; mat4 projection; mat4 model; mat4 normal; vec4 eye_in_model; };
layout(std140, binding = 0) uniform Eyes { EyeMatrices eyes[2]; };
)";

std::string block(const ProgramText& text) {
    std::string out = "{ flat int eye;";
    for (const Varying& varying : text.varyings)
        out += fmt::format(" {} {} {};", varying.qualifier, varying.type, varying.name);
    return out + " }";
}

/// The built-in outputs; the stages before and after must say the same.
std::string built_in(const ProgramText& text) {
    return fmt::format(
        "gl_PerVertex {{ vec4 gl_Position;{} }}", text.is_clipped ? " float gl_ClipDistance[3];" : ""
    );
}

std::string vertex_text(const ProgramText& text, StereoPath path) {
    const bool is_layered = path == StereoPath::VertexLayer;
    // Said in full, the block would have no room for gl_Layer.
    const std::string sized = text.is_clipped ? "out float gl_ClipDistance[3];" : "";
    return fmt::format(
        "#version 450 core\n{}{}{}{}\nout Varyings {} to;\n{}\n{}\n"
        "void main() {{ int eye = {}; to.eye = eye; place(eyes[eye]);{} }}\n",
        is_layered ? "#extension GL_ARB_shader_viewport_layer_array : require\n" : "",
        kEyes,
        path == StereoPath::TwoPass ? "uniform int only_eye;\n" : "",
        path == StereoPath::GeometryShader ? "out " + built_in(text) + ";" : sized,
        block(text),
        text.shared,
        text.vertex,
        path == StereoPath::TwoPass ? "only_eye" : "gl_InstanceID & 1",
        is_layered ? " gl_Layer = eye;" : ""
    );
}

std::string geometry_text(const ProgramText& text) {
    std::string copies = "to.eye = from[i].eye;";
    for (const Varying& varying : text.varyings)
        copies += fmt::format(" to.{0} = from[i].{0};", varying.name);
    if (text.is_clipped)
        copies += " for (int k = 0; k < 3; ++k) gl_ClipDistance[k] = gl_in[i].gl_ClipDistance[k];";
    return fmt::format(
        "#version 450 core\nlayout({}) in;\nlayout({}, max_vertices = {}) out;\n"
        "in {} gl_in[];\nout {};\nin Varyings {} from[];\nout Varyings {} to;\n"
        "void main() {{ for (int i = 0; i < {}; ++i) {{ gl_Position = gl_in[i].gl_Position; {} "
        "gl_Layer = from[0].eye; EmitVertex(); }} EndPrimitive(); }}\n",
        text.is_lines ? "lines" : "triangles",
        text.is_lines ? "line_strip" : "triangle_strip",
        text.is_lines ? 2 : 3,
        built_in(text),
        built_in(text),
        block(text),
        block(text),
        text.is_lines ? 2 : 3,
        copies
    );
}

std::string fragment_text(const ProgramText& text) {
    return fmt::format(
        "#version 450 core\n{}in Varyings {} from;\nlayout(location = 0) out vec4 colour_out;\n{}\n{}\n"
        "void main() {{ colour_out = colour_here(); }}\n",
        kEyes,
        block(text),
        text.shared,
        text.fragment
    );
}

}  // namespace

Program make_program(const ProgramText& text, StereoPath path) {
    std::vector<ShaderSource> sources{{GL_VERTEX_SHADER, vertex_text(text, path)}};
    if (path == StereoPath::GeometryShader) sources.push_back({GL_GEOMETRY_SHADER, geometry_text(text)});
    sources.push_back({GL_FRAGMENT_SHADER, fragment_text(text)});
    return {text.name, sources};
}

StereoPath best_stereo() {
    return epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array") ? StereoPath::VertexLayer
                                                                        : StereoPath::GeometryShader;
}

}  // namespace feelem::viewer
