// SPDX-License-Identifier: Apache-2.0
#include "read/answers.hpp"

#include "support/paths.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace feelem::test {
namespace {

using nlohmann::json;

AnswerRange read_range(const std::string& name, const json& range) {
    AnswerRange out{name, 0, 0, {}, {}};
    if (range.is_array()) {
        out.min = range[0];
        out.max = range[1];
    } else {
        out.min = range["min"];
        out.max = range["max"];
        out.min_node = range["min_node"].get<std::int64_t>();
        out.max_node = range["max_node"].get<std::int64_t>();
    }
    return out;
}

Answer read_answer(const nlohmann::ordered_json& all, const char* results) {
    Answer answer;
    if (!all.contains("nodes")) return answer;
    answer.known = true;
    answer.nodes = all["nodes"];
    answer.elements = all["elements"];
    if (all.contains("element_types")) {
        for (const auto& [type, count] : all["element_types"].items())
            answer.elements_by_frd_type[type] = count;
    }
    for (const auto& one : all[results]) {
        AnswerResult result{one["name"], one["value"], one["step"], one["nodes"], {}};
        for (const auto& [name, range] : one["comps"].items())
            result.ranges.push_back(read_range(name, range));
        answer.results.push_back(std::move(result));
    }
    return answer;
}

std::map<std::string, Answer> read_answers(const std::string& path, const char* results) {
    std::map<std::string, Answer> answers;
    const auto all = nlohmann::ordered_json::parse(read_file(path));
    for (const auto& [name, answer] : all.items()) answers[name] = read_answer(answer, results);
    return answers;
}

const std::map<std::string, ElementType> kFrdTypes{
    {"1", ElementType::Hex8},
    {"2", ElementType::Wedge6},
    {"3", ElementType::Tet4},
    {"4", ElementType::Hex20},
    {"5", ElementType::Wedge15},
    {"6", ElementType::Tet10},
    {"7", ElementType::Tri3},
    {"8", ElementType::Tri6},
    {"9", ElementType::Quad4},
    {"10", ElementType::Quad8},
    {"11", ElementType::Line2},
    {"12", ElementType::Line3},
};

struct Extremes {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    std::int64_t min_node = 0, max_node = 0;
    std::uint64_t valid = 0;
};

/// Of value(row) over the rows of a nodal result.
template <class Value>
Extremes extremes(const Mesh& mesh, const Value& value) {
    Extremes out;
    for (std::size_t row = 0; row < mesh.node_count(); ++row) {
        const double x = value(row);
        if (std::isnan(x)) continue;
        ++out.valid;
        if (x < out.min) {
            out.min = x;
            out.min_node = raw(mesh.node_ids[row]);
        }
        if (x > out.max) {
            out.max = x;
            out.max_node = raw(mesh.node_ids[row]);
        }
    }
    return out;
}

double magnitude(const float* row) {
    return std::sqrt(double(row[0]) * row[0] + double(row[1]) * row[1] + double(row[2]) * row[2]);
}

double von_mises(const float* s) {
    const double xy = double(s[0]) - s[1], yz = double(s[1]) - s[2], zx = double(s[2]) - s[0];
    const double shear = double(s[3]) * s[3] + double(s[4]) * s[4] + double(s[5]) * s[5];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * shear);
}

bool is_formula(const AnswerRange& range) {
    return range.component == "mises" || range.component == "magnitude";
}

void expect_range(const Mesh& mesh, const Result& result, std::size_t column, const AnswerRange& range) {
    const std::size_t width = result.component_count();
    if (is_formula(range)) {
        const auto found = extremes(mesh, [&](std::size_t row) {
            const float* values = &result.values[row * width];
            return range.component == "mises" ? von_mises(values) : magnitude(values);
        });
        EXPECT_NEAR(found.min, range.min, 1e-5 * range.max);
        EXPECT_NEAR(found.max, range.max, 1e-5 * range.max);
        if (range.max_node) {
            EXPECT_EQ(found.max_node, *range.max_node);
        }
        return;
    }
    const auto found =
        extremes(mesh, [&](std::size_t row) { return double(result.values[row * width + column]); });
    EXPECT_EQ(static_cast<float>(found.min), static_cast<float>(range.min)) << range.component;
    EXPECT_EQ(static_cast<float>(found.max), static_cast<float>(range.max)) << range.component;
    if (range.min_node) {
        EXPECT_EQ(found.min_node, *range.min_node) << range.component;
    }
    if (range.max_node) {
        EXPECT_EQ(found.max_node, *range.max_node) << range.component;
    }
}

void expect_results(
    ModelSource& model, const std::vector<AnswerResult>& answers, const Diagnostics& diagnostics
) {
    const auto infos = model.results();
    std::size_t next = 0;
    for (const AnswerResult& answer : answers) {
        SCOPED_TRACE(answer.name + " of step " + std::to_string(answer.step));
        std::size_t column = 0;
        Result result;
        const std::uint64_t lost_before = diagnostics.count(Code::ResultWithoutNode);
        for (const AnswerRange& range : answer.ranges) {
            // Amplitudes and phases of one block are two results of ours.
            if (!is_formula(range) && column == result.component_count()) {
                ASSERT_LT(next, infos.size());
                result = model.load(next++);
                column = 0;
                const Step& step = model.steps()[result.info.step];
                EXPECT_EQ(result.info.solver_name, answer.name);
                EXPECT_EQ(step.value, answer.value);
                EXPECT_EQ(step.step, answer.step);
                ASSERT_EQ(result.row_count(), model.mesh().node_count());
            }
            expect_range(model.mesh(), result, column, range);
            if (!is_formula(range)) ++column;
        }
        const auto with_value = extremes(model.mesh(), [&](std::size_t row) {
            return double(result.values[row * result.component_count()]);
        });
        const std::uint64_t lost = diagnostics.count(Code::ResultWithoutNode) - lost_before;
        EXPECT_EQ(with_value.valid + lost, answer.nodes);
    }
    EXPECT_EQ(next, infos.size());
}

}  // namespace

std::map<std::string, Answer> read_corpus_answers(const std::string& path) {
    return read_answers(path, "steps");
}

std::map<std::string, Answer> read_boiler_answers(const std::string& path) {
    return read_answers(path, "results");
}

void expect_answers(ModelSource& model, const Answer& answer, const Diagnostics& diagnostics) {
    const Mesh& mesh = model.mesh();
    EXPECT_EQ(mesh.node_count(), answer.nodes);
    EXPECT_EQ(mesh.element_count(), answer.elements);
    std::map<ElementType, std::uint64_t> expected, found;
    for (const auto& [type, count] : answer.elements_by_frd_type) expected[kFrdTypes.at(type)] = count;
    for (const ElementBlock& block : mesh.blocks) found[block.type] = block.ids.size();
    if (!expected.empty()) {
        EXPECT_EQ(found, expected);
    }
    expect_results(model, answer.results, diagnostics);
}

}  // namespace feelem::test
