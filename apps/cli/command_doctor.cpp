// SPDX-License-Identifier: Apache-2.0
// `feelem doctor`: what was found on this machine, and what it is good for. It looks; it does not try out.
#include "command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace feelem::cli {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool is_there(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

/// Full path of a program, or "".
std::string find_program(std::string_view name) {
    std::string folders = environment("PATH");
    for (std::size_t from = 0; from <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', from), folders.size());
        const fs::path file = fs::path(folders.substr(from, end - from)) / name;
        std::error_code error;
        if (fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) return file.string();
        from = end + 1;
    }
    return "";
}

std::string first_program(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        if (std::string path = find_program(name); !path.empty()) return path;
    }
    return "";
}

void report(std::string_view what, const std::string& found, std::string_view otherwise) {
    fmt::print("{:<14} {:<4} {}\n", what, found.empty() ? "no" : "yes", found.empty() ? otherwise : found);
}

void report_browser() {
    const std::string browser = first_program(
        {"chromium", "google-chrome", "google-chrome-stable", "chromium-browser", "microsoft-edge", "firefox"}
    );
    report(
        "browser",
        browser,
        "none on the PATH; any browser with WebGL 2 opens the address that `feelem view` prints"
    );
    const std::string opener = find_program("xdg-open");
    const bool has_display = !environment("DISPLAY").empty() || !environment("WAYLAND_DISPLAY").empty();
    report(
        "opens itself",
        has_display ? opener : "",
        has_display
            ? "xdg-open is not there (package xdg-utils): open the printed address yourself"
            : "no display here (DISPLAY, WAYLAND_DISPLAY): open the printed address where there is one"
    );
}

void report_sound() {
    std::ifstream cards("/proc/asound/cards");
    std::string line, found;
    while (std::getline(cards, line)) {
        const std::size_t colon = line.find("]: ");
        if (colon != std::string::npos) found += (found.empty() ? "" : ", ") + line.substr(colon + 3);
    }
    const std::string runtime = environment("XDG_RUNTIME_DIR");
    for (const char* socket : {"pipewire-0", "pulse/native"}) {
        if (!runtime.empty() && is_there(fs::path(runtime) / socket)) {
            found += (found.empty() ? "" : ", ") + std::string(socket);
        }
    }
    report("sound", found, "no sound card and no sound server: values can be seen, not heard");
}

void report_headset() {
    std::vector<fs::path> files;
    if (const std::string forced = environment("XR_RUNTIME_JSON"); !forced.empty())
        files.emplace_back(forced);
    const std::string config = environment("XDG_CONFIG_HOME");
    const std::string home = environment("HOME");
    files.push_back(
        (config.empty() ? fs::path(home) / ".config" : fs::path(config)) / "openxr/1/active_runtime.json"
    );
    files.emplace_back("/etc/xdg/openxr/1/active_runtime.json");
    files.emplace_back("/usr/share/openxr/1/openxr_monado.json");
    std::string found;
    for (const fs::path& file : files) {
        if (found.empty() && is_there(file)) found = file.string();
    }
    report(
        "headset",
        found,
        "no OpenXR runtime is set up on this machine (a headset with its own browser needs none)"
    );
}

void report_graphics() {
    std::string found;
    std::error_code error;
    for (fs::directory_iterator entry("/dev/dri", error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().filename().string().starts_with("renderD")) found = entry->path().string();
    }
    report("graphics card", found, "no render node in /dev/dri: the browser draws in software, slowly");
}

}  // namespace

int run_doctor(const Options&) {
    fmt::print("feelem {} on {} processors\n\n", version(), std::thread::hardware_concurrency());
    report_browser();
    report_graphics();
    report_sound();
    report_headset();
    fmt::print(
        "\nThis is what was found, not what was tried. `feelem formats` lists what is read and written.\n"
    );
    return 0;
}

}  // namespace feelem::cli
