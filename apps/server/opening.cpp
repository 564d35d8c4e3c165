// SPDX-License-Identifier: Apache-2.0
#include "opening.hpp"

#include "scene/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace feelem::server {
namespace {

using namespace std::chrono_literals;

/// A question without news is answered after so long: shorter than what any side takes for silence.
constexpr auto kLongestWait = 10s;
/// News of progress come no faster: who shows them wants the same cores as who makes them.
constexpr auto kBetweenNews = 250ms;
/// How often it is looked whether somebody still waits.
constexpr auto kLook = 250ms;

std::uint64_t version_asked(const httplib::Request& request) {
    const std::string text = request.get_param_value("after");
    std::uint64_t version = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, version);
    return stopped == end && error == std::errc() ? version : 0;
}

}  // namespace

Opening::Opening(const std::string& shape_path) : shape_(SceneFolder(shape_path).find("/scene.glb")) {}

void Opening::changed() {
    ++version_;
    news_.notify_all();
}

void Opening::progress(std::string_view stage, double fraction) {
    const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
    const std::lock_guard lock(mutex_);
    if (stage == stage_ && percent == percent_) return;
    stage_ = stage;
    percent_ = percent;
    changed();
}

void Opening::finish() {
    const std::lock_guard lock(mutex_);
    state_ = State::Ready;
    shape_.reset();
    changed();
}

void Opening::fail(const std::string& text) {
    const std::lock_guard lock(mutex_);
    state_ = State::Failed;
    text_ = text;
    changed();
}

bool Opening::has_guests() {
    const std::lock_guard lock(mutex_);
    return has_guests_;
}

void Opening::welcome() {
    const std::lock_guard lock(mutex_);
    has_guests_ = true;
}

bool Opening::wait_until_told(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return news_.wait_for(lock, time, [this] { return was_told_; });
}

template <class There>
void Opening::wait(std::unique_lock<std::mutex>& lock, const IsGone& is_gone, There there) {
    const auto end = std::chrono::steady_clock::now() + kLongestWait;
    while (!there() && !is_gone() && std::chrono::steady_clock::now() < end) news_.wait_for(lock, kLook);
}

std::string Opening::json() const {
    JsonText json;
    const char* const state = state_ == State::Reading ? "reading"
                              : state_ == State::Ready ? "ready"
                                                       : "failed";
    json.begin_object().member("state", state).member("version", version_).member("stage", stage_);
    json.member("percent", percent_).member("text", text_).end_object();
    return json.text();
}

void Opening::answer_progress(const Exchange& exchange, const IsGone& is_gone) {
    const std::uint64_t after = version_asked(exchange.request);
    const auto soonest = std::chrono::steady_clock::now() + (after == 0 ? 0ms : kBetweenNews);
    std::unique_lock lock(mutex_);
    // A version from another run of this server is no reason to wait.
    wait(lock, is_gone, [&] { return version_ != after || state_ != State::Reading; });
    news_.wait_until(lock, soonest, [this] { return state_ != State::Reading; });
    exchange.response.status = 200;
    exchange.response.set_header("Cache-Control", "no-store");
    exchange.response.set_content(json(), "application/json");
    if (state_ != State::Failed) return;
    was_told_ = true;
    news_.notify_all();
}

std::shared_ptr<const ServedFile> Opening::shape() {
    const std::lock_guard lock(mutex_);
    return shape_;
}

bool Opening::is_finished(const Exchange& exchange, const IsGone& is_gone) {
    std::unique_lock lock(mutex_);
    wait(lock, is_gone, [this] { return state_ != State::Reading; });
    if (state_ == State::Ready) return true;
    if (state_ == State::Failed) {
        answer_text(exchange.response, 500, "the scene cannot be made: " + text_ + "\n");
    } else {
        exchange.response.set_header("Retry-After", "1");
        answer_text(exchange.response, 503, "results are still being read\n");
    }
    return false;
}

std::string with_opening_hint(std::string index) {
    constexpr std::string_view kEnd = "</title>";
    const std::size_t at = index.find(kEnd);
    if (at != std::string::npos)
        index.insert(at + kEnd.size(), "\n    <meta name=\"feelem-opening\" content=\"opening\" />");
    return index;
}

}  // namespace feelem::server
