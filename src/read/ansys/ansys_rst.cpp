// SPDX-License-Identifier: Apache-2.0
// A result file as a ModelSource: heads are read on opening, values on demand.
#include "read/ansys/ansys_rst.hpp"

#include "model/node_lookup.hpp"
#include "read/ansys/rst_element.hpp"
#include "read/ansys/rst_header.hpp"
#include "read/ansys/rst_mesh.hpp"
#include "read/ansys/rst_nodal.hpp"
#include "read/ansys/rst_steps.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace feelem {
namespace rst {
namespace {

std::int32_t word_of(std::string_view head, std::size_t number) {
    std::int32_t word = 0;
    if (head.size() >= 4 * number + 4) std::memcpy(&word, head.data() + 4 * number, sizeof word);
    return word;
}

/// Every binary file of Ansys begins with a record of 100 integers; the first says what kind of file it is.
Likelihood recognise_rst(const Input& input) {
    constexpr std::int32_t kResultFile = 12;
    const std::string_view head = head_of(input);
    const bool is_ansys =
        word_of(head, 0) == 100 && static_cast<std::uint32_t>(word_of(head, 1)) >> 24 == 0x80;
    if (!is_ansys) return Likelihood::No;
    return word_of(head, 2) == kResultFile ? Likelihood::Sure : Likelihood::Maybe;
}

class RstSource : public ModelSource {
public:
    RstSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : records_(std::move(input)), diagnostics_(diagnostics), header_(read_header(records_)),
          file_mesh_(read_file_mesh(records_, header_, diagnostics)),
          sets_(read_sets(records_, header_, diagnostics)) {
        mesh_ = &file_mesh_.mesh;
        if (mesh_->node_count() == 0)
            throw Error(Code::NoNodes, records_.input().name(), "the result file holds no nodes");
        if (context.mesh != nullptr) check_same_mesh(*context.mesh, *mesh_, records_.input().name());
        find_row_nodes();
        list_results();
        reported_.resize(infos_.size());
        if (header_.sectors > 1) note_cyclic();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return sets_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"Ansys", header_.version}; }
    std::string title() const override { return header_.title; }

    Result load(std::size_t index) override {
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
            NodalValues values =
                read_nodal_values(records_, sets_.sets[nodal.set], nodal, *mesh_, row_nodes_);
            report(index, values.without_node, values.without_number);
            result.values = std::move(values.values);
        }
        reported_[index] = true;
        return result;
    }

private:
    /// A result by its kind and place among those.
    struct Listed {
        bool of_elements = false;
        std::size_t place = 0;
    };

    void list_results() {
        nodal_ = list_nodal_results(sets_, header_, records_, !mesh_->node_angles.empty());
        if (mesh_->node_angles.empty()) {
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

    const ResultInfo& info_of(const Listed& listed) const {
        return listed.of_elements ? elements_[listed.place].info : nodal_[listed.place].info;
    }

    void find_row_nodes() {
        if (header_.node_ids == 0) return;
        const std::vector<std::int32_t> ids = records_.integers(header_.node_ids, header_.nodes);
        row_nodes_.reserve(ids.size());
        const NodeLookup lookup(mesh_->node_ids);
        for (const std::int32_t id : ids) row_nodes_.push_back(lookup(NodeId{id}));
    }

    /// Two results of one step may not share a name: velocity of a fluid and of a structure.
    void make_unique(ResultInfo& info) {
        const auto key = std::make_tuple(info.step, info.layer, info.complex, info.name);
        const int before = names_[key]++;
        if (before > 0) info.name += fmt::format("_{}", before + 1);
    }

    /// No file was to be had that says along which axes they stand then.
    void note_averages() {
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

    void note_cyclic() {
        diagnostics_.add(
            Code::ResultForPartOfModel,
            records_.input().name(),
            fmt::format(
                "the model is one of {} equal sectors round an axis; only the sector in the file is shown",
                header_.sectors
            )
        );
    }

    void report(std::size_t index, std::uint64_t without_node, std::uint64_t without_number) {
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

    void report_elements(std::size_t index, std::uint64_t not_understood) {
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

    Records records_;
    Diagnostics& diagnostics_;
    ResultHeader header_;
    FileMesh file_mesh_;
    ResultSets sets_;
    const Mesh* mesh_ = nullptr;
    std::vector<NodeIndex> row_nodes_;
    std::vector<ResultInfo> infos_;
    std::vector<Listed> listed_;
    std::vector<NodalResult> nodal_;
    std::vector<ElementResult> elements_;
    std::vector<std::uint32_t> element_order_;
    std::vector<bool> reported_;
    std::map<std::tuple<std::uint32_t, Layer, Complex, std::string>, int> names_;
};

std::unique_ptr<ModelSource> open_rst(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<RstSource>(inputs.front(), context, diagnostics);
}

}  // namespace
}  // namespace rst

ReadFormat ansys_rst_format() {
    return {
        {"ansys-rst", "Ansys results, binary", ".rst .rth .rmg", true, true},
        false,
        rst::recognise_rst,
        rst::open_rst};
}

}  // namespace feelem
