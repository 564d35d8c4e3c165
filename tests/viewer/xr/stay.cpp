// SPDX-License-Identifier: Apache-2.0
// The program's loop, small enough for a test.
#include "viewer/xr/stay.hpp"

#include "support/paths.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace feelem::viewer {

namespace {

constexpr double kTurn = 0.02;
constexpr int kMostWaits = 30'000;

/// One of its own for each stay: the runtime begins anew when the script's name changes.
std::string fresh_folder() {
    static int count = 0;
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name() + std::to_string(count++);
    for (char& each : name)
        if (each == '/') each = '_';
    return feelem::test::scratch_folder("viewer_xr/" + name);
}

}  // namespace

void NeedsOpenGl::SetUp() {
    try {
        const GlContext context;
    } catch (const std::exception& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
}

Environment::~Environment() {
    for (auto each = before_.rbegin(); each != before_.rend(); ++each) {
        if (each->second)
            ::setenv(each->first.c_str(), each->second->c_str(), 1);
        else
            ::unsetenv(each->first.c_str());
    }
}

void Environment::remember(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    before_.emplace_back(name, value ? std::optional<std::string>(value) : std::nullopt);
}

void Environment::set(const std::string& name, const std::string& value) {
    remember(name);
    ::setenv(name.c_str(), value.c_str(), 1);
}

void Environment::unset(const std::string& name) {
    remember(name);
    ::unsetenv(name.c_str());
}

Stay::Stay(const std::string& script, const std::string& faults, const XrOptions& options)
    : gl(std::make_unique<GlContext>()) {
    start(script, faults, options);
}

Stay::Stay(InCurrentContext, const std::string& script, const std::string& faults) {
    start(script, faults, {});
}

void Stay::start(const std::string& script, const std::string& faults, const XrOptions& options) {
    const std::string folder = fresh_folder();
    const std::string script_path = folder + "/script";
    record_path_ = folder + "/record.jsonl";
    std::ofstream(script_path) << script;
    std::ofstream(record_path_, std::ios::trunc).close();
    environment_.set("XR_RUNTIME_JSON", FEELEM_SCRIPTED_XR_JSON);
    environment_.set("FEELEM_XR_SCRIPT", script_path);
    environment_.set("FEELEM_XR_RECORD", record_path_);
    environment_.set("FEELEM_XR_FAULTS", faults);
    system = std::make_unique<XrSystem>(options);
}

Stay::~Stay() {
    end();
}

void Stay::set_faults(const std::string& faults) {
    environment_.set("FEELEM_XR_FAULTS", faults);
}

bool Stay::turn() {
    time += kTurn;
    system->poll(time);
    // On a busy machine the answer takes a while of the real clock; none of the program's passes meanwhile.
    for (int i = 0; system->status().is_asking && i < kMostWaits; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        system->poll(time);
    }
    const auto frame = system->begin_frame();
    if (!frame) return false;
    last = *frame;
    if (draw) draw(last);
    system->end_frame(pictures ? pictures() : XrPictures{});
    return true;
}

bool Stay::reach(XrState state, double seconds) {
    const double until = time + seconds;
    while (time < until) {
        turn();
        if (system->status().state == state) return true;
    }
    return false;
}

bool Stay::frames(std::size_t count) {
    const double until = time + 60;
    while (count > 0 && time < until)
        if (turn()) --count;
    return count == 0;
}

void Stay::pass(double seconds) {
    const double until = time + seconds;
    while (time < until) turn();
}

void Stay::end() {
    system.reset();
}

std::vector<nlohmann::json> Stay::record(const std::string& member) const {
    std::vector<nlohmann::json> found;
    std::ifstream file(record_path_);
    for (std::string line; std::getline(file, line);) {
        auto each = nlohmann::json::parse(line);
        if (each.contains(member)) found.push_back(std::move(each));
    }
    return found;
}

std::vector<std::string> Stay::complaints() const {
    std::vector<std::string> found;
    for (const auto& each : record("violation")) found.push_back(each.dump());
    for (const char* kind :
         {"leaked_sessions", "leaked_sets", "leaked_swapchains", "leaked_spaces", "leaked_trackers"})
        for (const auto& each : record(kind))
            if (each[kind] != 0) found.push_back(each.dump());
    return found;
}

unsigned texture_of(int width, int height, const std::array<std::uint8_t, 4>& colour) {
    unsigned texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA8, width, height);
    glClearTexImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, colour.data());
    return texture;
}

void fill_eyes(const XrFrame& frame, const std::array<std::array<std::uint8_t, 4>, 2>& colours) {
    for (std::size_t i = 0; frame.should_render && i < frame.eyes.size(); ++i) {
        const XrEye& eye = frame.eyes[i];
        unsigned texture = texture_of(eye.width, eye.height, colours[i]), from = 0;
        glCreateFramebuffers(1, &from);
        glNamedFramebufferTexture(from, GL_COLOR_ATTACHMENT0, texture, 0);
        glBlitNamedFramebuffer(
            from,
            eye.framebuffer,
            0,
            0,
            eye.width,
            eye.height,
            0,
            0,
            eye.width,
            eye.height,
            GL_COLOR_BUFFER_BIT,
            GL_NEAREST
        );
        glDeleteFramebuffers(1, &from);
        glDeleteTextures(1, &texture);
    }
}

}  // namespace feelem::viewer
