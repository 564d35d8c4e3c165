// SPDX-License-Identifier: Apache-2.0
// The one runtime of the process, its record, its faults, and what its script does to a session.
#include "runtime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace feelem::xr_runtime {

namespace {

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

int number(const Line& line, std::size_t at, int otherwise) {
    return at < line.words.size() ? std::stoi(line.words[at]) : otherwise;
}

void end_by_script(Session& session, const Line& line) {
    session.exits = line.words[0] == "exit";
    session.polls_to_ready = session.exits ? -1 : number(line, 1, -1);
    while (session.state == XR_SESSION_STATE_FOCUSED || session.state == XR_SESSION_STATE_VISIBLE)
        go(session,
           session.state == XR_SESSION_STATE_FOCUSED ? XR_SESSION_STATE_VISIBLE
                                                     : XR_SESSION_STATE_SYNCHRONIZED);
    go(session, XR_SESSION_STATE_STOPPING);
}

void aim_for(Session& session, const Line& line) {
    const std::string wanted = line.words.size() > 1 ? line.words[1] : "focused";
    session.target = wanted == "visible"  ? XR_SESSION_STATE_VISIBLE
                     : wanted == "hidden" ? XR_SESSION_STATE_SYNCHRONIZED
                                          : XR_SESSION_STATE_FOCUSED;
    while (session.state != session.target) step_towards_target(session);
}

void lose_soon(Session& session, const Line& line) {
    if (line.words.size() > 1 && line.words[1] == "instance") {
        XrEventDataInstanceLossPending event{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr, 0};
        post(&event, sizeof event);
    } else {
        go(session, XR_SESSION_STATE_LOSS_PENDING);
    }
}

/// LOCAL's origin comes to where the head is, upright.
void recentre(World& world) {
    const glm::vec3 ahead = world.head.orientation * glm::vec3(0, 0, -1);
    const float turn = std::atan2(-ahead.x, -ahead.z);
    world.local = {world.head.position, glm::quat(std::cos(turn / 2), 0, std::sin(turn / 2), 0)};
    XrEventDataReferenceSpaceChangePending event{};
    event.type = XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING;
    event.session = handle_of<XrSession>(runtime().sessions.all().begin()->first);
    event.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    event.changeTime = static_cast<XrTime>(runtime().frame) * kPeriod;
    event.poseInPreviousSpace = to_xr({});
    post(&event, sizeof event);
}

void happen(Session& session, const Line& line) {
    Runtime& all = runtime();
    const std::string& verb = line.words[0];
    if (verb == "state")
        aim_for(session, line);
    else if (verb == "stop" || verb == "exit")
        end_by_script(session, line);
    else if (verb == "lose_session")
        session.is_lost = true;
    else if (verb == "lose_instance") {
        only_instance()->is_lost = true;
        all.refused_creations = number(line, 1, 0);
    } else if (verb == "loss_pending")
        lose_soon(session, line);
    else if (verb == "recentre")
        recentre(all.world);
    else
        broken(XR_ERROR_VALIDATION_FAILURE, "script", fmt::format("no verb '{}'", verb));
}

}  // namespace

Runtime& runtime() {
    static auto* all = new Runtime;
    return *all;
}

void begin_script() {
    const std::string path = environment("FEELEM_XR_SCRIPT");
    Runtime& all = runtime();
    if (path == all.script_path) return;
    all = Runtime{};
    all.script_path = path;
    all.script = read_script(path);
}

void play(Session& session) {
    Runtime& all = runtime();
    for (; all.played < all.script.size() && all.script[all.played].frame <= all.frame; ++all.played) {
        const Line& line = all.script[all.played];
        if (!change(all.world, line)) happen(session, line);
    }
    tell_changed_profiles(session);
}

bool has_fault(std::string_view word) {
    const std::string all = " " + environment("FEELEM_XR_FAULTS") + " ";
    return all.find(fmt::format(" {} ", word)) != std::string::npos;
}

void record(const std::string& members) {
    const std::string path = environment("FEELEM_XR_RECORD");
    if (path.empty()) return;
    if (std::FILE* file = std::fopen(path.c_str(), "ab")) {
        fmt::print(file, "{{\"frame\":{},{}}}\n", runtime().frame, members);
        std::fclose(file);
    }
}

XrResult broken(XrResult code, const char* call, const std::string& why) {
    record(fmt::format(R"("violation":"{}","code":{},"why":"{}")", call, static_cast<int>(code), why));
    return code;
}

Instance* only_instance() {
    auto& all = runtime().instances.all();
    return all.empty() ? nullptr : &all.begin()->second;
}

XrResult check(Session* session, const char* call) {
    const Instance* instance = only_instance();
    if (instance && instance->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!session) return broken(XR_ERROR_HANDLE_INVALID, call, "no such session");
    return session->is_lost ? XR_ERROR_SESSION_LOST : XR_SUCCESS;
}

void post(const void* event, std::size_t bytes) {
    XrEventDataBuffer buffer{};
    std::memcpy(&buffer, event, bytes);
    if (Instance* instance = only_instance()) instance->events.push_back(buffer);
}

const char* word(XrSessionState state) {
    static constexpr std::array kWords{
        "unknown",
        "idle",
        "ready",
        "synchronized",
        "visible",
        "focused",
        "stopping",
        "loss_pending",
        "exiting"};
    const auto at = static_cast<std::size_t>(state);
    return at < kWords.size() ? kWords[at] : "?";
}

void go(Session& session, XrSessionState state) {
    session.state = state;
    XrEventDataSessionStateChanged event{};
    event.type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
    for (auto& [number, each] : runtime().sessions.all())
        if (&each == &session) event.session = handle_of<XrSession>(number);
    event.state = state;
    event.time = static_cast<XrTime>(runtime().frame) * kPeriod;
    post(&event, sizeof event);
    record(fmt::format(R"("state":"{}")", word(state)));
}

void step_towards_target(Session& session) {
    const bool is_shown = session.state == XR_SESSION_STATE_SYNCHRONIZED ||
                          session.state == XR_SESSION_STATE_VISIBLE ||
                          session.state == XR_SESSION_STATE_FOCUSED;
    if (!is_shown || session.state == session.target) {
        if (!is_shown) session.target = session.state;
        return;
    }
    const int way = session.target > session.state ? 1 : -1;
    go(session, static_cast<XrSessionState>(session.state + way));
}

XrResult give_text(std::string_view text, std::uint32_t capacity, std::uint32_t* count, char* out) {
    const std::string ended(text);
    return give<char>({ended.c_str(), ended.size() + 1}, capacity, count, out);
}

}  // namespace feelem::xr_runtime
