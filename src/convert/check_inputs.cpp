// SPDX-License-Identifier: Apache-2.0
#include "convert/check_inputs.hpp"

#include "convert/prepared_source.hpp"
#include "convert/skin_options.hpp"
#include "convert/stage.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

namespace feelem {

Claim Tally::claim() const {
    const std::string all = fmt::format("{} of {} agree", compared, compared);
    if (wrong == 0) return {name, all, all, true};
    return {name, all, fmt::format("{} of {} agree; {}", compared - wrong, compared, first_wrong), false};
}

ElementTable::ElementTable(const Mesh& mesh) {
    for (std::uint32_t i = 0; i < mesh.element_count(); ++i)
        sorted_.emplace_back(raw(element_at(mesh, ElementIndex{i}).id()), i);
    std::ranges::sort(sorted_);
}

ElementIndex ElementTable::operator()(std::int64_t id) const {
    const auto found =
        std::ranges::lower_bound(sorted_, id, {}, &std::pair<std::int64_t, std::uint32_t>::first);
    return found == sorted_.end() || found->first != id ? kNoElement : ElementIndex{found->second};
}

namespace {

/// Positions of vertices that stand at a node. Beams and points are drawn around theirs.
Claim check_positions(const Mesh& mesh, const Scene& scene) {
    Tally tally{"positions of the nodes"};
    for (const ScenePart& part : scene.parts) {
        if (part.kind != "solid" && part.kind != "shell") continue;
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            if (part.node_ids[v] == 0) continue;
            const NodeIndex node = find_node(mesh, NodeId{part.node_ids[v]});
            bool right = node != kNoNode;
            for (std::size_t axis = 0; right && axis < 3; ++axis) {
                const auto wanted =
                    static_cast<float>(mesh.coordinates[raw(node)][axis] - scene.origin[axis]);
                const float found = part.positions[v][axis];
                right = std::bit_cast<std::uint32_t>(wanted) == std::bit_cast<std::uint32_t>(found) ||
                        (scene.position_bound > 0 &&
                         std::abs(static_cast<double>(wanted) - static_cast<double>(found)) <=
                             scene.position_bound * (1 + 1e-6));
            }
            tally.count(right, [&] {
                return fmt::format("node {} is elsewhere in the inputs", part.node_ids[v]);
            });
        }
    }
    return tally.claim();
}

std::string last_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

/// By their digests; by name and size where the scene was made without them.
bool are_one_file(const InputRecord& given, const InputRecord& recorded) {
    if (!recorded.sha256.empty()) return given.sha256 == recorded.sha256;
    return given.bytes == recorded.bytes && last_name(given.path) == last_name(recorded.path);
}

const InputRecord* given_for(std::span<const InputRecord> given, const InputRecord& recorded) {
    const auto found =
        std::ranges::find_if(given, [&](const InputRecord& one) { return are_one_file(one, recorded); });
    return found == given.end() ? nullptr : &*found;
}

const InputRecord* recorded_for(std::span<const InputRecord> recorded, const InputRecord& given) {
    const auto found =
        std::ranges::find_if(recorded, [&](const InputRecord& one) { return are_one_file(given, one); });
    return found == recorded.end() ? nullptr : &*found;
}

/// The second node list of the node map is among the inputs when a folder is given that holds it.
Job with_surface_nodes(const ModelSource& source, const Scene& scene, Job job) {
    const auto skin = scene.notes.find("skin");
    if (skin == scene.notes.end() || skin->second != "node-list") return job;
    job.skin.method = SkinMethod::NodeList;
    if (!job.surface_nodes_file.empty()) return job;
    for (const InputRecord& input : scene.inputs) {
        if (input.format != kSurfaceNodesFormat) continue;
        if (const InputRecord* file = given_for(source.inputs(), input)) job.surface_nodes_file = file->path;
    }
    return job;
}

/// The files are the ones that the scene was made of.
void check_files(const ModelSource& source, const Scene& scene, const Job& job, std::vector<Claim>& claims) {
    std::vector<InputRecord> given(source.inputs().begin(), source.inputs().end());
    auto list = surface_nodes_record(job);
    if (list && given_for(given, *list) == nullptr) given.push_back(std::move(*list));
    for (const InputRecord& input : given) {
        const InputRecord* known = recorded_for(scene.inputs, input);
        const std::string wanted = known != nullptr && known->sha256.empty()
                                       ? "an input of this scene, by name and size"
                                       : "an input of this scene";
        claims.push_back(
            {"input " + last_name(input.path),
             wanted,
             known != nullptr ? wanted : "another file",
             known != nullptr}
        );
    }
}

/// The ways of averaging, systems and envelopes that the scene says it has.
Preparing preparing_of(const Scene& scene) {
    Job as_said;
    as_said.averages.clear();
    for (const SceneResult& result : scene.results) {
        const bool is_ours =
            result.averaging != Averaging::NotApplicable && result.averaging != Averaging::Solver;
        if (is_ours && std::ranges::find(as_said.averages, result.averaging) == as_said.averages.end())
            as_said.averages.push_back(result.averaging);
        const auto known = std::ranges::find(as_said.result_systems, result.system);
        if (!result.system.empty() && known == as_said.result_systems.end())
            as_said.result_systems.push_back(result.system);
    }
    const auto envelopes = scene.notes.find("envelopes");
    if (envelopes != scene.notes.end()) as_said.envelopes = envelopes->second;
    return preparing_of(as_said);
}

/// Results of the inputs at the steps of the scene: an envelope is over these.
std::vector<std::size_t> results_of(const ModelSource& source, const Scene& scene) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < source.results().size(); ++i) {
        const Step& its = source.steps()[source.results()[i].step];
        const bool is_there = std::ranges::any_of(scene.steps, [&](const Step& step) {
            return step.step == its.step && step.substep == its.substep && step.kind == its.kind &&
                   step.value == its.value;
        });
        if (is_there) found.push_back(i);
    }
    return found;
}

}  // namespace

std::vector<Claim> check_against_inputs(
    const std::string& scene_path, const Job& job, Diagnostics& diagnostics, const Progress& progress
) {
    try {
        const std::unique_ptr<ModelSource> source = open_job(job, diagnostics, progress);
        if (!source) return {};
        report_progress(progress, "scene", 0);
        const Scene scene = load_scene(scene_path);
        std::vector<Claim> claims;
        const Job found = with_surface_nodes(*source, scene, job);
        check_files(*source, scene, found, claims);
        claims.push_back(check_positions(source->mesh(), scene));
        claims.push_back(check_counts(source->mesh(), scene, found));
        report_progress(progress, "triangles", 0);
        for (Claim& claim : check_triangles(source->mesh(), scene)) claims.push_back(std::move(claim));
        PreparedSource shown(*source, results_of(*source, scene), preparing_of(scene));
        for (Claim& claim : check_values(shown, scene, progress)) claims.push_back(std::move(claim));
        return claims;
    } catch (const Cancelled&) {
        return {};
    }
}

}  // namespace feelem
