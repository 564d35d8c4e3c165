// SPDX-License-Identifier: Apache-2.0
// Threads behind one function, split the same way whatever their number, so that results do not depend on it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

namespace feelem {

/// A chunk for loops whose rounds are short: long enough to hide what a chunk costs.
inline constexpr std::size_t kParallelChunk = 1U << 14U;

/// At most this many threads from now on; 0: as many as the machine has.
void set_thread_count(unsigned count);
/// How many threads parallel_chunks may use now. It changes at any time, when a OneThreadFewer comes or goes:
/// what depends on it must be decided once.
unsigned thread_count();

/// While it lives, one thread fewer: for work that has a thread of its own.
class OneThreadFewer {
public:
    OneThreadFewer();
    ~OneThreadFewer();
    OneThreadFewer(const OneThreadFewer&) = delete;
    OneThreadFewer& operator=(const OneThreadFewer&) = delete;

private:
    struct Limit;
    std::unique_ptr<Limit> limit_;
};

/// Calls body(first, last) for the chunks of [0, count), each `chunk` long but the last, in any order and at
/// once. An exception from body is rethrown here.
void parallel_chunks(
    std::size_t count, std::size_t chunk, const std::function<void(std::size_t first, std::size_t last)>& body
);

/// The same in this thread alone unless `is_shared`: for a body that was chosen for one thread. That
/// thread_count() is 1 does not say so, the number can grow while the loop runs.
template <class Body>
void parallel_chunks_if(bool is_shared, std::size_t count, std::size_t chunk, const Body& body) {
    if (is_shared) return parallel_chunks(count, chunk, body);
    for (std::size_t first = 0; first < count; first += chunk) body(first, std::min(first + chunk, count));
}

/// How many chunks ordered_chunks() should have in work at once now.
inline std::size_t ordered_slots() {
    const std::size_t threads = thread_count();
    return threads <= 1 ? 1 : 2 * threads;
}

/// Chunks 0 to count - 1: work(i, slot) at once and in any order, then take(i, slot) one after the other from
/// 0 on, so that what is taken does not depend on the number of threads. A slot (below `slots`) is one
/// chunk's own from its work to the end of its take. With one slot all is done in this thread. An exception
/// is rethrown here.
void ordered_chunks(
    std::size_t slots,
    std::size_t count,
    const std::function<void(std::size_t i, std::size_t slot)>& work,
    const std::function<void(std::size_t i, std::size_t slot)>& take
);

}  // namespace feelem
