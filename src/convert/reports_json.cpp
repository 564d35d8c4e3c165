// SPDX-License-Identifier: Apache-2.0
// The JSON forms of info, probe and check: the contract of docs/cli.md.
#include "feelem/convert.hpp"
#include "feelem/probe.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace feelem {
namespace {

using Json = nlohmann::ordered_json;

/// A float as the double of its shortest decimal, so that 0.1f is printed as 0.1; null for missing.
Json number(float value) {
    if (!std::isfinite(value)) return nullptr;
    const std::string text = fmt::format("{}", value);
    double shortest = 0;
    std::from_chars(text.data(), text.data() + text.size(), shortest);
    return shortest;
}

Json number(double value) {
    if (!std::isfinite(value)) return nullptr;
    return value;
}

Json text_or_null(std::string_view text) {
    if (text.empty()) return nullptr;
    return text;
}

std::string_view word(SkinMethod method) {
    switch (method) {
    case SkinMethod::Exact: return "exact";
    case SkinMethod::NodeList: return "node-list";
    case SkinMethod::All: return "all";
    }
    return "exact";
}

std::string_view word(Severity severity) {
    switch (severity) {
    case Severity::Note: return "note";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
    }
    return "note";
}

Json counts(const std::vector<std::pair<std::string, std::uint64_t>>& rows) {
    Json json = Json::object();
    for (const auto& [name, count] : rows) json[name] = count;
    return json;
}

/// A list, since two sets may have the same name.
Json sets(const std::vector<std::pair<std::string, std::uint64_t>>& rows, const char* members) {
    Json json = Json::array();
    for (const auto& [name, count] : rows) json.push_back({{"name", name}, {members, count}});
    return json;
}

Json point(const Point3& p) {
    return Json::array({number(p[0]), number(p[1]), number(p[2])});
}

Json model_json(const ModelReport& report) {
    Json json{
        {"nodes", report.nodes},
        {"elements", report.elements},
        {"elements_by_type", counts(report.elements_by_type)},
        {"skipped_elements", counts(report.skipped_elements)},
        {"parts", Json::array()},
        {"node_sets", sets(report.node_sets, "nodes")},
        {"element_sets", sets(report.element_sets, "elements")},
        {"bounds", nullptr},
        {"length_unit", nullptr}};
    for (const auto& [name, elements] : report.parts) {
        json["parts"].push_back({{"name", name}, {"elements", elements}});
    }
    if (report.bounds) {
        json["bounds"] = {{"min", point(report.bounds->front())}, {"max", point(report.bounds->back())}};
    }
    if (report.length_unit) json["length_unit"] = report.length_unit->name;
    return json;
}

Json skin_json(const ModelReport& report) {
    if (!report.skin) return nullptr;
    const SkinReport& skin = *report.skin;
    return {
        {"method", word(report.skin_method)},
        {"solid_facets", {{"tri", skin.solid_tri_kept}, {"quad", skin.solid_quad_kept}}},
        {"shell_facets", {{"tri", skin.shell_tri}, {"quad", skin.shell_quad}}},
        {"triangles", skin.triangles},
        {"vertices", skin.vertices},
        {"closed", skin.has_solids ? Json(skin.closed) : Json(nullptr)},
        {"area", number(skin.area)},
        {"volume", number(skin.volume)},
        {"solid_facets_in", skin.solid_facets_in}};
}

Json step_json(const Step& step) {
    return {
        {"input", step.input},
        {"step", step.step},
        {"substep", step.substep},
        {"kind", word(step.kind)},
        {"value", number(step.value)},
        {"label", step.label}};
}

Json range_json(const ComponentRange& range) {
    Json json{{"component", range.component}};
    const bool known = range.valid > 0;
    json["min"] = known ? number(range.min) : Json(nullptr);
    json["min_id"] = known ? Json(range.min_id) : Json(nullptr);
    if (range.min_element != 0) json["min_element"] = range.min_element;
    json["max"] = known ? number(range.max) : Json(nullptr);
    json["max_id"] = known ? Json(range.max_id) : Json(nullptr);
    if (range.max_element != 0) json["max_element"] = range.max_element;
    json["missing"] = range.missing;
    return json;
}

Json result_json(const ModelReport& report, const ResultReport& result) {
    const ResultInfo& info = result.info;
    const Step& step = report.steps.at(info.step);
    Json json{
        {"name", info.name},
        {"solver_name", info.solver_name},
        {"location", word(info.location)},
        {"unit", text_or_null(info.unit)},
        {"input", step.input},
        {"step", step.step},
        {"substep", step.substep},
        {"value", number(step.value)}};
    const auto add = [&](const char* key, std::string_view value) {
        if (!value.empty()) json[key] = value;
    };
    add("complex", word(info.complex));
    add("layer", word(info.layer));
    add("averaging", word(info.averaging));
    add("shear", word(info.shear));
    add("system", info.system);
    json["ranges"] = Json::array();
    for (const ComponentRange& range : result.ranges) json["ranges"].push_back(range_json(range));
    return json;
}

Json reaction_json(const ModelReport& report, const ReactionSum& reaction) {
    const Step& step = report.steps.at(reaction.info.step);
    Json json{
        {"name", reaction.info.name},
        {"solver_name", reaction.info.solver_name},
        {"unit", text_or_null(reaction.info.unit)},
        {"input", step.input},
        {"step", step.step},
        {"substep", step.substep},
        {"value", number(step.value)},
        {"nodes", reaction.nodes},
        {"sum", Json::object()}};
    if (const auto complex = word(reaction.info.complex); !complex.empty()) json["complex"] = complex;
    for (std::size_t c = 0; c < reaction.sum.size(); ++c) {
        json["sum"][reaction.info.components[c]] = number(reaction.sum[c]);
    }
    return json;
}

std::string printed(const Json& json) {
    // Names come from hostile files: bytes that are no UTF-8 become U+FFFD.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json place_json(const ProbedPlace& place) {
    Json json{
        {"point", point(place.point)},
        {"part", place.part},
        {"elementId", place.element_id},
        {"nodeId", or_null(place.node_id)},
        {"distance", number(place.distance)},
        {"step", place.step ? step_json(*place.step) : Json(nullptr)},
        {"results", Json::array()}};
    for (const ProbedValue& value : place.results) {
        json["results"].push_back(
            {{"key", value.key},
             {"name", value.name},
             {"component", value.component},
             {"unit", text_or_null(value.unit)},
             {"value", value.value ? number(*value.value) : Json(nullptr)},
             {"nodeValue", value.node_value ? number(*value.node_value) : Json(nullptr)},
             {"nodeId", or_null(value.node_id)},
             {"state", value.state}}
        );
        if (value.bound > 0) json["results"].back()["bound"] = number(value.bound);
    }
    json["colour"] = nullptr;
    if (const auto& rgb = place.colour) {
        json["colour"] = fmt::format("#{:02x}{:02x}{:02x}", (*rgb)[0], (*rgb)[1], (*rgb)[2]);
    }
    json["hz"] = place.tone ? number(place.tone->hz) : Json(nullptr);
    json["gain"] = place.tone ? number(place.tone->gain) : Json(nullptr);
    json["tickRate"] = place.tick_rate ? number(*place.tick_rate) : Json(nullptr);
    json["pulse"] = nullptr;
    if (place.pulse) {
        json["pulse"] = {{"rate", number(place.pulse->rate)}, {"amplitude", number(place.pulse->amplitude)}};
    }
    return json;
}

}  // namespace

std::string probe_json(const std::vector<ProbedPlace>& places) {
    if (places.empty()) return "null\n";
    Json json = place_json(places.front());
    if (places.size() > 1) json["others"] = Json::array();
    for (std::size_t i = 1; i < places.size(); ++i) json["others"].push_back(place_json(places[i]));
    return printed(json);
}

std::string claims_json(const std::vector<Claim>& claims) {
    bool all = true;
    Json list = Json::array();
    for (const Claim& claim : claims) {
        all = all && claim.holds;
        list.push_back(
            {{"name", claim.name}, {"claimed", claim.claimed}, {"found", claim.found}, {"holds", claim.holds}}
        );
    }
    return printed({{"version", 1}, {"holds", all}, {"claims", std::move(list)}});
}

std::string info_json(const ModelReport& report, const Diagnostics& diagnostics) {
    Json json{
        {"version", 1},
        {"feelem", version()},
        {"inputs", Json::array()},
        {"model", model_json(report)},
        {"skin", skin_json(report)},
        {"steps", Json::array()},
        {"results", Json::array()},
        {"reactions", Json::array()},
        {"diagnostics", Json::array()}};
    for (const ReactionSum& reaction : report.reactions) {
        json["reactions"].push_back(reaction_json(report, reaction));
    }
    for (const InputRecord& input : report.inputs) {
        Json entry{{"path", input.path}, {"format", input.format}, {"bytes", input.bytes}};
        entry["sha256"] = input.sha256.empty() ? Json() : Json(input.sha256);
        json["inputs"].push_back(std::move(entry));
    }
    for (const Step& step : report.steps) json["steps"].push_back(step_json(step));
    for (const ResultReport& result : report.results) json["results"].push_back(result_json(report, result));
    for (const Diagnostic& entry : diagnostics.entries()) {
        const CodeInfo& code = code_info(entry.code);
        json["diagnostics"].push_back(
            {{"code", code.word},
             {"severity", word(code.severity)},
             {"where", entry.where},
             {"count", entry.count},
             {"text", entry.text}}
        );
    }
    return printed(json);
}

}  // namespace feelem
