// SPDX-License-Identifier: Apache-2.0
// Plain output formats for other programs: the skin as .ply, the whole mesh as .vtu.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"
#include "feelem/surface.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

struct WriteFormatInfo {
    std::string_view id;  ///< "ply"
    std::string_view title;
    std::string_view suffix;  ///< ".ply"
};
std::vector<WriteFormatInfo> write_formats();

/// A field with the names its components get in the file.
struct NamedField {
    std::string name;  ///< "displacement"
    std::vector<std::string> components;
    SurfaceField field;
};
/// ASCII, positions as double in model units, one float property a component, node_id, element_id; the step
/// of the fields, when it is known, as a comment. Atomic.
void write_ply(
    const std::string& path,
    const Mesh& mesh,
    const Surface& surface,
    std::span<const NamedField> fields,
    const Step* step = nullptr
);

/// All elements in VTK's order with the results given (any location; averaged ones as point data), arrays
/// NodeId, ElementId, Part; the step of the results, when it is known, as the field data TimeValue (its
/// value: time, Hz or load factor), StepNumber (step, substep) and StepKind. Appended raw, little-endian.
/// Atomic.
void write_vtu(
    const std::string& path, const Mesh& mesh, std::span<const Result> results, const Step* step = nullptr
);

}  // namespace feelem
