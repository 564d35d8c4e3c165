// SPDX-License-Identifier: Apache-2.0
// A set of lists as a ModelSource: heads are found on opening, values read on demand.
#include "read/ansys/ansys_lists.hpp"

#include "read/ansys/element_adder.hpp"
#include "read/ansys/list_heads.hpp"
#include "read/ansys/list_mesh.hpp"
#include "read/ansys/list_results.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace feelem {
namespace {

using namespace ansys;

Likelihood recognise_lists(const Input& input) {
    const std::string_view head = head_of(input);
    if (has_list_title(head)) return Likelihood::Sure;
    return is_export(head) || has_list_rows(head) ? Likelihood::Maybe : Likelihood::No;
}

bool has_elements(const ListModel& model) {
    return std::ranges::any_of(model.files, [](const ListFile& file) {
        return std::ranges::any_of(file.lists, [](const List& list) {
            return list.kind == ListKind::Elements && list.has_nodes;
        });
    });
}

class ListSource : public ModelSource {
public:
    ListSource(std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics)
        : diagnostics_(diagnostics) {
        for (std::uint32_t i = 0; i < inputs.size(); ++i) scan(inputs[i], i);
        report_lists_without_nodes();
        read_own_mesh(context);
        const bool has_angles = has_angles_ || !mesh_->node_angles.empty();
        listed_ = list_results(model_, *mesh_, has_angles, diagnostics_);
        for (const ListedResult& result : listed_.results) infos_.push_back(result.info);
        reported_.resize(infos_.size());
        if (mesh_->node_count() == 0) throw_nothing(inputs.front().name());
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return listed_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"Ansys", ""}; }

    Result load(std::size_t index) override {
        const ListedResult& result = listed_.results.at(index);
        Result loaded = load_values(model_, result, *mesh_, reported_[index] ? nullptr : &diagnostics_);
        reported_[index] = true;
        return loaded;
    }

private:
    void scan(const Input& input, std::uint32_t index) {
        if (!has_list_title(head_of(input)) && is_export(head_of(input))) {
            if (auto file = scan_export(input, diagnostics_)) {
                model_.exports.push_back(std::move(*file));
                model_.export_inputs.push_back(index);
            }
            return;
        }
        model_.files.push_back(scan_lists(input, diagnostics_));
        model_.file_inputs.push_back(index);
    }

    void report_lists_without_nodes() {
        for (const ListFile& file : model_.files) {
            for (const List& list : file.lists) {
                if (list.kind != ListKind::Elements || list.has_nodes) continue;
                without_nodes_ =
                    list.runs.empty() ? file.input.name() : file.input.where_line(list.runs[0].begin);
                diagnostics_.add(
                    Code::NotAMesh, without_nodes_, kWithoutNodes, std::max<std::size_t>(list.rows, 1)
                );
            }
        }
    }

    void read_own_mesh(const ReadContext& context) {
        if (context.mesh != nullptr && !has_elements(model_)) {
            mesh_ = context.mesh;
            return;
        }
        ListedNodes nodes = collect_nodes(model_.files, diagnostics_);
        has_angles_ = nodes.has_angles;
        if (nodes.ids.empty()) {
            collect_places(nodes);
            add_unplaced(nodes, ids_without_places());
        }
        std::vector<int> materials;
        for (const ListFile& file : model_.files) {
            for (const List& list : file.lists) {
                if (list.head.material != 0 && list.rows > 0) materials.push_back(list.head.material);
            }
        }
        TypeTable types = read_types(model_.files, context.options.types, diagnostics_);
        own_mesh_ =
            build_mesh(model_.files, std::move(types), std::move(nodes), part_names(materials), diagnostics_);
        const auto has_no_place = [](const Point3& place) { return std::isnan(place[0]); };
        if (!own_mesh_.blocks.empty() && std::ranges::any_of(own_mesh_.coordinates, has_no_place)) {
            diagnostics_.add(
                Code::NotAMesh,
                std::string(),
                "the inputs name elements but not where their nodes are. Add the node list: "
                "NLIST,ALL,,,COORD."
            );
        }
        mesh_ = own_or_shared(own_mesh_, context.mesh);
    }

    /// Parts that results need besides those of elements.
    std::vector<std::string> part_names(std::span<const int> materials) const {
        std::vector<std::string> names;
        for (const int material : materials) names.push_back(part_name(material));
        if (has_elements(model_)) return names;
        for (const ExportFile& file : model_.exports) {
            for (std::size_t body = 0; file.repeats_numbers && body < file.bodies.size(); ++body) {
                names.push_back(body_name(file, body));
            }
        }
        return names;
    }

    /// Places out of exports, when there is no node list.
    void collect_places(ListedNodes& nodes) {
        for (const ExportFile& file : model_.exports) {
            if (!file.has_places || file.of_elements) continue;
            nodes.length_unit = file.length_unit;
            for (const TextRange body : file.bodies) {
                for_each_export_row(file, body, nullptr, [&](const ExportRow& row) {
                    nodes.ids.push_back(NodeId{row.values.id});
                    nodes.positions.push_back(row.place);
                });
            }
            sort_nodes(nodes);
            diagnostics_.add(
                Code::LowPrecision,
                file.input.name(),
                "nodes are placed by an exported table, which has five digits; a node list has more"
            );
        }
    }

    std::vector<NodeId> ids_without_places() {
        std::vector<NodeId> ids = nodes_of_elements(model_.files);
        for (std::size_t i = 0; i < model_.files.size(); ++i) {
            const ListFile& file = model_.files[i];
            for (std::size_t l = 0; l < file.lists.size(); ++l) {
                const ListKind kind = file.lists[l].kind;
                if (kind == ListKind::NodalValues || kind == ListKind::ElementNodalValues)
                    add_ids({false, i, l, {}}, ids);
            }
        }
        for (std::size_t i = 0; i < model_.exports.size(); ++i) {
            const ExportFile& file = model_.exports[i];
            for (std::size_t body = 0; !file.of_elements && body < file.bodies.size(); ++body) {
                add_ids({true, i, body, {}}, ids);
            }
        }
        return ids;
    }

    void add_ids(const Table& table, std::vector<NodeId>& ids) {
        for_each_table_row(model_, table, nullptr, [&](const ValueRow& row) {
            ids.push_back(NodeId{row.id});
        });
    }

    [[noreturn]] void throw_nothing(const std::string& name) const {
        if (!without_nodes_.empty()) throw Error(Code::NotAMesh, without_nodes_, kWithoutNodes);
        const bool has_results = !listed_.results.empty();
        throw Error(
            has_results ? Code::NoElements : Code::NoNodes,
            name,
            has_results
                ? "the lists hold values of elements, but no input lists the elements. Add ELIST and NLIST."
                : "the lists hold no nodes, no elements and no results that Feelem reads"
        );
    }

    static constexpr const char* kWithoutNodes = "elements are listed without their nodes (DO NOT LIST "
                                                 "NODES): they are no mesh. List them again with ELIST.";

    Diagnostics& diagnostics_;
    ListModel model_;
    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    bool has_angles_ = false;
    std::string without_nodes_;
    ListedResults listed_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

std::unique_ptr<ModelSource> open_lists(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<ListSource>(inputs, context, diagnostics);
}

}  // namespace

ReadFormat ansys_lists_format() {
    return {
        {"ansys-lists",
         "Ansys text lists (NLIST, ELIST, ETLIST, PRNSOL, PRESOL) and Mechanical exports",
         ".lis .txt .csv",
         true,
         true},
        true,
        recognise_lists,
        open_lists};
}

}  // namespace feelem
