// SPDX-License-Identifier: Apache-2.0
#include "read/merged_model.hpp"

#include "base/sha256.hpp"
#include "read/adopt_sets.hpp"
#include "read/choose_mesh.hpp"
#include "read/remap_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace feelem {
namespace {

bool is_same_division(const Mesh& a, const Mesh& b) {
    return a.node_angles == b.node_angles &&
           std::ranges::equal(a.parts, b.parts, {}, &Part::name, &Part::name) &&
           std::ranges::equal(a.blocks, b.blocks, {}, &ElementBlock::parts, &ElementBlock::parts);
}

bool has_turned_results(const ModelSource& source) {
    return std::ranges::any_of(source.results(), [](const ResultInfo& info) { return info.nodal_system; });
}

/// One model made of several sources; input records are hashed when they are first asked for.
class MergedModel : public ModelSource {
public:
    MergedModel(
        std::vector<OpenedSource> sources,
        std::vector<std::unique_ptr<ModelSource>> kept_alive,
        std::vector<UsedInput> inputs,
        MeshChoice choice,
        Diagnostics& diagnostics,
        bool hash_inputs,
        std::unique_ptr<EarlyDigests> early
    )
        : kept_alive_(std::move(kept_alive)), sources_(std::move(sources)), inputs_(std::move(inputs)),
          choice_(std::move(choice)), diagnostics_(diagnostics), hash_inputs_(hash_inputs),
          early_(std::move(early)) {
        assert(!sources_.empty());
        adopt_unit();
        adopt_angles();
        adopt_all_sets();
        for (const OpenedSource& opened : sources_) append(opened);
        reported_.resize(results_.size());
    }

    const Mesh& mesh() const override { return sources_[choice_.shown].source->mesh(); }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return results_; }

    Result load(std::size_t index) override {
        const auto [source, local] = origin_.at(index);
        Result result = sources_[source].source->load(local);
        const std::optional<MeshMap>& map = choice_.maps[source];
        if (map) {
            std::uint64_t left_out = 0;
            drop_turned_otherwise(source, *map, result);
            result = remap_result(result, *map, mesh(), left_out);
            if (left_out > 0 && !reported_[index]) {
                diagnostics_.add(
                    Code::ResultWithoutNode,
                    name_of(source),
                    fmt::format(
                        "{} has values at places that the mesh shown does not have; they are left out",
                        result.info.solver_name
                    ),
                    left_out
                );
            }
            reported_[index] = true;
        }
        result.info = results_[index];
        return result;
    }

    std::span<const InputRecord> inputs() const override {
        std::call_once(hashed_, [this] {
            for (std::size_t i = 0; i < inputs_.size(); ++i) {
                const UsedInput& used = inputs_[i];
                records_.push_back({used.input.name(), used.format, used.input.size(), digest_of(i)});
            }
        });
        return records_;
    }

    SolverInfo solver() const override {
        for (const OpenedSource& opened : sources_) {
            if (SolverInfo info = opened.source->solver(); !info.name.empty()) return info;
        }
        return {};
    }

    std::string title() const override {
        for (const OpenedSource& opened : sources_) {
            if (std::string title = opened.source->title(); !title.empty()) return title;
        }
        return {};
    }

private:
    struct Origin {
        std::size_t source = 0;
        std::size_t index = 0;
    };

    const std::string& name_of(std::size_t source) const {
        return inputs_[sources_[source].inputs.front()].input.name();
    }
    std::string digest_of(std::size_t i) const {
        if (!hash_inputs_) return {};
        return early_ && i < early_->size() ? early_->take(i) : sha256_hex(inputs_[i].input);
    }
    /// Ours alone, and no constant; a copy would double the memory of a large model.
    Mesh& shown_mesh() { return const_cast<Mesh&>(mesh()); }

    /// Nodes stand at the same places, so a unit that one source declares is that of all.
    void adopt_unit() {
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            const std::optional<LengthUnit>& unit = sources_[i].source->mesh().length_unit;
            if (unit && !mesh().length_unit) shown_mesh().length_unit = unit;
        }
    }

    /// Turned nodal systems of the first source that has some, where the mesh shown has none.
    void adopt_angles() {
        for (std::size_t i = 0; i < sources_.size() && mesh().node_angles.empty(); ++i) {
            const std::vector<NodalAngles>& angles = sources_[i].source->mesh().node_angles;
            if (angles.empty() || !choice_.maps[i] || !has_turned_results(*sources_[i].source)) continue;
            std::vector<NodalAngles> turned(mesh().node_count(), NodalAngles{});
            const std::vector<NodeIndex>& nodes = choice_.maps[i]->nodes;
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                if (nodes[n] != kNoNode) turned[raw(nodes[n])] = angles[n];
            }
            shown_mesh().node_angles = std::move(turned);
        }
    }

    void adopt_all_sets() {
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            const Mesh& other = sources_[i].source->mesh();
            if (&other == &mesh()) continue;
            const MeshMap* map = choice_.maps[i] ? &*choice_.maps[i] : nullptr;
            adopt_sets(other, map, name_of(i), shown_mesh(), diagnostics_);
        }
    }

    /// Values in a nodal system that the mesh shown turns in another way cannot be told in the global one.
    void drop_turned_otherwise(std::size_t source, const MeshMap& map, Result& result) const {
        if (!result.info.nodal_system) return;
        const auto angles_at = [](const Mesh& mesh, std::size_t node) {
            return mesh.node_angles.empty() ? NodalAngles{} : mesh.node_angles[node];
        };
        const Mesh& other = sources_[source].source->mesh();
        const std::size_t width = result.component_count();
        std::uint64_t dropped = 0;
        for (std::size_t row = 0; row < result.row_count(); ++row) {
            const std::size_t node = result.row_node.empty() ? row : raw(result.row_node[row]);
            if (node >= map.nodes.size() || map.nodes[node] == kNoNode) continue;
            if (angles_at(other, node) == angles_at(mesh(), raw(map.nodes[node]))) continue;
            std::fill_n(&result.values[row * width], width, std::numeric_limits<float>::quiet_NaN());
            ++dropped;
        }
        if (dropped == 0) return;
        diagnostics_.add(
            Code::SourcesDisagree,
            name_of(source),
            fmt::format(
                "{} stands in nodal systems that are turned in another way than those of the mesh shown; its "
                "values there are left out",
                result.info.solver_name
            ),
            dropped
        );
    }

    void append(const OpenedSource& opened) {
        const auto first_step = static_cast<std::uint32_t>(steps_.size());
        for (Step step : opened.source->steps()) {
            step.input = opened.inputs.at(step.input);
            steps_.push_back(std::move(step));
        }
        const auto source = static_cast<std::size_t>(&opened - sources_.data());
        const std::span<const ResultInfo> results = opened.source->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            results_.push_back(results[i]);
            results_.back().step += first_step;
            origin_.push_back({source, i});
        }
    }

    std::vector<std::unique_ptr<ModelSource>> kept_alive_;
    std::vector<OpenedSource> sources_;
    std::vector<UsedInput> inputs_;
    MeshChoice choice_;
    Diagnostics& diagnostics_;
    bool hash_inputs_;
    std::unique_ptr<EarlyDigests> early_;  ///< Of the first inputs.
    std::vector<bool> reported_;
    std::vector<Step> steps_;
    std::vector<ResultInfo> results_;
    std::vector<Origin> origin_;
    mutable std::once_flag hashed_;
    mutable std::vector<InputRecord> records_;
};

}  // namespace

const Mesh* own_or_shared(Mesh& own, const Mesh* shared) {
    if (shared != nullptr && own.node_count() == 0) return shared;
    if (shared == nullptr || !is_same_mesh(*shared, own) || !is_same_division(*shared, own)) return &own;
    // The other source's mesh is as young as this one, and no constant: nobody has seen it yet.
    if (!share_sets(own, const_cast<Mesh&>(*shared))) return &own;
    own = {};
    return shared;
}

const Mesh* mesh_for_next(std::span<const OpenedSource> sources) {
    const Mesh* best = nullptr;
    int most = -1;
    for (const OpenedSource& opened : sources) {
        const Mesh& mesh = opened.source->mesh();
        const int rank = mesh.element_count() == 0 ? 0 : opened.source->results().empty() ? 1 : 2;
        if (rank <= most) continue;
        most = rank;
        best = &mesh;
    }
    return best;
}

std::unique_ptr<ModelSource> merge_sources(
    std::vector<OpenedSource> sources,
    std::vector<std::unique_ptr<ModelSource>> kept_alive,
    std::vector<UsedInput> inputs,
    Diagnostics& diagnostics,
    bool hash_inputs,
    std::unique_ptr<EarlyDigests> early
) {
    std::vector<std::string> names;
    for (const OpenedSource& opened : sources) names.push_back(inputs[opened.inputs.front()].input.name());
    MeshChoice choice = choose_mesh(sources, names, diagnostics);
    return std::make_unique<MergedModel>(
        std::move(sources),
        std::move(kept_alive),
        std::move(inputs),
        std::move(choice),
        diagnostics,
        hash_inputs,
        std::move(early)
    );
}

}  // namespace feelem
