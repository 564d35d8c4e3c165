// SPDX-License-Identifier: Apache-2.0
// A number of threads that changes all the time, as it does while digests of inputs are made or end.
#pragma once

#include "base/parallel.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace feelem::test {

/// While it lives there are two threads, or one, in turns of some microseconds.
class ThreadsComeAndGo {
public:
    ThreadsComeAndGo() {
        set_thread_count(2);
        changing_ = std::thread([this] {
            for (unsigned i = 0; !over_; ++i) {
                {
                    const OneThreadFewer fewer;
                    std::this_thread::sleep_for(std::chrono::microseconds(20 + 37 * (i % 9)));
                }
                std::this_thread::sleep_for(std::chrono::microseconds(20 + 53 * (i % 7)));
            }
        });
    }
    ~ThreadsComeAndGo() {
        over_ = true;
        changing_.join();
        set_thread_count(0);
    }
    ThreadsComeAndGo(const ThreadsComeAndGo&) = delete;
    ThreadsComeAndGo& operator=(const ThreadsComeAndGo&) = delete;

private:
    std::atomic<bool> over_ = false;
    std::thread changing_;
};

}  // namespace feelem::test
