// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_chunks.hpp"

#include "model/collapse.hpp"
#include "model/element_table.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::ansys::cdb {
namespace {

void close_chunk(ChunkEnd& end, std::size_t at, const RowPlace& place, std::int64_t count, bool cut) {
    end.end = at;
    end.last = place.offset();
    end.count = count;
    end.cut = cut;
}

}  // namespace

void NodeChunk::read(const Deck& deck, const BlockRows& rows, RowRange range) {
    ids.clear();
    positions.clear();
    odd.clear();
    NodeRows reader(deck, rows, range);
    while (reader.next()) {
        const CommandNode& node = reader.node();
        const Point3& p = node.position;
        const NodalAngles& a = node.angles;
        // A sum is finite only when all are.
        const bool plain = a[0] == 0 && a[1] == 0 && a[2] == 0 &&
                           std::isfinite((p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]));
        if (!plain) odd.push_back({ids.size(), reader.place().offset(), a});
        ids.push_back(NodeId{node.id});
        positions.push_back(p);
    }
    close_chunk(end, reader.at(), reader.place(), reader.count(), reader.cut());
}

std::size_t most_nodes(const ElementAdder& types, std::int64_t number) {
    const TypeShape* type = types.find_type(number);
    if (type == nullptr || type->name.empty()) return 0;
    const auto shape = shape_of(*type, kMaxElementNodes);
    return shape ? shape->nodes : 1;
}

void ElementChunk::read(
    const Deck& deck,
    const ElementRows& block,
    RowRange range,
    const ElementAdder& types,
    const NodeLookup& nodes
) {
    runs.clear();
    ids.clear();
    offsets.clear();
    found.clear();
    ids_of_nodes.clear();
    ElementRowsReader reader(deck, block, range, [&](std::int64_t type) { return most_nodes(types, type); });
    std::int64_t number = 0;
    std::size_t count = 0;  // Of nodes; 0: no shape is known yet.
    std::optional<RowShape> shape;
    while (reader.next()) {
        if (reader.type() != number || reader.node_count() != count) {
            number = reader.type();
            count = reader.node_count();
            const TypeShape* type = types.find_type(number);
            shape = type == nullptr ? std::nullopt : shape_of(*type, count);
            // Rows that leave out or add nodes need more than this.
            if (shape && (shape->nodes != count || element_row(shape->type).node_count != count))
                shape.reset();
        }
        add(reader, shape, nodes);
    }
    close_chunk(end, reader.at(), reader.place(), reader.count(), reader.cut());
}

template <class Id>
bool ElementChunk::find_nodes(std::span<const Id> listed, RowShape shape, const NodeLookup& nodes) {
    const std::size_t first = found.size();
    found.resize(first + listed.size());
    const ElementRow& element = element_row(shape.type);
    const std::span<const NodeIndex> corners(found.data() + first, element.corner_count);
    if (nodes.find(listed, found.data() + first) && (element.dimension < 2 || all_differ(corners)))
        return true;
    found.resize(first);
    return false;
}

void ElementChunk::add(
    ElementRowsReader& reader, const std::optional<RowShape>& shape, const NodeLookup& nodes
) {
    const std::size_t at = ids.size();
    ids.push_back(ElementId{reader.id()});
    offsets.push_back(reader.offset());
    const std::span<const std::uint32_t> plain = reader.plain_nodes();
    const bool whole = shape && (plain.empty() ? find_nodes(reader.row().nodes, *shape, nodes)
                                               : find_nodes(plain, *shape, nodes));
    if (whole) {
        const std::size_t count = reader.node_count();
        const bool goes_on = !runs.empty() && runs.back().type == shape->type &&
                             runs.back().material == reader.material() &&
                             runs.back().type_number == reader.type();
        if (!goes_on)
            runs.push_back({shape->type, reader.type(), reader.material(), at, 0, found.size() - count, 0});
        runs.back().node_count += count;
        ++runs.back().count;
        return;
    }
    const ElementRowIds& row = reader.row();
    runs.push_back({std::nullopt, row.type, row.material, at, 1, ids_of_nodes.size(), row.nodes.size()});
    ids_of_nodes.insert(ids_of_nodes.end(), row.nodes.begin(), row.nodes.end());
}

}  // namespace feelem::ansys::cdb
