// SPDX-License-Identifier: Apache-2.0
// Which presentations are refused, and at which key: tests/contract/presentations.json, made here, checked by
// the page's reader and against the schema too. FEELEM_UPDATE_GOLDEN=1 writes it anew.
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace feelem {
namespace {

/// What follows the result of one effect.
constexpr std::string_view kEffects[]{
    R"("type": "colour")",
    R"("type": "colour", "map": "jet")",
    R"("type": "colour", "map": null)",
    R"("type": "colour", "bands": 0)",
    R"("type": "colour", "bands": 101)",
    R"("type": "colour", "bands": 2.5)",
    R"("type": "colour", "above": "#FF00ff")",
    R"("type": "colour", "below": "#ff00f")",
    R"("type": "colour", "nan": 5)",
    R"("type": "colour", "invert": 1)",
    R"("type": "pitch", "midi": [36, 96], "gamma": 0.5)",
    R"("type": "pitch", "midi": [36])",
    R"("type": "pitch", "midi": [36, 128])",
    R"("type": "pitch", "midi": [60, 60])",
    R"("type": "pitch", "midi": 60)",
    R"("type": "pitch", "gamma": 3)",
    R"("type": "pitch", "quantise": "semitone")",
    R"("type": "pitch", "quantise": "octave")",
    R"("type": "pitch", "signTimbre": "no")",
    R"("type": "pitch", "sense": "audio")",
    R"("type": "pitch", "sense": "visual")",
    R"("type": "ticks", "rateHz": [1, 12.5])",
    R"("type": "ticks", "rateHz": [0, 5])",
    R"("type": "ticks", "rateHz": ["1", "5"])",
    R"("type": "pulses", "ampMin": 0.01, "pulseMs": 200)",
    R"("type": "pulses", "ampMin": 2)",
    R"("type": "pulses", "pulseMs": 1)",
    R"("type": "pulses", "fallback": null)",
    R"("type": "pulses", "fallback": {"type": "ticks", "rateHz": [2, 5]})",
    R"("type": "pulses", "fallback": {"type": "pitch"})",
    R"("type": "pulses", "fallback": {"rateHz": [2, 50]})",
    R"("type": "pulses", "fallback": 5)",
    R"("type": "shape")",
    R"("type": "smell")",
    R"("type": null)",
    R"("sense": "audio")",
    R"("type": "colour", "my own": [1, {"x": null}])",
};

/// What follows the results of a document.
constexpr std::string_view kRests[]{
    R"("effects": [{"type": "colour"}])",
    R"("effects": [{"result": "X", "type": "colour"}])",
    R"("effects": [{"result": "T", "type": "pitch"}, {"result": "S", "type": "pitch"}])",
    R"("effects": [{"result": "S", "type": "ticks"}])",
    R"("effects": [{"result": "S", "type": "pitch"}])",
    R"("effects": [{"result": "T", "type": "pitch"}, {"result": "T", "type": "colour"}])",
    R"("effects": {})",
    R"("effects": null)",
    R"("effects": [null])",
    R"("effects": [7])",
    R"("probe": {"card": ["S", "T"]})",
    R"("probe": {"card": ["Q"]})",
    R"("probe": {"card": [1]})",
    R"("probe": [])",
    R"("deformation": {"result": "T", "factor": 20})",
    R"("deformation": {"result": "Q"})",
    R"("deformation": {"result": "Q", "mode": "none"})",
    R"("deformation": {"mode": "manual"})",
    R"("deformation": {"mode": "manual", "factor": 2})",
    R"("deformation": {"mode": "huge"})",
    R"("deformation": null)",
    R"("step": {"input": 0, "step": 1, "substep": 3})",
    R"("step": {"step": 1.5})",
    R"("step": {"input": -1})",
    R"("step": 5)",
    R"("title": 5)",
    R"("title": null)",
    R"("version": 2)",
    R"("version": "1")",
    R"("format": "gltf")",
};

/// Members of a result; some go on to a second one.
constexpr std::string_view kResults[]{
    R"("name": "t")",
    R"("key": "", "name": "t")",
    R"("key": "T")",
    R"("key": 5, "name": "t")",
    R"("key": "T", "name": "t", "component": 1)",
    R"("key": "T", "name": "t", "unit": null)",
    R"("key": "T", "name": "t", "range": null)",
    R"("key": "T", "name": "t", "range": {"mode": "manual"})",
    R"("key": "T", "name": "t", "range": {"mode": "manual", "lo": 1, "hi": 2})",
    R"("key": "T", "name": "t", "range": {"lo": 2, "hi": 1})",
    R"("key": "T", "name": "t", "range": {"lo": "2"})",
    R"("key": "T", "name": "t", "range": {"mode": "best"})",
    R"("key": "T", "name": "t", "range": {"scale": "cubic"})",
    R"("key": "T", "name": "t", "range": {"symmetric": 0})",
    R"("key": "T", "name": "t", "range": {"p": [1, 99]})",
    R"("key": "T", "name": "t", "range": {"p": [99, 1]})",
    R"("key": "T", "name": "t", "range": {"p": [1, 101]})",
    R"("key": "T", "name": "t", "range": {"p": [1, 2, 3]})",
    R"("key": "T", "name": "t", "limit": {"value": 3})",
    R"("key": "T", "name": "t", "limit": {"value": "3"})",
    R"("key": "T", "name": "t", "limit": {"value": 3, "kind": "beside"})",
    R"("key": "T", "name": "t", "limit": {"value": 3, "label": 4})",
    R"("key": "T", "name": "a"}, {"key": "T", "name": "b")",
    R"("key": "A", "name": "a", "limit": {"value": 1}}, {"key": "B", "name": "b", "limit": {"value": 2})",
    R"("key": "A", "name": "a", "limit": {"value": 1}}, {"key": "B", "name": "b", "limit": {"value": 2, "label": "x"})",
};

/// Whole documents.
constexpr std::string_view kWholes[]{
    "{}",
    "[]",
    "5",
    "null",
    R"({"results": 5})",
};

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
        }
        out += c;
    }
    return out + "\"";
}

/// Where the reader finds a document wrong: "effects[1].result"; nothing when it is right.
std::string wrong_path(std::string_view document) {
    try {
        parse_presentation(document, "p");
        return {};
    } catch (const Error& error) {
        const std::string_view text = std::string_view(error.what()).substr(3);
        return std::string(text.substr(0, text.find(": ")));
    }
}

/// Documents right and wrong: small ones with the same results in front, and whole ones.
std::vector<std::string> documents() {
    std::vector<std::string> all;
    const auto with = [&](std::string_view rest) {
        all.push_back(fmt::format(
            R"({{"results": [{{"key": "T", "name": "temperature"}}, {{"key": "S", "name": "stress", "range": {{"scale": "signed"}}}}], {}}})",
            rest
        ));
    };
    for (const std::string_view effect : kEffects) {
        with(fmt::format(R"("effects": [{{"result": "T", {}}}])", effect));
    }
    for (const std::string_view rest : kRests) {
        with(rest);
    }
    for (const std::string_view result : kResults) {
        all.push_back(fmt::format(R"({{"results": [{{{}}}]}})", result));
    }
    for (const std::string_view whole : kWholes) {
        all.emplace_back(whole);
    }
    return all;
}

TEST(Contract, wrong_presentations_are_refused_where_every_viewer_refuses_them) {
    std::string found = "[";
    for (const std::string& document : documents()) {
        found += fmt::format(
            "{}\n  {{\"document\": {}, \"wrong\": {}}}",
            found.size() > 1 ? "," : "",
            in_quotes(document),
            in_quotes(wrong_path(document))
        );
    }
    found += "\n]\n";
    const std::string path = test::project_file("tests/contract/presentations.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        test::write_file(path, found);
    }

    EXPECT_EQ(found, test::read_file(path));
}

}  // namespace
}  // namespace feelem
