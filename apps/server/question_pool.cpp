// SPDX-License-Identifier: Apache-2.0
#include "question_pool.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace feelem::server {
namespace {

using namespace std::chrono_literals;

}  // namespace

QuestionPool::QuestionPool(const PoolLimits& limits) : limits_(limits) {
    try {
        while (workers_.size() < limits_.workers) workers_.emplace_back([this] { run_worker(); });
    } catch (const std::system_error&) {
        // The system has no more threads to give: fewer do.
        if (workers_.empty()) throw;
    }
}

QuestionPool::~QuestionPool() {
    {
        const Lock lock(mutex_);
        is_closing_ = true;
        for (const auto& question : waiting_) give_up(*question, End::Closing, lock);
        for (const auto& question : running_) give_up(*question, End::Closing, lock);
    }
    for_workers_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void QuestionPool::give_up(Question& question, End why, const Lock&) {
    if (question.is_cancelled) return;
    question.why = why;
    question.is_cancelled = true;
}

QuestionPool::End QuestionPool::ask(
    const std::string& client, const Work& work, const std::function<bool()>& is_gone
) {
    const auto mine = std::make_shared<Question>();
    mine->work = &work;
    Lock lock(mutex_);
    if (is_closing_) return End::Closing;
    if (const auto older = latest_.find(client); older != latest_.end()) {
        give_up(*older->second, End::Superseded, lock);
        // One that waits is over at once: its place is free for this one.
        if (std::erase(waiting_, older->second) > 0) older->second->is_over = true;
        latest_.erase(older);
        for_askers_.notify_all();
    }
    if (waiting_.size() >= limits_.waiting) return End::Busy;
    if (!client.empty()) latest_[client] = mine;
    waiting_.push_back(mine);
    for_workers_.notify_one();
    while (!mine->is_over) {
        for_askers_.wait_for(lock, 50ms);
        if (mine->is_over || mine->is_cancelled) continue;
        lock.unlock();
        const bool is_alone = is_gone && is_gone();
        lock.lock();
        if (!is_alone) continue;
        give_up(*mine, End::Gone, lock);
        if (std::erase(waiting_, mine) > 0) mine->is_over = true;
    }
    if (const auto own = latest_.find(client); own != latest_.end() && own->second == mine)
        latest_.erase(own);
    if (mine->error) std::rethrow_exception(mine->error);
    return mine->why;
}

void QuestionPool::run_worker() {
    Lock lock(mutex_);
    while (true) {
        for_workers_.wait(lock, [&] { return is_closing_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const std::shared_ptr<Question> question = waiting_.front();
        waiting_.pop_front();
        if (!question->is_cancelled) work_on(question, lock);
        question->is_over = true;
        for_askers_.notify_all();
    }
}

void QuestionPool::work_on(const std::shared_ptr<Question>& question, Lock& lock) {
    question->end = std::chrono::steady_clock::now() + limits_.time;
    running_.push_back(question);
    lock.unlock();
    std::exception_ptr error;
    try {
        (*question->work
        )([&] { return question->is_cancelled || std::chrono::steady_clock::now() > question->end; });
    } catch (...) {
        error = std::current_exception();
    }
    lock.lock();
    std::erase(running_, question);
    // An answer that came to its end in spite of all is as good as any, but nobody is there to read it.
    if (question->is_cancelled) return;
    if (error) {
        question->error = error;
    } else if (std::chrono::steady_clock::now() > question->end) {
        question->why = End::TooLong;
    }
}

}  // namespace feelem::server
