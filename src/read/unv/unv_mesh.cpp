// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/text_lines.hpp"
#include "read/unv/unv_elements.hpp"
#include "read/unv/unv_systems.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace feelem::unv {
namespace {

constexpr std::size_t kMostNodesOfAnElement = 64;

struct Group {
    std::string name;
    std::vector<NodeId> nodes;
    std::vector<ElementId> elements;
};

class MeshReader {
public:
    MeshReader(const Input& input, std::span<const Dataset> datasets, Diagnostics& diagnostics)
        : input_(input), datasets_(datasets), diagnostics_(diagnostics), builder_(diagnostics) {}

    Mesh read() {
        for_each({2420}, [&](const Dataset& dataset) {
            for (auto& [number, system] : read_systems(input_, dataset)) systems_[number] = system;
        });
        for_each({164}, [&](const Dataset& dataset) { read_units(dataset); });
        for_each({2411, 781, 15}, [&](const Dataset& dataset) { read_nodes(dataset); });
        builder_.seal_nodes();
        for_each({2412, 780}, [&](const Dataset& dataset) { read_elements(dataset); });
        for_each({2467, 2477, 2435, 2452, 2430, 2429, 2432}, [&](const Dataset& dataset) {
            read_groups(dataset);
        });
        for (const Group& group : groups_) {
            if (!group.nodes.empty()) builder_.add_node_set(group.name, group.nodes);
        }
        Mesh mesh = builder_.finish();
        const ElementLookup lookup(mesh);
        for (const Group& group : groups_) add_element_set(mesh, lookup, group.name, group.elements);
        report();
        return mesh;
    }

private:
    template <class Read>
    void for_each(std::initializer_list<int> numbers, const Read& read) {
        for (const Dataset& dataset : datasets_) {
            if (std::ranges::find(numbers, dataset.number) != numbers.end()) read(dataset);
        }
    }

    [[noreturn]] void bad(const TextLines& lines, Code code, std::string_view text) const {
        throw Error(code, lines.where(), std::string(text));
    }

    /// The factor turns the file's lengths into metres by division.
    void read_units(const Dataset& dataset) {
        TextLines lines(input_, dataset.first, dataset.last);
        lines.next();
        auto line = lines.next();
        const auto factor = line ? parse_double(take_word(*line)) : std::nullopt;
        if (!factor || !(*factor > 0) || !std::isfinite(*factor)) {
            diagnostics_.add(
                Code::UnitsUnknown,
                [&] { return lines.where(); },
                "the units (dataset 164) have no length factor"
            );
            return;
        }
        struct Known {
            const char* name;
            double metres;
        };
        constexpr Known kKnown[]{
            {"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}, {"um", 1e-6}};
        for (const Known& unit : kKnown) {
            // Writers round the factor of feet and inches to a few digits.
            if (std::abs(*factor * unit.metres - 1) < 1e-4) {
                builder_.set_length_unit({unit.name, unit.metres});
                return;
            }
        }
        diagnostics_.add(
            Code::UnitsUnknown,
            [&] { return lines.where(); },
            fmt::format(
                "{:g} units of the file are a metre (dataset 164): no unit that Feelem knows", *factor
            )
        );
    }

    void read_nodes(const Dataset& dataset) {
        TextLines lines(input_, dataset.first, dataset.last);
        const bool one_line = dataset.number == 15;
        while (auto line = lines.next()) {
            if (trim(*line).empty()) continue;
            const auto id = take_integer(*line);
            const auto defined_in = take_integer(*line);
            const auto results_in = take_integer(*line);
            if (!id || *id <= 0 || !defined_in || !results_in || !take_integer(*line))
                bad(lines,
                    Code::BadNumber,
                    "a node needs four integers: label, two coordinate systems, colour");
            Point3 place{};
            std::string_view numbers = one_line ? *line : lines.next().value_or(std::string_view{});
            for (double& x : place) {
                const auto value = parse_double(take_word(numbers));
                if (!value) bad(lines, Code::BadNumber, fmt::format("node {} needs three coordinates", *id));
                x = *value;
            }
            note_results_in(*results_in);
            // Only the oldest form has coordinates in the node's own system.
            if (one_line) place = placed(place, *defined_in);
            builder_.add_node(NodeId{*id}, place);
        }
    }

    Point3 placed(const Point3& place, std::int64_t number) {
        const auto found = systems_.find(number);
        if (found != systems_.end()) return found->second.to_part(place);
        if (number != 0) ++in_unknown_system_;
        return place;
    }

    void note_results_in(std::int64_t number) {
        const auto found = systems_.find(number);
        if (found != systems_.end() && !found->second.is_global()) ++with_turned_results_;
    }

    void read_elements(const Dataset& dataset) {
        TextLines lines(input_, dataset.first, dataset.last);
        const bool newer = dataset.number == 2412;
        while (auto line = lines.next()) {
            if (trim(*line).empty()) continue;
            const std::size_t start = lines.line_start();
            std::int64_t head[8]{};
            const std::size_t fields = newer ? 6 : 8;
            for (std::size_t i = 0; i < fields; ++i) {
                const auto value = take_integer(*line);
                if (!value)
                    bad(lines, Code::BadNumber, fmt::format("an element's head needs {} integers", fields));
                head[i] = *value;
            }
            const std::int64_t count = head[fields - 1];
            if (count <= 0 || count > 1'000'000)
                bad(lines, Code::BadStructure, fmt::format("element {} has {} nodes", head[0], count));
            if (has_beam_line(head[1])) lines.next();
            const std::size_t kept = read_row(lines, static_cast<std::size_t>(count), head[0]);
            add(head[0], head[1], newer ? head[2] : head[3], std::span(row_).first(kept), count, start);
        }
    }

    /// The nodes of an element into row_, as many as it holds.
    std::size_t read_row(TextLines& lines, std::size_t count, std::int64_t id) {
        std::string_view rest;
        for (std::size_t i = 0; i < count; ++i) {
            std::string_view word = take_word(rest);
            if (word.empty()) {
                rest = lines.next().value_or(std::string_view{});
                word = take_word(rest);
            }
            const auto node = parse_integer(word);
            if (!node) bad(lines, Code::BadNumber, fmt::format("element {} should have {} nodes", id, count));
            if (i < row_.size()) row_[i] = NodeId{*node};
        }
        return std::min(count, row_.size());
    }

    void add(
        std::int64_t id,
        std::int64_t descriptor,
        std::int64_t property,
        std::span<const NodeId> row,
        std::int64_t count,
        std::size_t start
    ) {
        const auto where = [&] { return input_.where_line(start); };
        const auto type = type_of(descriptor, static_cast<std::size_t>(count));
        if (!type) {
            if (family_of(descriptor) == Family::NoSurface) {
                builder_.skip_element(descriptor_name(descriptor));
                return;
            }
            diagnostics_.add(
                Code::UnknownElementType,
                where,
                fmt::format("elements {} with {} nodes are left out", descriptor_name(descriptor), count)
            );
            return;
        }
        const std::span<const std::uint8_t> order = file_order(*type);
        NodeId ours[kMaxElementNodes];
        for (std::size_t i = 0; i < row.size(); ++i) ours[i] = order.empty() ? row[i] : row[order[i]];
        if (property != last_property_ || !last_part_) {
            last_part_ = builder_.part(fmt::format("property {}", property));
            last_property_ = property;
        }
        builder_.add_element(ElementId{id}, *type, std::span(ours).first(row.size()), *last_part_, where);
    }

    void read_groups(const Dataset& dataset) {
        TextLines lines(input_, dataset.first, dataset.last);
        const bool with_leaves = dataset.number > 2432;  // Two more numbers an entity.
        while (auto line = lines.next()) {
            if (trim(*line).empty()) continue;
            const auto number = take_integer(*line);
            std::int64_t count = 0;
            while (const auto value = take_integer(*line)) count = *value;
            if (!number || count < 0)
                bad(lines,
                    Code::BadNumber,
                    "a group's head needs its number and, last, its number of entities");
            Group group;
            group.name = trim(lines.next().value_or(std::string_view{}));
            if (group.name.empty()) group.name = fmt::format("group {}", *number);
            std::string_view rest;
            for (std::int64_t i = 0; i < count; ++i) {
                if (trim(rest).empty()) rest = lines.next().value_or(std::string_view{});
                const auto kind = take_integer(rest);
                const auto id = take_integer(rest);
                if (!kind || !id)
                    bad(lines,
                        Code::BadNumber,
                        fmt::format("group \"{}\" should list {} entities", group.name, count));
                if (with_leaves) {
                    take_word(rest);
                    take_word(rest);
                }
                if (*kind == 7) group.nodes.push_back(NodeId{*id});
                if (*kind == 8) group.elements.push_back(ElementId{*id});
            }
            groups_.push_back(std::move(group));
        }
    }

    void report() {
        if (in_unknown_system_ > 0) {
            diagnostics_.add(
                Code::CoordinateSystem,
                input_.name(),
                "nodes are given in coordinate systems that the file does not define; their coordinates are "
                "taken as they stand",
                in_unknown_system_
            );
        }
        if (with_turned_results_ > 0) {
            diagnostics_.add(
                Code::CoordinateSystem,
                input_.name(),
                "nodes name a displacement system of their own; vectors are taken as global, as the datasets "
                "of results call them",
                with_turned_results_
            );
        }
    }

    const Input& input_;
    std::span<const Dataset> datasets_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    std::map<std::int64_t, System> systems_;
    std::array<NodeId, kMostNodesOfAnElement> row_{};
    std::vector<Group> groups_;
    std::int64_t last_property_ = 0;
    std::optional<PartIndex> last_part_;
    std::uint64_t in_unknown_system_ = 0, with_turned_results_ = 0;
};

}  // namespace

Mesh read_mesh(const Input& input, std::span<const Dataset> datasets, Diagnostics& diagnostics) {
    return MeshReader(input, datasets, diagnostics).read();
}

}  // namespace feelem::unv
