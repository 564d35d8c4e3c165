// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_source.hpp"

#include "model/node_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace feelem::rst {

RstSource::RstSource(Input input, Diagnostics& diagnostics)
    : records_(std::move(input)), diagnostics_(diagnostics), header_(read_header(records_)),
      file_mesh_(read_file_mesh(records_, header_, diagnostics)) {
    // Heads lie far from each other: what stands between them is not wanted yet.
    records_.input().expect_jumps();
    sets_ = read_sets(records_, header_, diagnostics);
    if (mesh().node_count() == 0)
        throw Error(Code::NoNodes, records_.input().name(), "the result file holds no nodes");
    find_row_nodes();
    list_results();
    records_.input().expect_run();
    reported_.resize(infos_.size());
}

Result RstSource::load(std::size_t index) {
    const Listed& listed = listed_.at(index);
    if (listed.group == Group::Nodal) return load_nodal(index);
    ElementValues values = load_of_elements(listed);
    report(index, 0, values.without_number);
    report_elements(index, values.not_understood);
    reported_[index] = true;
    return {infos_[index], std::move(values.values), std::move(values.row_owner), std::move(values.row_node)};
}

Result RstSource::load_nodal(std::size_t index) {
    const NodalResult& nodal = nodal_[listed_[index].place];
    NodalValues values = read_nodal_values(records_, sets_.sets[nodal.set], nodal, mesh(), row_nodes_);
    report(index, values.without_node, values.without_number);
    reported_[index] = true;
    return {infos_[index], std::move(values.values), {}, {}};
}

ElementValues RstSource::load_of_elements(const Listed& listed) const {
    const ElementSource source = element_source();
    const auto set_of = [this](const auto& result) -> const ResultSet& { return sets_.sets[result.set]; };
    switch (listed.group) {
    case Group::Element: {
        const ElementResult& result = elements_[listed.place];
        return read_element_values(source, set_of(result), result);
    }
    case Group::Beam: {
        const BeamResult& result = beams_[listed.place];
        return read_beam_values(source, set_of(result), result);
    }
    case Group::Energy: {
        const EnergyResult& result = energies_[listed.place];
        return read_energy(source, set_of(result), result);
    }
    case Group::Nodal: break;
    }
    return {};
}

void RstSource::find_row_nodes() {
    if (header_.node_ids == 0) return;
    const std::vector<std::int32_t> ids = records_.integers(header_.node_ids, header_.nodes);
    row_nodes_.reserve(ids.size());
    const NodeLookup lookup(mesh().node_ids);
    for (const std::int32_t id : ids) row_nodes_.push_back(lookup(NodeId{id}));
}

void RstSource::list_results() {
    nodal_ = list_nodal_results(sets_, header_, records_, !mesh().node_angles.empty());
    if (mesh().node_angles.empty()) {
        for (NodalResult& average : list_nodal_averages(sets_, header_, records_))
            nodal_.push_back(std::move(average));
    } else {
        note_averages();
    }
    element_order_ = elements_in_mesh_order(file_mesh_);
    elements_ = list_element_results(sets_, header_, file_mesh_);
    beams_ = list_beam_results(sets_, header_, file_mesh_, records_.input().name(), diagnostics_);
    energies_ = list_energies(sets_, element_source());
    const auto list_all = [this](Group group, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) listed_.push_back({group, i});
    };
    list_all(Group::Nodal, nodal_.size());
    list_all(Group::Element, elements_.size());
    list_all(Group::Beam, beams_.size());
    list_all(Group::Energy, energies_.size());
    std::ranges::stable_sort(listed_, {}, [this](const Listed& listed) { return info_of(listed).step; });
    for (const Listed& listed : listed_) {
        infos_.push_back(info_of(listed));
        make_unique(infos_.back());
    }
}

const ResultInfo& RstSource::info_of(const Listed& listed) const {
    switch (listed.group) {
    case Group::Element: return elements_[listed.place].info;
    case Group::Beam: return beams_[listed.place].info;
    case Group::Energy: return energies_[listed.place].info;
    case Group::Nodal: break;
    }
    return nodal_[listed.place].info;
}

void RstSource::make_unique(ResultInfo& info) {
    const auto key = std::make_tuple(info.step, info.layer, info.complex, info.name);
    const int before = names_[key]++;
    if (before > 0) info.name += fmt::format("_{}", before + 1);
}

/// No file was to be had that says along which axes they stand then.
void RstSource::note_averages() {
    for (const ResultSet& set : sets_.sets) {
        if (set.nodal_averages == 0) continue;
        diagnostics_.add(
            Code::UnknownBlock,
            records_.input().name(),
            "nodal averages (OUTRES,NAR) are left out: some nodes have coordinate systems of their own, "
            "and "
            "it is not known whether the averages follow them"
        );
    }
}

void RstSource::report(std::size_t index, std::uint64_t without_node, std::uint64_t without_number) {
    if (reported_[index]) return;
    const std::string& name = infos_[index].solver_name;
    if (without_node > 0) {
        diagnostics_.add(
            Code::ResultWithoutNode,
            records_.input().name(),
            fmt::format("{} has values at nodes that the mesh does not have", name),
            without_node
        );
    }
    if (without_number > 0) {
        diagnostics_.add(
            Code::NonFiniteValue,
            records_.input().name(),
            fmt::format("{} has values that are no finite numbers; they count as missing", name),
            without_number
        );
    }
}

void RstSource::report_elements(std::size_t index, std::uint64_t not_understood) {
    if (reported_[index] || not_understood == 0) return;
    diagnostics_.add(
        Code::ResultForPartOfModel,
        records_.input().name(),
        fmt::format(
            "{} is left out for elements whose layers are stored in an order that is not known",
            infos_[index].solver_name
        ),
        not_understood
    );
}

}  // namespace feelem::rst
