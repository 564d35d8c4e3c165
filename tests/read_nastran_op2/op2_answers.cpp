// SPDX-License-Identifier: Apache-2.0
#include "read_nastran_op2/op2_answers.hpp"

#include "support/paths.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace feelem::test {
namespace {

using nlohmann::json;

constexpr double kTolerance = 1e-6;

/// Python writes NaN, which JSON does not know.
std::string without_nan(std::string text) {
    for (std::size_t at = 0; (at = text.find("NaN", at)) != std::string::npos;) text.replace(at, 3, "null");
    return text;
}

/// "1" or "(1, 6, 2, 0, 0, '', '')": the subcase comes first; 2 in third place says sorted by node.
std::int32_t subcase_of(const std::string& key) {
    return std::stoi(key.substr(key.starts_with('(') ? 1 : 0));
}

Op2Answer read_answer(const std::string& result, const std::string& key, const json& all) {
    Op2Answer answer;
    answer.result = result;
    answer.subcase = subcase_of(key);
    answer.step_count = all["shape"][0];
    answer.node_count = all["shape"][1];
    answer.component_count = all["shape"][2];
    answer.max_abs_component = all["max_abs_component"];
    answer.max_translation = all["max_translation"];
    answer.grid_of_max = all["grid_of_max"];
    answer.complex = all["complex"];
    for (const json& step : all["steps"]) {
        answer.steps.push_back(step.is_number() ? step.get<double>() : std::nan(""));
    }
    return answer;
}

struct Names {
    const char* name;
    bool modal;
};
const std::map<std::string, Names> kNames{
    {"displacements", {"displacement", false}},
    {"eigenvectors", {"displacement", true}},
    {"temperatures", {"temperature", false}},
    {"velocities", {"temperature_rate", false}},
};

bool is_modal(StepKind kind) {
    return kind == StepKind::Mode || kind == StepKind::Buckling;
}

/// Results of this answer: its steps' columns, a list of parts (real and imaginary) each.
using Columns = std::map<std::uint32_t, std::vector<Result>>;

Columns load_columns(ModelSource& model, const Op2Answer& answer, const std::string& name) {
    Columns columns;
    const auto infos = model.results();
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const Step& step = model.steps()[infos[i].step];
        if (infos[i].name != name || step.step != answer.subcase ||
            is_modal(step.kind) != kNames.at(answer.result).modal)
            continue;
        columns[infos[i].step].push_back(model.load(i));
    }
    return columns;
}

double part_magnitude(const std::vector<Result>& parts, std::size_t at) {
    if (parts.front().info.complex != Complex::Real) return std::abs(double(parts.front().values[at]));
    return std::hypot(double(parts.front().values[at]), double(parts.at(1).values[at]));
}

void expect_near(double found, double expected, const char* what) {
    EXPECT_NEAR(found, expected, kTolerance * std::abs(expected)) << what;
}

struct Maxima {
    double component = 0, translation = -1;
    std::set<std::int64_t> ties;  ///< Grids as far as the farthest.
    std::set<std::int64_t> grids;
};

Maxima maxima_of(const Mesh& mesh, const Columns& columns) {
    Maxima maxima;
    for (const auto& [step, parts] : columns) {
        const std::size_t width = parts.front().component_count();
        for (std::size_t row = 0; row < mesh.node_count(); ++row) {
            double squares = 0;
            for (std::size_t c = 0; c < width; ++c) {
                const double value = part_magnitude(parts, row * width + c);
                maxima.component = std::fmax(maxima.component, value);
                squares += value * value;
            }
            if (std::isnan(squares)) continue;
            const std::int64_t id = raw(mesh.node_ids[row]);
            maxima.grids.insert(id);
            const double length = std::sqrt(squares);
            if (length > maxima.translation * (1 + kTolerance)) maxima.ties.clear();
            if (length >= maxima.translation * (1 - kTolerance)) maxima.ties.insert(id);
            maxima.translation = std::max(maxima.translation, length);
        }
    }
    return maxima;
}

void expect_steps(const ModelSource& model, const Op2Answer& answer, const Columns& columns) {
    ASSERT_EQ(columns.size(), answer.step_count);
    std::size_t i = 0;
    for (const auto& [index, parts] : columns) {
        const Step& step = model.steps()[index];
        EXPECT_EQ(parts.size(), answer.complex ? 2U : 1U);
        if (i >= answer.steps.size()) break;
        const double expected = answer.steps[i++];
        if (std::isnan(expected)) {
            EXPECT_EQ(step.kind, StepKind::Static);
        } else if (step.kind == StepKind::Mode) {
            EXPECT_EQ(step.substep, expected);
        } else if (step.kind == StepKind::Buckling) {
            // The answers have no sign; the file's eigenvalues are negative.
            EXPECT_EQ(std::abs(step.value), expected);
        } else {
            EXPECT_EQ(step.value, expected);
        }
    }
}

}  // namespace

std::vector<Op2File> read_op2_answers(const std::string& path) {
    std::vector<Op2File> files;
    const json all = json::parse(without_nan(read_file(path)));
    for (const auto& [name, answers] : all.items()) {
        Op2File file{name, answers.contains("pynastran_failed"), {}};
        if (answers.contains("results")) {
            for (const auto& [result, subcases] : answers["results"].items()) {
                for (const auto& [key, answer] : subcases.items())
                    file.answers.push_back(read_answer(result, key, answer));
            }
        }
        files.push_back(std::move(file));
    }
    return files;
}

void expect_answer(ModelSource& model, const Op2Answer& answer) {
    const Columns translations = load_columns(model, answer, kNames.at(answer.result).name);
    expect_steps(model, answer, translations);
    const Maxima maxima = maxima_of(model.mesh(), translations);
    EXPECT_EQ(maxima.grids.size(), answer.node_count);
    expect_near(maxima.component, answer.max_abs_component, "largest component");
    expect_near(maxima.translation, answer.max_translation, "largest translation");
    EXPECT_TRUE(maxima.ties.contains(answer.grid_of_max)) << answer.grid_of_max;
}

}  // namespace feelem::test
