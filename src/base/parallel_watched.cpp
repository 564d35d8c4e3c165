// SPDX-License-Identifier: Apache-2.0
// The functions of parallel.cpp on plain threads, built instead of it for the thread sanitizer: oneTBB's own
// library is not built for that, so that it would miss who waits for whom there. OneThreadFewer takes no
// thread away here: with oneTBB, too, it can come back while a loop runs, and what then meets it must be
// seen.
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace feelem {
namespace {

std::atomic<unsigned> limit = 0, fewer = 0;

unsigned all_threads() {
    const unsigned set = limit;
    return set > 0 ? set : std::max(1U, std::thread::hardware_concurrency());
}

/// Calls run() on so many threads, this one among them. What the first throws is rethrown when all have
/// ended.
template <class Run>
void on_threads(std::size_t count, const Run& run) {
    std::mutex mutex;
    std::exception_ptr first;
    const auto guarded = [&] {
        try {
            run();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        while (others.size() + 1 < count) others.emplace_back(guarded);
        guarded();
    }
    if (first) std::rethrow_exception(first);
}

}  // namespace

void set_thread_count(unsigned count) {
    limit = count;
}

unsigned thread_count() {
    const unsigned all = all_threads(), away = fewer;
    return away < all ? all - away : 1;
}

struct OneThreadFewer::Limit {
    Limit() { ++fewer; }
    ~Limit() { --fewer; }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;
};

OneThreadFewer::OneThreadFewer() : limit_(std::make_unique<Limit>()) {}
OneThreadFewer::~OneThreadFewer() = default;

void parallel_chunks(
    std::size_t count, std::size_t chunk, const std::function<void(std::size_t first, std::size_t last)>& body
) {
    const std::size_t chunks = (count + chunk - 1) / chunk;
    std::atomic<std::size_t> next = 0;
    on_threads(std::min<std::size_t>(all_threads(), chunks), [&] {
        try {
            for (std::size_t i = next++; i < chunks; i = next++) {
                body(i * chunk, std::min((i + 1) * chunk, count));
            }
        } catch (...) {
            next = chunks;
            throw;
        }
    });
}

void ordered_chunks(
    std::size_t slots,
    std::size_t count,
    const std::function<void(std::size_t i, std::size_t slot)>& work,
    const std::function<void(std::size_t i, std::size_t slot)>& take
) {
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t next = 0, taken = 0;
    bool failed = false;
    const auto one = [&](std::unique_lock<std::mutex>& lock) {
        const std::size_t i = next++;
        changed.wait(lock, [&] { return failed || i < taken + slots; });
        if (failed) return;
        lock.unlock();
        work(i, i % slots);
        lock.lock();
        changed.wait(lock, [&] { return failed || i == taken; });
        if (failed) return;
        lock.unlock();
        take(i, i % slots);
        lock.lock();
        ++taken;
        changed.notify_all();
    };
    on_threads(slots == 1 ? 1 : std::min<std::size_t>(all_threads(), count), [&] {
        std::unique_lock lock(mutex);
        try {
            while (next < count && !failed) one(lock);
        } catch (...) {
            if (!lock.owns_lock()) lock.lock();
            failed = true;
            changed.notify_all();
            throw;
        }
    });
}

}  // namespace feelem
