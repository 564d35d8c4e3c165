// SPDX-License-Identifier: Apache-2.0
// Rows of a text in chunks that are read at once and taken in turn, so that what is taken does not depend on
// the number of threads.
#pragma once

#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace feelem {

/// A chunk costs a few microseconds beside its rows.
inline constexpr std::size_t kTextChunk = std::size_t{1} << 20U;

/// Whether so many bytes of rows are worth threads.
inline bool is_worth_chunks(std::size_t bytes) {
    return ordered_slots() > 1 && bytes > 2 * kTextChunk;
}

/// Rows of [first, last) in chunks at once: those are taken that one reader would find from `first` on. Where
/// it came to; empty when go_on() ended it. `Rows` says how, the first two called by several threads:
///   start(at): where the first row at or behind `at` begins; a guess will do.
///   read(chunk, from, stop): the rows that begin in [from, stop), into a chunk that may be a used one; where
///     the next begins, before `stop` only when it cannot read that one.
///   take(chunk)
///   go_on(from, stop): reads what stands at `from` another way, and on from there at least up to `stop`;
///     where it came to, empty when the rows end there.
template <class Chunk, class Rows>
std::optional<std::size_t> read_in_text_chunks(std::size_t first, std::size_t last, Rows rows) {
    struct Slot {
        Chunk chunk;
        std::size_t begin = 0, end = 0;
    };
    std::vector<Slot> slots(ordered_slots());
    std::size_t next = first;
    std::atomic<bool> is_over = false;
    const auto stop_of = [&](std::size_t i) { return std::min(first + (i + 1) * kTextChunk, last); };
    const auto read_from = [&](Slot& slot, std::size_t from, std::size_t stop) {
        slot.begin = from;
        slot.end = rows.read(slot.chunk, from, stop);
    };
    ordered_chunks(
        slots.size(),
        (last - first + kTextChunk - 1) / kTextChunk,
        [&](std::size_t i, std::size_t slot) {
            if (!is_over)
                read_from(slots[slot], i == 0 ? first : rows.start(first + i * kTextChunk), stop_of(i));
        },
        [&](std::size_t i, std::size_t at) {
            Slot& slot = slots[at];
            const std::size_t stop = stop_of(i);
            if (is_over || next >= stop) return;
            if (slot.begin != next) read_from(slot, next, stop);
            rows.take(std::as_const(slot.chunk));
            next = slot.end;
            if (next >= stop) return;
            const std::optional<std::size_t> further = rows.go_on(next, stop);
            if (further) next = *further;
            is_over = !further;
        }
    );
    return is_over ? std::nullopt : std::optional(next);
}

}  // namespace feelem
