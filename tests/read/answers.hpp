// SPDX-License-Identifier: Apache-2.0
// Right answers of the corpus and of the shipped boiler, and a model compared with them.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace feelem::test {

struct AnswerRange {
    std::string component;  ///< The solver's name, or "mises", "magnitude".
    double min = 0, max = 0;
    std::optional<std::int64_t> min_node, max_node;
};
struct AnswerResult {
    std::string name;
    double value = 0;
    std::int64_t step = 0;
    std::uint64_t nodes = 0;  ///< With a value.
    std::vector<AnswerRange> ranges;
};
struct Answer {
    bool known = false;  ///< False: the plain reader behind the answers failed on this file.
    std::uint64_t nodes = 0, elements = 0;
    std::map<std::string, std::uint64_t> elements_by_frd_type;  ///< Empty: not said.
    std::vector<AnswerResult> results;
};

/// answers.json of the corpus: by file name.
std::map<std::string, Answer> read_corpus_answers(const std::string& path);
/// results.json of a boiler: by analysis ("heat").
std::map<std::string, Answer> read_boiler_answers(const std::string& path);

/// Fails the test on any difference. Components are compared bit for bit; magnitude and von Mises, computed
/// here by their textbook formulas, to 1e-5. `diagnostics`: those of opening; values at nodes that the mesh
/// does not have must be counted there.
void expect_answers(ModelSource& model, const Answer& answer, const Diagnostics& diagnostics);

}  // namespace feelem::test
