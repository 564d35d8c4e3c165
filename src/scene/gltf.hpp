// SPDX-License-Identifier: Apache-2.0
// The part of glTF 2.0 that a scene uses, as plain structs: written by gltf_json, read by scene_json.
#pragma once

#include "scene/packed_arrays.hpp"
#include "scene/steps.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace feelem::gltf {

inline constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
inline constexpr int kAttributeTarget = 34962, kIndexTarget = 34963;
inline constexpr int kLines = 1, kTriangles = 4;
inline constexpr int kNearest = 9728, kLinear = 9729;

using Attributes = std::vector<std::pair<std::string, int>>;  ///< Semantic -> accessor.

struct Buffer {
    std::string uri;  ///< Empty: the chunk of the .glb.
    std::uint64_t bytes = 0;
};
struct View {
    int buffer = 0;
    std::uint64_t offset = 0, bytes = 0;
    int target = 0;  ///< 0: data.
    /// Then buffer, offset and bytes are those of the unpacked array in the buffer that nobody stores.
    std::optional<PackedView> packed{};
};
struct Accessor {
    std::string name;
    int view = -1;
    int component_type = kFloat;
    unsigned components = 1;  ///< 1: SCALAR, 2, 3: VEC2, VEC3
    std::uint64_t count = 0;
    std::vector<double> min, max;
    std::optional<Steps> steps{};  ///< The numbers are steps.
};
struct Mapping {
    int material = 0;
    std::vector<int> variants;
};
struct Primitive {
    Attributes attributes;
    int indices = -1, material = -1, mode = kTriangles;
    std::vector<int> targets;  ///< POSITION accessors.
    std::vector<Mapping> mappings;
};
struct Mesh {
    std::string name;
    Primitive primitive;
    std::vector<double> weights;
    std::vector<std::string> target_names;
};
struct Node {
    std::string name;
    std::string role;
    int part = -1;
    int mesh = -1;
    std::vector<int> children;
    std::optional<std::array<double, 16>> matrix;
};
struct Material {
    std::string name;
    bool unlit = true, double_sided = false;
    int texture = -1, texcoord = 0;
    std::array<double, 3> factor{1, 1, 1};
};
struct Texture {
    int sampler = 0, image = 0;
};
struct Image {
    std::string name;
    int view = 0;
};
struct Channel {
    int node = 0, input = 0, output = 0;  ///< Accessors of its sampler; always `weights`, CUBICSPLINE.
};
struct Animation {
    std::string name;
    std::vector<Channel> channels;
};

struct Document {
    std::vector<Buffer> buffers;
    std::vector<View> views;
    std::vector<Accessor> accessors;
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<int> roots;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Image> images;
    std::vector<int> samplers;  ///< Filter of each: kNearest or kLinear.
    std::vector<Animation> animations;
    std::vector<std::string> variants;
    std::uint64_t unpacked_bytes = 0;  ///< Of all packed views: the length of the buffer that nobody stores.
};

}  // namespace feelem::gltf
