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
      file_mesh_(read_file_mesh(records_, header_, diagnostics)),
      sets_(read_sets(records_, header_, diagnostics)) {
    if (mesh().node_count() == 0)
        throw Error(Code::NoNodes, records_.input().name(), "the result file holds no nodes");
    find_row_nodes();
    list_results();
    reported_.resize(infos_.size());
}

Result RstSource::load(std::size_t index) {
    const Listed& listed = listed_.at(index);
    Result result;
    result.info = infos_[index];
    if (listed.of_elements) {
        const ElementResult& element = elements_[listed.place];
        const ElementSource source{records_, header_, file_mesh_, element_order_};
        ElementValues values = read_element_values(source, sets_.sets[element.set], element);
        report(index, 0, values.without_number);
        report_elements(index, values.not_understood);
        result.values = std::move(values.values);
        result.row_owner = std::move(values.row_owner);
        result.row_node = std::move(values.row_node);
    } else {
        const NodalResult& nodal = nodal_[listed.place];
        NodalValues values = read_nodal_values(records_, sets_.sets[nodal.set], nodal, mesh(), row_nodes_);
        report(index, values.without_node, values.without_number);
        result.values = std::move(values.values);
    }
    reported_[index] = true;
    return result;
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
    elements_ = list_element_results(sets_, header_, file_mesh_);
    if (!elements_.empty()) element_order_ = elements_in_mesh_order(file_mesh_);
    for (std::size_t i = 0; i < nodal_.size(); ++i) listed_.push_back({false, i});
    for (std::size_t i = 0; i < elements_.size(); ++i) listed_.push_back({true, i});
    std::ranges::stable_sort(listed_, {}, [this](const Listed& listed) { return info_of(listed).step; });
    for (const Listed& listed : listed_) {
        infos_.push_back(info_of(listed));
        make_unique(infos_.back());
    }
}

const ResultInfo& RstSource::info_of(const Listed& listed) const {
    return listed.of_elements ? elements_[listed.place].info : nodal_[listed.place].info;
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
