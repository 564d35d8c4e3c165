// SPDX-License-Identifier: Apache-2.0
// Which results the lists hold: lists of one command by material become one result, shells become two.
#include "read/ansys/list_results.hpp"

#include "model/node_lookup.hpp"
#include "read/ansys/element_adder.hpp"
#include "read/ansys/list_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace feelem::ansys {
namespace {

std::optional<PartIndex> find_part(const Mesh& mesh, std::string_view name) {
    const auto found = std::ranges::find(mesh.parts, name, &Part::name);
    if (found == mesh.parts.end()) return std::nullopt;
    return PartIndex{static_cast<std::uint32_t>(found - mesh.parts.begin())};
}

/// Per node: whether elements use it as a mid-side node only.
std::vector<bool> midside_nodes(const Mesh& mesh) {
    std::vector<bool> middle(mesh.node_count());
    const bool has_middles = std::ranges::any_of(mesh.blocks, [](const ElementBlock& block) {
        return element_row(block.type).node_count > element_row(block.type).corner_count;
    });
    if (!has_middles) return middle;
    for (const bool corners : {false, true}) {
        for (const ElementBlock& block : mesh.blocks) {
            const ElementRow& row = element_row(block.type);
            for (std::size_t i = 0; i < block.nodes.size(); ++i) {
                const bool is_corner = i % row.node_count < row.corner_count;
                if (is_corner == corners && block.nodes[i] != kNoNode) middle[raw(block.nodes[i])] = !corners;
            }
        }
    }
    return middle;
}

/// Steps of the inputs, each once.
class StepTable {
public:
    explicit StepTable(std::vector<Step>& steps) : steps_(steps) {}

    std::uint32_t index(std::uint32_t input, const ValueHead& head, bool is_static) {
        const auto key =
            std::tuple(input, head.step, head.substep, head.load_case, head.is_frequency, head.value);
        const auto [found, added] = known_.emplace(key, static_cast<std::uint32_t>(steps_.size()));
        if (!added) return found->second;
        Step step{input, head.step, head.substep, StepKind::Other, head.value, ""};
        if (head.has_step) {
            step.kind = head.is_frequency ? StepKind::Frequency
                        : is_static       ? StepKind::Static
                                          : StepKind::Time;
        }
        if (head.load_case != 0) step.label = fmt::format("load case {}", head.load_case);
        steps_.push_back(step);
        return found->second;
    }

private:
    std::vector<Step>& steps_;
    std::map<std::tuple<std::uint32_t, int, int, int, bool, double>, std::uint32_t> known_;
};

bool is_values(ListKind kind) {
    return kind == ListKind::NodalValues || kind == ListKind::ElementNodalValues ||
           kind == ListKind::ElementValues;
}

/// A static solution ends load step n at time n unless the user says otherwise.
bool has_static_times(const ListFile& file) {
    return std::ranges::all_of(file.lists, [](const List& list) {
        return !is_values(list.kind) || list.head.value == static_cast<double>(list.head.step);
    });
}

class Lister {
public:
    Lister(const ListModel& model, const Mesh& mesh, bool has_angles, Diagnostics& diagnostics)
        : model_(model), mesh_(mesh), has_angles_(has_angles), diagnostics_(diagnostics), steps_(out_.steps) {
    }

    ListedResults run() {
        for (std::size_t i = 0; i < model_.files.size(); ++i) add_file(i);
        for (std::size_t i = 0; i < model_.exports.size(); ++i) add_export(i);
        join_derived(out_);
        return std::move(out_);
    }

private:
    void add_file(std::size_t file_index) {
        const ListFile& file = model_.files[file_index];
        const bool is_static = has_static_times(file);
        for (std::size_t i = 0; i < file.lists.size();) {
            const List& list = file.lists[i];
            std::size_t end = i + 1;
            if (is_values(list.kind)) {
                while (end < file.lists.size() && goes_on(file, i, end)) ++end;
                add_lists(file_index, i, end, is_static);
            }
            i = end;
        }
    }

    /// Whether a list is the table of a further material of the same command.
    static bool goes_on(const ListFile& file, std::size_t first, std::size_t next) {
        const List& list = file.lists[next];
        ValueHead head = list.head;
        head.material = file.lists[first].head.material;
        head.has_layers = file.lists[first].head.has_layers;
        if (list.kind != ListKind::NodalValues || list.kind != file.lists[first].kind) return false;
        if (head != file.lists[first].head || list.head.material == 0) return false;
        for (std::size_t i = first; i < next; ++i) {
            if (file.lists[i].head.material == list.head.material) return false;
        }
        return true;
    }

    void add_lists(std::size_t file_index, std::size_t first, std::size_t end, bool is_static) {
        const ListFile& file = model_.files[file_index];
        const List& list = file.lists[first];
        std::vector<Table> plain;
        std::vector<Table> layered;
        for (std::size_t i = first; i < end; ++i) {
            if (file.lists[i].rows == 0) continue;
            const int material = file.lists[i].head.material;
            Table table{false, file_index, i, std::nullopt};
            if (material != 0) table.part = find_part_of_material(mesh_, material);
            (file.lists[i].head.has_layers ? layered : plain).push_back(table);
        }
        const auto where = [&] {
            return list.runs.empty() ? file.input.name() : file.input.where_line(list.runs[0].begin);
        };
        if (plain.empty() && layered.empty()) {
            diagnostics_.add(
                Code::EmptyResult, where, fmt::format("a list of {} has no rows", name_of(list))
            );
            return;
        }
        note_axes(list, where);
        const std::uint32_t step = steps_.index(model_.file_inputs[file_index], list.head, is_static);
        for (const ColumnGroup& group : group_columns(list)) {
            ListedResult result{group.info, {}, group.columns, list.kind, file.input.name(), {}};
            result.info.step = step;
            result.info.nodal_system = group.info.nodal_system && !(has_angles_ && mesh_.node_angles.empty());
            add_layers(result, plain, layered);
        }
    }

    void add_layers(
        const ListedResult& result, const std::vector<Table>& plain, const std::vector<Table>& layered
    ) {
        if (result.kind == ListKind::ElementNodalValues) {
            add_element_layers(result, plain);
            return;
        }
        if (!plain.empty()) add_result(result, plain, result.info.layer);
        if (layered.empty()) return;
        add_result(result, layered, Layer::Top);
        add_result(result, layered, Layer::Bottom);
    }

    /// The rows of a shell are those of its top, of its bottom, and of its middle where it has one.
    void add_element_layers(const ListedResult& result, const std::vector<Table>& tables) {
        std::array<bool, 4> found{};  // Rows a node in an element.
        for (const Table& table : tables) {
            std::int64_t element = 0;
            std::vector<std::int64_t> nodes;
            const auto close = [&] {
                if (!nodes.empty()) found[count_layers(nodes)] = true;
                nodes.clear();
            };
            for_each_table_row(model_, table, nullptr, [&](const ValueRow& row) {
                if (row.element != element) close();
                element = row.element;
                nodes.push_back(row.id);
            });
            close();
        }
        if (found[1]) add_result(result, tables, Layer::No);
        if (found[2] || found[3]) add_result(result, tables, Layer::Top);
        if (found[2] || found[3]) add_result(result, tables, Layer::Bottom);
        if (found[3]) add_result(result, tables, Layer::Middle);
    }

    void add_result(ListedResult result, const std::vector<Table>& tables, Layer layer) {
        result.tables = tables;
        result.info.layer = layer;
        switch (result.kind) {
        case ListKind::ElementValues: result.info.location = Location::Elemental; break;
        case ListKind::ElementNodalValues: result.info.location = Location::ElementNodal; break;
        default: {
            const bool by_part =
                std::ranges::any_of(tables, [](const Table& table) { return table.part.has_value(); });
            result.info.location = by_part ? Location::PartNodal : Location::Nodal;
        }
        }
        result.info.corner_only = is_corner_only(result);
        out_.results.push_back(std::move(result));
    }

    /// Results of elements are listed at corner nodes only: no row of a mid-side node.
    bool is_corner_only(const ListedResult& result) {
        const Averaging averaging = result.info.averaging;
        if (averaging != Averaging::Solver && averaging != Averaging::None) return false;
        if (result.info.location == Location::Elemental) return false;
        if (middle_.empty()) middle_ = midside_nodes(mesh_);
        if (std::ranges::find(middle_, true) == middle_.end()) return false;
        if (!lookup_) lookup_.emplace(mesh_.node_ids);
        bool only_corners = true;
        for (const Table& table : result.tables) {
            for_each_table_row(model_, table, nullptr, [&](const ValueRow& row) {
                const NodeIndex node = (*lookup_)(NodeId{row.id});
                if (node != kNoNode && middle_[raw(node)]) only_corners = false;
            });
        }
        return only_corners;
    }

    void note_axes(const List& list, const std::function<std::string()>& where) {
        if (list.head.axes == AxesNote::Other) {
            diagnostics_.add(
                Code::CoordinateSystem,
                where,
                fmt::format(
                    "{} is not along global axes (\"{}\"): its components keep the solver's names. List it "
                    "again after "
                    "RSYS,0.",
                    name_of(list),
                    list.head.axes_text
                )
            );
        } else if (list.head.axes == AxesNote::Nodal && !has_angles_) {
            diagnostics_.add(
                Code::CoordinateSystem,
                where,
                fmt::format(
                    "{} is in nodal coordinate systems, and no input says how these are turned: taken as "
                    "global. Add a "
                    "node list with THXY THYZ THZX.",
                    name_of(list)
                )
            );
        }
    }

    static std::string name_of(const List& list) {
        return list.head.label.empty() ? list.head.title.empty() ? "values" : list.head.title
                                       : list.head.label;
    }

    void add_export(std::size_t index) {
        const ExportFile& file = model_.exports[index];
        if (file.rows == 0) {
            diagnostics_.add(Code::EmptyResult, file.input.name(), "the exported table has no rows");
            return;
        }
        const std::uint32_t step = steps_.index(model_.export_inputs[index], {}, false);
        std::vector<Table> tables;
        for (std::size_t body = 0; body < file.bodies.size(); ++body) {
            tables.push_back(
                {true, index, body, file.repeats_numbers ? part_of_body(file, body) : std::nullopt}
            );
        }
        // Half known parts would lose the other rows.
        const bool all =
            std::ranges::all_of(tables, [](const Table& table) { return table.part.has_value(); });
        if (!all) {
            for (Table& table : tables) table.part.reset();
        }
        for (std::size_t column = 0; column < file.columns.size(); ++column) {
            ListedResult result{
                file.columns[column], {}, {column}, ListKind::NodalValues, file.input.name(), {}};
            if (file.of_elements) result.kind = ListKind::ElementValues;
            result.info.step = step;
            add_result(std::move(result), tables, Layer::No);
        }
    }

    /// The one part whose elements use all nodes of a body; without elements the part made for it.
    std::optional<PartIndex> part_of_body(const ExportFile& file, std::size_t body) {
        if (mesh_.blocks.empty()) return find_part(mesh_, body_name(file, body));
        if (!lookup_) lookup_.emplace(mesh_.node_ids);
        if (nodes_of_parts_.empty()) find_nodes_of_parts();
        std::vector<bool> possible(mesh_.parts.size(), true);
        for_each_export_row(file, file.bodies[body], nullptr, [&](const ExportRow& row) {
            const NodeIndex node = (*lookup_)(NodeId{row.values.id});
            for (std::size_t part = 0; part < possible.size(); ++part) {
                possible[part] = possible[part] && node != kNoNode && nodes_of_parts_[part][raw(node)];
            }
        });
        if (std::ranges::count(possible, true) != 1) return std::nullopt;
        return PartIndex{static_cast<std::uint32_t>(std::ranges::find(possible, true) - possible.begin())};
    }

    void find_nodes_of_parts() {
        nodes_of_parts_.assign(mesh_.parts.size(), std::vector<bool>(mesh_.node_count()));
        for (const ElementBlock& block : mesh_.blocks) {
            const std::size_t count = element_row(block.type).node_count;
            for (std::size_t i = 0; i < block.nodes.size(); ++i) {
                if (block.nodes[i] != kNoNode)
                    nodes_of_parts_[raw(block.parts[i / count])][raw(block.nodes[i])] = true;
            }
        }
    }

    const ListModel& model_;
    const Mesh& mesh_;
    bool has_angles_;
    Diagnostics& diagnostics_;
    ListedResults out_;
    StepTable steps_;
    std::vector<bool> middle_;
    std::optional<NodeLookup> lookup_;
    std::vector<std::vector<bool>> nodes_of_parts_;
};

}  // namespace

std::string body_name(const ExportFile& file, std::size_t body) {
    const std::string& name = file.input.name();
    return fmt::format("{} body {}", name.substr(name.find_last_of('/') + 1), body + 1);
}

std::size_t count_layers(std::span<const std::int64_t> nodes) {
    for (const std::size_t layers : {2U, 3U}) {
        const std::size_t period = nodes.size() / layers;
        if (nodes.size() % layers != 0 || period < 2) continue;
        if (std::equal(nodes.begin() + static_cast<std::ptrdiff_t>(period), nodes.end(), nodes.begin()))
            return layers;
    }
    return 1;
}

ListedResults list_results(
    const ListModel& model, const Mesh& mesh, bool has_angles, Diagnostics& diagnostics
) {
    return Lister(model, mesh, has_angles, diagnostics).run();
}

void for_each_table_row(
    const ListModel& model,
    const Table& table,
    Diagnostics* diagnostics,
    const std::function<void(const ValueRow&)>& use,
    const std::function<void(const ValueRows&)>& use_many
) {
    if (!table.is_export) {
        const ListFile& file = model.files[table.file];
        for_each_value_row(file, file.lists[table.list], diagnostics, use, use_many);
        return;
    }
    const ExportFile& file = model.exports[table.file];
    for_each_export_row(file, file.bodies[table.list], diagnostics, [&](const ExportRow& row) {
        use(row.values);
    });
}

}  // namespace feelem::ansys
