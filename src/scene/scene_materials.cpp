// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_materials.hpp"

#include "scene/legend.hpp"
#include "scene/scene_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace feelem {
namespace {

/// The three looks of a result, in the order of the variants.
enum class Look : std::uint8_t {
    Smooth,
    Bands,
    Shaded
};
constexpr std::array kLooks{Look::Smooth, Look::Bands, Look::Shaded};

std::string variant_name(const SceneBuild& build, std::size_t set, Look look) {
    const ColouredResult& coloured = build.coloured[set];
    const SceneResult& result = build.contents.results[coloured.result];
    std::string name = result.title.empty() ? result.id : result.title;
    if (result.components.size() > 1) name += " " + coloured.component_name;
    // Titles may repeat (two inputs, two layers): variants are chosen by name.
    for (std::size_t other = 0; other < set; ++other) {
        if (variant_name(build, other, Look::Smooth) == name) name = fmt::format("{} ({})", name, result.id);
    }
    constexpr std::array kSuffix{"", ", bands", ", shaded"};
    return name + kSuffix[static_cast<std::size_t>(look)];
}

ColourEffect effect_of(const ColouredResult& coloured, Look look) {
    constexpr int kUsualBands = 9;
    ColourEffect effect = coloured.effect;
    if (look == Look::Bands)
        effect.bands = effect.bands > 0 ? effect.bands : kUsualBands;
    else
        effect.bands = 0;
    return effect;
}

/// Textures by their bytes, so that results with the same colours share one.
struct Textures {
    SceneBuild& build;
    std::map<std::pair<std::string, int>, int> known{};

    int sampler(int filter) {
        std::vector<int>& samplers = build.document.samplers;
        const auto found = std::ranges::find(samplers, filter);
        if (found != samplers.end()) return static_cast<int>(found - samplers.begin());
        samplers.push_back(filter);
        return static_cast<int>(samplers.size()) - 1;
    }
    int add(const std::string& name, const Picture& picture, int filter) {
        std::string bytes = png_bytes(picture);
        const auto [place, is_new] = known.try_emplace({std::move(bytes), filter}, 0);
        if (!is_new) return place->second;
        gltf::Document& document = build.document;
        const int view = build.arrays.blob(std::as_bytes(std::span(place->first.first)));
        document.images.push_back({name, view});
        document.textures.push_back({sampler(filter), static_cast<int>(document.images.size()) - 1});
        return place->second = static_cast<int>(document.textures.size()) - 1;
    }
};

/// Materials of one variant: of the parts with one side, with two sides, and of the legend.
struct VariantMaterials {
    int single = -1, both = -1, legend = -1;
};

int add_material(SceneBuild& build, gltf::Material material) {
    build.document.materials.push_back(std::move(material));
    return static_cast<int>(build.document.materials.size()) - 1;
}

LegendText legend_text(const SceneBuild& build, const ColouredResult& coloured) {
    const SceneResult& result = build.contents.results[coloured.result];
    const Step& step = build.contents.steps[result.values[coloured.values].step];
    LegendText text;
    text.title = result.title.empty() ? result.id : result.title;
    text.component = coloured.component_name;
    text.unit = result.unit;
    text.step = fmt::format("step {}.{}", step.step, step.substep);
    if (step.kind == StepKind::Time) text.step += fmt::format("  t = {:.6g} s", step.value);
    if (step.kind == StepKind::Mode || step.kind == StepKind::Frequency)
        text.step += fmt::format("  {} {:.6g} Hz", word(step.kind), step.value);
    if (build.deformation) {
        text.deformation = build.deformation->name.substr(build.deformation->name.find(' ') + 1);
        text.animated = true;
    }
    return text;
}

VariantMaterials add_variant(SceneBuild& build, Textures& textures, std::size_t set, Look look) {
    const ColouredResult& coloured = build.coloured[set];
    const ColourEffect effect = effect_of(coloured, look);
    const std::string name = variant_name(build, set, look);
    const char* kind = look == Look::Bands ? "palette, bands" : "palette";
    gltf::Material material{name, look != Look::Shaded, false, -1, static_cast<int>(set), {1, 1, 1}};
    material.texture = textures.add(kind, palette_picture(effect), gltf::kNearest);
    VariantMaterials out;
    const auto is_shell = [](const ScenePartBuild& part) { return part.double_sided; };
    if (!std::ranges::all_of(build.parts, is_shell)) out.single = add_material(build, material);
    if (std::ranges::any_of(build.parts, is_shell)) {
        material.name += ", both sides";
        material.double_sided = true;
        out.both = add_material(build, material);
    }
    if (look == Look::Shaded) return out;  // its legend is that of the smooth look
    const Picture picture = legend_picture(legend_text(build, coloured), coloured.range, effect);
    gltf::Material legend{"legend: " + name, true, true, -1, 0, {1, 1, 1}};
    legend.texture = textures.add("legend: " + name, picture, gltf::kLinear);
    out.legend = add_material(build, legend);
    return out;
}

/// Right of the model, facing the viewer, in metres.
gltf::Mesh legend_mesh(SceneBuild& build) {
    const Point3 a = to_metres(build, build.box.low), b = to_metres(build, build.box.high);
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(a[axis], b[axis]);
        box.high[axis] = std::max(a[axis], b[axis]);
    }
    // A flat model has no height of its own.
    const double tall = std::max(box.side(1), 0.25 * box.largest());
    const double height = 0.8 * tall;
    const double left = box.high[0] + 0.05 * height, low = box.low[1] + 0.1 * tall;
    const double right = left + height / 2, high = low + height, z = box.centre(2);
    const std::array<std::array<double, 2>, 4> corners{
        {{left, low}, {right, low}, {right, high}, {left, high}}};
    const std::array<std::array<float, 2>, 4> coordinates{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    constexpr std::array<std::uint32_t, 6> kIndices{0, 1, 2, 0, 2, 3};
    gltf::Mesh mesh;
    mesh.name = "legend";
    const ArraySpec positions{"legend/POSITION", 3, 4, gltf::kAttributeTarget};
    const int position = build.arrays.floats(positions, [&](std::size_t i, float* out) {
        out[0] = static_cast<float>(corners[i][0]);
        out[1] = static_cast<float>(corners[i][1]);
        out[2] = static_cast<float>(z);
    });
    const ArraySpec texcoords{"legend/TEXCOORD_0", 2, 4, gltf::kAttributeTarget, false};
    const int texcoord = build.arrays.floats(texcoords, [&](std::size_t i, float* out) {
        std::ranges::copy(coordinates[i], out);
    });
    mesh.primitive.attributes = {{"POSITION", position}, {"TEXCOORD_0", texcoord}};
    const ArraySpec indices{"legend/indices", 1, 6, gltf::kIndexTarget};
    mesh.primitive.indices = build.arrays.indices(indices, 4, [&](std::size_t i) { return kIndices[i]; });
    return mesh;
}

/// A triangle without area, which any material can be put on.
gltf::Primitive swatch_primitive(SceneBuild& build) {
    Point3 centre{};
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = build.box.centre(axis);
    const Point3 at = to_metres(build, centre);
    gltf::Primitive primitive;
    const ArraySpec positions{"swatches/POSITION", 3, 3, gltf::kAttributeTarget};
    primitive.attributes
        .emplace_back("POSITION", build.arrays.floats(positions, [&](std::size_t, float* out) {
            for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = static_cast<float>(at[axis]);
        }));
    for (std::size_t set = 0; set < std::max<std::size_t>(build.coloured.size(), 1); ++set) {
        const std::string semantic = fmt::format("TEXCOORD_{}", set);
        const ArraySpec spec{"swatches/" + semantic, 2, 3, gltf::kAttributeTarget, false};
        primitive.attributes.emplace_back(semantic, build.arrays.floats(spec, [](std::size_t, float* out) {
            out[0] = 0.5F;
            out[1] = 0;
        }));
    }
    return primitive;
}

/// model-viewer tone-maps a variant's material unless some primitive has it as its own.
void add_swatches(SceneBuild& build, const std::set<int>& worn, std::vector<gltf::Node>& out) {
    const int count = static_cast<int>(build.document.materials.size());
    if (static_cast<int>(worn.size()) == count) return;
    gltf::Node group{"swatches", "swatches", -1, -1, {}, {}};
    const gltf::Primitive primitive = swatch_primitive(build);
    for (int material = 0; material < count; ++material) {
        if (worn.contains(material)) continue;
        gltf::Mesh mesh;
        mesh.name = "swatch: " + build.document.materials[static_cast<std::size_t>(material)].name;
        mesh.primitive = primitive;
        mesh.primitive.material = material;
        build.document.meshes.push_back(std::move(mesh));
        group.children.push_back(static_cast<int>(build.document.meshes.size()) - 1);  // a mesh, until placed
    }
    out.push_back(std::move(group));
}

void map_variants(gltf::Primitive& primitive, const std::vector<int>& materials) {
    primitive.material = materials[0];
    for (std::size_t variant = 0; variant < materials.size(); ++variant) {
        const auto same = std::ranges::find(primitive.mappings, materials[variant], &gltf::Mapping::material);
        if (same == primitive.mappings.end())
            primitive.mappings.push_back({materials[variant], {static_cast<int>(variant)}});
        else
            same->variants.push_back(static_cast<int>(variant));
    }
}

/// Parts and edges of a scene that shows no result.
void write_plain(SceneBuild& build, std::set<int>& worn) {
    for (ScenePartBuild& part : build.parts) {
        gltf::Material plain{part.name, false, part.double_sided, -1, 0, {0.6, 0.6, 0.6}};
        part.mesh.primitive.material = add_material(build, std::move(plain));
        worn.insert(part.mesh.primitive.material);
    }
}

gltf::Node write_coloured(SceneBuild& build, std::set<int>& worn) {
    Textures textures{build};
    std::vector<int> single, both, legends;
    for (std::size_t set = 0; set < build.coloured.size(); ++set) {
        int smooth_legend = -1;
        for (const Look look : kLooks) {
            const VariantMaterials made = add_variant(build, textures, set, look);
            if (look == Look::Smooth) smooth_legend = made.legend;
            single.push_back(made.single);
            both.push_back(made.both);
            legends.push_back(made.legend >= 0 ? made.legend : smooth_legend);
            build.document.variants.push_back(variant_name(build, set, look));
        }
    }
    for (ScenePartBuild& part : build.parts) {
        map_variants(part.mesh.primitive, part.double_sided ? both : single);
        worn.insert(part.mesh.primitive.material);
    }
    gltf::Mesh legend = legend_mesh(build);
    map_variants(legend.primitive, legends);
    worn.insert(legend.primitive.material);
    build.document.meshes.push_back(std::move(legend));
    return {"legend", "legend", -1, static_cast<int>(build.document.meshes.size()) - 1, {}, {}};
}

}  // namespace

std::vector<gltf::Node> write_materials(SceneBuild& build) {
    std::set<int> worn;
    std::vector<gltf::Node> beside;
    if (build.coloured.empty())
        write_plain(build, worn);
    else
        beside.push_back(write_coloured(build, worn));
    const auto has_edges = [](const ScenePartBuild& part) { return part.edge_mesh >= 0; };
    if (std::ranges::any_of(build.parts, has_edges)) {
        const int material = add_material(build, {"edges", true, false, -1, 0, {0.1, 0.1, 0.1}});
        worn.insert(material);
        for (const ScenePartBuild& part : build.parts) {
            if (part.edge_mesh >= 0)
                build.document.meshes[static_cast<std::size_t>(part.edge_mesh)].primitive.material = material;
        }
    }
    add_swatches(build, worn, beside);
    return beside;
}

}  // namespace feelem
