// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_domains.hpp"

#include "model/mesh_builder.hpp"
#include "model/node_lookup.hpp"
#include "read/ansys/rst_copy.hpp"
#include "read/element_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace feelem::rst {
namespace {

class MergedDomains : public ModelSource {
public:
    MergedDomains(
        std::vector<std::unique_ptr<ModelSource>> domains,
        const std::vector<std::string>& names,
        Diagnostics& diagnostics
    )
        : domains_(std::move(domains)), name_(names.front()), diagnostics_(diagnostics) {
        check_steps(names);
        merge_meshes();
        merge_results();
    }

    const Mesh& mesh() const override { return mesh_; }
    std::span<const Step> steps() const override { return domains_.front()->steps(); }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return domains_.front()->solver(); }
    std::string title() const override { return domains_.front()->title(); }

    Result load(std::size_t index) override {
        Result merged;
        merged.info = infos_.at(index);
        if (merged.info.location == Location::Nodal) {
            load_nodal(index, merged);
        } else if (merged.info.location == Location::Elemental) {
            load_elemental(index, merged);
        } else {
            load_of_elements(index, merged);
        }
        return merged;
    }

private:
    struct Source {
        std::size_t domain = 0;
        std::size_t index = 0;
    };

    void check_steps(const std::vector<std::string>& names) const {
        const auto first = domains_.front()->steps();
        const auto same = [](const Step& a, const Step& b) {
            return a.step == b.step && a.substep == b.substep && a.value == b.value;
        };
        for (std::size_t d = 1; d < domains_.size(); ++d) {
            const auto steps = domains_[d]->steps();
            if (std::ranges::equal(first, steps, same)) continue;
            throw Error(
                Code::MeshesDiffer,
                names[d],
                fmt::format(
                    "holds other steps ({}) than {} ({}). Are these files of one distributed run, and whole?",
                    steps.size(),
                    names.front(),
                    first.size()
                )
            );
        }
    }

    void merge_meshes() {
        Diagnostics heard_already;
        MeshBuilder builder(heard_already);
        add_nodes(builder);
        builder.seal_nodes();
        std::set<ElementId> known;
        for (const auto& domain : domains_) {
            const Mesh& mesh = domain->mesh();
            const auto node = [&](NodeIndex index) { return mesh.node_ids[raw(index)]; };
            copy_elements(mesh, {node, [&](ElementId id) { return known.insert(id).second; }, 0}, builder);
            for (const auto& [type, count] : mesh.skipped_elements) builder.skip_element(type, count);
        }
        if (const auto& unit = domains_.front()->mesh().length_unit) builder.set_length_unit(*unit);
        mesh_ = builder.finish();
        find_places();
        merge_sets();
    }

    void add_nodes(MeshBuilder& builder) const {
        std::map<NodeId, std::pair<const Mesh*, std::size_t>> nodes;
        for (const auto& domain : domains_) {
            const Mesh& mesh = domain->mesh();
            for (std::size_t i = 0; i < mesh.node_count(); ++i) nodes.try_emplace(mesh.node_ids[i], &mesh, i);
        }
        builder.reserve_nodes(nodes.size());
        for (const auto& [id, place] : nodes) {
            const auto& [mesh, i] = place;
            const NodalAngles angles = mesh->node_angles.empty() ? NodalAngles{} : mesh->node_angles[i];
            builder.add_node(id, mesh->coordinates[i], angles);
        }
    }

    void find_places() {
        const NodeLookup node(mesh_.node_ids);
        const ElementLookup element(mesh_);
        for (const auto& domain : domains_) {
            auto& nodes = node_place_.emplace_back();
            for (const NodeId id : domain->mesh().node_ids) nodes.push_back(node(id));
            auto& elements = element_place_.emplace_back();
            for (const ElementBlock& block : domain->mesh().blocks) {
                for (const ElementId id : block.ids) elements.push_back(element(id));
            }
        }
    }

    void merge_sets() {
        std::map<std::string, std::set<NodeIndex>> nodes;
        std::map<std::string, std::set<ElementIndex>> elements;
        for (std::size_t d = 0; d < domains_.size(); ++d) {
            for (const NodeSet& set : domains_[d]->mesh().node_sets) {
                for (const NodeIndex node : set.nodes) nodes[set.name].insert(node_place_[d][raw(node)]);
            }
            for (const ElementSet& set : domains_[d]->mesh().element_sets) {
                for (const ElementIndex at : set.elements)
                    elements[set.name].insert(element_place_[d][raw(at)]);
            }
        }
        for (const auto& [name, set] : nodes) mesh_.node_sets.push_back({name, {set.begin(), set.end()}});
        for (const auto& [name, set] : elements)
            mesh_.element_sets.push_back({name, {set.begin(), set.end()}});
    }

    void merge_results() {
        std::map<std::tuple<std::uint32_t, std::string, Layer, Complex, Location>, std::size_t> known;
        for (std::size_t d = 0; d < domains_.size(); ++d) {
            const auto results = domains_[d]->results();
            for (std::size_t i = 0; i < results.size(); ++i) {
                const ResultInfo& info = results[i];
                const auto [it, is_new] = known.try_emplace(
                    {info.step, info.name, info.layer, info.complex, info.location}, infos_.size()
                );
                if (is_new) {
                    infos_.push_back(info);
                    sources_.emplace_back();
                }
                infos_[it->second].nodal_system |= info.nodal_system;
                infos_[it->second].corner_only |= info.corner_only;
                if (infos_[it->second].components == info.components) sources_[it->second].push_back({d, i});
            }
        }
    }

    void load_nodal(std::size_t index, Result& merged) {
        const std::size_t width = merged.component_count();
        merged.values.assign(mesh_.node_count() * width, std::numeric_limits<float>::quiet_NaN());
        std::vector<bool> disputed(merged.values.size());
        for (const Source& source : sources_[index]) {
            const Result part = domains_[source.domain]->load(source.index);
            const auto& places = node_place_[source.domain];
            for (std::size_t row = 0; row < part.row_count() && row < places.size(); ++row) {
                for (std::size_t c = 0; c < width; ++c) {
                    const float value = part.values[row * width + c];
                    const std::size_t at = raw(places[row]) * width + c;
                    float& there = merged.values[at];
                    if (std::isnan(value)) continue;
                    if (std::isnan(there)) there = value;
                    if (there != value) disputed[at] = true;
                }
            }
        }
        std::uint64_t count = 0;
        for (std::size_t at = 0; at < disputed.size(); ++at) {
            if (!disputed[at]) continue;
            merged.values[at] = std::numeric_limits<float>::quiet_NaN();
            ++count;
        }
        if (count > 0 && reported_.insert(index).second) {
            diagnostics_.add(
                Code::SeveralValuesAtNode,
                name_,
                fmt::format(
                    "{} differs between the files of the run at nodes that they share; it is missing there",
                    merged.info.solver_name
                ),
                count
            );
        }
    }

    /// An element stands in one file; should it stand in two, the first has its value.
    void load_elemental(std::size_t index, Result& merged) {
        const std::size_t width = merged.component_count();
        merged.values.assign(mesh_.element_count() * width, std::numeric_limits<float>::quiet_NaN());
        for (const Source& source : sources_[index]) {
            const Result part = domains_[source.domain]->load(source.index);
            const auto& places = element_place_[source.domain];
            for (std::size_t row = 0; row < part.row_count() && row < places.size(); ++row) {
                if (places[row] == kNoElement) continue;
                for (std::size_t c = 0; c < width; ++c) {
                    float& there = merged.values[raw(places[row]) * width + c];
                    if (std::isnan(there)) there = part.values[row * width + c];
                }
            }
        }
    }

    void load_of_elements(std::size_t index, Result& merged) {
        const std::size_t width = merged.component_count();
        std::vector<float> values;
        std::vector<std::uint32_t> owners;
        std::vector<NodeIndex> nodes;
        for (const Source& source : sources_[index]) {
            const Result part = domains_[source.domain]->load(source.index);
            // Damaged files may name an element twice.
            for (std::size_t row = 0; row < part.row_count(); ++row) {
                owners.push_back(raw(element_place_[source.domain][part.row_owner[row]]));
                nodes.push_back(node_place_[source.domain][raw(part.row_node[row])]);
            }
            values.insert(values.end(), part.values.begin(), part.values.end());
        }
        std::vector<std::size_t> order(owners.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t row) { return owners[row]; });
        for (const std::size_t row : order) {
            merged.row_owner.push_back(owners[row]);
            merged.row_node.push_back(nodes[row]);
            const float* first = values.data() + row * width;
            merged.values.insert(merged.values.end(), first, first + width);
        }
    }

    std::vector<std::unique_ptr<ModelSource>> domains_;
    std::string name_;
    Diagnostics& diagnostics_;
    Mesh mesh_;
    std::vector<std::vector<NodeIndex>> node_place_;        ///< Of each domain, into mesh_.
    std::vector<std::vector<ElementIndex>> element_place_;  ///< Likewise.
    std::vector<ResultInfo> infos_;
    std::vector<std::vector<Source>> sources_;
    std::set<std::size_t> reported_;
};

}  // namespace

std::unique_ptr<ModelSource> merge_domains(
    std::vector<std::unique_ptr<ModelSource>> domains,
    const std::vector<std::string>& names,
    Diagnostics& diagnostics
) {
    return std::make_unique<MergedDomains>(std::move(domains), names, diagnostics);
}

}  // namespace feelem::rst
