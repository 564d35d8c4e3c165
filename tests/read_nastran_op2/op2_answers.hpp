// SPDX-License-Identifier: Apache-2.0
// Right answers of the Nastran corpus (pyNastran's), and a model compared with them.
#pragma once

#include "feelem/model.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace feelem::test {

/// One result of one subcase over all its steps.
struct Op2Answer {
    std::string result;  ///< displacements eigenvectors temperatures velocities
    std::int32_t subcase = 1;
    std::size_t step_count = 0, node_count = 0, component_count = 0;
    double max_abs_component = 0, max_translation = 0;
    std::int64_t grid_of_max = 0;
    bool complex = false;
    std::vector<double> steps;  ///< NaN: static.
};
struct Op2File {
    std::string path;     ///< Below the corpus folder nastran.
    bool failed = false;  ///< pyNastran itself does not read it.
    std::vector<Op2Answer> answers;
};
std::vector<Op2File> read_op2_answers(const std::string& path);

/// Fails the test on any difference of more than 1e-6.
void expect_answer(ModelSource& model, const Op2Answer& answer);

}  // namespace feelem::test
