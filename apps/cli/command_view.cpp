// SPDX-License-Identifier: Apache-2.0
// `feelem view`: convert if need be, serve the page on this machine or to the local network, open it.
#include "command.hpp"
#include "page_server.hpp"
#include "qr_code.hpp"
#include "scene_input.hpp"
#include "terminal.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

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

}  // namespace

int run_view(const Options& options) {
    refuse_making_a_scene_again(options);
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
    server::ServeOptions serving{scene.path(), options.port, options.port_given, options.lan};
    if (scene.is_made()) serving.model = options.job;
    serving.certificate_file = options.certificate_file;
    serving.key_file = options.key_file;
    server::PageServer server(serving);
    server.start();
    const std::filesystem::path path(scene.path());
    const std::string name = path.filename().string();
    // The page looks for scene.glb unless it is told otherwise.
    const std::string query = path.extension() == ".gltf" ? "?scene=scene.gltf" : "";
    const std::string address = server.address() + query;
    fmt::print("{} is shown at {}\n", name, address);
    if (options.lan) print_ways(server, query);
    fmt::print("Ctrl-C ends it.\n");
    std::fflush(stdout);
    if (options.open_browser) open_browser(address);
    int signal = 0;
    sigwait(&ending, &signal);
    server.stop();
    return 0;
}

}  // namespace feelem::cli
