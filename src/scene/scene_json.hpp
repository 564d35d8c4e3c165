// SPDX-License-Identifier: Apache-2.0
// The JSON of a scene read into plain structs: the only file of this folder that knows a JSON library.
#pragma once

#include "scene/gltf.hpp"

#include "feelem/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// An accessor with what reading it needs.
struct ReadAccessor {
    gltf::Accessor accessor;
    std::uint64_t offset = 0;
};
struct ReadView {
    gltf::View view;
    std::uint64_t stride = 0;  ///< 0: tightly packed.
};

/// Where one result at one step stands.
struct FieldPlace {
    std::vector<std::vector<std::string>> accessors;  ///< Per part.
    std::vector<std::string> masks;
};

struct CertificateSkin {
    std::optional<Extreme> min, max;
    std::uint64_t missing = 0, interpolated = 0;
};
struct CertificateResult {
    std::string result;
    std::size_t step = 0;  ///< Id.
    CertificateSkin skin;
    std::optional<Extreme> model_min, model_max;
    std::uint64_t model_missing = 0;
};
/// The claims that can be recomputed from the scene alone.
struct CertificateClaims {
    std::uint64_t scene_vertices = 0, scene_triangles = 0, scene_edges = 0;
    double scene_area = 0, scene_volume = 0;
    std::uint64_t skin_vertices = 0, skin_triangles = 0;
    std::uint64_t facets_unmatched = 0;
    std::uint64_t facets_in = 0, facets_kept = 0, facets_dropped = 0;
    std::optional<bool> closed;
    double area = 0, volume = 0;
    std::vector<CertificateResult> results;
    std::map<std::string, std::string> digests;
};

/// TEXCOORD_<set> of all parts, as extras say what it shows. `result` counts in Scene::results.
struct TexcoordClaim {
    std::size_t set = 0, result = 0, step = 0;  ///< Step from 0.
    std::string component;
    ValueRange range;
};
struct DeformationClaim {
    std::size_t result = 0, step = 0;
    double factor = 0;
};

struct SceneDocument {
    std::vector<gltf::Buffer> buffers;
    std::vector<ReadView> views;
    std::vector<ReadAccessor> accessors;
    std::map<std::string, int> by_name;
    std::vector<gltf::Primitive> parts;   ///< Of role "part", by part id.
    std::vector<std::string> elements;    ///< Accessor per part.
    std::vector<gltf::Primitive> edges;   ///< Of role "edges".
    std::vector<std::size_t> edge_parts;  ///< Which part each of them belongs to.
    /// Of the node of role "model", column-major: model units minus origin -> metres, +Y up.
    std::array<double, 16> model_matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::vector<std::uint64_t> vertices;  ///< As extras say, per part.
    std::vector<std::uint64_t> triangles;
    std::vector<std::uint64_t> model_parts;  ///< Which part of the model; solids and shells may share one.
    std::vector<std::vector<FieldPlace>> fields;  ///< [result][values]
    std::vector<std::vector<std::string>>
        level_indices;  ///< [level][part]; empty: nothing of the part is left.
    Scene scene;        ///< All but geometry and fields.
    std::vector<TexcoordClaim> texcoords;
    std::optional<DeformationClaim> deformation;
    std::string presentation_json;
    CertificateClaims certificate;
};

/// Throws Error(BadScene) with `where` and the path of the key.
SceneDocument parse_scene_json(std::string_view json, const std::string& where);

}  // namespace feelem
