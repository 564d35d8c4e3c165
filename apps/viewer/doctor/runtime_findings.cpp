// SPDX-License-Identifier: Apache-2.0
#include "viewer/doctor/findings.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace feelem::viewer {
namespace {

namespace fs = std::filesystem;

std::string how_to_start(RuntimeKind kind) {
    switch (kind) {
    case RuntimeKind::Monado:
        return "Start Monado's service: systemctl --user start monado.service, or monado-service in a "
               "terminal.";
    case RuntimeKind::SteamVr: return "Start SteamVR.";
    case RuntimeKind::Wivrn: return "Start the WiVRn server and connect the headset to it.";
    case RuntimeKind::Unknown: break;
    }
    return "Start the runtime's own program.";
}

/// Where the service listens; empty: not known of this runtime.
fs::path socket_of(const Machine& machine, RuntimeKind kind) {
    const std::string folder = machine.environment("XDG_RUNTIME_DIR");
    if (folder.empty()) return {};
    if (kind == RuntimeKind::Monado) return fs::path(folder) / "monado_comp_ipc";
    if (kind == RuntimeKind::Wivrn) return fs::path(folder) / "wivrn/comp_ipc";
    return {};
}

std::string how_to_connect(RuntimeKind kind) {
    switch (kind) {
    case RuntimeKind::Wivrn: return "Start WiVRn on the headset and let it connect to this machine.";
    case RuntimeKind::SteamVr: return "Connect the headset and switch it on; SteamVR's window must show it.";
    case RuntimeKind::Monado:
    case RuntimeKind::Unknown: break;
    }
    return "Connect the headset and switch it on; the package xr-hardware lets you use it without being "
           "root.";
}

}  // namespace

Finding examine_runtime(const RuntimeFiles& found) {
    const std::string chosen = found.chosen.string();
    const std::string installed = found.installed.empty() ? "" : found.installed.front().string();
    switch (found.fault) {
    case RuntimeFault::None:
        return well(
            "runtime",
            fmt::format("{}, chosen by {}", found.name, found.is_forced ? "XR_RUNTIME_JSON" : chosen)
        );
    case RuntimeFault::NotInstalled:
        return missing(
            "runtime",
            "no OpenXR runtime is installed",
            "For a headset, install its runtime: SteamVR (Index, Vive), WiVRn (Quest, Pico), Monado (many "
            "others)."
        );
    case RuntimeFault::NotChosen:
        return missing(
            "runtime",
            installed + " is installed, but no runtime is chosen",
            fmt::format(
                "Choose it: mkdir -p ~/.config/openxr/1 && ln -sf {} ~/.config/openxr/1/active_runtime.json",
                installed
            )
        );
    case RuntimeFault::ForcedIsAbsent:
        return missing(
            "runtime",
            fmt::format("XR_RUNTIME_JSON names {}, which is not there", chosen),
            "Correct XR_RUNTIME_JSON, or unset it."
        );
    case RuntimeFault::LinkIsBroken:
        return missing(
            "runtime",
            fmt::format("{} points to {}, which is not there", chosen, found.link.string()),
            installed.empty() ? "Install that runtime again, or remove the link."
                              : fmt::format("Choose what is there: ln -sf {} {}", installed, chosen)
        );
    case RuntimeFault::NotADescription:
        return missing(
            "runtime",
            chosen + " describes no OpenXR runtime (no \"library_path\")",
            "Install the runtime again, or let the link point to its own file."
        );
    case RuntimeFault::NoLibrary:
        return missing(
            "runtime",
            fmt::format("{} names the library {}, which is not there", chosen, found.library),
            fmt::format("Install {} again.", found.name)
        );
    }
    std::abort();
}

Finding examine_service(const Machine& machine, const RuntimeFiles& runtime, const XrStatus* headset) {
    if (headset == nullptr) return missing("service", "not asked, since there is no OpenGL");
    if (headset->state == XrState::NoRuntime) {
        const std::string why = headset->why.empty() ? "its library cannot be used" : headset->why;
        return missing(
            "service", fmt::format("not asked: {}", why), fmt::format("Install {} again.", runtime.name)
        );
    }
    if (headset->state != XrState::NoService)
        return well("service", headset->runtime.empty() ? runtime.name + " answers" : headset->runtime);
    const bool has_socket = runtime.kind == RuntimeKind::Monado || runtime.kind == RuntimeKind::Wivrn;
    if (has_socket && machine.environment("XDG_RUNTIME_DIR").empty()) {
        return missing(
            "service",
            "XDG_RUNTIME_DIR is not set, so the service cannot be found",
            "Start feelem-xr from your own session, without sudo or su."
        );
    }
    const fs::path socket = socket_of(machine, runtime.kind);
    if (!socket.empty() && is_there(machine.at(socket))) {
        return missing(
            "service",
            fmt::format("{} is there, but nobody answers: the service has crashed or hangs", socket.string()),
            how_to_start(runtime.kind)
        );
    }
    return missing(
        "service", fmt::format("{} is chosen, but it does not run", runtime.name), how_to_start(runtime.kind)
    );
}

Finding examine_headset(const RuntimeFiles& runtime, const XrStatus* headset) {
    if (headset == nullptr) return missing("headset", "not asked");
    switch (headset->state) {
    case XrState::NoRuntime:
    case XrState::NoService: return missing("headset", "not asked");
    case XrState::NoHeadset:
        return missing("headset", fmt::format("{} finds none", runtime.name), how_to_connect(runtime.kind));
    case XrState::Unusable:
        return missing("headset", headset->why.empty() ? headset->what : headset->why, headset->hint);
    case XrState::Starting:
    case XrState::Asleep:
    case XrState::Visible:
    case XrState::Focused:
    case XrState::Ended: break;
    }
    return well("headset", headset->headset);
}

}  // namespace feelem::viewer
