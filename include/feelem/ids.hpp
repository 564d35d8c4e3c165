// SPDX-License-Identifier: Apache-2.0
// Solver ids and our own indices: distinct types, so that the compiler keeps them apart.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

namespace feelem {

enum class NodeId : std::int64_t {
};  ///< Number in the solver's file.
enum class ElementId : std::int64_t {
};
enum class NodeIndex : std::uint32_t {
};  ///< Dense position in Mesh::node_ids, from 0.
enum class ElementIndex : std::uint32_t {
};  ///< Dense position over all blocks of a Mesh, from 0.
enum class PartIndex : std::uint32_t {
};  ///< Position in Mesh::parts.
enum class VertexIndex : std::uint32_t {
};  ///< Position in Surface's vertex arrays.

/// A mid-side node that the solver left out, or a vertex that no node stands behind.
inline constexpr NodeIndex kNoNode{std::numeric_limits<std::uint32_t>::max()};
inline constexpr ElementIndex kNoElement{std::numeric_limits<std::uint32_t>::max()};

/// The number behind an id or index.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr std::underlying_type_t<Enum> raw(Enum value) noexcept {
    return static_cast<std::underlying_type_t<Enum>>(value);
}

}  // namespace feelem
