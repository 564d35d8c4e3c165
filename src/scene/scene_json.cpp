// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_json.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace feelem {
namespace {

using nlohmann::json;

[[noreturn]] void bad(const std::string& text) {
    throw Error(Code::BadScene, "", text);
}

const json& need(const json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || found == object.end()) bad(fmt::format("the key '{}' is missing", key));
    return *found;
}

const json& list(const json& object, const char* key) {
    static const json kNone = json::array();
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || found == object.end()) return kNone;
    if (!found->is_array()) bad(fmt::format("'{}' is not a list", key));
    return *found;
}

std::string text(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::uint64_t count(const json& object, const char* key, std::uint64_t otherwise = 0) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    if (!found->is_number_unsigned()) bad(fmt::format("'{}' is not a number from 0", key));
    return found->get<std::uint64_t>();
}

int index(const json& object, const char* key, std::size_t size) {
    const auto found = object.find(key);
    if (found == object.end()) return -1;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() >= size)
        bad(fmt::format("'{}' points at nothing", key));
    return found->get<int>();
}

double number(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

/// The value whose word is `wanted`; the first one when there is none.
template <class Enum, std::size_t N>
Enum from_word(std::string_view wanted, const std::array<Enum, N>& values) {
    for (const Enum value : values) {
        if (word(value) == wanted) return value;
    }
    return values[0];
}

/// Nothing when the view is not packed.
std::optional<PackedView> read_packed(const json& view, std::size_t buffers) {
    const auto extensions = view.find("extensions");
    if (extensions == view.end() || !extensions->is_object()) return std::nullopt;
    const auto found = extensions->find("EXT_meshopt_compression");
    if (found == extensions->end()) return std::nullopt;
    if (!found->is_object()) bad("EXT_meshopt_compression is not an object");
    PackedView packed;
    packed.buffer = index(*found, "buffer", buffers);
    if (packed.buffer < 0) bad("a packed bufferView without buffer");
    packed.offset = count(*found, "byteOffset");
    packed.bytes = count(*found, "byteLength");
    packed.count = count(*found, "count");
    packed.stride = count(*found, "byteStride");
    const std::string mode = text(*found, "mode"), filter = text(*found, "filter");
    for (const Packing known : {Packing::Attributes, Packing::Triangles, Packing::Indices}) {
        if (mode == packing_word(known)) packed.mode = known;
    }
    if (filter == packing_filter_word(PackingFilter::Exponential)) packed.filter = PackingFilter::Exponential;
    const bool known_filter = filter.empty() || filter == packing_filter_word(packed.filter);
    if (mode != packing_word(packed.mode) || !known_filter)
        bad(fmt::format("a bufferView is packed as {:.20} {:.20}, which scenes do not have", mode, filter));
    return packed;
}

/// How the numbers of an accessor become values.
std::optional<gltf::Steps> read_steps(const json& accessor) {
    const auto extras = accessor.find("extras");
    if (extras == accessor.end() || !extras->is_object()) return std::nullopt;
    const auto ours = extras->find("feelem");
    if (ours == extras->end() || !ours->is_object()) return std::nullopt;
    return gltf::Steps{number(*ours, "offset"), number(*ours, "step")};
}

void read_buffers(const json& root, SceneDocument& out) {
    for (const json& buffer : list(root, "buffers"))
        out.buffers.push_back({text(buffer, "uri"), count(buffer, "byteLength")});
    for (const json& view : list(root, "bufferViews")) {
        ReadView read;
        read.view.buffer = index(view, "buffer", out.buffers.size());
        if (read.view.buffer < 0) bad("a bufferView without buffer");
        read.view.offset = count(view, "byteOffset");
        read.view.bytes = count(view, "byteLength");
        read.stride = count(view, "byteStride");
        read.view.packed = read_packed(view, out.buffers.size());
        out.views.push_back(read);
    }
}

void read_accessors(const json& root, SceneDocument& out) {
    for (const json& entry : list(root, "accessors")) {
        ReadAccessor read;
        read.accessor.name = text(entry, "name");
        read.accessor.view = index(entry, "bufferView", out.views.size());
        read.accessor.component_type = static_cast<int>(count(entry, "componentType") & 0xFFFF);
        read.accessor.count = count(entry, "count");
        read.accessor.steps = read_steps(entry);
        const std::string type = text(entry, "type");
        read.accessor.components = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 0;
        read.offset = count(entry, "byteOffset");
        const int place = static_cast<int>(out.accessors.size());
        if (!read.accessor.name.empty() && !out.by_name.emplace(read.accessor.name, place).second)
            bad(fmt::format("two accessors have the name '{}'", read.accessor.name));
        out.accessors.push_back(std::move(read));
    }
}

gltf::Primitive read_primitive(const json& mesh, std::size_t accessors) {
    const json& primitives = list(mesh, "primitives");
    if (primitives.size() != 1) bad("a part's mesh must have one primitive");
    const json& attributes = need(primitives[0], "attributes");
    gltf::Primitive out;
    out.indices = index(primitives[0], "indices", accessors);
    out.mode = static_cast<int>(count(primitives[0], "mode", gltf::kTriangles) & 0xFF);
    for (const auto& [semantic, unused] : attributes.items())
        out.attributes.emplace_back(semantic, index(attributes, semantic.c_str(), accessors));
    for (const json& target : list(primitives[0], "targets"))
        out.targets.push_back(index(target, "POSITION", accessors));
    return out;
}

void read_matrix(const json& node, std::array<double, 16>& out) {
    const auto found = node.find("matrix");
    if (found == node.end()) return;
    if (!found->is_array() || found->size() != out.size()) bad("the model's matrix is not sixteen numbers");
    for (std::size_t i = 0; i < out.size(); ++i) {
        const json& entry = (*found)[i];
        if (!entry.is_number() || !std::isfinite(entry.get<double>()))
            bad("the model's matrix is not sixteen numbers");
        out[i] = entry.get<double>();
    }
}

void read_nodes(const json& root, SceneDocument& out, std::size_t parts) {
    const json& meshes = list(root, "meshes");
    std::vector<bool> seen(parts, false);
    out.parts.resize(parts);
    for (const json& node : list(root, "nodes")) {
        if (!node.is_object() || !node.contains("extras") || !node["extras"].contains("feelem")) continue;
        const json& extras = node["extras"]["feelem"];
        const std::string role = text(extras, "role");
        if (role == "model") read_matrix(node, out.model_matrix);
        if (role != "part" && role != "edges") continue;
        const int part = index(extras, "part", parts);
        const int mesh = index(node, "mesh", meshes.size());
        if (part < 0 || mesh < 0) bad("a node of the model without part or mesh");
        gltf::Primitive primitive =
            read_primitive(meshes[static_cast<std::size_t>(mesh)], out.accessors.size());
        if (role == "edges") {
            out.edges.push_back(std::move(primitive));
            out.edge_parts.push_back(static_cast<std::size_t>(part));
            continue;
        }
        if (seen[static_cast<std::size_t>(part)]) bad(fmt::format("part {} occurs twice", part));
        seen[static_cast<std::size_t>(part)] = true;
        out.parts[static_cast<std::size_t>(part)] = std::move(primitive);
    }
    if (std::ranges::find(seen, false) != seen.end()) bad("a part has no node of its own");
}

void read_head(const json& feelem, SceneDocument& out) {
    Scene& scene = out.scene;
    if (count(feelem, "version") != 1)
        bad("extras.feelem.version is not 1. Was it written by a newer Feelem?");
    scene.title = text(feelem, "title");
    for (const json& input : list(feelem, "inputs")) {
        if (!input.is_object()) bad("an entry of 'inputs' is not an object");
        const bool has_format = input.contains("format");
        scene.inputs.push_back(
            {text(input, "name"),
             has_format ? text(input, "format") : "",
             count(input, "bytes"),
             text(input, "sha256")}
        );
    }
    scene.position_bound = number(feelem, "positionBound");
    const json& origin = need(feelem, "origin");
    if (!origin.is_array() || origin.size() != 3) bad("'origin' is not three numbers");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!origin[axis].is_number()) bad("'origin' is not three numbers");
        scene.origin[axis] = origin[axis].get<double>();
    }
    const json& unit = need(feelem, "lengthUnit");
    if (unit.is_object()) scene.length_unit = LengthUnit{text(unit, "name"), number(unit, "metres")};
    for (const json& part : list(feelem, "parts")) {
        if (!part.is_object()) bad("an entry of 'parts' is not an object");
        ScenePart read;
        read.name = text(part, "name");
        read.kind = text(part, "kind");
        read.domain = text(part, "domain");
        out.elements.push_back(text(part, "elements"));
        out.vertices.push_back(count(part, "vertices"));
        out.triangles.push_back(count(part, "triangles"));
        out.model_parts.push_back(count(part, "modelPart"));
        read.model_part = static_cast<std::uint32_t>(out.model_parts.back());
        scene.parts.push_back(std::move(read));
    }
    out.presentation_json = feelem.contains("presentation") ? feelem["presentation"].dump() : "{}";
    scene.extras_json = feelem.dump();
}

void read_steps(const json& feelem, SceneDocument& out) {
    constexpr std::array kKinds{
        StepKind::Other,
        StepKind::Static,
        StepKind::Time,
        StepKind::Mode,
        StepKind::Frequency,
        StepKind::Buckling};
    for (const json& entry : list(feelem, "steps")) {
        if (!entry.is_object()) bad("an entry of 'steps' is not an object");
        Step step;
        step.input = static_cast<std::uint32_t>(count(entry, "input"));
        step.kind = from_word(text(entry, "kind"), kKinds);
        const json& numbers = list(entry, "number");
        if (numbers.size() == 2 && numbers[0].is_number_integer() && numbers[1].is_number_integer()) {
            step.step = numbers[0].get<std::int32_t>();
            step.substep = numbers[1].get<std::int32_t>();
        }
        step.value = number(entry, "value");
        step.label = text(entry, "name");
        if (count(entry, "id") != out.scene.steps.size() + 1) bad("step ids are not 1, 2, 3, ...");
        out.scene.steps.push_back(std::move(step));
    }
}

std::optional<Extreme> read_extreme(const json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_object()) return std::nullopt;
    Extreme extreme;
    extreme.value = static_cast<float>(number(*found, "value"));
    for (const char* id : {"node", "element", "id"}) {
        if (found->contains(id) && (*found)[id].is_number_integer())
            extreme.id = (*found)[id].get<std::int64_t>();
    }
    return extreme;
}

FieldPlace read_place(const json& entry, std::size_t parts) {
    FieldPlace place;
    for (const json& names : list(entry, "accessors")) {
        std::vector<std::string>& out = place.accessors.emplace_back();
        if (names.is_string()) out.push_back(names.get<std::string>());
        if (!names.is_array()) continue;
        for (const json& name : names) {
            if (name.is_string()) out.push_back(name.get<std::string>());
        }
    }
    for (const json& name : list(entry, "valid"))
        place.masks.push_back(name.is_string() ? name.get<std::string>() : std::string());
    if (place.accessors.size() != parts || place.masks.size() != parts)
        bad("a result does not name one accessor per part");
    return place;
}

Shape shape_from(std::string_view text) {
    return text == "scalar"   ? Shape::Scalar
           : text == "vector" ? Shape::Vector
           : text == "tensor" ? Shape::SymmetricTensor
                              : Shape::Other;
}

SceneResult read_result(const json& entry) {
    using enum Averaging;
    SceneResult result;
    result.id = text(entry, "id");
    result.quantity = text(entry, "quantity");
    result.title = text(entry, "name");
    result.source = text(entry, "source");
    for (const json& name : list(entry, "components")) {
        if (name.is_string()) result.components.push_back(name.get<std::string>());
    }
    if (result.components.empty()) bad(fmt::format("result '{}' has no components", result.id));
    result.shape = shape_from(text(entry, "shape"));
    result.unit = text(entry, "unit");
    const std::string location = text(entry, "location");
    result.location = location == "element"        ? Location::Elemental
                      : location == "element-node" ? Location::ElementNodal
                                                   : Location::Nodal;
    result.averaging =
        from_word(text(entry, "averaging"), std::array{NotApplicable, Solver, Part, All, None});
    result.complex = from_word(
        text(entry, "complex"),
        std::array{Complex::No, Complex::Real, Complex::Imaginary, Complex::Amplitude, Complex::Phase}
    );
    result.layer =
        from_word(text(entry, "layer"), std::array{Layer::No, Layer::Top, Layer::Middle, Layer::Bottom});
    result.shear =
        from_word(text(entry, "shear"), std::array{Shear::NotApplicable, Shear::Engineering, Shear::Tensor});
    if (entry.contains("system")) result.system = text(entry, "system");
    result.derived = entry.contains("derived") && entry["derived"] == true;
    result.bound = number(entry, "bound");
    return result;
}

void read_results(const json& feelem, SceneDocument& out) {
    for (const json& entry : list(feelem, "results")) {
        if (!entry.is_object()) bad("an entry of 'results' is not an object");
        SceneResult result = read_result(entry);
        std::vector<FieldPlace>& places = out.fields.emplace_back();
        for (const json& values : list(entry, "values")) {
            if (!values.is_object()) bad("an entry of 'values' is not an object");
            SceneValues read;
            const std::uint64_t step = count(values, "step");
            if (step == 0 || step > out.scene.steps.size()) bad(fmt::format("there is no step {}", step));
            read.step = static_cast<std::size_t>(step - 1);
            read.min = read_extreme(values, "min");
            read.max = read_extreme(values, "max");
            read.missing_in_model = count(values, "missing");
            places.push_back(read_place(values, out.scene.parts.size()));
            result.values.push_back(std::move(read));
        }
        out.scene.results.push_back(std::move(result));
    }
}

SceneLevelValues read_level_values(const json& entry, const SceneDocument& out) {
    const auto& results = out.scene.results;
    const auto found = std::ranges::find(results, text(entry, "result"), &SceneResult::id);
    if (found == results.end()) bad(fmt::format("there is no result '{}'", text(entry, "result")));
    const std::uint64_t step = count(entry, "step");
    const auto values = std::ranges::find(found->values, step - 1, &SceneValues::step);
    if (values == found->values.end())
        bad(fmt::format("result '{}' has no values at step {}", found->id, step));
    return {
        static_cast<std::size_t>(found - results.begin()),
        static_cast<std::size_t>(values - found->values.begin()),
        number(entry, "bound"),
        number(entry, "max"),
        number(entry, "shown")};
}

void read_levels(const json& feelem, SceneDocument& out) {
    for (const json& entry : list(feelem, "levels")) {
        if (!entry.is_object()) bad("an entry of 'levels' is not an object");
        SceneLevel level;
        level.triangles = count(entry, "triangles");
        level.bound = number(entry, "bound");
        const json& distance = need(entry, "distance");
        if (!distance.is_object()) bad("'distance' of a level is not an object");
        level.distance_bound = number(distance, "bound");
        level.max_distance = number(distance, "max");
        level.samples = count(entry, "samples");
        for (const json& values : list(entry, "values")) {
            if (!values.is_object()) bad("an entry of a level's 'values' is not an object");
            level.values.push_back(read_level_values(values, out));
        }
        std::vector<std::string>& names = out.level_indices.emplace_back();
        for (const json& name : list(entry, "indices"))
            names.push_back(name.is_string() ? name.get<std::string>() : std::string());
        if (names.size() != out.scene.parts.size()) bad("a level does not name one array per part");
        out.scene.levels.push_back(std::move(level));
    }
}

/// Result and step that an entry of extras names.
std::pair<std::size_t, std::size_t> read_shown(const json& entry, const SceneDocument& out) {
    const auto& results = out.scene.results;
    const auto found = std::ranges::find(results, text(entry, "result"), &SceneResult::id);
    const std::uint64_t step = count(entry, "step");
    if (found == results.end() || step == 0 || step > out.scene.steps.size())
        bad(fmt::format("there is no result '{}' at step {}", text(entry, "result"), step));
    return {static_cast<std::size_t>(found - results.begin()), static_cast<std::size_t>(step - 1)};
}

Scale scale_from(std::string_view text) {
    return text == "log"      ? Scale::Log
           : text == "signed" ? Scale::Signed
           : text == "symlog" ? Scale::SymLog
                              : Scale::Linear;
}

void read_what_is_shown(const json& feelem, SceneDocument& out) {
    for (const json& entry : list(feelem, "texcoords")) {
        const json& range = need(entry, "range");
        if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number())
            bad("the range of a texture coordinate is not two numbers");
        TexcoordClaim claim;
        std::tie(claim.result, claim.step) = read_shown(entry, out);
        claim.set = static_cast<std::size_t>(count(entry, "set"));
        claim.component = text(entry, "component");
        claim.range = {range[0].get<double>(), range[1].get<double>(), scale_from(text(entry, "scale"))};
        out.texcoords.push_back(std::move(claim));
    }
    const json& deformation = need(feelem, "deformation");
    if (!deformation.is_object()) return;
    const auto [result, step] = read_shown(deformation, out);
    out.deformation = DeformationClaim{result, step, number(deformation, "factor")};
}

void read_certificate(const json& feelem, CertificateClaims& out) {
    const json& certificate = need(feelem, "certificate");
    const json& scene = need(certificate, "scene");
    out.scene_vertices = count(scene, "vertices");
    out.scene_triangles = count(scene, "triangles");
    out.scene_edges = count(scene, "edges");
    out.scene_area = number(scene, "area");
    out.scene_volume = number(scene, "volume");
    const json& skin = need(certificate, "skin");
    out.skin_vertices = count(skin, "vertices");
    out.skin_triangles = count(skin, "triangles");
    const json& closed = need(skin, "closed");
    if (closed.is_boolean()) out.closed = closed.get<bool>();
    out.area = number(skin, "area");
    out.volume = number(skin, "volume");
    const json& facets = need(skin, "facets");
    out.facets_in = count(facets, "in");
    out.facets_kept = count(facets, "kept");
    out.facets_unmatched = count(facets, "unmatched");
    const json& dropped = need(facets, "dropped");
    for (const char* why : {"inner", "manyOwners", "collapsed", "ofDuplicates"})
        out.facets_dropped += count(dropped, why);
    for (const json& entry : list(certificate, "results")) {
        const json& on_skin = need(entry, "skin");
        CertificateResult claim;
        claim.result = text(entry, "result");
        claim.step = static_cast<std::size_t>(count(entry, "step"));
        const json& over_model = need(entry, "model");
        claim.model_min = read_extreme(over_model, "min");
        claim.model_max = read_extreme(over_model, "max");
        claim.model_missing = count(over_model, "missing");
        claim.skin.min = read_extreme(on_skin, "min");
        claim.skin.max = read_extreme(on_skin, "max");
        claim.skin.missing = count(on_skin, "missing");
        claim.skin.interpolated = count(on_skin, "interpolated");
        out.results.push_back(std::move(claim));
    }
    const json& digests = need(certificate, "digests");
    if (!digests.is_object()) bad("'digests' is not an object");
    for (const auto& [name, digest] : digests.items()) {
        if (digest.is_string()) out.digests.emplace(name, digest.get<std::string>());
    }
}

/// Numbers of nested objects under dotted names.
void read_numbers(
    const json& object, const std::string& name, int depth, std::map<std::string, double>& out
) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_number()) out.emplace(name + "." + key, value.get<double>());
        if (value.is_object() && depth > 0) read_numbers(value, name + "." + key, depth - 1, out);
    }
}

SceneDocument read_document(const json& root) {
    SceneDocument out;
    if (!root.is_object() || !root.contains("extras") || !root["extras"].is_object() ||
        !root["extras"].contains("feelem"))
        bad("a glTF file, but not one of Feelem's: extras.feelem is missing");
    const json& feelem = root["extras"]["feelem"];
    if (!feelem.is_object()) bad("extras.feelem is not an object");
    read_buffers(root, out);
    read_accessors(root, out);
    read_head(feelem, out);
    read_nodes(root, out, out.scene.parts.size());
    read_steps(feelem, out);
    read_results(feelem, out);
    read_levels(feelem, out);
    read_what_is_shown(feelem, out);
    read_certificate(feelem, out.certificate);
    for (const char* name : {"model", "skin"}) {
        const json& object = need(need(feelem, "certificate"), name);
        if (object.is_object()) read_numbers(object, name, 2, out.scene.certificate_numbers);
    }
    if (const json& notes = need(feelem, "certificate");
        notes.contains("notes") && notes["notes"].is_object()) {
        for (const auto& [name, note] : notes["notes"].items()) {
            if (note.is_string()) out.scene.notes.emplace(name, note.get<std::string>());
        }
    }
    return out;
}

}  // namespace

SceneDocument parse_scene_json(std::string_view text, const std::string& where) {
    try {
        return read_document(json::parse(text));
    } catch (const Error& error) {
        throw Error(error.code(), where, error.what());
    } catch (const json::exception& error) {
        throw Error(Code::BadScene, where, std::string("its JSON cannot be read: ") + error.what());
    }
}

}  // namespace feelem
