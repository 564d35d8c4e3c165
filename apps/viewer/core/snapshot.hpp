// SPDX-License-Identifier: Apache-2.0
// The one truth of a frame: what is pointed at and what it is worth. Number, colour, tone and pulse are all
// made from it, and it is what a recording keeps, so the senses cannot disagree.
#pragma once

#include "viewer/core/look.hpp"
#include "viewer/core/senses.hpp"

#include "feelem/present.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

/// One result of the presentation at the place.
struct Reading {
    std::string key;  ///< PresentedResult::key.
    FieldChoice field;
    double value = 0;                 ///< Barycentric on the full triangle, computed in double; NaN: missing.
    std::optional<float> node_value;  ///< The solver's at the nearest node, bit for bit.
    std::string_view state;           ///< solver interpolated missing, as ProbedValue::state.
    Normalised at;
    bool beyond_limit = false;
};

struct Probed {
    std::size_t part = 0;
    std::uint32_t triangle = 0;  ///< Of the part's full list.
    std::array<double, 3> weights{};
    glm::vec3 world{0}, normal{0, 1, 0};  ///< Place on the drawn (deformed) shape, metres.
    std::array<double, 3> model{};        ///< The same place undeformed, model units with the origin.
    std::int64_t element_id = 0;
    std::optional<std::int64_t> node_id;  ///< Nearest corner that has a node.
    std::vector<Reading> readings;        ///< In the order of the presentation's results.
};

/// Who points: the mouse, or a hand.
enum class Pointer : std::uint8_t {
    Mouse,
    Left,
    Right,
    Pin,
};
std::string_view word(Pointer pointer);  ///< "mouse"

struct Snapshot {
    std::uint64_t frame = 0;
    double time = 0;
    std::optional<Pointer> pointer;  ///< The one that counts, of those on the model.
    bool is_held = false;            ///< Hear and feel is asked for.
    std::optional<Probed> probed;
    std::optional<Rgb> colour;                             ///< Of the coloured result at the place.
    std::optional<SoundFrame> sound;                       ///< Empty: silence.
    std::array<std::optional<HapticFrame>, kSides> touch;  ///< Empty: that hand is left in peace.
    std::vector<SenseEvent> events;                        ///< Of this frame.
};

}  // namespace feelem::viewer
