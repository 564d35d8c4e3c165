// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_mesh.hpp"

#include "base/number.hpp"
#include "read/ansys/cdb_chunks.hpp"
#include "read/ansys/element_adder.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace feelem::ansys::cdb {
namespace {

/// Ids from first to last.
using IdRange = std::pair<std::int64_t, std::int64_t>;

class MeshReader {
public:
    MeshReader(const Deck& deck, TypeTable types, Diagnostics& diagnostics)
        : deck_(deck), diagnostics_(diagnostics), builder_(diagnostics),
          adder_(builder_, std::move(types), diagnostics),
          release_of_nodes_(deck.inputs.begin(), deck.inputs.end()),
          release_of_elements_(deck.inputs.begin(), deck.inputs.end()) {}

    Mesh read() {
        reserve();
        for (const BlockRows& rows : deck_.node_blocks) read_nodes(rows);
        for (const CommandNode& node : deck_.nodes) add_node(node, [] { return std::string(); });
        if (deck_.unit) builder_.set_length_unit(*deck_.unit);
        builder_.seal_nodes();
        for (const ElementRows& block : deck_.element_blocks) read_elements(block);
        add_command_elements();
        Mesh mesh = builder_.finish();
        add_components(mesh);
        return mesh;
    }

private:
    /// As many as there are lines for, whatever they announce.
    void reserve() {
        std::size_t nodes = deck_.nodes.size();
        for (const BlockRows& rows : deck_.node_blocks) nodes += rows.rows;
        builder_.reserve_nodes(nodes);
        std::size_t elements = deck_.elements.size();
        for (const ElementRows& block : deck_.element_blocks) elements += block.rows.rows;
        builder_.expect_elements(elements);
    }

    template <class Where>
    void add_node(const CommandNode& node, const Where& where) {
        Point3 position = node.position;
        for (double& x : position) {
            if (std::isfinite(x)) continue;
            diagnostics_.add(Code::NonFiniteValue, where, "nodes have a coordinate that is no finite number");
            x = std::nan("");
        }
        const std::int64_t id = node.id > 0 ? node.id : highest_node_ + 1;
        highest_node_ = std::max(highest_node_, id);
        builder_.add_node(NodeId{id}, position, node.angles);
    }

    void note_cut(const BlockRows& rows, std::string_view block, const ChunkEnd& last, std::int64_t count) {
        diagnostics_.add(
            Code::TruncatedInput,
            [&] { return deck_.inputs[rows.input].where_line(last.last); },
            fmt::format("{} ends with the file, after {} rows of {}", block, count, rows.announced)
        );
    }

    /// Adds the chunks of a block in their order, and says when it is not whole.
    template <class Chunk, class Read, class Take>
    void read_block(
        const BlockRows& rows,
        std::string_view name,
        ReleaseBehind& release,
        const Read& read,
        const Take& take
    ) {
        std::int64_t count = 0;
        ChunkEnd last;
        read_in_chunks<Chunk>(rows, read, [&](const Chunk& chunk) {
            take(chunk);
            count += chunk.end.count;
            last = chunk.end;
            release.at(last.end);
        });
        const bool complete = rows.ended || count == rows.announced;
        if (last.cut || !complete) note_cut(rows, name, last, count);
    }

    void read_nodes(const BlockRows& rows) {
        read_block<NodeChunk>(
            rows,
            "NBLOCK",
            release_of_nodes_[rows.input],
            [&](NodeChunk& chunk, RowRange range) { chunk.read(deck_, rows, range); },
            [&](const NodeChunk& chunk) { add_nodes(chunk, deck_.inputs[rows.input]); }
        );
    }

    void add_nodes(const NodeChunk& chunk, const Input& input) {
        std::size_t first = 0;
        for (const NodeChunk::Odd& odd : chunk.odd) {
            add_plain_nodes(chunk, first, odd.row);
            const CommandNode node{raw(chunk.ids[odd.row]), chunk.positions[odd.row], odd.angles};
            add_node(node, [&] { return input.where_line(odd.offset); });
            first = odd.row + 1;
        }
        add_plain_nodes(chunk, first, chunk.ids.size());
    }

    void add_plain_nodes(const NodeChunk& chunk, std::size_t first, std::size_t end) {
        if (first == end) return;
        const auto ids = std::span(chunk.ids).subspan(first, end - first);
        highest_node_ = std::max(highest_node_, raw(*std::ranges::max_element(ids)));
        builder_.add_nodes(ids, std::span(chunk.positions).subspan(first, end - first));
    }

    void read_elements(const ElementRows& block) {
        adder_.set_body(block.body);
        read_block<ElementChunk>(
            block.rows,
            "EBLOCK",
            release_of_elements_[block.rows.input],
            [&](ElementChunk& chunk, RowRange range) {
                chunk.read(deck_, block, range, adder_, builder_.nodes());
            },
            [&](const ElementChunk& chunk) { add_elements(chunk, deck_.inputs[block.rows.input]); }
        );
    }

    void add_elements(const ElementChunk& chunk, const Input& input) {
        for (const ElementChunk::Run& run : chunk.runs) {
            const auto ids = std::span(chunk.ids).subspan(run.first, run.count);
            highest_element_ = std::max(highest_element_, raw(*std::ranges::max_element(ids)));
            if (run.type) {
                const auto nodes = std::span(chunk.found).subspan(run.first_node, run.node_count);
                adder_.add_whole(input, *run.type, run.material, ids, nodes, [&](std::size_t i) {
                    return chunk.offsets[run.first + i];
                });
                continue;
            }
            ElementRowIds row;
            row.id = raw(ids.front());
            row.type = run.type_number;
            row.material = run.material;
            row.offset = chunk.offsets[run.first];
            row.nodes = std::span(chunk.ids_of_nodes).subspan(run.first_node, run.node_count);
            adder_.add(input, row);
        }
    }

    void add_command_elements() {
        adder_.set_body({});
        for (const CommandElement& element : deck_.elements) {
            ElementRowIds row;
            row.id = element.id > 0 ? element.id : highest_element_ + 1;
            row.material = element.material;
            row.type = element.type;
            row.offset = element.offset;
            std::size_t count = element.count;
            while (count > 0 && deck_.element_nodes[element.first + count - 1] == 0) --count;
            row.nodes = std::span(deck_.element_nodes).subspan(element.first, count);
            highest_element_ = std::max(highest_element_, row.id);
            adder_.add(deck_.inputs[element.input], row);
        }
    }

    /// 17 -18 21 -40 is 17 to 18 and 21 to 40. Sorted and without overlap, so that no range is walked twice.
    std::vector<IdRange> ranges_of(const ComponentRows& component) const {
        const BlockRows& rows = component.rows;
        const Input& input = deck_.inputs[rows.input];
        RowPlace place(input, "CMBLOCK");
        std::vector<IdRange> ranges;
        const std::size_t width = rows.format.id_width;
        const std::string_view text = input.text();
        for (Lines lines(text, rows.begin, rows.end, rows.line_end); lines.next();) {
            place.at(lines.begin());
            for (std::size_t at = 0; at < lines.line().size(); at += width) {
                const std::int64_t number = integer_field(lines.line(), at, width, place);
                if (number > 0) ranges.emplace_back(number, number);
                if (number < 0 && !ranges.empty())
                    ranges.back().second = std::max(ranges.back().second, -number);
            }
        }
        std::ranges::sort(ranges);
        std::size_t kept = 0;
        for (const IdRange& range : ranges) {
            if (kept > 0 && range.first <= ranges[kept - 1].second)
                ranges[kept - 1].second = std::max(ranges[kept - 1].second, range.second);
            else
                ranges[kept++] = range;
        }
        ranges.resize(kept);
        return ranges;
    }

    void add_components(Mesh& mesh) {
        // Ten characters can name a million nodes: no honest deck names its whole mesh a thousand times.
        constexpr std::size_t kMembersPerByte = 16;
        std::size_t left = kMembersPerByte * deck_.inputs.front().size();
        std::vector<std::pair<std::int64_t, ElementIndex>> elements;
        for (const ComponentRows& component : deck_.components) {
            const std::vector<IdRange> ranges = ranges_of(component);
            std::size_t members = 0;
            if (component.of_nodes) {
                mesh.node_sets.push_back({component.name, nodes_in(mesh, ranges)});
                members = mesh.node_sets.back().nodes.size();
            } else {
                if (elements.empty()) elements = elements_by_id(mesh);
                mesh.element_sets.push_back({component.name, elements_in(elements, ranges)});
                members = mesh.element_sets.back().elements.size();
            }
            if (members > left)
                throw Error(Code::TooLarge, deck_.inputs.front().name(), "components have too many members");
            left -= members;
        }
    }

    static std::vector<NodeIndex> nodes_in(const Mesh& mesh, const std::vector<IdRange>& ranges) {
        std::vector<NodeIndex> nodes;
        for (const auto& [first, last] : ranges) {
            auto at = std::ranges::lower_bound(mesh.node_ids, NodeId{first});
            for (; at != mesh.node_ids.end() && raw(*at) <= last; ++at)
                nodes.push_back(NodeIndex{static_cast<std::uint32_t>(at - mesh.node_ids.begin())});
        }
        return nodes;
    }

    static std::vector<std::pair<std::int64_t, ElementIndex>> elements_by_id(const Mesh& mesh) {
        std::vector<std::pair<std::int64_t, ElementIndex>> elements;
        elements.reserve(mesh.element_count());
        for (const ElementBlock& block : mesh.blocks) {
            for (const ElementId id : block.ids)
                elements.emplace_back(raw(id), ElementIndex{static_cast<std::uint32_t>(elements.size())});
        }
        std::ranges::sort(elements);
        return elements;
    }

    static std::vector<ElementIndex> elements_in(
        const std::vector<std::pair<std::int64_t, ElementIndex>>& elements, const std::vector<IdRange>& ranges
    ) {
        std::vector<ElementIndex> found;
        for (const auto& [first, last] : ranges) {
            auto at =
                std::ranges::lower_bound(elements, first, {}, &std::pair<std::int64_t, ElementIndex>::first);
            for (; at != elements.end() && at->first <= last; ++at) found.push_back(at->second);
        }
        return found;
    }

    const Deck& deck_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    ElementAdder adder_;
    std::vector<ReleaseBehind> release_of_nodes_;
    std::vector<ReleaseBehind> release_of_elements_;
    std::int64_t highest_node_ = 0;
    std::int64_t highest_element_ = 0;
};

}  // namespace

Mesh read_mesh(const Deck& deck, const TypeTable& types, Diagnostics& diagnostics) {
    TypeTable all = types;
    for (const auto& [number, type] : deck.types) all[number] = type;
    return MeshReader(deck, std::move(all), diagnostics).read();
}

}  // namespace feelem::ansys::cdb
