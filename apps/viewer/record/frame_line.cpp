// SPDX-License-Identifier: Apache-2.0
// Written by hand: the same frame is the same bytes, keys in the order of docs/recording.md.
#include "viewer/record/frame_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace feelem::viewer {

namespace {

constexpr std::array<std::string_view, kSides> kSideWords{"left", "right"};

/// Shortest text that reads back to the same bits.
template <class Number>
std::string digits(Number value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string list(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", digits(v.x), digits(v.y), digits(v.z));
}

std::string list(const std::array<double, 3>& v) {
    return fmt::format("[{}, {}, {}]", digits(v[0]), digits(v[1]), digits(v[2]));
}

std::string pose_text(const Pose& pose) {
    const glm::quat& q = pose.orientation;
    return fmt::format(
        R"({{"position": {}, "orientation": [{}, {}, {}, {}]}})",
        list(pose.position),
        digits(q.x),
        digits(q.y),
        digits(q.z),
        digits(q.w)
    );
}

std::string hand_text(const HandInput& hand, std::size_t side) {
    std::string text = fmt::format(
        R"({{"side": "{}", "bare": {}, "aim": {}, "grip": {}, "trigger": {}, "squeeze": {}, "stick": [{}, {}])",
        kSideWords[side],
        hand.is_bare,
        pose_text(hand.aim),
        pose_text(hand.grip),
        digits(hand.trigger),
        digits(hand.squeeze),
        digits(hand.stick.x),
        digits(hand.stick.y)
    );
    if (hand.fingertip) text += fmt::format(R"(, "fingertip": {})", list(*hand.fingertip));
    return text + "}";
}

std::string reading_text(const Reading& reading) {
    std::string text = fmt::format(
        R"({{"key": {}, "value": {}, "state": {}, "u": {}, "beyondLimit": {})",
        json_text(reading.key),
        digits(reading.value),
        json_text(reading.state),
        reading.at.missing ? "null" : digits(reading.at.u),
        reading.beyond_limit
    );
    if (reading.node_value) text += fmt::format(R"(, "nodeValue": {})", digits(*reading.node_value));
    return text + "}";
}

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
    std::string all = "[";
    std::string_view comma;
    for (const auto& item : items) {
        all += fmt::format("{}{}", comma, text(item));
        comma = ", ";
    }
    return all + "]";
}

std::string probed_text(const Probed& probed) {
    return fmt::format(
        R"({{"part": {}, "triangle": {}, "weights": {}, "element": {}, "node": {}, "world": {}, "normal": {}, )"
        R"("model": {}, "readings": {}}})",
        probed.part,
        probed.triangle,
        list(probed.weights),
        probed.element_id,
        probed.node_id ? fmt::format("{}", *probed.node_id) : "null",
        list(probed.world),
        list(probed.normal),
        list(probed.model),
        listed(probed.readings, reading_text)
    );
}

std::string sound_text(const SoundFrame& sound) {
    return fmt::format(
        R"({{"hz": {}, "gain": {}, "negative": {}, "tickRate": {}, "source": {}, "tremolo": {}, "dull": {}, "still": {}}})",
        digits(sound.hz),
        digits(sound.gain),
        sound.negative,
        digits(sound.tick_rate),
        list(sound.source),
        sound.tremolo,
        sound.dull,
        sound.still
    );
}

std::string touch_text(const HapticFrame& touch, std::size_t side) {
    return fmt::format(
        R"({{"side": "{}", "rate": {}, "amplitude": {}, "milliseconds": {}, "alarm": {}, "still": {}}})",
        kSideWords[side],
        digits(touch.rate),
        digits(touch.amplitude),
        digits(touch.milliseconds),
        touch.alarm,
        touch.still
    );
}

std::string pulse_text(const SentPulse& pulse) {
    return fmt::format(
        R"({{"side": "{}", "time": {}, "strength": {}, "milliseconds": {}, "cause": "{}"}})",
        kSideWords[static_cast<std::size_t>(pulse.side)],
        digits(pulse.time),
        digits(pulse.strength),
        digits(pulse.milliseconds),
        pulse.event ? word(*pulse.event) : "beat"
    );
}

void add_input(std::string& text, const FrameInput& input) {
    text += fmt::format(
        R"("focused": {}, "headset": {}, "head": {})",
        input.is_focused,
        input.is_headset,
        pose_text(input.head)
    );
    std::vector<std::string> hands;
    for (std::size_t side = 0; side < kSides; ++side) {
        if (input.hands[side].is_tracked) hands.push_back(hand_text(input.hands[side], side));
    }
    const auto itself = [](const std::string& item) { return item; };
    if (!hands.empty()) text += fmt::format(R"(, "hands": {})", listed(hands, itself));
    if (const std::optional<Ray>& ray = input.pointer.ray) {
        text += fmt::format(
            R"(, "mouse": {{"origin": {}, "direction": {}, "pressed": {}}})",
            list(ray->origin),
            list(ray->direction),
            input.pointer.primary
        );
    }
}

void add_senses(std::string& text, const Snapshot& snapshot, std::span<const SentPulse> pulses) {
    if (snapshot.colour) {
        const Rgb& c = *snapshot.colour;
        text += fmt::format(R"(, "colour": [{}, {}, {}])", c[0], c[1], c[2]);
    }
    if (snapshot.sound) text += fmt::format(R"(, "sound": {})", sound_text(*snapshot.sound));
    std::vector<std::string> touched;
    for (std::size_t side = 0; side < kSides; ++side) {
        if (snapshot.touch[side]) touched.push_back(touch_text(*snapshot.touch[side], side));
    }
    const auto itself = [](const std::string& item) { return item; };
    const auto event_text = [](SenseEvent event) { return fmt::format("\"{}\"", word(event)); };
    if (!touched.empty()) text += fmt::format(R"(, "touch": {})", listed(touched, itself));
    if (!snapshot.events.empty())
        text += fmt::format(R"(, "events": {})", listed(snapshot.events, event_text));
    if (!pulses.empty()) text += fmt::format(R"(, "pulses": {})", listed(pulses, pulse_text));
}

}  // namespace

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 0x20) {
            fmt::format_to(std::back_inserter(out), "\\u{:04x}", byte);
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string frame_line(const FrameInput& input, const Snapshot& snapshot, std::span<const SentPulse> pulses) {
    std::string text = fmt::format(R"({{"frame": {}, "time": {}, )", snapshot.frame, digits(snapshot.time));
    add_input(text, input);
    if (snapshot.pointer) text += fmt::format(R"(, "pointer": "{}")", word(*snapshot.pointer));
    if (snapshot.is_held) text += R"(, "held": true)";
    if (snapshot.probed) text += fmt::format(R"(, "probed": {})", probed_text(*snapshot.probed));
    add_senses(text, snapshot, pulses);
    return text + "}";
}

}  // namespace feelem::viewer
