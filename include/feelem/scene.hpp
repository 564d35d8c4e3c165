// SPDX-License-Identifier: Apache-2.0
// The scene of docs/scene-format.md: written as .glb or .gltf, read back, and checked against its
// certificate.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/present.hpp"
#include "feelem/surface.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace feelem {

/// Smallest or largest value of a result over the whole model, with its solver id (smallest id on a tie).
struct Extreme {
    float value = 0;
    std::int64_t id = 0;
};

/// One result at one step, as the scene lists it.
struct SceneValues {
    std::size_t step = 0;                ///< Into SceneContents::steps.
    std::optional<Extreme> min, max;     ///< Scalars only: of the solver's values over the whole model.
    std::uint64_t missing_in_model = 0;  ///< Nodes (elements) of the model without a value.
};

/// One result of the scene: as the solver gave it, or one derived scalar of it.
struct SceneResult {
    std::string id;                       ///< Unique, [a-z0-9_]+: "temperature", "stress_von_mises".
    std::string quantity;                 ///< docs/cli.md's name: "stress".
    std::string title;                    ///< For people: "von Mises stress".
    std::string source;                   ///< The solver's name: "STRESS".
    std::vector<std::string> components;  ///< {"value"}, {"x","y","z"}, {"von_mises"}, {"xx",...}.
    Shape shape = Shape::Scalar;
    std::string unit;  ///< Empty: unknown.
    Location location = Location::Nodal;
    Averaging averaging = Averaging::NotApplicable;
    Complex complex = Complex::No;
    Layer layer = Layer::No;
    Shear shear = Shear::NotApplicable;
    std::string system;  ///< Of the components, as ResultInfo says it; empty: the global one.
    bool derived = false;
    std::vector<SceneValues> values;
    /// Of all components over the model and all steps, as the solver gave them: what SceneOptions::bound is a
    /// part of. Empty: unknown, or no value at all.
    std::optional<std::array<float, 2>> range;
    /// Each value in the scene differs from the solver's by at most this, in the result's unit. 0: bit for
    /// bit.
    double bound = 0;
};

/// What holds for one result at one step while a level is drawn: no component is shown further off than
/// `bound` (the whole vector, of vectors).
struct SceneLevelValues {
    std::size_t result = 0, values = 0;  ///< Into the scene's results, and their values.
    double bound = 0;                    ///< In the result's unit.
    double max = 0;                      ///< Found by the simplifier, with the middles of triangles.
    double shown = 0;                    ///< Found by the independent checker at every original vertex.
};

/// A level of detail: fewer triangles over the same vertices, and what is promised while it is drawn.
struct SceneLevel {
    std::uint64_t triangles = 0;
    double bound = 0;  ///< Largest of the values' bounds, fraction of the result's range.
    double distance_bound = 0,
           max_distance = 0;    ///< Model units, between original vertices and what is drawn, and back.
    std::uint64_t samples = 0;  ///< Vertices and middles of triangles that were compared.
    std::vector<SceneLevelValues> values;  ///< By result and step: every one of the scene.
};

/// Everything a scene is made of. Fields are asked for one at a time, so that memory holds one.
struct SceneContents {
    std::string title;
    SolverInfo solver;
    std::vector<InputRecord> inputs;
    const Mesh* mesh = nullptr;
    const Surface* surface = nullptr;
    char up = 'z';  ///< The model's up axis.
    std::vector<Step> steps;
    std::vector<SceneResult> results;
    std::size_t shown_step = 0;  ///< Step whose results stand in the attributes.
    std::function<SurfaceField(std::size_t result, std::size_t values)> load;
    std::vector<SceneLevel> levels;  ///< From fine to coarse, without the full one.
    /// Per level: its triangles, in the order of the parts.
    std::vector<std::vector<std::array<VertexIndex, 3>>> level_triangles;
    Presentation presentation;  ///< Ranges resolved: lo and hi set on every result it uses.
    std::map<std::string, std::string>
        notes;  ///< Facts for the certificate: "midside_interpolated" -> "5124", "skin" -> "exact".
};

struct SceneOptions {
    std::uint64_t embed_limit = 4u << 20;  ///< Side files smaller than this in all stay inside the .glb.
    bool compress = false;  ///< Arrays by EXT_meshopt_compression: smaller, for Feelem's viewers alone.
    /// With `compress`: values may differ by this part of their result's range (0.0001), positions by
    /// 1/131072 of the model's largest side; both are stated in the scene. 0: nothing is lost.
    double bound = 0;
};

/// Atomic: on failure the old file is still there. Throws Error(WriteFailed).
void write_scene(
    const SceneContents& contents,
    const std::string& path,
    const SceneOptions& options,
    Diagnostics& diagnostics
);

/// Vertices of the skin as a scene with these options holds them: rounded to float32 or to the grid of a
/// compressed scene, origin subtracted.
std::vector<Point3> scene_positions(const Surface& surface, const SceneOptions& options);

/// A scene read back: what `probe` and `check` need.
struct ScenePart {
    std::string name;
    std::string kind;                             ///< solid shell beam point
    std::string domain;                           ///< node element-node
    std::uint32_t model_part = 0;                 ///< Into Mesh::parts of the model.
    std::vector<std::array<float, 3>> positions;  ///< Model units minus origin.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::int64_t> node_ids;     ///< Per vertex; 0 = none.
    std::vector<std::int64_t> element_ids;  ///< Per triangle.
};
struct SceneField {
    std::size_t result = 0;
    std::size_t step = 0;  ///< Into Scene::steps.
    std::size_t part = 0;
    std::vector<float> values;  ///< vertices x components; NaN where the mask says missing.
    std::vector<Validity> validity;
};
struct Scene {
    std::string title;
    std::vector<InputRecord> inputs;  ///< Paths without folders.
    Point3 origin{};
    double position_bound = 0;  ///< Model units: beyond float32's own rounding. 0: none.
    std::optional<LengthUnit> length_unit;
    std::vector<ScenePart> parts;
    std::vector<Step> steps;
    std::vector<SceneResult> results;
    Presentation presentation;
    std::vector<SceneField> fields;            ///< Filled by load_scene.
    std::vector<SceneLevel> levels;            ///< What they say; their triangles stay in the file.
    std::map<std::string, std::string> notes;  ///< Of the certificate: "skin" -> "exact".
    /// Numbers of the certificate's "model" and "skin": "skin.facets.in" -> 7608.
    std::map<std::string, double> certificate_numbers;
    std::string extras_json;  ///< extras.feelem as written.
};
/// Throws Error(BadScene) on anything that is not a scene of ours.
Scene load_scene(const std::string& path);

/// One claim of the certificate that was recomputed.
struct Claim {
    std::string name;  ///< "digest p0/_TEMPERATURE/1"
    std::string claimed, found;
    bool holds = false;
};
/// Digests, counts, closedness, area, volume, extremes and id maps against the certificate.
std::vector<Claim> check_scene(const std::string& path);

}  // namespace feelem
