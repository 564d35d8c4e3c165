// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

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

}  // namespace feelem
