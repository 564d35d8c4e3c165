// SPDX-License-Identifier: Apache-2.0
// A scene that is still being made: its shape is served, who asks how far it is is told, and who asks for the
// scene waits for it (docs/serving.md).
#pragma once

#include "answers.hpp"
#include "side_files.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace feelem::server {

/// Any thread may call anything.
class Opening {
public:
    /// `shape_path`: a scene of the shape alone.
    explicit Opening(const std::string& shape_path);

    // By who makes the scene.
    void progress(std::string_view stage, double fraction);
    void finish();                       ///< The scene is there, whole.
    void fail(const std::string& text);  ///< It will never be.
    bool has_guests();                   ///< Somebody has come to see it.
    /// True once somebody was told that it failed; waits so long for it.
    bool wait_until_told(std::chrono::milliseconds time);

    // By who serves. `is_gone`: whether the other side still waits.
    using IsGone = std::function<bool()>;
    void welcome();  ///< The page was asked for.
    /// "/opening": at once, or with `after=VERSION` when there is news.
    void answer_progress(const Exchange& exchange, const IsGone& is_gone);
    /// "/shape.glb"; null once the scene is there.
    std::shared_ptr<const ServedFile> shape();
    /// True when the scene may be served now, if need be after a while; else it is answered why not.
    bool is_finished(const Exchange& exchange, const IsGone& is_gone);

private:
    enum class State {
        Reading,
        Ready,
        Failed
    };
    std::string json() const;
    void changed();
    /// Until `there` holds, nobody waits any more, or it has taken too long.
    template <class There>
    void wait(std::unique_lock<std::mutex>& lock, const IsGone& is_gone, There there);

    std::shared_ptr<const ServedFile> shape_;
    std::mutex mutex_;
    std::condition_variable news_;
    State state_ = State::Reading;
    std::uint64_t version_ = 1;
    std::string stage_ = "results", text_;
    int percent_ = 0;
    bool has_guests_ = false;
    bool was_told_ = false;  ///< That it failed.
};

/// The page is told that the scene may not be there yet.
std::string with_opening_hint(std::string index);

}  // namespace feelem::server
