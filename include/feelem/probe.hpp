// SPDX-License-Identifier: Apache-2.0
// What a scene says at one place: every value there, and what it looks, sounds and feels like.
#pragma once

#include "feelem/scene.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// Exactly one of them. Positions are in model units and axes, undeformed.
struct ProbeQuery {
    std::optional<std::int64_t> node;
    std::optional<Point3> point;               ///< The nearest place on the skin.
    std::optional<std::array<double, 6>> ray;  ///< Origin and direction.
    /// As --steps: "all", "last", "1.3" ...: a place for each of them. Empty: the step that the scene shows
    /// first.
    std::string steps{};
};

/// One component of a result at a place.
struct ProbedValue {
    std::string key;  ///< Of the presentation; the scene result's id where the presentation has none.
    std::string name, component, unit;
    std::optional<double> value;      ///< Barycentric on the drawn triangle.
    std::optional<float> node_value;  ///< The scene's at the nearest node, bit for bit.
    std::optional<std::int64_t> node_id;
    std::string_view state;  ///< solver interpolated missing
    double bound = 0;        ///< SceneResult::bound: what a compressed scene may have changed.
};

/// As the page's lastProbe(). Senses that the presentation does not use are empty.
struct ProbedPlace {
    Point3 point{};
    std::string part;
    std::int64_t element_id = 0;
    std::optional<std::int64_t> node_id;  ///< Corner of the largest weight, the smallest id on a tie.
    double distance = 0;                  ///< Along the ray, or from the point asked for.
    std::optional<Step> step;             ///< That of the values.
    std::vector<ProbedValue> results;
    std::optional<Rgb> colour;
    std::optional<Tone> tone;
    std::optional<double> tick_rate;
    std::optional<Pulse> pulse;
};

/// A node may be in several parts, each with its own values: one place a part. Else one place, or none when
/// the ray meets nothing. All places of a step, then those of the next. Throws Error(UnknownName) for a node
/// that is not on the skin and for a step that is not in the scene.
std::vector<ProbedPlace> probe(const Scene& scene, const ProbeQuery& query);

/// The first place with the keys of lastProbe(), the others under "others"; null when there is none.
std::string probe_json(const std::vector<ProbedPlace>& places);

/// `feelem check --json`.
std::string claims_json(const std::vector<Claim>& claims);

}  // namespace feelem
