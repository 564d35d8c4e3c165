// SPDX-License-Identifier: Apache-2.0
// The shaders of one eye, in GLSL: twins of web/src/render/shaders.ts where the page has the same.
#pragma once

#include "viewer/render/programs.hpp"

namespace feelem::viewer {

ProgramText skin_text();   ///< Triangles by their values.
ProgramText cap_text();    ///< Cut material.
ProgramText edge_text();   ///< Lines of the model.
ProgramText mark_text();   ///< Dots, rings and lines in the room.
ProgramText label_text();  ///< Letters from the atlas, and plates behind them.
ProgramText panel_text();  ///< A texture in the room.
ProgramText floor_text();

/// Attributes of the skin and of edges.
enum Attribute : GLuint {
    kPosition,
    kNormal,
    kValue,
    kMissing,
    kDisplacement,
    kDisplacementIm,
    kPartLow,    ///< One a part: xyz where its box begins, w: encloses a volume.
    kPartSize,   ///< One a part: what a coordinate is multiplied with.
    kMovedWith,  ///< Of an edge: the vertex whose displacement it takes.
};

}  // namespace feelem::viewer
