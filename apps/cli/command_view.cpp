// SPDX-License-Identifier: Apache-2.0
// `feelem view`: convert if need be, serve the page on this machine, open it.
#include "command.hpp"
#include "page_server.hpp"
#include "scene_input.hpp"
#include "terminal.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

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

}  // namespace

int run_view(const Options& options) {
    if (options.lan) {
        throw UsageError(
            "--lan is not available yet: the page is served on this machine only (leave out --lan)"
        );
    }
    const SceneInput scene(options);
    if (scene.path().empty()) {
        fmt::print(stderr, "feelem: cancelled\n");
        return 1;
    }
    // Threads inherit the mask: Ctrl-C is waited for here and nowhere else.
    sigset_t ending;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &ending, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // A browser that goes away is no reason to end.
    server::PageServer server({scene.path(), options.port, options.port_given});
    server.start();
    const std::filesystem::path path(scene.path());
    const std::string name = path.filename().string();
    // The page looks for scene.glb unless it is told otherwise.
    const std::string query = path.extension() == ".gltf" ? "?scene=scene.gltf" : "";
    const std::string address = server.address() + query;
    fmt::print("{} is shown at {}\nCtrl-C ends it.\n", name, address);
    std::fflush(stdout);
    if (options.open_browser) open_browser(address);
    int signal = 0;
    sigwait(&ending, &signal);
    server.stop();
    return 0;
}

}  // namespace feelem::cli
