// SPDX-License-Identifier: Apache-2.0
// Threads behind one function, split the same way whatever their number, so that results do not depend on it.
#pragma once

#include <cstddef>
#include <functional>

namespace feelem {

/// A chunk for loops whose rounds are short: long enough to hide what a chunk costs.
inline constexpr std::size_t kParallelChunk = 1U << 14U;

/// At most this many threads from now on; 0: as many as the machine has.
void set_thread_count(unsigned count);
/// How many threads parallel_chunks may use now.
unsigned thread_count();

/// Calls body(first, last) for the chunks of [0, count), each `chunk` long but the last, in any order and at
/// once. An exception from body is rethrown here.
void parallel_chunks(
    std::size_t count, std::size_t chunk, const std::function<void(std::size_t first, std::size_t last)>& body
);

}  // namespace feelem
