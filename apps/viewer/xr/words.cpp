// SPDX-License-Identifier: Apache-2.0
// What people are told about the headset.
#include "viewer/xr/connection.hpp"

#include <fmt/format.h>

#include <string_view>

namespace feelem::viewer {

std::string_view word(XrState state) {
    switch (state) {
    case XrState::NoRuntime: return "no-runtime";
    case XrState::NoService: return "no-service";
    case XrState::NoHeadset: return "no-headset";
    case XrState::Unusable: return "unusable";
    case XrState::Starting: return "starting";
    case XrState::Asleep: return "asleep";
    case XrState::Visible: return "visible";
    case XrState::Focused: return "focused";
    case XrState::Ended: return "ended";
    }
    return "";
}

namespace xr {

namespace {

struct Told {
    std::string what, why, hint;
};

/// Words for codes that people may have to look up.
std::string code_text(XrResult result) {
    switch (result) {
    case XR_ERROR_EXTENSION_NOT_PRESENT:
        return "it takes no pictures from OpenGL, or not from this kind of window (SDL_VIDEODRIVER=x11 may "
               "help)";
    case XR_ERROR_GRAPHICS_DEVICE_INVALID: return "it does not accept this OpenGL context";
    case XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED: return "it takes no 8-bit colour pictures";
    case XR_ERROR_API_VERSION_UNSUPPORTED: return "it does not know OpenXR 1.0";
    case XR_ERROR_FORM_FACTOR_UNSUPPORTED: return "it serves no headsets";
    case XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED: return "it does not show two eyes";
    case XR_ERROR_LIMIT_REACHED: return "another program has it";
    default: return fmt::format("OpenXR code {}", static_cast<int>(result));
    }
}

Told words_of_trouble(const Connection& connection) {
    const std::string code = code_text(connection.reason);
    switch (connection.trouble) {
    case Trouble::None: break;
    case Trouble::NoRuntime:
        return {
            "No headset; the window is used.",
            "No OpenXR runtime is installed on this computer.",
            "Install one (SteamVR, Monado, WiVRn) and start again; `feelem-xr doctor` says more."};
    case Trouble::NoService:
        return {
            "No headset yet; the window is used.",
            fmt::format("The OpenXR runtime is installed but does not start ({}).", code),
            "Start its service, such as SteamVR or monado-service. It is asked again every few seconds."};
    case Trouble::ServiceStopped:
        return {
            "The headset's service stopped; the window goes on.",
            "The runtime no longer answers.",
            "Model and view are kept. Start the service again: it is asked every few seconds."};
    case Trouble::NoHeadset:
        return {
            "No headset yet; the window is used.",
            "The runtime runs, but finds no headset.",
            "Connect it and switch it on: it is looked for every two seconds."};
    case Trouble::NoGraphics:
        return {
            "The headset cannot be used; the window is.",
            fmt::format("The runtime cannot show our pictures: {}.", code),
            "Another runtime may; `feelem-xr doctor` names the one in use."};
    case Trouble::Refused:
        return {
            "The headset does not let us in; the window is used.",
            fmt::format("The runtime refused: {}.", code),
            "It is asked again every few seconds."};
    case Trouble::SessionLost:
        return {
            "The headset's session broke off; the window goes on.",
            "The runtime ended it.",
            "Model and view are kept; it is begun again in a moment."};
    case Trouble::LossPending:
        return {
            "The headset goes away; the window goes on.",
            "The runtime says that it restarts or loses the headset.",
            "Model and view are kept; it is looked for every few seconds."};
    }
    return {};
}

Told words_of(const Connection& connection) {
    if (connection.phase == Phase::Ended)
        return {"The headset was left; the window goes on.", "", "Enter it again from the menu."};
    if (connection.trouble != Trouble::None) return words_of_trouble(connection);
    switch (state_of(connection)) {
    case XrState::Focused: return {"In the headset.", "", ""};
    case XrState::Visible:
        return {"The headset's menu is open.", "Nothing is heard, felt or moved meanwhile.", ""};
    case XrState::Asleep: return {"The headset sleeps.", "It is off the head, or shows something else.", ""};
    default: return {"The headset is being started.", "", ""};
    }
}

}  // namespace

void put_words(const Connection& connection, XrStatus& status) {
    status.state = state_of(connection);
    Told told = words_of(connection);
    status.what = std::move(told.what);
    status.why = std::move(told.why);
    status.hint = std::move(told.hint);
}

}  // namespace xr

}  // namespace feelem::viewer
