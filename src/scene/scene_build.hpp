// SPDX-License-Identifier: Apache-2.0
// What write_scene has gathered so far; each step of it takes this and adds its share.
#pragma once

#include "scene/array_writer.hpp"
#include "scene/gltf.hpp"

#include "feelem/scene.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace feelem {

struct ScenePartBuild {
    const SurfacePart* range = nullptr;
    std::string name;
    std::string prefix;  ///< "p0/"
    gltf::Mesh mesh;
    int node = -1;       ///< Into document.nodes.
    int edge_mesh = -1;  ///< Into document.meshes.
    bool double_sided = false;
};

/// What became of one result at one step.
struct WrittenField {
    std::vector<std::vector<std::string>> accessors;  ///< Per part; none: the part has no value.
    std::vector<std::string> masks;                   ///< Per part; empty: all are the solver's.
    std::optional<Extreme> min, max;                  ///< Scalars: of the solver's values on the skin.
    std::uint64_t missing = 0, interpolated = 0;      ///< Vertices.
    bool exact = true;                                ///< The values are the solver's, bit for bit.
};

/// A result that gets a texture coordinate, materials and variants.
struct ColouredResult {
    std::size_t result = 0, values = 0;
    int component = 0;  ///< -1: the magnitude of the vector.
    std::string component_name;
    ValueRange range;
    ColourEffect effect;
};

/// A vector that moves the vertices: one, or real and imaginary part of a mode.
struct ShapeResult {
    std::size_t result = 0, values = 0;
};
struct Deformation {
    std::vector<ShapeResult> shapes;
    double factor = 0;
    bool is_mode = false;
    std::string name;  ///< "deformation x50"
};

struct Box {
    Point3 low{}, high{};
    double side(std::size_t axis) const { return high[axis] - low[axis]; }
    double centre(std::size_t axis) const { return 0.5 * (low[axis] + high[axis]); }
    double diagonal() const;
    double largest() const;
};

struct SceneBuild {
    const SceneContents& contents;
    const SceneOptions& options;
    gltf::Document document{};
    ArrayWriter arrays{document};
    std::vector<ScenePartBuild> parts{};
    Box box{};  ///< Of the drawn positions, model units, before the shift.
    Point3 origin{};
    double largest_rounding = 0;
    float grid = 0;  ///< Positions are whole multiples of it; 0: as they are.
    std::vector<std::optional<gltf::Steps>> steps{};   ///< Per result: on what its values stand.
    double area = 0, volume = 0;                       ///< Of the float32 positions.
    std::vector<std::vector<WrittenField>> written{};  ///< [result][values]
    std::vector<std::string> attribute_names{};        ///< Per result: "_TEMPERATURE".
    std::vector<ColouredResult> coloured{};
    std::optional<Deformation> deformation{};
    std::uint64_t edges = 0;
    std::vector<Digest> digests{};  ///< Of all accessors, when all are written.
};

/// The GLB chunk and the side files while they are made.
struct SceneFiles {
    std::string path;         ///< NAME.glb or NAME.gltf
    std::string folder;       ///< NAME.d
    std::string folder_name;  ///< As uris name it.
    std::string new_folder;   ///< Where side files are made.
    bool is_glb = true;
    std::unique_ptr<ScratchFile> main;
};

}  // namespace feelem
