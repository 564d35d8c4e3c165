// SPDX-License-Identifier: Apache-2.0
#include "rate_limit.hpp"

#include <algorithm>

namespace feelem::server {
namespace {

/// Of a network full of liars no more than this is remembered.
constexpr std::size_t kMostAddresses = 1024;

}  // namespace

bool RateLimit::take(const std::string& address, Time now) {
    const std::lock_guard lock(mutex_);
    if (buckets_.size() >= kMostAddresses && !buckets_.contains(address)) forget_full(now);
    const auto [entry, is_new] = buckets_.try_emplace(address, Bucket{at_once_, now});
    Bucket& bucket = entry->second;
    const double seconds = std::chrono::duration<double>(now - bucket.seen).count();
    bucket.left = std::min(at_once_, bucket.left + std::max(0.0, seconds) * a_second_);
    bucket.seen = now;
    if (bucket.left < 1) return false;
    bucket.left -= 1;
    return true;
}

/// An address whose bucket has filled up again is as good as one never seen; else the one seen longest ago
/// goes.
void RateLimit::forget_full(Time now) {
    std::erase_if(buckets_, [&](const auto& entry) {
        const double seconds = std::chrono::duration<double>(now - entry.second.seen).count();
        return entry.second.left + seconds * a_second_ >= at_once_;
    });
    if (buckets_.size() < kMostAddresses) return;
    buckets_.erase(std::ranges::min_element(buckets_, {}, [](const auto& entry) { return entry.second.seen; })
    );
}

std::size_t RateLimit::addresses() const {
    const std::lock_guard lock(mutex_);
    return buckets_.size();
}

}  // namespace feelem::server
