// SPDX-License-Identifier: Apache-2.0
// How often an address may do something: so many at once, so many a second after that.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace feelem::server {

class RateLimit {
public:
    using Time = std::chrono::steady_clock::time_point;

    RateLimit(double at_once, double a_second) : at_once_(at_once), a_second_(a_second) {}
    /// Counts one more; false when it is one too many.
    bool take(const std::string& address, Time now);
    std::size_t addresses() const;

private:
    struct Bucket {
        double left = 0;
        Time seen;
    };
    void forget_full(Time now);

    double at_once_, a_second_;
    mutable std::mutex mutex_;
    std::map<std::string, Bucket> buckets_;
};

}  // namespace feelem::server
