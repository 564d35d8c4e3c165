// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/options.hpp"

#include "base/nearest_name.hpp"

#include "feelem/convert.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace feelem::viewer {
namespace {

constexpr int kSmallestSide = 64, kLargestSide = 8192;

const std::map<std::string, UseHeadset>& headset_words() {
    static const std::map<std::string, UseHeadset> words{
        {"auto", UseHeadset::Auto}, {"off", UseHeadset::Off}, {"require", UseHeadset::Require}};
    return words;
}

void add_options(CLI::App& app, Options& options) {
    app.add_option(
           "SCENE", options.inputs, "A scene, or result files of one model, which are converted first"
    )
        ->option_text("...");
    app.add_option(
           "--xr",
           options.headset,
           "auto | off | require: use a headset when there is one, never, or not without (auto)"
    )
        ->transform(CLI::CheckedTransformer(headset_words(), CLI::ignore_case))
        ->option_text(" ");
    app.add_option(
           "--present",
           options.presentation,
           "FILE: which result drives which sense, instead of the scene's own"
    )
        ->option_text(" ");
    app.add_option(
           "--screenshot",
           options.screenshot,
           "FILE.png: one picture, without window or headset, then the end"
    )
        ->option_text(" ");
    app.add_option("--record", options.record, "FOLDER: poses, readings, pulses and sound go there")
        ->option_text(" ");
    app.add_option("--script", options.script, "FILE: does at the desk what it says (docs/native-viewer.md)")
        ->option_text(" ");
    app.add_option("--size", options.size, "W H: of the window or the picture, in pixels (1280 800)")
        ->check(CLI::Range(kSmallestSide, kLargestSide))
        ->option_text(" ");
    app.add_option("--seconds", options.seconds, "N: ends by itself")
        ->check(CLI::NonNegativeNumber)
        ->option_text(" ");
    app.add_flag("--dark", options.dark, "Dark panels and background");
    app.add_flag("--left-handed", options.left_handed, "Boards and buttons of the headset mirrored");
    app.add_flag("--mute", options.mute, "Begin without sound");
}

[[noreturn]] void refuse(const CLI::App& app, const std::string& extra) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string name = extra.substr(0, extra.find('='));
    throw UsageError(
        fmt::format("there is no option {}.{} feelem-xr --help lists them", name, did_you_mean(name, views))
    );
}

}  // namespace

ParsedLine parse_command_line(std::vector<std::string> arguments) {
    ParsedLine line;
    CLI::App app{
        "See, hear and feel a scene on the desk and in an OpenXR headset\n\n"
        "feelem-xr doctor says what works on this machine: runtime, headset, graphics, sound",
        "feelem-xr"};
    app.allow_extras();
    add_options(app, line.options);
    if (arguments.size() == 1 && arguments.front() == "--version") {
        line.text = fmt::format("feelem-xr {}\n", version());
        return line;
    }
    std::ranges::reverse(arguments);  // CLI11 takes them from the back.
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        line.text = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (const auto extras = app.remaining(); !extras.empty()) refuse(app, extras.front());
    if (line.options.inputs == std::vector<std::string>{"doctor"}) {
        line.options.is_doctor = true;
        return line;
    }
    if (line.options.inputs.empty())
        throw UsageError("no scene. Usage: feelem-xr SCENE.glb (feelem-xr --help says more)");
    return line;
}

}  // namespace feelem::viewer
