// SPDX-License-Identifier: Apache-2.0
// Which clusters are worth sending, as commands for the card. No OpenGL.
#pragma once

#include "viewer/core/look.hpp"
#include "viewer/render/clusters.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem::viewer {

/// As glMultiDrawElementsIndirect reads it.
struct DrawCommand {
    std::uint32_t count = 0, instances = 1, first = 0;
    std::int32_t base_vertex = 0;
    std::uint32_t part = 0;  ///< Base instance: what is one a part is taken from there.
};

struct VisibleQuestion {
    std::span<const Cluster> clusters{};
    std::span<const ClusterMove> moves{}, moves_im{};  ///< Empty: the shape is at rest.
    float factor = 0, factor_im = 0;
    std::span<const SeenFrom> eyes{};
    std::span<const PartLook> parts{};  ///< Empty: all are shown.
    PartLook wanted = PartLook::Shown;
    const std::vector<bool>* solid = nullptr;  ///< Given: parts that are not solid are left out.
    bool is_culled = true;                     ///< What is out of sight is left out.
    bool hides_backs = false;                  ///< And what turns its back.
    std::uint32_t instances = 1;
};
struct Visible {
    std::vector<DrawCommand> commands;  ///< Neighbours are one.
    std::uint64_t triangles = 0, clusters = 0, culled = 0;
};
Visible find_visible(const VisibleQuestion& question);

bool is_solid(const std::vector<bool>& solid, std::uint32_t part);
PartLook look_of(std::span<const PartLook> parts, std::uint32_t part);

}  // namespace feelem::viewer
