// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>

namespace feelem {

void set_thread_count(unsigned count) {
    // The limit holds as long as the control lives: until the next call or the end of the program.
    static std::unique_ptr<tbb::global_control> limit;
    limit.reset();
    if (count > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, count);
}

unsigned thread_count() {
    return static_cast<unsigned>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)
    );
}

struct OneThreadFewer::Limit {
    tbb::global_control control{
        tbb::global_control::max_allowed_parallelism, std::max<std::size_t>(thread_count(), 2) - 1};
};

OneThreadFewer::OneThreadFewer() : limit_(std::make_unique<Limit>()) {}
OneThreadFewer::~OneThreadFewer() = default;

void parallel_chunks(
    std::size_t count, std::size_t chunk, const std::function<void(std::size_t first, std::size_t last)>& body
) {
    const std::size_t chunks = (count + chunk - 1) / chunk;
    if (chunks <= 1) {
        if (count > 0) body(0, count);
        return;
    }
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t i) {
        body(i * chunk, std::min((i + 1) * chunk, count));
    });
}

void ordered_chunks(
    std::size_t slots,
    std::size_t count,
    const std::function<void(std::size_t i, std::size_t slot)>& work,
    const std::function<void(std::size_t i, std::size_t slot)>& take
) {
    if (slots == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) {
            work(i, 0);
            take(i, 0);
        }
        return;
    }
    // As many chunks as slots are under way, and they leave in order: so the slot of i - slots is free again.
    std::size_t next = 0;
    const auto number = [&](tbb::flow_control& control) {
        if (next == count) control.stop();
        return next++;
    };
    const auto worked = [&](std::size_t i) {
        work(i, i % slots);
        return i;
    };
    using Mode = tbb::filter_mode;
    tbb::parallel_pipeline(
        slots,
        tbb::make_filter<void, std::size_t>(Mode::serial_in_order, number) &
            tbb::make_filter<std::size_t, std::size_t>(Mode::parallel, worked) &
            tbb::make_filter<std::size_t, void>(
                Mode::serial_in_order, [&](std::size_t i) { take(i, i % slots); }
            )
    );
}

}  // namespace feelem
