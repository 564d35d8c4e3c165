// SPDX-License-Identifier: Apache-2.0
// What every viewer must agree on: tests/contract/senses.json, made here, checked by the page's tests too.
// FEELEM_UPDATE_GOLDEN=1 writes it anew; the difference is then for people to judge.
#include "support/paths.hpp"

#include "feelem/present.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace feelem {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 4> kScaleNames{"linear", "log", "signed", "symlog"};
constexpr std::array<std::string_view, 3> kQuantiseNames{"none", "semitone", "pentatonic"};

std::string number(double value) {
    return std::isnan(value) ? "null" : fmt::format("{}", value);
}

std::string input(double value, const ValueRange& range) {
    return fmt::format(
        R"("value": {}, "range": {{"lo": {}, "hi": {}, "scale": "{}"}})",
        number(value),
        number(range.lo),
        number(range.hi),
        kScaleNames.at(static_cast<std::size_t>(range.scale))
    );
}

/// A range and values worth trying in it: ends, neighbours of the ends, inside, outside, missing.
struct Trial {
    ValueRange range;
    std::vector<double> values;
};
std::vector<Trial> trials() {
    const double tiny = std::numeric_limits<float>::denorm_min();
    return {
        {{150, 200, Scale::Linear},
         {150, 200, 150.000001, 149.99999, 200.00001, 162.5, 187.3, 171.94, 0, -40, 1e300, kNaN}},
        {{-3.25e-5, 4.125e-4, Scale::Linear}, {-3.25e-5, 0, 1e-5, 1.9e-4, 4.125e-4, 4.2e-4, kNaN}},
        {{7, 7, Scale::Linear}, {7, 6, 8, kNaN}},
        {{0, 0, Scale::SymLog}, {0, 1, -1}},
        {{0.01, 1000, Scale::Log}, {0.01, 0.02, 1, 31.6, 999, 1000, 1001, 0, -5, tiny, kNaN}},
        {{0, 250, Scale::Log}, {0, 0.01, 0.25, 1, 120, 250, 251}},
        {{-80, 200, Scale::Signed}, {-250, -200, -80, -1e-9, 0, 33.5, 120, 200, 201, kNaN}},
        {{-200, 200, Scale::SymLog}, {-201, -200, -10, -0.1, 0, 0.1, 0.2, 77, 200}},
        {{0, 1, Scale::Linear}, {0.0625, 0.111, 0.25, 0.333, 0.5, 0.6, 0.75, 0.9, 0.99, 1}},
    };
}

template <class Line>
std::string section(std::string_view name, Line line) {
    std::string text = fmt::format("  \"{}\": [\n", name);
    std::string_view comma;
    for (const Trial& trial : trials()) {
        for (const double value : trial.values) {
            for (const std::string& item : line(value, trial.range)) {
                text += fmt::format("{}    {{{}, {}}}", comma, input(value, trial.range), item);
                comma = ",\n";
            }
        }
    }
    return text + "\n  ]";
}

using Lines = std::vector<std::string>;

Lines normalise_lines(double value, const ValueRange& range) {
    const Normalised n = normalise(value, range);
    return {fmt::format(
        R"("u": {}, "position": {}, "sign": {}, "below": {}, "above": {}, "missing": {})",
        number(n.u),
        number(n.position),
        n.sign,
        n.below,
        n.above,
        n.missing
    )};
}

Lines colour_lines(double value, const ValueRange& range) {
    Lines lines;
    const std::array<std::pair<int, bool>, 4> styles{{{9, false}, {0, false}, {11, true}, {0, true}}};
    for (const std::string_view map : colour_maps()) {
        if (map != "batlow" && range.hi != 1) {
            continue;  // One range shows every map.
        }
        for (const auto& [bands, invert] : styles) {
            const ColourEffect effect{.map = std::string(map), .bands = bands, .invert = invert};
            const Rgb rgb = colour_of(value, range, effect);
            lines.push_back(fmt::format(
                R"("map": "{}", "bands": {}, "invert": {}, "colour": [{}, {}, {}])",
                map,
                bands,
                invert,
                rgb[0],
                rgb[1],
                rgb[2]
            ));
        }
    }
    return lines;
}

Lines tone_lines(double value, const ValueRange& range) {
    Lines lines;
    const std::array<PitchEffect, 5> effects{{
        {},
        {.invert = true},
        {.midi_low = 36, .midi_high = 96, .gamma = 2, .quantise = Quantise::Semitone},
        {.midi_low = 67, .midi_high = 84, .gamma = 0.5, .quantise = Quantise::Pentatonic},
        {.sign_timbre = false},
    }};
    for (const PitchEffect& e : effects) {
        const Tone tone = tone_of(value, range, e);
        lines.push_back(fmt::format(
            R"("midi": [{}, {}], "gamma": {}, "invert": {}, "quantise": "{}", "signTimbre": {}, )"
            R"("hz": {}, "gain": {}, "negative": {})",
            e.midi_low,
            e.midi_high,
            e.gamma,
            e.invert,
            kQuantiseNames.at(static_cast<std::size_t>(e.quantise)),
            e.sign_timbre,
            number(tone.hz),
            number(tone.gain),
            tone.negative
        ));
    }
    return lines;
}

Lines tick_lines(double value, const ValueRange& range) {
    Lines lines;
    for (const TickEffect& e : {TickEffect{}, TickEffect{.rate_low = 2, .rate_high = 8, .invert = true}}) {
        lines.push_back(fmt::format(
            R"("rateHz": [{}, {}], "invert": {}, "tickRate": {})",
            e.rate_low,
            e.rate_high,
            e.invert,
            number(tick_rate_of(value, range, e))
        ));
    }
    return lines;
}

Lines pulse_lines(double value, const ValueRange& range) {
    Lines lines;
    for (const PulseEffect& e :
         {PulseEffect{}, PulseEffect{.rate_low = 1, .rate_high = 6, .amplitude_min = 0.3, .invert = true}}) {
        const Pulse pulse = pulse_of(value, range, e);
        lines.push_back(fmt::format(
            R"("rateHz": [{}, {}], "ampMin": {}, "invert": {}, "rate": {}, "amplitude": {})",
            e.rate_low,
            e.rate_high,
            e.amplitude_min,
            e.invert,
            number(pulse.rate),
            number(pulse.amplitude)
        ));
    }
    return lines;
}

std::string deformation_section() {
    std::string text = "  \"deformation\": [\n";
    const std::array<std::array<double, 2>, 4> cases{{{1000, 2}, {1240.5, 0.0371}, {5, 0}, {0, 3}}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        text += fmt::format(
            "    {{\"largestSide\": {}, \"largestDisplacement\": {}, \"factor\": {}}}{}\n",
            number(cases[i][0]),
            number(cases[i][1]),
            number(automatic_deformation_factor(cases[i][0], cases[i][1])),
            i + 1 < cases.size() ? "," : ""
        );
    }
    return text + "  ]";
}

std::string contract() {
    return fmt::format(
        "{{\n  \"about\": \"value -> what is seen, heard and felt; null is no "
        "value\",\n{},\n{},\n{},\n{},\n{},\n{}\n}}\n",
        section("normalise", normalise_lines),
        section("colour", colour_lines),
        section("tone", tone_lines),
        section("ticks", tick_lines),
        section("pulses", pulse_lines),
        deformation_section()
    );
}

/// Numbers agree to 1e-12, all else exactly: the last digit of a power is the mathematics library's own.
void expect_same(const std::string& found, const std::string& expected) {
    const char* a = found.c_str();
    const char* b = expected.c_str();
    while (*a != '\0' && *b != '\0') {
        const bool numeric = std::isdigit(static_cast<unsigned char>(*a)) != 0;
        if (numeric && std::isdigit(static_cast<unsigned char>(*b)) != 0) {
            char* a_end = nullptr;
            char* b_end = nullptr;
            const double x = std::strtod(a, &a_end);
            const double y = std::strtod(b, &b_end);
            ASSERT_LE(std::abs(x - y), 1e-12 * std::abs(y))
                << "at byte " << b - expected.c_str() << " of the file";
            a = a_end;
            b = b_end;
        } else {
            ASSERT_EQ(*a, *b) << std::string(
                a, std::min<std::size_t>(200, std::char_traits<char>::length(a))
            );
            ++a;
            ++b;
        }
    }
    EXPECT_EQ(*a, *b) << "one is longer than the other";
}

constexpr std::array<std::string_view, 5> kSlotNames{"colour", "pitch", "ticks", "pulses", "shape"};

std::string choice_line(std::span<const Candidate> candidates) {
    const Presentation p = choose_presentation(candidates, "");
    std::string offered, results, effects;
    for (const Candidate& c : candidates) {
        offered += fmt::format(
            R"({}{{"name": "{}", "component": "{}", "hasSign": {}, "mostlyZero": {}}})",
            offered.empty() ? "" : ", ",
            c.name,
            c.component,
            c.has_sign,
            c.mostly_zero
        );
    }
    for (const PresentedResult& r : p.results) {
        results += fmt::format(
            R"({}{{"key": "{}", "name": "{}", "component": "{}", "rangeMode": "{}", "scale": "{}"}})",
            results.empty() ? "" : ", ",
            r.key,
            r.name,
            r.component,
            r.range_mode,
            kScaleNames.at(static_cast<std::size_t>(r.scale))
        );
    }
    for (const PresentedEffect& e : p.effects) {
        effects += fmt::format(
            R"({}{{"result": "{}", "slot": "{}", "map": "{}", "invert": {}}})",
            effects.empty() ? "" : ", ",
            e.result,
            kSlotNames.at(static_cast<std::size_t>(e.sense)),
            e.sense == Sense::Colour ? e.colour.map : "",
            e.sense == Sense::Colour  ? e.colour.invert
            : e.sense == Sense::Ticks ? e.ticks.invert
                                      : e.sense == Sense::Pulses && e.pulses.invert
        );
    }
    return fmt::format(
        "  {{\"candidates\": [{}],\n   \"results\": [{}],\n   \"effects\": [{}],\n   \"deformation\": "
        "\"{}\"}}",
        offered,
        results,
        effects,
        p.deformation_result
    );
}

/// The cases of the paper, then many mixtures.
std::string choice_contract() {
    const Candidate temperature{.name = "temperature", .component = "value"};
    const Candidate displacement{.name = "displacement", .component = "magnitude"};
    const Candidate stress{.name = "stress", .component = "von_mises"};
    std::string text = "[\n" + choice_line(std::vector<Candidate>{});
    for (const auto& offered : {
             std::vector{temperature},
             std::vector{displacement},
             std::vector{stress},
             std::vector{temperature, displacement},
             std::vector{displacement, stress},
             std::vector{temperature, stress},
             std::vector{temperature, displacement, stress},
         }) {
        text += ",\n" + choice_line(offered);
    }
    const std::array<std::string_view, 16> names{
        "temperature",
        "displacement",
        "stress",
        "heat_flux",
        "pressure",
        "velocity",
        "plastic_strain",
        "strain",
        "my_own",
        "safety_factor",
        "part_id",
        "damage",
        "acceleration",
        "temperature@b.frd",
        "Ünit",
        "contact_pressure"};
    const std::array<std::string_view, 7> components{
        "value", "magnitude", "von_mises", "xx", "equivalent", "principal_1", "x"};
    std::uint32_t state = 1;
    const auto random = [&](std::size_t below) {
        state = state * 1664525 + 1013904223;
        return static_cast<std::size_t>(state >> 8U) % below;
    };
    for (int i = 0; i < 100; ++i) {
        std::vector<Candidate> offered(1 + random(6));
        for (Candidate& c : offered) {
            c.name = names.at(random(names.size()));
            c.component = components.at(random(components.size()));
            c.has_sign = random(3) == 0;
            c.mostly_zero = random(5) == 0;
        }
        text += ",\n" + choice_line(offered);
    }
    return text + "\n]\n";
}

TEST(Contract, automatic_choice_is_what_every_viewer_agreed_on) {
    const std::string path = test::project_file("tests/contract/choose.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        test::write_file(path, choice_contract());
    }

    EXPECT_EQ(choice_contract(), test::read_file(path));
}

TEST(Contract, values_map_to_what_every_viewer_agreed_on) {
    const std::string path = test::project_file("tests/contract/senses.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        test::write_file(path, contract());
    }

    expect_same(contract(), test::read_file(path));
}

}  // namespace
}  // namespace feelem
