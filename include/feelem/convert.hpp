// SPDX-License-Identifier: Apache-2.0
// The whole pipeline as one call: read -> derive -> skin -> present -> write.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// Told what is being done and how far it is (0..1). Return false to cancel.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

/// What to convert and how: cli.md's options.
struct Job {
    std::vector<std::string> inputs;
    std::string output;
    ReadOptions read;
    SkinOptions skin;
    std::string surface_nodes_file;
    std::string length_unit;                   ///< Empty: from the input.
    std::map<std::string, std::string> units;  ///< result name -> unit
    std::string steps;                         ///< "", "last", "all", "1,3", "1.3", "mode:2"
    std::string results;                       ///< "", "all" or names
    Averaging average = Averaging::Part;
    char up = 'z';
    std::string presentation_file;
    std::string title;
};

/// The model with the job's units applied and results listed once (bitwise equal twins of two inputs merged).
std::unique_ptr<ModelSource> open_job(const Job& job, Diagnostics& diagnostics, const Progress& progress);

/// Writes job.output in the format of its suffix. Throws Error; cancelling throws nothing and writes nothing.
void convert(const Job& job, Diagnostics& diagnostics, const Progress& progress);

/// `feelem info --json`, version 1 (docs/cli.md), as text.
std::string info_json(const Job& job, Diagnostics& diagnostics, const Progress& progress);

}  // namespace feelem
