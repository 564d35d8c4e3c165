// SPDX-License-Identifier: Apache-2.0
#include "read/early_digests.hpp"

#include "base/parallel.hpp"
#include "base/sha256.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

namespace feelem {

EarlyDigests::EarlyDigests(std::vector<Input> inputs) : inputs_(std::move(inputs)) {
    std::vector<std::promise<std::string>> promises(inputs_.size());
    for (auto& promise : promises) digests_.push_back(promise.get_future());
    // Else three threads would share two cores, and chunks that are taken in order wait for the one that
    // rests.
    auto fewer = std::make_unique<OneThreadFewer>();
    thread_ = std::thread([this, promises = std::move(promises), fewer = std::move(fewer)]() mutable {
        run(std::move(promises));
        fewer.reset();
    });
}

EarlyDigests::~EarlyDigests() {
    stop_ = true;
    thread_.join();
}

void EarlyDigests::run(std::vector<std::promise<std::string>> promises) {
    constexpr std::size_t kWindow = std::size_t{1} << 20U;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        try {
            const Input& input = inputs_[i];
            Sha256 digest;
            for (std::size_t at = 0; at < input.size(); at += kWindow) {
                if (stop_) return;
                const std::size_t end = std::min(at + kWindow, input.size());
                digest.add(input.bytes().subspan(at, end - at));
                input.release(at, end);
            }
            promises[i].set_value(digest.hex());
        } catch (...) {
            promises[i].set_exception(std::current_exception());
        }
    }
}

}  // namespace feelem
