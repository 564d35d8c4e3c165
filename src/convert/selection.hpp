// SPDX-License-Identifier: Apache-2.0
// Which steps and results of a model a job takes.
#pragma once

#include "feelem/convert.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace feelem {

/// What --steps means when it is not given.
enum class DefaultSteps {
    All,
    UpToTwenty,  ///< All up to 20, else the last of each load step and every mode (StepsLeftOut).
    Last,        ///< Of each input.
};

/// Indices into `steps`, ascending. Throws Error(BadOption | UnknownName).
std::vector<std::size_t> select_steps(
    std::span<const Step> steps, std::string_view wanted, DefaultSteps otherwise, Diagnostics& diagnostics
);

/// Indices into source.results() at those steps, in the source's order. Throws Error(UnknownName).
std::vector<std::size_t> select_results(
    const ModelSource& source, const std::vector<std::size_t>& steps, std::string_view results
);

/// The file's name without folders: "static.frd".
std::string_view file_name(std::string_view path);

/// "1.3", "mode 2": a step as messages and tables name it.
std::string step_name(const Step& step);

}  // namespace feelem
