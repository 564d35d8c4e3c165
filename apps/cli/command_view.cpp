// SPDX-License-Identifier: Apache-2.0
// `feelem view`: convert if need be, serve the page on this machine or to the local network, open it: as soon
// as the shape stands, while results are still being read.
#include "command.hpp"
#include "page_server.hpp"
#include "qr_code.hpp"
#include "scene_input.hpp"
#include "terminal.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

extern char** environ;

namespace feelem::cli {
namespace {

bool has_display() {
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

/// By the desktop's own way; without one the printed address must do.
void open_browser(const std::string& address) {
    if (!has_display()) return;
    std::string program = "xdg-open", target = address;
    char* const arguments[]{program.data(), target.data(), nullptr};
    posix_spawn_file_actions_t quiet{};
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1 /* O_WRONLY */, 0);
    posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1 /* O_WRONLY */, 0);
    posix_spawnattr_t attributes{};
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    pid_t child = 0;
    if (posix_spawnp(&child, program.c_str(), &quiet, &attributes, arguments, environ) != 0) {
        fmt::print(stderr, "note:    xdg-open is not there: please open {} yourself\n", address);
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&quiet);
}

/// How others get here: link, code, fingerprint, cable.
void print_ways(const server::PageServer& server, const std::string& query) {
    const std::vector<std::string> links = server.links();
    if (links.empty()) {
        fmt::print("No network is up: only this machine can see it.\n");
    } else {
        fmt::print("Headset or phone in the same network: {}{}\n", links.front(), query);
        if (isatty(STDOUT_FILENO) != 0) fmt::print("\n{}\n", server::qr_for_terminal(links.front() + query));
        for (std::size_t i = 1; i < links.size(); ++i) fmt::print("  or {}{}\n", links[i], query);
        fmt::print(
            "Who has the link sees the model. {}SHA-256 fingerprint of the certificate{}:\n  {}\n",
            server.has_own_certificate() ? "The browser warns once: we signed ourselves. " : "",
            server.has_new_certificate() ? ", made anew just now" : "",
            server.fingerprint()
        );
    }
    const std::string path = server.address().substr(server.address().find('/', 7));
    fmt::print(
        "By USB: adb reverse tcp:{0} tcp:{0}, then http://localhost:{0}{1}{2} on the headset\n",
        server.port(),
        path,
        query
    );
}

/// While it lives, signals that end the program wait. Threads inherit that.
class SignalsWait {
public:
    SignalsWait() { pthread_sigmask(SIG_BLOCK, &ending(), &before_); }
    ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

    static const sigset_t& ending() {
        static const sigset_t signals = [] {
            sigset_t set;
            sigemptyset(&set);
            sigaddset(&set, SIGINT);
            sigaddset(&set, SIGTERM);
            sigaddset(&set, SIGHUP);
            return set;
        }();
        return signals;
    }

private:
    sigset_t before_{};
};

/// The server of one `feelem view`, from when there is something to show.
class Viewing {
public:
    explicit Viewing(const Options& options) : options_(options) {}

    /// The scene will be at `scene_path`.
    void show_shape(const std::string& shape_path, const std::string& scene_path) {
        opening_ = std::make_shared<server::Opening>(shape_path);
        begin(scene_path, true);
        fmt::print("Its shape is there; results are still being read.\n");
        std::fflush(stdout);
    }
    void progress(std::string_view stage, double fraction) {
        if (opening_) opening_->progress(stage, fraction);
    }
    void show_scene(const SceneInput& scene) {
        if (!server_) return begin(scene.path(), scene.is_made());
        opening_->finish();
        fmt::print("Its results are there.\n");
        std::fflush(stdout);
    }
    /// A page that shows the shape is told before the server goes.
    void fail(const std::string& text, std::chrono::milliseconds patience) {
        if (!opening_ || !server_) return;
        opening_->fail(text);
        if (!opening_->has_guests() && !is_browser_open_) return;
        if (opening_->wait_until_told(patience)) std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    void stop() { server_->stop(); }

private:
    void begin(const std::string& scene_path, bool is_made);

    const Options& options_;
    std::shared_ptr<server::Opening> opening_;  ///< Null: the scene was there from the start.
    std::optional<server::PageServer> server_;
    bool is_browser_open_ = false;
};

void Viewing::begin(const std::string& scene_path, bool is_made) {
    const SignalsWait in_this_thread_alone;
    std::signal(SIGPIPE, SIG_IGN);  // A browser that goes away is no reason to end.
    server::ServeOptions serving{scene_path, options_.port, options_.port_given, options_.lan};
    if (is_made) serving.model = options_.job;
    serving.certificate_file = options_.certificate_file;
    serving.key_file = options_.key_file;
    serving.opening = opening_;
    server_.emplace(serving);
    server_->start();
    const std::filesystem::path path(scene_path);
    // The page looks for scene.glb unless it is told otherwise.
    const std::string query = path.extension() == ".gltf" ? "?scene=scene.gltf" : "";
    const std::string address = server_->address() + query;
    fmt::print("{} is shown at {}\n", path.filename().string(), address);
    if (options_.lan) print_ways(*server_, query);
    fmt::print("Ctrl-C ends it.\n");
    std::fflush(stdout);
    if (!options_.open_browser) return;
    open_browser(address);
    is_browser_open_ = has_display();
}

}  // namespace

int run_view(const Options& options) {
    using namespace std::chrono_literals;
    refuse_making_a_scene_again(options);
    Viewing viewing(options);
    std::optional<SceneInput> scene;
    try {
        scene.emplace(
            options,
            SceneWatcher{
                [&](const std::string& shape, const std::string& path) { viewing.show_shape(shape, path); },
                [&](std::string_view stage, double fraction) { viewing.progress(stage, fraction); }}
        );
    } catch (const std::exception& error) {
        viewing.fail(error.what(), 4s);
        throw;
    }
    if (scene->path().empty()) {
        viewing.fail("feelem was ended before they were read", 1s);
        fmt::print(stderr, "feelem: cancelled\n");
        return 1;
    }
    // Ctrl-C is waited for here and nowhere else.
    const SignalsWait until_asked_for;
    viewing.show_scene(*scene);
    // Until this thread waits, another may be given the signal: then it is only noted.
    const timespec often{0, 200'000'000};
    while (!was_interrupted() && sigtimedwait(&SignalsWait::ending(), nullptr, &often) < 0) {}
    viewing.stop();
    return 0;
}

}  // namespace feelem::cli
