// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_json.hpp"

#include "scene/json_text.hpp"

#include <algorithm>
#include <array>

namespace feelem::gltf {
namespace {

template <class T>
void write_list(JsonText& json, std::string_view name, const std::vector<T>& list) {
    if (list.empty()) return;
    json.key(name).begin_array();
    for (const T& entry : list) json.value(entry);
    json.end_array();
}

/// Calls write(json, entry) for each entry of a list; nothing at all for an empty one (glTF forbids []).
template <class T, class Write>
void write_all(JsonText& json, std::string_view name, const std::vector<T>& list, const Write& write) {
    if (list.empty()) return;
    json.key(name).begin_array();
    for (const T& entry : list) {
        json.begin_object();
        write(json, entry);
        json.end_object();
    }
    json.end_array();
}

void write_buffer(JsonText& json, const Buffer& buffer) {
    if (!buffer.uri.empty()) json.member("uri", buffer.uri);
    json.member("byteLength", buffer.bytes);
}

constexpr std::string_view kPackedExtension = "EXT_meshopt_compression";

void write_view(JsonText& json, const View& view) {
    json.member("buffer", view.buffer).member("byteOffset", view.offset).member("byteLength", view.bytes);
    if (view.target != 0) json.member("target", view.target);
    if (!view.packed) return;
    const PackedView& packed = *view.packed;
    json.key("extensions").begin_object().key(kPackedExtension).begin_object();
    json.member("buffer", packed.buffer).member("byteOffset", packed.offset);
    json.member("byteLength", packed.bytes).member("byteStride", packed.stride).member("count", packed.count);
    json.member("mode", packing_word(packed.mode));
    if (packed.filter != PackingFilter::None) json.member("filter", packing_filter_word(packed.filter));
    json.end_object().end_object();
}

/// Packed views lie in a buffer that is nowhere stored: loaders that do not know the extension see that.
void write_buffers(JsonText& json, const Document& document) {
    json.key("buffers").begin_array();
    for (const Buffer& buffer : document.buffers) {
        json.begin_object();
        write_buffer(json, buffer);
        json.end_object();
    }
    if (document.unpacked_bytes > 0) {
        json.begin_object().member("byteLength", document.unpacked_bytes).key("extensions").begin_object();
        json.key(kPackedExtension).begin_object().member("fallback", true).end_object();
        json.end_object().end_object();
    }
    json.end_array();
}

void write_accessor(JsonText& json, const Accessor& accessor) {
    constexpr std::array kTypes{"", "SCALAR", "VEC2", "VEC3"};
    json.member("name", accessor.name).member("bufferView", accessor.view);
    json.member("componentType", accessor.component_type).member("count", accessor.count);
    json.member("type", kTypes[accessor.components]);
    write_list(json, "min", accessor.min);
    write_list(json, "max", accessor.max);
    if (!accessor.steps) return;
    json.key("extras").begin_object().key("feelem").begin_object();
    json.member("offset", accessor.steps->offset).member("step", accessor.steps->step);
    json.end_object().end_object();
}

void write_primitive(JsonText& json, const Primitive& primitive) {
    json.key("attributes").begin_object();
    for (const auto& [semantic, accessor] : primitive.attributes) json.member(semantic, accessor);
    json.end_object();
    if (primitive.indices >= 0) json.member("indices", primitive.indices);
    if (primitive.material >= 0) json.member("material", primitive.material);
    if (primitive.mode != kTriangles) json.member("mode", primitive.mode);
    write_all(json, "targets", primitive.targets, [](JsonText& out, int target) {
        out.member("POSITION", target);
    });
    if (primitive.mappings.empty()) return;
    json.key("extensions").begin_object().key("KHR_materials_variants").begin_object();
    write_all(json, "mappings", primitive.mappings, [](JsonText& out, const Mapping& mapping) {
        out.member("material", mapping.material);
        write_list(out, "variants", mapping.variants);
    });
    json.end_object().end_object();
}

void write_mesh(JsonText& json, const Mesh& mesh) {
    json.member("name", mesh.name).key("primitives").begin_array().begin_object();
    write_primitive(json, mesh.primitive);
    json.end_object().end_array();
    write_list(json, "weights", mesh.weights);
    if (mesh.target_names.empty()) return;
    json.key("extras").begin_object();
    write_list(json, "targetNames", mesh.target_names);
    json.end_object();
}

void write_node(JsonText& json, const Node& node) {
    json.member("name", node.name);
    if (node.mesh >= 0) json.member("mesh", node.mesh);
    write_list(json, "children", node.children);
    if (node.matrix)
        write_list(json, "matrix", std::vector<double>(node.matrix->begin(), node.matrix->end()));
    json.key("extras").begin_object().key("feelem").begin_object().member("role", node.role);
    if (node.part >= 0) json.member("part", node.part);
    json.end_object().end_object();
}

void write_material(JsonText& json, const Material& material) {
    json.member("name", material.name).key("pbrMetallicRoughness").begin_object();
    if (material.texture >= 0) {
        json.key("baseColorTexture").begin_object().member("index", material.texture);
        if (material.texcoord > 0) json.member("texCoord", material.texcoord);
        json.end_object();
    }
    if (material.factor != std::array<double, 3>{1, 1, 1}) {
        json.key("baseColorFactor").begin_array();
        for (const double channel : material.factor) json.value(channel);
        json.value(1.0).end_array();
    }
    json.member("metallicFactor", 0).member("roughnessFactor", 0.9).end_object();
    if (material.double_sided) json.member("doubleSided", true);
    if (!material.unlit) return;
    json.key("extensions").begin_object().key("KHR_materials_unlit").begin_object().end_object().end_object();
}

void write_animation(JsonText& json, const Animation& animation) {
    json.member("name", animation.name);
    int sampler = 0;
    write_all(json, "channels", animation.channels, [&](JsonText& out, const Channel& channel) {
        out.member("sampler", sampler++).key("target").begin_object();
        out.member("node", channel.node).member("path", "weights").end_object();
    });
    write_all(json, "samplers", animation.channels, [](JsonText& out, const Channel& channel) {
        out.member("input", channel.input).member("output", channel.output);
        out.member("interpolation", "CUBICSPLINE");
    });
}

void write_textures(JsonText& json, const Document& document) {
    write_all(json, "textures", document.textures, [](JsonText& out, const Texture& texture) {
        out.member("sampler", texture.sampler).member("source", texture.image);
    });
    write_all(json, "images", document.images, [](JsonText& out, const Image& image) {
        out.member("name", image.name).member("mimeType", "image/png").member("bufferView", image.view);
    });
    write_all(json, "samplers", document.samplers, [](JsonText& out, int filter) {
        constexpr int kClampToEdge = 33071;
        out.member("magFilter", filter).member("minFilter", filter);
        out.member("wrapS", kClampToEdge).member("wrapT", kClampToEdge);
    });
}

void write_extensions(JsonText& json, const Document& document) {
    const bool unlit = std::ranges::any_of(document.materials, [](const Material& m) { return m.unlit; });
    std::vector<std::string> used;
    if (unlit) used.push_back("KHR_materials_unlit");
    if (!document.variants.empty()) used.push_back("KHR_materials_variants");
    if (document.unpacked_bytes > 0) used.emplace_back(kPackedExtension);
    write_list(json, "extensionsUsed", used);
    if (document.unpacked_bytes > 0)
        write_list(json, "extensionsRequired", std::vector<std::string>{std::string(kPackedExtension)});
    if (document.variants.empty()) return;
    json.key("extensions").begin_object().key("KHR_materials_variants").begin_object();
    write_all(json, "variants", document.variants, [](JsonText& out, const std::string& name) {
        out.member("name", name);
    });
    json.end_object().end_object();
}

}  // namespace

std::string to_json(const Document& document, std::string_view feelem_extras) {
    JsonText json;
    json.begin_object().key("asset").begin_object().member("version", "2.0");
    json.member("generator", "Feelem " FEELEM_VERSION).end_object();
    write_extensions(json, document);
    json.member("scene", 0).key("scenes").begin_array().begin_object();
    write_list(json, "nodes", document.roots);
    json.end_object().end_array();
    write_all(json, "nodes", document.nodes, write_node);
    write_all(json, "meshes", document.meshes, write_mesh);
    write_all(json, "materials", document.materials, write_material);
    write_textures(json, document);
    write_all(json, "animations", document.animations, write_animation);
    write_all(json, "accessors", document.accessors, write_accessor);
    std::vector<View> views = document.views;
    for (View& view : views) {
        if (view.packed) view.buffer = static_cast<int>(document.buffers.size());
    }
    write_all(json, "bufferViews", views, write_view);
    write_buffers(json, document);
    json.key("extras").begin_object().key("feelem").raw(feelem_extras).end_object().end_object();
    return json.text();
}

}  // namespace feelem::gltf
