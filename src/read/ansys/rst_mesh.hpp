// SPDX-License-Identifier: Apache-2.0
// Nodes, elements, types and components of a result file.
#pragma once

#include "read/ansys/ansys_elements.hpp"
#include "read/ansys/rst_header.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::rst {

struct ElementKindOfFile {
    std::int32_t routine = 0;  ///< 186: SOLID186.
    std::array<std::int32_t, 12> keyopts{};
    std::size_t result_nodes = 0;  ///< Corner nodes, those that have stresses.
    std::optional<ansys::ElementName> name;

    std::int32_t keyopt(std::size_t number) const { return keyopts[number - 1]; }
};

/// An element as it stands in the file.
struct FileElement {
    ElementId id{};
    std::uint32_t kind = 0;   ///< Into FileMesh::kinds.
    std::uint32_t place = 0;  ///< Among all elements of the file, drawn or not: where its results are.
    std::uint32_t first_corner = 0;
    std::uint32_t corner_count = 0;
    ElementIndex index = kNoElement;  ///< In the mesh; kNoElement when it is not drawn.
};

struct FileMesh {
    Mesh mesh;
    std::vector<ElementKindOfFile> kinds;
    std::vector<FileElement> elements;  ///< Drawn ones, in the file's order.
    std::size_t element_count = 0;      ///< All elements of the file.
    std::vector<NodeIndex> corners;     ///< In the file's order, repeats included; only of drawn elements.
};

/// Throws Error when the file ends early or contradicts itself.
FileMesh read_file_mesh(const Records& records, const ResultHeader& header, Diagnostics& diagnostics);

}  // namespace feelem::rst
