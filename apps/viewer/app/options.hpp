// SPDX-License-Identifier: Apache-2.0
// The command line of feelem-xr.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Wrong usage: exit code 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

enum class UseHeadset {
    Auto,     ///< When there is one, at any time.
    Off,      ///< The window alone.
    Require,  ///< Without a headset it ends, and says why.
};

struct Options {
    bool is_doctor = false;
    std::vector<std::string> inputs;
    UseHeadset headset = UseHeadset::Auto;
    std::string screenshot;  ///< PNG: one picture without a window, then the end.
    std::string record;      ///< Folder: session.jsonl and sound.wav.
    std::string script;      ///< What a person would do at the desk, from a file.
    std::string presentation;
    std::array<int, 2> size{1280, 800};
    bool dark = false;
    bool mute = false;
    bool left_handed = false;
    std::optional<double> seconds;  ///< Ends by itself.
};

struct ParsedLine {
    Options options;
    std::optional<std::string> text;  ///< To print instead: help, version.
};

/// Throws UsageError.
ParsedLine parse_command_line(std::vector<std::string> arguments);

}  // namespace feelem::viewer
