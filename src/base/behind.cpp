// SPDX-License-Identifier: Apache-2.0
#include "base/behind.hpp"

#include <utility>

namespace feelem {

Behind::~Behind() {
    if (!thread_.joinable()) return;
    {
        std::unique_lock lock(mutex_);
        until_idle(lock);
        ended_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Behind::add(std::function<void()> task) {
    std::unique_lock lock(mutex_);
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    changed_.wait(lock, [&] { return tasks_.size() < ahead_; });
    tasks_.push_back(std::move(task));
    lock.unlock();
    changed_.notify_all();
}

void Behind::wait() {
    std::unique_lock lock(mutex_);
    until_idle(lock);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Behind::until_idle(std::unique_lock<std::mutex>& lock) {
    changed_.wait(lock, [&] { return tasks_.empty() && !busy_; });
}

void Behind::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return ended_ || !tasks_.empty(); });
        if (tasks_.empty()) return;
        std::function<void()> task = std::move(tasks_.front());
        tasks_.pop_front();
        busy_ = true;
        const bool dropped = error_ != nullptr;
        lock.unlock();
        std::exception_ptr error;
        try {
            if (!dropped) task();
        } catch (...) {
            error = std::current_exception();
        }
        task = nullptr;
        lock.lock();
        if (error) error_ = error;
        busy_ = false;
        changed_.notify_all();
    }
}

}  // namespace feelem
