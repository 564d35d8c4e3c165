// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_extras.hpp"

#include "scene/json_text.hpp"
#include "scene/scene_fields.hpp"
#include "scene/scene_levels.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem {
namespace {

void write_inputs(JsonText& json, const SceneContents& contents) {
    json.key("inputs").begin_array();
    for (const InputRecord& input : contents.inputs) {
        const std::size_t slash = input.path.find_last_of('/');
        json.begin_object().member("name", input.path.substr(slash == std::string::npos ? 0 : slash + 1));
        json.member("format", input.format).member("bytes", input.bytes);
        json.key("sha256").text_or_null(input.sha256);
        json.end_object();
    }
    json.end_array();
}

void write_parts(JsonText& json, const SceneBuild& build) {
    json.key("parts").begin_array();
    for (std::size_t i = 0; i < build.parts.size(); ++i) {
        const ScenePartBuild& part = build.parts[i];
        json.begin_object()
            .member("id", i)
            .member("name", part.name)
            .member("kind", scene_kind(part.range->kind));
        json.member("domain", build.contents.surface->domain == Domain::Node ? "node" : "element-node");
        json.member("vertices", part.range->vertex_count).member("triangles", part.range->triangle_count);
        json.member("elements", part.prefix + "elements").member("modelPart", raw(part.range->part));
        json.end_object();
    }
    json.end_array();
}

void write_steps(JsonText& json, const SceneContents& contents) {
    json.key("steps").begin_array();
    for (std::size_t i = 0; i < contents.steps.size(); ++i) {
        const Step& step = contents.steps[i];
        json.begin_object().member("id", i + 1).member("kind", word(step.kind)).member("input", step.input);
        json.key("number").begin_array().value(step.step).value(step.substep).end_array();
        json.member("value", step.value).key("unit");
        if (step.kind == StepKind::Time)
            json.value("s");
        else if (step.kind == StepKind::Mode || step.kind == StepKind::Frequency)
            json.value("Hz");
        else
            json.null();
        json.member(
            "name", step.label.empty() ? fmt::format("Step {}.{}", step.step, step.substep) : step.label
        );
        json.end_object();
    }
    json.end_array();
}

void write_extreme(JsonText& json, const std::optional<Extreme>& extreme, Location location) {
    if (!extreme) {
        json.null();
        return;
    }
    json.begin_object().member("value", static_cast<double>(extreme->value));
    json.member(location == Location::Elemental ? "element" : "node", extreme->id).end_object();
}

void write_names(JsonText& json, const std::vector<std::string>& names) {
    if (names.empty()) {
        json.null();
        return;
    }
    if (names.size() == 1) {
        json.value(names[0]);
        return;
    }
    json.begin_array();
    for (const std::string& name : names) json.value(name);
    json.end_array();
}

void write_values(
    JsonText& json, const SceneResult& result, const SceneValues& values, const WrittenField& field
) {
    json.begin_object().member("step", step_id(values)).key("accessors").begin_array();
    for (const auto& names : field.accessors) write_names(json, names);
    json.end_array().key("valid").begin_array();
    for (const std::string& mask : field.masks) json.text_or_null(mask);
    json.end_array().member("missing", values.missing_in_model).key("min");
    write_extreme(json, values.min, result.location);
    json.key("max");
    write_extreme(json, values.max, result.location);
    json.end_object();
}

std::string_view shape_word(Shape shape) {
    switch (shape) {
    case Shape::Scalar: return "scalar";
    case Shape::Vector: return "vector";
    case Shape::SymmetricTensor: return "tensor";
    case Shape::Other: return "other";
    }
    return "other";
}

double range_width(const SceneResult& result) {
    const auto range = result.range.value_or(std::array{0.0F, 0.0F});
    return static_cast<double>(range[1]) - static_cast<double>(range[0]);
}

void write_result(JsonText& json, const SceneBuild& build, std::size_t index) {
    const SceneResult& result = build.contents.results[index];
    json.begin_object().member("id", result.id).member("attribute", build.attribute_names[index]);
    json.member("name", result.title.empty() ? result.id : result.title).member("quantity", result.quantity);
    json.member("source", result.source).key("components").begin_array();
    for (const std::string& component : result.components) json.value(component);
    json.end_array().member("shape", shape_word(result.shape)).key("unit").text_or_null(result.unit);
    json.member("location", scene_location(result.location));
    json.key("averaging").text_or_null(word(result.averaging));
    json.key("complex");
    if (result.complex == Complex::No)
        json.value(false);
    else
        json.value(word(result.complex));
    json.key("layer").text_or_null(word(result.layer)).key("shear").text_or_null(word(result.shear));
    json.key("system").text_or_null(result.system);
    json.member("derived", result.derived);
    const auto& written = build.written[index];
    if (!std::ranges::all_of(written, &WrittenField::exact))
        json.member("bound", build.options.bound * range_width(result));
    json.key("values").begin_array();
    for (std::size_t v = 0; v < result.values.size(); ++v)
        write_values(json, result, result.values[v], build.written[index][v]);
    json.end_array().end_object();
}

void write_texcoords(JsonText& json, const SceneBuild& build) {
    json.key("texcoords").begin_array();
    for (std::size_t set = 0; set < build.coloured.size(); ++set) {
        const ColouredResult& coloured = build.coloured[set];
        const SceneResult& result = build.contents.results[coloured.result];
        json.begin_object()
            .member("set", set)
            .member("result", result.id)
            .member("component", coloured.component_name);
        json.member("step", step_id(result.values[coloured.values])).key("range").begin_array();
        json.value(coloured.range.lo).value(coloured.range.hi).end_array();
        json.member("scale", scale_word(coloured.range.scale)).end_object();
    }
    json.end_array();
}

void write_deformation(JsonText& json, const SceneBuild& build) {
    json.key("deformation");
    if (!build.deformation) {
        json.null();
        return;
    }
    const ShapeResult& shape = build.deformation->shapes[0];
    const SceneResult& result = build.contents.results[shape.result];
    json.begin_object().member("result", result.id).member("step", step_id(result.values[shape.values]));
    json.member("factor", build.deformation->factor).end_object();
}

}  // namespace

std::string_view scene_location(Location location) {
    switch (location) {
    case Location::Nodal:
    case Location::PartNodal: return "node";
    case Location::Elemental: return "element";
    case Location::ElementNodal: return "element-node";
    }
    return "node";
}

std::string_view scene_kind(PartKind kind) {
    switch (kind) {
    case PartKind::Solid: return "solid";
    case PartKind::Shell: return "shell";
    case PartKind::Beam: return "beam";
    case PartKind::Point: return "point";
    }
    return "solid";
}

std::string_view scale_word(Scale scale) {
    switch (scale) {
    case Scale::Linear: return "linear";
    case Scale::Log: return "log";
    case Scale::Signed: return "signed";
    case Scale::SymLog: return "symlog";
    }
    return "linear";
}

std::string extras_text(const SceneBuild& build) {
    const SceneContents& contents = build.contents;
    JsonText json;
    json.begin_object().member("version", 1).member("feelem", FEELEM_VERSION).member("title", contents.title);
    json.key("solver").begin_object().key("name").text_or_null(contents.solver.name);
    json.key("version").text_or_null(contents.solver.version).end_object();
    write_inputs(json, contents);
    json.key("lengthUnit");
    const std::optional<LengthUnit>& unit = contents.mesh->length_unit;
    if (unit && unit->metres > 0)
        json.begin_object().member("name", unit->name).member("metres", unit->metres).end_object();
    else
        json.null();
    json.member("upAxis", std::string_view(&contents.up, 1)).key("origin").begin_array();
    for (const double coordinate : build.origin) json.value(coordinate);
    json.end_array();
    // Half a step of the grid, and what rounding to float32 before it may add.
    if (build.options.compress && build.options.bound > 0) json.member("valueBound", build.options.bound);
    if (build.grid > 0) json.member("positionBound", 0.5 * static_cast<double>(build.grid) * (1 + 1e-6));
    write_parts(json, build);
    write_steps(json, contents);
    json.key("results").begin_array();
    for (std::size_t i = 0; i < contents.results.size(); ++i) write_result(json, build, i);
    json.end_array();
    write_levels(json, build);
    write_texcoords(json, build);
    write_deformation(json, build);
    json.key("hotspots").begin_array().end_array();
    json.key("presentation").raw(presentation_json(contents.presentation));
    json.key("certificate").raw(certificate_text(build)).end_object();
    return json.text();
}

}  // namespace feelem
