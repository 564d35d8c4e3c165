// SPDX-License-Identifier: Apache-2.0
// The whole pipeline as one call: read -> derive -> skin -> present -> write.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"
#include "feelem/scene.hpp"
#include "feelem/skin.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem {

/// Told what is being done and how far it is (0..1), from the calling thread. Return false to cancel.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

/// What to convert and how: docs/cli.md's options.
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
    /// Part, All, None: the first one is shown first.
    std::vector<Averaging> averages{Averaging::Part};
    /// "cylindrical:OX,OY,OZ,AX,AY,AZ": results in these systems besides those in the global one.
    std::vector<std::string> result_systems;
    bool brief = false;     ///< report_model() reads no values and makes no skin: quick for many steps.
    std::string envelopes;  ///< "", "max", "min", "absmax", or several with commas: over the chosen steps.
    std::string levels = "auto";  ///< Of detail: "auto", "off", "200000" triangles, "0.5%" of the ranges.
    char up = 'z';
    std::string presentation_file;
    std::string title;
    bool compress = false;  ///< SceneOptions::compress and bound.
    double compress_bound = 0;
};

/// Feelem's own version: "0.1.0".
std::string_view version();

/// The model with the job's units applied and results listed once (bitwise equal twins of two inputs merged).
/// Null when cancelled.
std::unique_ptr<ModelSource> open_job(const Job& job, Diagnostics& diagnostics, const Progress& progress);

/// A scene of the shape alone, for who does not want to wait until results are read as well. It has no
/// results, names no inputs, and its certificate says by the note "preview" that it is not the finished
/// scene; its vertices, triangles and edges are those of the finished one, bit for bit.
struct EarlyShape {
    std::string output;            ///< Path of a .glb; empty: none is made.
    std::function<void()> stands;  ///< Told once, from the calling thread, when it is written.
};

/// Writes job.output in the format of its suffix. Throws Error. False when cancelled: then nothing was
/// written but maybe the early shape, which only scenes have.
bool convert(
    const Job& job, Diagnostics& diagnostics, const Progress& progress, const EarlyShape& early = {}
);

/// Levels of detail of a scene against its full triangles and values, by the independent checker: every
/// original vertex at every result and step. Nothing when it has no levels. Throws Error(BadScene).
std::vector<Claim> check_levels(const std::string& scene_path);

/// Smallest and largest value of one component over the whole model, with solver ids (the smallest on a tie).
struct ComponentRange {
    std::string component;
    bool derived = false;
    std::uint64_t valid = 0;  ///< Rows with a value; 0: the next six mean nothing.
    float min = 0, max = 0;
    std::int64_t min_id = 0, max_id = 0;
    std::int64_t min_element = 0, max_element = 0;  ///< Unaveraged results only, else 0.
    std::uint64_t missing = 0;                      ///< Nodes (elements) of the model without a value.
    std::uint64_t zeros = 0;                        ///< Rows that are exactly zero.
};
struct ResultReport {
    ResultInfo info;                     ///< As averaged by the job.
    std::vector<ComponentRange> ranges;  ///< None when the report is brief.
};

/// The sum over all nodes of a result whose name begins with reaction_.
struct ReactionSum {
    ResultInfo info;          ///< ResultInfo::step counts in ModelReport::steps.
    std::vector<double> sum;  ///< One a component, of the float values in the global system, in node order.
    std::uint64_t nodes = 0;  ///< With a value.
};

/// What `feelem info` says of a model.
struct ModelReport {
    std::vector<InputRecord> inputs;
    std::uint64_t nodes = 0, elements = 0;  ///< Elements include those without a surface.
    std::vector<std::pair<std::string, std::uint64_t>> elements_by_type, skipped_elements, parts;
    std::vector<std::pair<std::string, std::uint64_t>> node_sets,
        element_sets;                             ///< Name and size, in file order.
    std::optional<std::array<Point3, 2>> bounds;  ///< Of drawn elements.
    std::optional<LengthUnit> length_unit;
    SkinMethod skin_method = SkinMethod::Exact;
    std::optional<SkinReport> skin;  ///< Empty when nothing can be drawn.
    bool is_brief = false;           ///< No skin, no ranges, no sums.
    std::vector<Step> steps;
    std::vector<ResultReport> results;  ///< ResultInfo::step counts in `steps`.
    std::vector<ReactionSum> reactions;
};

/// Empty when cancelled.
std::optional<ModelReport> report_model(const Job& job, Diagnostics& diagnostics, const Progress& progress);

/// `feelem info --json`, version 1 (docs/cli.md), as text.
std::string info_json(const ModelReport& report, const Diagnostics& diagnostics);

/// `feelem check SCENE INPUT...`: reads the job's inputs again and compares every node's place and values and
/// every triangle's element with the scene, bit for bit. Shares no code with the skin and the writing of
/// scenes, and trusts no digest. Empty when cancelled. Throws Error when the inputs or the scene cannot be
/// read.
std::vector<Claim> check_against_inputs(
    const std::string& scene_path, const Job& job, Diagnostics& diagnostics, const Progress& progress
);

}  // namespace feelem
