// SPDX-License-Identifier: Apache-2.0
// Blocks of an archive in chunks that are read at once and taken in turn, so that what is taken does not
// depend on the number of threads.
#pragma once

#include "base/parallel.hpp"
#include "model/node_lookup.hpp"
#include "read/ansys/cdb_rows.hpp"
#include "read/ansys/element_adder.hpp"

#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace feelem::ansys::cdb {

/// What reading any chunk ends with.
struct ChunkEnd {
    std::size_t begin = 0, end = 0;  ///< From its first row to where the next one begins.
    std::size_t last = 0;            ///< Its last row, for messages.
    std::int64_t count = 0;
    bool cut = false;          ///< The file ends in the middle of the last row, which is not given.
    std::exception_ptr error;  ///< What stopped it.
};

/// Rows of an NBLOCK.
struct NodeChunk {
    /// A node with a nodal system of its own, or without a finite coordinate.
    struct Odd {
        std::size_t row = 0, offset = 0;
        NodalAngles angles{};
    };
    ChunkEnd end;
    std::vector<NodeId> ids;
    std::vector<Point3> positions;
    std::vector<Odd> odd;

    void read(const Deck& deck, const BlockRows& rows, RowRange range);
};

/// Rows of an EBLOCK: runs of alike ones that nothing has to be done for, and others as they stand.
struct ElementChunk {
    struct Run {
        std::optional<ElementType> type;  ///< None: one row, its node ids as they stand.
        std::int64_t type_number = 0, material = 0;
        std::size_t first = 0, count = 0;  ///< Into ids, offsets.
        std::size_t first_node = 0,
                    node_count = 0;  ///< Into found or, for a row as it stands, into ids_of_nodes.
    };
    ChunkEnd end;
    std::vector<Run> runs;
    std::vector<ElementId> ids;
    std::vector<std::size_t> offsets;
    std::vector<NodeIndex> found;
    std::vector<std::int64_t> ids_of_nodes;

    /// `types` and `nodes` are asked by several threads at once.
    void read(
        const Deck& deck,
        const ElementRows& block,
        RowRange range,
        const ElementAdder& types,
        const NodeLookup& nodes
    );

private:
    void add(ElementRowsReader& reader, const std::optional<RowShape>& shape, const NodeLookup& nodes);
    /// Adds the nodes of an element that nothing has to be done for; else false, and nothing is added.
    template <class Id>
    bool find_nodes(std::span<const Id> listed, RowShape shape, const NodeLookup& nodes);
};

/// How many nodes elements of a type have at most: 0 when nothing names it, 1 when it is not drawn.
std::size_t most_nodes(const ElementAdder& types, std::int64_t number);

/// read(chunk, range) for each part of the block at once, then take(chunk) in their order. Where a row goes
/// on beyond the place at which the next chunk was said to begin, that one is read again from the right
/// place: the rows that are taken are those that one reader would find from the block's begin to its end.
template <class Chunk, class Read, class Take>
void read_in_chunks(const BlockRows& rows, const Read& read, const Take& take) {
    const auto read_from = [&](Chunk& chunk, std::size_t i, std::size_t first) {
        const std::size_t stop = i < rows.cuts.size() ? rows.cuts[i] : rows.end;
        chunk.end = {};
        chunk.end.begin = chunk.end.end = chunk.end.last = first;
        try {
            read(chunk, RowRange{first, stop});
        } catch (...) {
            chunk.end.error = std::current_exception();
        }
    };
    std::vector<Chunk> slots(ordered_slots());
    std::size_t next = rows.begin;
    ordered_chunks(
        slots.size(),
        rows.cuts.size() + 1,
        [&](std::size_t i, std::size_t slot) {
            read_from(slots[slot], i, i == 0 ? rows.begin : rows.cuts[i - 1]);
        },
        [&](std::size_t i, std::size_t slot) {
            Chunk& chunk = slots[slot];
            if (chunk.end.begin != next) read_from(chunk, i, next);
            if (chunk.end.error) std::rethrow_exception(chunk.end.error);
            next = chunk.end.end;
            take(std::as_const(chunk));
        }
    );
}

}  // namespace feelem::ansys::cdb
