// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/run.hpp"

#include "base/atomic_file.hpp"
#include "base/input.hpp"
#include "convert/scene_for_viewing.hpp"
#include "viewer/app/desk_screen.hpp"
#include "viewer/app/headset_screen.hpp"
#include "viewer/app/run_doctor.hpp"
#include "viewer/app/scripted_events.hpp"
#include "viewer/record/recording.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

namespace feelem::viewer {
namespace {

/// Of scripts, whose frames take the same time on any machine.
constexpr double kScriptedFrame = 1.0 / 60;
/// What a frame may take at the desk, as on the page.
constexpr double kDeskFrame = 0.033;
/// Seconds without change after which the picture is drawn at its finest, once.
constexpr double kRestAfter = 0.25;
constexpr auto kRestingFrame = std::chrono::milliseconds(8);
/// Until --xr=require gives up, seconds: services start on demand.
constexpr double kPatience = 10;
constexpr int kLongestWaitFrames = 20'000;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void write_picture(const std::string& path, const Pixels& pixels) {
    AtomicFile file(path);
    file.write(png_of(pixels));
    file.commit();
}

bool has_display() {
    const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("SDL_VIDEODRIVER");
}

/// A picture needs no window, and neither does a headset or a script where there is no screen.
bool wants_window(const Options& options) {
    if (!options.screenshot.empty()) return false;
    if (has_display()) return true;
    if (options.headset == UseHeadset::Require || !options.script.empty()) return false;
    throw Error(
        Code::UnsupportedFormat,
        "",
        "there is no screen in this session (DISPLAY and WAYLAND_DISPLAY are not set). Start it in a desktop "
        "session; "
        "--screenshot FILE.png draws without a screen, --xr=require uses a headset alone"
    );
}

class Session {
public:
    Session(const Options& options, const SceneForViewing& scene)
        // A scene that was made for this run holds the presentation already, with its ranges found.
        : options_(options), desk_(options, wants_window(options)),
          stage_(scene.path(), sound_of(options, desk_), scene.is_made() ? "" : options.presentation) {
        stage_.devices().theme = options.dark ? Theme::Dark : Theme::Light;
        stage_.viewer().state.sound = !options.mute;
        stage_.viewer().state.person.left_handed = options.left_handed;
        if (options.headset != UseHeadset::Off && options.screenshot.empty())
            headset_.emplace(XrOptions{"feelem-xr", options.headset == UseHeadset::Require});
        if (!options.record.empty())
            recording_.emplace(
                options.record, std::filesystem::path(options.inputs.front()).filename().string()
            );
        if (!options.script.empty()) {
            const Input script = Input::from_file(options.script);
            script_.emplace(parse_script(script.text(), options.script));
        }
    }

    int run();

private:
    static SoundOutputOptions sound_of(const Options& options, const DeskScreen& desk) {
        const bool is_heard = desk.has_window() && options.script.empty();
        return {is_heard ? SoundDevice::Standard : SoundDevice::None, !options.record.empty()};
    }
    double time() const { return script_ ? static_cast<double>(frames_) * kScriptedFrame : now() - began_; }
    bool is_over(const DeskFrame& desk) const;
    void tell(const XrStatus& status, double time);
    bool rest(double time, bool headset_shows);
    void keep_presentation();
    bool frame();
    int take_picture();

    Options options_;
    DeskScreen desk_;
    std::optional<HeadsetScreen> headset_;  ///< Before the stage, which stills the hands at its end.
    Stage stage_;
    std::optional<ScriptPlayer> script_;
    ScriptedHand scripted_;
    std::optional<Recording> recording_;
    std::optional<XrState> told_;
    bool was_in_headset_ = false;
    double active_at_ = 0;
    bool drawn_at_rest_ = false;
    std::uint64_t frames_ = 0;
    double began_ = now();
};

bool Session::is_over(const DeskFrame& desk) const {
    if (desk.close_wanted || stage_.viewer().state.leaves) return true;
    return options_.seconds && time() >= *options_.seconds;
}

/// What has become of the headset, in one line. Who cannot do without one is told so by an end.
void Session::tell(const XrStatus& status, double time) {
    was_in_headset_ = was_in_headset_ || headset_->is_shown();
    std::string line = status.what;
    for (const std::string& sentence : {status.why, status.hint})
        if (!sentence.empty()) line += " " + sentence;
    const bool may_come = status.state == XrState::NoService || status.state == XrState::NoHeadset;
    const bool is_hopeless = status.state == XrState::NoRuntime || status.state == XrState::Unusable ||
                             (may_come && time > kPatience);
    if (options_.headset == UseHeadset::Require && !was_in_headset_ && is_hopeless)
        throw Error(
            Code::UnsupportedFormat,
            "",
            "--xr=require, but no headset: " + (status.why.empty() ? line : status.why + " " + status.hint)
        );
    // Before anybody was asked there is nothing to tell.
    const bool is_news = std::exchange(told_, status.state) != status.state;
    drawn_at_rest_ = drawn_at_rest_ && !is_news;
    if (is_news && (status.state != XrState::Starting || !status.runtime.empty()))
        fmt::print(stderr, "feelem-xr: {}\n", line);
}

/// Nothing has happened at the desk for a while: one last picture, the finest, stays.
bool Session::rest(double time, bool headset_shows) {
    const bool is_active = script_ || headset_shows || !stage_.is_ready() || desk_.was_used() ||
                           stage_.viewer().state.playing || !stage_.viewer().state.notice.empty() ||
                           !options_.screenshot.empty();
    if (is_active) active_at_ = time;
    const bool rests = time - active_at_ > kRestAfter;
    if (!rests) drawn_at_rest_ = false;
    stage_.set_rest(rests);
    return rests;
}

/// Into the file that --present named, else beside the scene, or beside the first of the results that were
/// converted.
void Session::keep_presentation() {
    ViewerState& state = stage_.viewer().state;
    if (!std::exchange(state.wants_save, false)) return;
    std::filesystem::path path(options_.presentation);
    if (path.empty())
        path = std::filesystem::path(options_.inputs.front()).replace_extension(".presentation.json");
    try {
        save_presentation(state, stage_.viewer().model, path.string());
        state.notice = fmt::format("Saved as {}.", path.filename().string());
    } catch (const Error& error) {
        state.notice = fmt::format("Not saved: {}", error.what());
    }
}

bool Session::frame() {
    ScriptedFrame scripted;
    const double at = time();
    if (script_ && stage_.is_ready()) scripted = scripted_.frame(script_->due(at), desk_.pixels());
    const DeskFrame desk = desk_.poll(stage_, at, scripted.events);
    bool in_headset = false;
    if (headset_) {
        tell(headset_->poll(stage_, at), now() - began_);
        if (desk_.wants_headset_again()) headset_->ask_again();
        in_headset = headset_->frame(stage_, at, desk.input.commands);
    }
    // A headset that asks for no picture now keeps the room as it is.
    const bool is_at_desk = !in_headset && !(headset_ && headset_->is_shown());
    if (is_at_desk) {
        desk_.lend_motors(stage_.senses());
        stage_.set_budget(script_ || !options_.screenshot.empty() ? 0 : kDeskFrame);
        stage_.step(desk.input);
    }
    if (recording_ && (in_headset || is_at_desk)) {
        const Frame& was = stage_.frame();
        recording_->add(was.input, was.snapshot, was.pulses, stage_.senses().take_sound());
        if (!recording_->trouble().empty()) stage_.devices().trouble = recording_->trouble();
    }
    keep_presentation();
    if (!desk.dropped.empty())
        stage_.viewer().state.notice = "One scene at a time: start feelem-xr again with the other one.";
    const bool headset_shows = headset_ && headset_->is_shown();
    const bool rests = rest(at, headset_shows);
    // Nobody looks at a desk without a window while the headset shows the model, nor for a change where
    // nothing changes.
    if (rests && std::exchange(drawn_at_rest_, true)) {
        std::this_thread::sleep_for(kRestingFrame);
        return !is_over(desk);
    }
    if (desk_.has_window() || !headset_shows || !scripted.screenshots.empty())
        desk_.draw(stage_, headset_shows);
    for (const std::string& path : scripted.screenshots) write_picture(path, desk_.picture());
    desk_.show(in_headset);
    if (!script_ || stage_.is_ready()) ++frames_;
    return !scripted.quits && !is_over(desk);
}

int Session::take_picture() {
    for (int i = 0; i < kLongestWaitFrames && !stage_.is_ready(); ++i) frame();
    frame();
    write_picture(options_.screenshot, desk_.picture());
    return 0;
}

int Session::run() {
    if (!options_.screenshot.empty()) return take_picture();
    while (frame()) {}
    return 0;
}

}  // namespace

int run(const Options& options) {
    if (options.is_doctor) return run_doctor();
    Job job;
    job.inputs = options.inputs;
    job.presentation_file = options.presentation;
    Diagnostics diagnostics;
    const SceneForViewing scene(job, diagnostics, {});
    for (const Diagnostic& entry : diagnostics.entries()) fmt::print(stderr, "note: {}\n", entry.text);
    return Session(options, scene).run();
}

}  // namespace feelem::viewer
