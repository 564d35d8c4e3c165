// SPDX-License-Identifier: Apache-2.0
// What the doctor's report is made of, a finding each.
#pragma once

#include "viewer/doctor/doctor.hpp"
#include "viewer/doctor/runtime_files.hpp"

#include <utility>

namespace feelem::viewer {

inline Finding well(std::string_view what, std::string text) {
    return {what, Health::Well, std::move(text), ""};
}
inline Finding poor(std::string_view what, std::string text, std::string advice = "") {
    return {what, Health::Poor, std::move(text), std::move(advice)};
}
inline Finding missing(std::string_view what, std::string text, std::string advice = "") {
    return {what, Health::Missing, std::move(text), std::move(advice)};
}

Finding examine_graphics(const Machine& machine, const TriedGraphics& tried);
Finding examine_screen(const Machine& machine, const TriedGraphics& tried);
Finding examine_sound(const Machine& machine);
Finding examine_gamepad(const Machine& machine);

Finding examine_runtime(const RuntimeFiles& found);
/// Null: the headset could not be tried, since there is no OpenGL.
Finding examine_service(const Machine& machine, const RuntimeFiles& runtime, const XrStatus* headset);
Finding examine_headset(const RuntimeFiles& runtime, const XrStatus* headset);

}  // namespace feelem::viewer
