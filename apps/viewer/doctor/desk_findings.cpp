// SPDX-License-Identifier: Apache-2.0
#include "viewer/doctor/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

namespace feelem::viewer {
namespace {

namespace fs = std::filesystem;

bool draws_in_software(const std::string& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"}) {
        if (renderer.find(name) != std::string::npos) return true;
    }
    return false;
}

std::vector<fs::path> render_nodes(const Machine& machine) {
    std::vector<fs::path> nodes;
    std::error_code error;
    for (fs::directory_iterator entry(machine.at("/dev/dri"), error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().filename().string().starts_with("renderD")) nodes.push_back(entry->path());
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

Finding software_graphics(const Machine& machine, const std::string& what) {
    const std::vector<fs::path> nodes = render_nodes(machine);
    if (nodes.empty()) return poor("graphics", what + ": slow. No graphics card is to be seen here");
    const std::string node = "/dev/dri/" + nodes.front().filename().string();
    if (!machine.can_use(nodes.front())) {
        return poor(
            "graphics",
            fmt::format("{}: slow. The graphics card {} is not open to you", what, node),
            "Join the group that may use the graphics card: sudo usermod -aG render \"$USER\", then log in "
            "again."
        );
    }
    return poor(
        "graphics",
        fmt::format("{}: slow. The graphics card {} has no OpenGL driver", what, node),
        "Install the graphics card's driver: package libgl1-mesa-dri, or the maker's."
    );
}

/// Where its full stop is; one in brackets is somebody else's.
std::size_t end_of_sentence(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')') --depth;
        if (text[i] == '.' && depth == 0 && (i + 1 == text.size() || text[i + 1] == ' ')) return i;
    }
    return text.size();
}

void add(std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
}

/// f(line) for each line of a text.
template <class Function>
void each_line(const std::string& text, Function&& f) {
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        f(std::string_view(text).substr(from, end - from));
        from = end + 1;
    }
}

struct Gamepad {
    std::string name, node;
};

/// Of /proc/bus/input/devices, what the kernel takes for a joystick: N: Name="..." H: Handlers=event7 js0
std::optional<Gamepad> find_gamepad(const Machine& machine) {
    std::optional<Gamepad> found;
    std::string name;
    each_line(text_of(machine.at("/proc/bus/input/devices")), [&](std::string_view line) {
        if (line.starts_with("N: Name=\"")) name = std::string(line.substr(9, line.find_last_of('"') - 9));
        if (found || !line.starts_with("H: Handlers=") || line.find("js") == std::string_view::npos) return;
        const std::size_t at = line.find("event");
        if (at == std::string_view::npos) return;
        found = Gamepad{name, std::string(line.substr(at, line.find(' ', at) - at))};
    });
    return found;
}

}  // namespace

Finding examine_graphics(const Machine& machine, const TriedGraphics& tried) {
    if (!tried.trouble.empty()) {
        return missing(
            "graphics",
            tried.trouble,
            "Install an OpenGL 4.5 driver: package libgl1-mesa-dri, or the maker's of your graphics card."
        );
    }
    const std::string version = tried.version.substr(0, tried.version.find(' '));
    const std::string what = fmt::format("OpenGL {}, {}", version, tried.renderer);
    if (draws_in_software(tried.renderer)) return software_graphics(machine, what);
    return well("graphics", what);
}

Finding examine_screen(const Machine& machine, const TriedGraphics& tried) {
    const std::string wayland = machine.environment("WAYLAND_DISPLAY"), x11 = machine.environment("DISPLAY");
    if (wayland.empty() && x11.empty()) {
        return missing(
            "screen",
            "no screen in this session (DISPLAY, WAYLAND_DISPLAY): --screenshot works, a window does not",
            machine.environment("SSH_CONNECTION").empty() ? "Start it in a desktop session."
                                                          : "Start it at the machine itself, not over ssh."
        );
    }
    if (!tried.screen_trouble.empty()) {
        const std::size_t end = end_of_sentence(tried.screen_trouble);
        const std::size_t next = std::min(end + 2, tried.screen_trouble.size());
        return missing("screen", tried.screen_trouble.substr(0, end), tried.screen_trouble.substr(next));
    }
    return well("screen", wayland.empty() ? x11 : wayland);
}

Finding examine_sound(const Machine& machine) {
    std::string found;
    const std::string folder = machine.environment("XDG_RUNTIME_DIR");
    if (!folder.empty() && is_there(machine.at(fs::path(folder) / "pipewire-0"))) add(found, "PipeWire");
    if (!folder.empty() && is_there(machine.at(fs::path(folder) / "pulse/native"))) add(found, "PulseAudio");
    each_line(text_of(machine.at("/proc/asound/cards")), [&](std::string_view line) {
        const std::size_t name = line.find("]: ");
        if (name != std::string_view::npos) add(found, std::string(line.substr(name + 3)));
    });
    if (found.empty())
        return missing("sound", "no sound card and no sound server: values can be seen and felt, not heard");
    return well("sound", found);
}

Finding examine_gamepad(const Machine& machine) {
    const std::optional<Gamepad> pad = find_gamepad(machine);
    if (!pad) return missing("gamepad", "none here; at the desk, one would let the hand feel");
    if (machine.can_use(machine.at("/dev/input") / pad->node)) return well("gamepad", pad->name);
    return poor(
        "gamepad",
        fmt::format("{}, but /dev/input/{} is not open to you", pad->name, pad->node),
        "Let the gamepad be used: sudo usermod -aG input \"$USER\", then log in again."
    );
}

}  // namespace feelem::viewer
