// SPDX-License-Identifier: Apache-2.0
// All that the panels show, as plain data: filled by the program each frame, read by the panels. They keep no
// state of their own; what the person wants comes out as wishes.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/core/look.hpp"

#include "feelem/present.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace feelem::viewer {

struct UiLegend {
    std::string key;     ///< PresentedResult::key.
    std::string title;   ///< "von Mises stress"
    std::string unit;    ///< As the scene has it: "degC"; empty: not given.
    std::string step;    ///< step_text.
    std::string origin;  ///< "at nodes · averaged in parts"; may be empty.
    ValueRange range;
    ColourEffect colour;
    std::optional<double> limit;
    bool limit_is_upper = true;
    std::string limit_label;
    std::optional<double> probed;  ///< Value that is pointed at.
    /// What a level, or a compressed scene, may be off: "values within ±0.05 % (±0.26 °C)". Empty: nothing.
    std::string within;
    std::string deformation;  ///< "deformation × 120"; empty: none.
    bool isolines = false;
};

struct UiCardRow {
    std::string key, label, unit;
    double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no value.
    std::optional<float> node_value;
    std::string state = "solver";  ///< solver interpolated missing
    std::vector<Sense> senses;     ///< That it drives.
    std::optional<double> limit;
    bool limit_is_upper = true;
    std::string limit_label;
    bool beyond = false;
    double bound = 0;  ///< What the value may be off.
};

struct UiCard {
    std::vector<UiCardRow> rows;
    std::optional<std::int64_t> node;
    std::int64_t element = 0;
    std::array<double, 3> place{};  ///< Model units, undeformed.
    std::string length_unit;        ///< Empty: not given.
    std::string sounding;           ///< "tone 440 Hz · 4 pulses/s"; empty: silence.
    bool is_pinned = false;
};

struct UiResult {
    std::string key, label, unit;
    std::optional<ValueRange> range;  ///< Empty: not in this scene.
    std::vector<Sense> senses;        ///< That it drives.
    bool can_shape = false;
    std::optional<double> limit;
    bool limit_is_upper = true;
};

struct UiSteps {
    std::vector<std::string> names;  ///< step_text each.
    std::size_t shown = 0;
    bool is_playing = false;
    bool is_mode = false;  ///< What is shown swings when it is played.
};

struct UiDeformation {
    bool is_there = false;            ///< The scene has displacements.
    double factor = 0;                ///< Shown now.
    std::optional<double> automatic;  ///< 5 % of the largest side.
    bool is_automatic = false;
};

struct UiPart {
    std::string name, kind;  ///< "solid"
    std::uint64_t triangles = 0;
    PartLook look = PartLook::Shown;
};

struct UiCut {
    CutPlane plane;
    float from = -1, to = 1;  ///< Where along its normal the model begins and ends.
    bool is_on = true;
    double shift =
        0;  ///< Of the scene's origin along the normal: in the solver's axes the plane is so much further.
};

struct UiHotSpot {
    std::string label, unit;  ///< Of the result.
    double value = 0;
    std::optional<double> utilisation;  ///< Of the limit.
    std::int64_t node = 0;
    bool is_chosen = false;
};

struct UiMarker {
    std::string unit;  ///< Of the coloured result, whose value it is.
    double value = std::numeric_limits<double>::quiet_NaN();
    std::optional<std::int64_t> node;
    std::string text;
};

struct UiSound {
    double volume = 0.5;
    bool is_muted = false, is_mono = false;
    std::string trouble;     ///< "no sound device"; empty: none.
    bool is_guided = false;  ///< Ticks lead to the largest value.
};

struct UiTouch {
    double strength = 1;
    bool is_still = false;
    std::string trouble;  ///< "nothing here can shake: ticks stand in".
};

struct UiHeadset {
    std::string what, why, todo;  ///< Of the fault table; all empty: nothing to say.
    bool is_running = false;
};

struct UiFact {
    std::string name, value;
};

struct UiKey {
    std::string shown, text;
};

enum class Theme : std::uint8_t {
    Light,
    Dark,
};

struct UiModel {
    std::string title, solver;  ///< "Boiler", "CalculiX 2.20".
    Theme theme = Theme::Light;
    bool show_help = false;
    std::optional<UiLegend> legend;  ///< Empty: no result is seen.
    std::optional<UiCard> card;      ///< Empty: nothing is pointed at.
    std::vector<UiResult> results;
    UiSteps steps;
    UiDeformation deformation;
    std::vector<UiPart> parts;
    std::vector<UiCut> cuts;
    bool cuts_are_on = true;
    std::string length_unit;
    std::vector<UiHotSpot> hot_spots;
    std::vector<UiMarker> markers;
    bool edges = true, ghost = false;
    UiSound sound;
    UiTouch touch;
    UiHeadset headset;
    std::vector<UiFact> certificate;
    std::vector<UiKey> keys;
    std::string message;  ///< Said for a while at the window's lower edge; empty: nothing.
    std::string trouble;  ///< Stays until it is mended: "Level of detail: the file is cut off".
};

// What the person wants. Nothing changes by itself: the program does it, and the next model shows it.
struct AssignSense {
    std::string key;
    Sense sense = Sense::Colour;
    bool on = true;  ///< False: this sense lets the result go.
};
struct ReleaseAll {
    std::string key;  ///< On the card alone.
};
struct GoToStep {
    std::size_t step = 0;
};
struct SetFactor {
    std::optional<double> factor;  ///< Empty: automatic.
};
struct SetPart {
    std::size_t part = 0;
    PartLook look = PartLook::Shown;
};
struct OnlyPart {
    std::size_t part = 0;
};
struct ShowAllParts {};
struct AddCut {
    glm::vec3 normal{1, 0, 0};  ///< Model axes.
};
struct SetCut {
    std::size_t cut = 0;
    CutPlane plane;
    bool is_on = true;
};
/// Across an axis of the model (0 x, 1 y, 2 z), through its middle.
struct TurnCut {
    std::size_t cut = 0, axis = 0;
};
struct RemoveCut {
    std::size_t cut = 0;
};
struct GoToHotSpot {
    std::size_t spot = 0;
};
struct GoToMarker {
    std::size_t marker = 0;
};
struct RemoveMarker {
    std::size_t marker = 0;
};
/// The camera looks from there: model axes; (1, 1, 1): the view at an angle, (0, 0, 0): the first one.
struct LookFrom {
    glm::vec3 direction{0};
};
struct SetColour {
    ColourEffect colour;
};
struct SetRange {
    std::string key;
    ValueRange range;
};
struct SetRangeMode {
    std::string key, mode;  ///< auto allSteps
};
struct SetLimit {
    std::string key;
    std::optional<double> limit;
    bool is_upper = true;
};
struct SetVolume {
    double volume = 0.5;
};
struct SetMono {
    bool on = false;
};
struct SetStrength {
    double strength = 1;
};
struct SetTheme {
    Theme theme = Theme::Light;
};
struct SetHelp {
    bool on = false;
};
struct ReleasePin {};
struct TryHeadset {};  ///< Look for it again.

using UiWish = std::variant<
    Command,
    AssignSense,
    ReleaseAll,
    GoToStep,
    SetFactor,
    SetPart,
    OnlyPart,
    ShowAllParts,
    AddCut,
    SetCut,
    RemoveCut,
    GoToHotSpot,
    GoToMarker,
    RemoveMarker,
    LookFrom,
    SetColour,
    SetRange,
    SetRangeMode,
    SetLimit,
    SetVolume,
    SetMono,
    SetStrength,
    SetTheme,
    SetHelp,
    ReleasePin,
    TryHeadset,
    TurnCut>;
using UiWishes = std::vector<UiWish>;

}  // namespace feelem::viewer
