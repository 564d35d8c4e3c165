// SPDX-License-Identifier: Apache-2.0
// Value -> colour, tone, tick, pulse (docs/effects.md), and the presentation: which result drives which.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

enum class Scale : std::uint8_t {
    Linear,
    Log,
    Signed,
    SymLog
};

/// One range a result, shared by all its effects, so that the senses cannot disagree.
struct ValueRange {
    double lo = 0;
    double hi = 1;
    Scale scale = Scale::Linear;
};

/// Position of a value in a range. `u` is clamped to 0..1; NaN in: `missing`. A range without width puts its
/// one value in the middle. Scale::Log over a range that reaches zero is taken as SymLog.
struct Normalised {
    double u = 0;
    double position = 0;  ///< On the colour map: u, but for Scale::Signed (0 -> 0.5, range symmetric).
    double sign = 1;      ///< Of the value, for Scale::Signed.
    bool below = false, above = false, missing = false;
};
Normalised normalise(double value, const ValueRange& range);

using Rgb = std::array<std::uint8_t, 3>;

/// Names of the colour maps, default first: batlow viridis cividis turbo ansys_rainbow cool_warm.
std::span<const std::string_view> colour_maps();
/// sRGB of a map at t in 0..1: linear between the map's rows. Throws Error(UnknownName).
Rgb map_colour(std::string_view map, double t);
/// Which of `bands` equal bands t lies in: 0..bands-1.
int band_of(double t, int bands);

struct ColourEffect {
    std::string map = "batlow";
    int bands = 9;  ///< 0: continuous.
    bool invert = false;
    Rgb above{255, 0, 255}, below{255, 255, 0}, missing{128, 128, 128};
    friend bool operator==(const ColourEffect&, const ColourEffect&) = default;
};
/// The effect's colour at t in 0..1 of the range: bands and inversion applied. Outer bands take the map's
/// ends.
Rgb palette_colour(double t, const ColourEffect& effect);
Rgb colour_of(double value, const ValueRange& range, const ColourEffect& effect);

enum class Quantise : std::uint8_t {
    None,
    Semitone,
    Pentatonic
};
struct PitchEffect {
    double midi_low = 48, midi_high = 84;
    double gamma = 1;
    bool invert = false;
    Quantise quantise = Quantise::None;
    bool sign_timbre = true;  ///< Negative values of Scale::Signed sound hollow.
    friend bool operator==(const PitchEffect&, const PitchEffect&) = default;
};
/// Amplitudes of the harmonics 1..4 of the tone, and of the hollow tone of negative values.
inline constexpr std::array<double, 4> kTonePartials{1, 0.5, 0.25, 0.125};
inline constexpr std::array<double, 4> kNegativePartials{1, 0, 0.45, 0};
struct Tone {
    double hz = 0;
    double gain = 0;        ///< Equal-loudness gain g(f), 0..1; 0: silent (missing).
    bool negative = false;  ///< Use kNegativePartials.
};
Tone tone_of(double value, const ValueRange& range, const PitchEffect& effect);

struct TickEffect {
    double rate_low = 1.5, rate_high = 12;  ///< Hz
    bool invert = false;
    friend bool operator==(const TickEffect&, const TickEffect&) = default;
};
/// Ticks a second; 0 when missing.
double tick_rate_of(double value, const ValueRange& range, const TickEffect& effect);

struct PulseEffect {
    double rate_low = 2, rate_high = 10;  ///< Hz
    double amplitude_min = 0.15;
    double milliseconds = 35;
    bool invert = false;
    friend bool operator==(const PulseEffect&, const PulseEffect&) = default;
};
struct Pulse {
    double rate = 0;       ///< Hz; 0 when missing.
    double amplitude = 0;  ///< 0..1
};
Pulse pulse_of(double value, const ValueRange& range, const PulseEffect& effect);

/// What the presentation (docs/effects.md) says of a result. Numbers are in the result's unit.
struct PresentedResult {
    std::string key{};   ///< "T"
    std::string name{};  ///< "temperature"
    std::string component = "value";
    std::string location = "nodal";
    std::string averaging{};  ///< Empty: not said.
    std::string layer{};      ///< top middle bottom; empty: not said.
    std::string unit{};
    std::string range_mode = "auto";   ///< auto allSteps percentile manual
    std::optional<double> lo{}, hi{};  ///< Set by the user (manual) or by the converter.
    Scale scale = Scale::Linear;
    bool symmetric = false;  ///< lo = -hi, made by the converter.
    std::array<double, 2> percentile{0.5, 99.5};
    std::optional<double> limit{};
    bool limit_is_upper = true;  ///< Alarm above the limit, else below.
    std::string limit_label{};
    friend bool operator==(const PresentedResult&, const PresentedResult&) = default;
};

/// What an effect drives. Each slot has room for one result.
enum class Sense : std::uint8_t {
    Colour,
    Pitch,
    Ticks,
    Pulses,
    Shape
};
/// Only the member that `sense` names means anything; `ticks` of a pulse effect is its fallback.
struct PresentedEffect {
    std::string result{};  ///< A PresentedResult's key.
    Sense sense = Sense::Colour;
    ColourEffect colour{};
    PitchEffect pitch{};
    TickEffect ticks{};
    PulseEffect pulses{};
    bool falls_back_to_ticks = true;  ///< Sense::Pulses, where there is no actuator.
    friend bool operator==(const PresentedEffect&, const PresentedEffect&) = default;
};

struct Presentation {
    std::string title;
    std::vector<PresentedResult> results;
    std::vector<PresentedEffect> effects;
    std::vector<std::string> card;             ///< Keys in the order of the probe card; empty: all results.
    std::string deformation_result;            ///< Key; empty: none.
    std::optional<double> deformation_factor;  ///< Empty: 5 % of the largest side.
    std::optional<std::array<int, 3>> step;    ///< input, step, substep
    std::string json;  ///< The document it was read from: unknown keys survive a round trip.
};

/// Throws Error(BadPresentation) with the path of the key: "effects[1].result: no result has the key 'X'".
Presentation parse_presentation(std::string_view json, std::string_view name);
/// The document `presentation.json` with what has changed since put in; a full one where there is none.
std::string presentation_json(const Presentation& presentation);
/// The range as the mappings take it; lo and hi must be set.
ValueRange value_range(const PresentedResult& result);

/// One result that could be shown, for the automatic choice.
struct Candidate {
    std::string name{};       ///< "temperature"
    std::string component{};  ///< "value", "magnitude", "von_mises"
    std::string unit{};
    bool has_sign = false;     ///< Values on both sides of zero.
    bool mostly_zero = false;  ///< More than half of the values are exactly zero.
};
/// docs/effects.md 7: effects for the 1 to 4 most telling candidates; displacement also drives the shape.
Presentation choose_presentation(std::span<const Candidate> candidates, std::string_view title);

/// 0.05 x largest side / largest displacement (docs/effects.md 6); 0 when there is no displacement.
double automatic_deformation_factor(double largest_side, double largest_displacement);

}  // namespace feelem
