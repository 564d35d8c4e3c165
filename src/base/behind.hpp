// SPDX-License-Identifier: Apache-2.0
// Work that follows behind on a thread of its own: digests and writing, while the next values are made.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace feelem {

/// Does one task after the other in their order. The thread begins with the first task.
class Behind {
public:
    /// At most `ahead` tasks wait; then add() does too.
    explicit Behind(std::size_t ahead) : ahead_(ahead) {}
    ~Behind();  ///< Waits until all are done; what they threw is lost.
    Behind(const Behind&) = delete;
    Behind& operator=(const Behind&) = delete;

    /// Once a task has thrown, those behind it are dropped.
    void add(std::function<void()> task);
    /// Until all are done. Rethrows what one has thrown, once.
    void wait();

private:
    void run();
    void until_idle(std::unique_lock<std::mutex>& lock);

    const std::size_t ahead_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> tasks_;
    bool busy_ = false, ended_ = false;
    std::exception_ptr error_;
    std::thread thread_;
};

}  // namespace feelem
