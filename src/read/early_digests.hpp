// SPDX-License-Identifier: Apache-2.0
// SHA-256 of inputs, made by a thread of its own while they are read: one digest cannot be shared between
// cores, so that it is the longest single piece of work on a large file.
#pragma once

#include "base/input.hpp"

#include <atomic>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace feelem {

class EarlyDigests {
public:
    /// Begins at once, one input after the other.
    explicit EarlyDigests(std::vector<Input> inputs);
    /// Stops, however far it is.
    ~EarlyDigests();
    EarlyDigests(const EarlyDigests&) = delete;
    EarlyDigests& operator=(const EarlyDigests&) = delete;

    std::size_t size() const { return digests_.size(); }
    /// Of the i-th input, in hexadecimal digits: waits for it. Once each.
    std::string take(std::size_t i) { return digests_[i].get(); }

private:
    void run(std::vector<std::promise<std::string>> promises);

    std::vector<Input> inputs_;
    std::vector<std::future<std::string>> digests_;
    std::atomic<bool> stop_ = false;
    std::thread thread_;
};

}  // namespace feelem
