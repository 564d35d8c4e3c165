// SPDX-License-Identifier: Apache-2.0
// How the model is drawn: plain data, made by core, read by render. Nothing here knows a graphics library.
#pragma once

#include "viewer/core/space.hpp"

#include "feelem/present.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::viewer {

/// One component of a result at a step: Scene::results[result], its values[values], its
/// components[component].
struct FieldChoice {
    std::size_t result = 0, values = 0, component = 0;
    friend bool operator==(const FieldChoice&, const FieldChoice&) = default;
};

enum class PartLook : std::uint8_t {
    Shown,
    Clear,  ///< Seen through, not pointed at.
    Hidden,
};

/// What lies on the side that the normal points to is cut away. Model units minus the scene's origin.
struct CutPlane {
    glm::vec3 normal{1, 0, 0};
    float offset = 0;
};
inline constexpr std::size_t kMostCuts = 3;

struct Shape {
    FieldChoice field;                     ///< `component` means nothing: all three are taken.
    std::optional<FieldChoice> imaginary;  ///< Of a complex mode.
    float factor = 0, imaginary_factor = 0;
};

struct Look {
    std::optional<FieldChoice> field;  ///< Empty: plain grey.
    ValueRange range;
    ColourEffect colour;
    float shade_floor = 0.75F;  ///< Share of the light that a place seen edge-on keeps.
    std::optional<double> limit;
    bool isolines = false;
    bool edges = true;
    bool ghost = false;  ///< The undeformed shape's edges beside a deformed one.
    std::optional<Shape> shape;
    std::vector<PartLook> parts;       ///< Per part of the scene; empty: all shown.
    std::vector<CutPlane> cuts;        ///< At most kMostCuts.
    std::optional<std::size_t> level;  ///< Of detail: into Scene::levels; empty: the full triangles.
    glm::mat4 model_to_world{1};  ///< Model units minus origin -> metres of the world, placement included.
};

/// A text that floats at a place and always faces the eye.
struct Label {
    glm::vec3 place{0};  ///< World, metres.
    std::string text;
    Rgb colour{255, 255, 255};
    float height =
        0.012F;  ///< Of a capital letter, metres, at any distance up to 1 m; beyond, it keeps its angle.
};

/// A mark, such as the reticle, a pin, or a pointer's ray.
struct Mark {
    enum class Kind : std::uint8_t {
        Dot,
        Ring,
        Line,
    } kind = Kind::Dot;
    glm::vec3 from{0}, to{0};  ///< Dot and Ring: `to` is the surface's normal (unit).
    float size = 0.005F;       ///< Radius or width, metres.
    Rgb colour{255, 255, 255};
};

}  // namespace feelem::viewer
