// SPDX-License-Identifier: Apache-2.0
// What may be asked of the volume: planes and levels as numbers that pass through zero.
#include "feelem/inside.hpp"

#include "base/parallel.hpp"
#include "inside/cut_solids.hpp"
#include "inside/element_values.hpp"
#include "model/vector.hpp"
#include "skin/element_checks.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <cmath>

namespace feelem {
namespace {

NodeNumbers values_of(const ElementValues& values) {
    return [&values](const SolidRef& solid, std::span<double> out) { values.gather(solid, out); };
}

}  // namespace

Solids find_solids(const Mesh& mesh) {
    Solids solids;
    solids.mesh = &mesh;
    for (const ElementBlock& block : mesh.blocks) {
        if (element_row(block.type).dimension == 3) solids.count += block.ids.size();
    }
    if (solids.count == 0) return solids;
    solids.set_aside = find_duplicate_solids(mesh);
    solids.count -= static_cast<std::uint64_t>(std::ranges::count(solids.set_aside, true));
    return solids;
}

Solids moved_by(const Solids& solids, const Result& displacement, double scale) {
    const auto& names = displacement.info.components;
    const bool is_vector = names.size() >= 3 && names[0] == "x" && names[1] == "y" && names[2] == "z";
    const Mesh& mesh = *solids.mesh;
    if (displacement.info.location != Location::Nodal || !is_vector ||
        displacement.row_count() != mesh.node_count() || !std::isfinite(scale)) {
        throw Error(Code::BadOption, "", "a shape is deformed by a nodal result with components x y z");
    }
    Solids moved = solids;
    moved.moved = mesh.coordinates;
    parallel_chunks(moved.moved.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto by = std::span(displacement.values).subspan(i * names.size(), 3);
            if (std::ranges::any_of(by, [](float v) { return std::isnan(v); })) continue;
            for (std::size_t axis = 0; axis < 3; ++axis)
                moved.moved[i][axis] += scale * static_cast<double>(by[axis]);
        }
    });
    return moved;
}

std::optional<Section> cut_plane(
    const Solids& solids, const FieldOf& field, const Plane& plane, const SectionLimits& limits
) {
    const auto normal = direction(plane.normal);
    if (!normal || !std::isfinite(plane.offset))
        throw Error(Code::BadOption, "", "a plane has a direction of some length and a finite offset");
    const double offset = plane.offset / length(plane.normal);
    const ElementValues values(*solids.mesh, field);
    const auto places = solids.places();
    CutJob job;
    job.level = [&](const SolidRef& solid, std::span<double> out) {
        const auto nodes = solid.nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            out[i] = nodes[i] == kNoNode ? 0 : dot(*normal, places[raw(nodes[i])]) - offset;
    };
    job.values = values_of(values);
    job.is_flat = values.is_elemental();
    job.normal = normal;
    return cut_solids(solids, job, limits);
}

std::optional<Section> isosurface(
    const Solids& solids,
    const FieldOf& field,
    double level,
    const std::optional<FieldOf>& colour,
    const SectionLimits& limits
) {
    const ElementValues values(*solids.mesh, field);
    if (values.is_elemental())
        throw Error(Code::BadOption, "", "a result with one value an element has no surface of equal value");
    if (!std::isfinite(level)) throw Error(Code::BadOption, "", "the value of a surface must be finite");
    const std::optional<ElementValues> colours =
        colour ? std::optional<ElementValues>(std::in_place, *solids.mesh, *colour) : std::nullopt;
    CutJob job;
    job.level = [&](const SolidRef& solid, std::span<double> out) {
        values.gather(solid, out);
        for (double& v : out) v -= level;
    };
    job.values = [&](const SolidRef& solid, std::span<double> out) {
        if (colours) return colours->gather(solid, out);
        std::ranges::fill(out, level);
    };
    job.is_flat = colours ? colours->is_elemental() : true;
    return cut_solids(solids, job, limits);
}

}  // namespace feelem
