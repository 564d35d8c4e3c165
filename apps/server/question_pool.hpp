// SPDX-License-Identifier: Apache-2.0
// A few workers for questions that take their time: so many at once, so many waiting, each given up when
// nobody wants its answer any more.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace feelem::server {

struct PoolLimits {
    std::size_t workers = 2;
    std::size_t waiting = 8;
    std::chrono::milliseconds time{30'000};  ///< Of one question, from the moment it is worked on.
};

class QuestionPool {
public:
    enum class End {
        Done,
        Busy,        ///< Too many wait already.
        Superseded,  ///< The same client asks something newer.
        Gone,        ///< Nobody waits for the answer.
        TooLong,
        Closing
    };
    using IsCancelled = std::function<bool()>;
    using Work = std::function<void(const IsCancelled&)>;

    explicit QuestionPool(const PoolLimits& limits);
    ~QuestionPool();
    QuestionPool(const QuestionPool&) = delete;
    QuestionPool& operator=(const QuestionPool&) = delete;

    /// Has `work` done by a worker and waits for it; what it throws is thrown here. `client`: an earlier
    /// question of the same name is given up; empty: it stands alone. `is_gone` is asked while waiting.
    End ask(const std::string& client, const Work& work, const std::function<bool()>& is_gone);

private:
    struct Question {
        const Work* work = nullptr;
        std::atomic<bool> is_cancelled = false;
        End why = End::Done;  ///< It was cancelled, if it was.
        bool is_over = false;
        std::exception_ptr error;
        std::chrono::steady_clock::time_point end;  ///< Once it is worked on.
    };
    using Lock = std::unique_lock<std::mutex>;
    void run_worker();
    void give_up(Question& question, End why, const Lock& lock);
    void work_on(const std::shared_ptr<Question>& question, Lock& lock);

    PoolLimits limits_;
    std::mutex mutex_;
    std::condition_variable for_workers_, for_askers_;
    std::deque<std::shared_ptr<Question>> waiting_;
    std::vector<std::shared_ptr<Question>> running_;
    std::map<std::string, std::shared_ptr<Question>> latest_;  ///< By client, while it is not over.
    bool is_closing_ = false;
    std::vector<std::thread> workers_;
};

}  // namespace feelem::server
