// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_mesh.hpp"

#include "base/huge_pages.hpp"
#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/text_lines.hpp"
#include "read/unv/plain_records.hpp"
#include "read/unv/unv_elements.hpp"
#include "read/unv/unv_groups.hpp"
#include "read/unv/unv_systems.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace feelem::unv {
namespace {

constexpr std::size_t kMostNodesOfAnElement = 64;

struct NodeRows {
    std::vector<NodeId> ids;
    std::vector<Point3> places;
};

/// Elements of one type and part that follow each other.
struct AlikeElements {
    ElementType type = ElementType::Point1;
    std::vector<ElementId> ids;
    std::vector<std::uint32_t> nodes;
    std::vector<std::size_t> starts;
};
constexpr std::size_t kMostAlike = std::size_t{1} << 16U;

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
            read_groups(input_, dataset, groups_);
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
        NodeRows rows;
        for (;;) {
            take_plain_nodes(lines, dataset, one_line, rows);
            if (!read_node(lines, one_line, rows)) break;
        }
        builder_.add_nodes(std::move(rows.ids), std::move(rows.places));
    }

    /// As long as they follow each other.
    void take_plain_nodes(TextLines& lines, const Dataset& dataset, bool one_line, NodeRows& rows) {
        const char* const text = input_.text().data();
        const char* const end = text + dataset.last;
        std::array<std::int64_t, 4> head{};
        Point3 place{};
        PlainText plain(text + lines.offset(), end);
        for (const char* from = plain.at(); take_plain_node(plain, one_line, head, place);
             from = plain.at()) {
            if (rows.ids.size() == rows.ids.capacity()) {
                grow_by_text(
                    rows.ids,
                    static_cast<std::size_t>(end - from),
                    static_cast<std::size_t>(plain.at() - from)
                );
                reserve_big(rows.places, rows.ids.capacity());
            }
            add_node(rows, head[0], place, one_line ? head[1] : 0, head[2]);
        }
        lines = TextLines(input_, static_cast<std::size_t>(plain.at() - text), dataset.last);
    }

    /// False at the end.
    bool read_node(TextLines& lines, bool one_line, NodeRows& rows) {
        auto line = lines.next();
        while (line && trim(*line).empty()) line = lines.next();
        if (!line) return false;
        const auto id = take_integer(*line);
        const auto defined_in = take_integer(*line);
        const auto results_in = take_integer(*line);
        if (!id || *id <= 0 || !defined_in || !results_in || !take_integer(*line))
            bad(lines, Code::BadNumber, "a node needs four integers: label, two coordinate systems, colour");
        Point3 place{};
        std::string_view numbers = one_line ? *line : lines.next().value_or(std::string_view{});
        for (double& x : place) {
            const auto value = parse_double(take_word(numbers));
            if (!value) bad(lines, Code::BadNumber, fmt::format("node {} needs three coordinates", *id));
            x = *value;
        }
        add_node(rows, *id, place, one_line ? *defined_in : 0, *results_in);
        return true;
    }

    /// Only the oldest form has coordinates in the node's own system.
    void add_node(
        NodeRows& rows, std::int64_t id, const Point3& place, std::int64_t defined_in, std::int64_t results_in
    ) {
        note_results_in(results_in);
        rows.ids.push_back(NodeId{id});
        rows.places.push_back(placed(place, defined_in));
    }

    Point3 placed(const Point3& place, std::int64_t number) {
        const auto found = systems_.find(number);
        if (found != systems_.end()) return found->second.to_part(place);
        if (number != 0) ++in_unknown_system_;
        return place;
    }

    void note_results_in(std::int64_t number) {
        if (systems_.empty()) return;
        const auto found = systems_.find(number);
        if (found != systems_.end() && !found->second.is_global()) ++with_turned_results_;
    }

    void read_elements(const Dataset& dataset) {
        TextLines lines(input_, dataset.first, dataset.last);
        const bool newer = dataset.number == 2412;
        for (;;) {
            take_plain_elements(lines, dataset, newer);
            // What is said about the rows so far comes before what may be said now.
            add_alike();
            if (!read_element(lines, newer)) break;
        }
        add_alike();
    }

    /// As long as they follow each other, without those that have a line for their beam's axis.
    void take_plain_elements(TextLines& lines, const Dataset& dataset, bool newer) {
        const char* const text = input_.text().data();
        std::array<std::int64_t, 8> numbers{};
        std::array<std::int64_t, kMostNodesOfAnElement> nodes{};
        const auto head = std::span(numbers).first(newer ? 6 : 8);
        PlainText plain(text + lines.offset(), text + dataset.last);
        for (;;) {
            PlainText ahead = plain;
            if (!take_plain_numbers(ahead, head)) break;
            const std::int64_t count = head.back();
            if (count <= 0 || count > std::ssize(nodes) || has_beam_line(head[1])) break;
            const auto row = std::span(nodes).first(static_cast<std::size_t>(count));
            if (!take_plain_numbers(ahead, row)) break;
            for (std::size_t i = 0; i < row.size(); ++i) row_[i] = NodeId{row[i]};
            const auto start = static_cast<std::size_t>(plain.at() - text);
            add(head[0], head[1], newer ? head[2] : head[3], std::span(row_).first(row.size()), count, start);
            plain = ahead;
        }
        lines = TextLines(input_, static_cast<std::size_t>(plain.at() - text), dataset.last);
    }

    /// False at the end.
    bool read_element(TextLines& lines, bool newer) {
        auto line = lines.next();
        while (line && trim(*line).empty()) line = lines.next();
        if (!line) return false;
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
        return true;
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
            add_alike();
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
        if (property != last_property_ || !last_part_) {
            add_alike();
            last_part_ = builder_.part(fmt::format("property {}", property));
            last_property_ = property;
        }
        const bool is_narrow = std::ranges::all_of(row, [](NodeId node) {
            return raw(node) >= 0 && raw(node) <= std::numeric_limits<std::uint32_t>::max();
        });
        if (alike_.type != *type || alike_.ids.size() == kMostAlike || !is_narrow) add_alike();
        const std::span<const std::uint8_t> order = file_order(*type);
        const auto from = [&](std::size_t i) { return order.empty() ? row[i] : row[order[i]]; };
        if (!is_narrow) {
            std::array<NodeId, kMaxElementNodes> ours{};
            for (std::size_t i = 0; i < row.size(); ++i) ours[i] = from(i);
            builder_.add_element(ElementId{id}, *type, std::span(ours).first(row.size()), *last_part_, where);
            return;
        }
        alike_.type = *type;
        alike_.ids.push_back(ElementId{id});
        alike_.starts.push_back(start);
        for (std::size_t i = 0; i < row.size(); ++i)
            alike_.nodes.push_back(static_cast<std::uint32_t>(raw(from(i))));
    }

    /// The elements of one type and part that were read but not yet added.
    void add_alike() {
        if (alike_.ids.empty()) return;
        builder_.add_elements(alike_.type, *last_part_, alike_.ids, alike_.nodes, [&](std::size_t i) {
            return input_.where_line(alike_.starts[i]);
        });
        alike_.ids.clear();
        alike_.starts.clear();
        alike_.nodes.clear();
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
    AlikeElements alike_;
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
