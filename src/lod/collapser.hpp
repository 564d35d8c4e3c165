// SPDX-License-Identifier: Apache-2.0
// Takes points away one after the other, as long as every sample stays within its bounds.
#pragma once

#include "lod/fan.hpp"
#include "lod/lod_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace feelem::lod {

class Collapser {
public:
    Collapser(Model& model, float least_cosine);

    /// Visits every point once, in order; stops at `target` triangles. Returns how many points went.
    std::uint64_t sweep(float error, std::uint64_t target);
    std::uint64_t triangles() const noexcept { return triangles_; }
    std::uint64_t points() const noexcept { return points_; }

private:
    struct Choice {
        float rank = 0;
        float error = 0;
        std::uint32_t corner = 0;
    };

    bool visit(std::uint32_t place);
    bool visit_free(std::uint32_t place);
    bool visit_crease(std::uint32_t place);
    bool collect_closed(std::uint32_t start, Patch& patch) const;
    std::uint32_t collect_open(std::uint32_t start);
    bool flatten(Patch& patch) const;
    void choose(const Patch& patch);
    float shape_of(const Patch& patch, std::uint32_t from, std::uint32_t& over_centre) const;
    float guess(const Patch& patch, std::uint32_t from, std::uint32_t m) const;
    void gather(const Patch& patch, std::uint32_t own);
    float test(std::size_t first, std::size_t last);
    float curve_error(const CreasePoint& point, const Patch& patch) const;
    bool keeps_topology(std::uint32_t place, std::uint32_t patches, std::uint32_t corner0) const;
    bool keeps_corners(const Patch& patch, std::uint32_t from) const;
    void apply(const Patch& patch, std::uint32_t from, std::size_t first, std::size_t last);
    void join_curve(std::uint32_t place, std::uint32_t target);
    void finish(std::uint32_t place, std::uint32_t patches);

    Model& model_;
    Fan fan_;
    Limits limits_;
    std::vector<float> cost_;          ///< Per place: no collapse there can cost less until its star changes.
    std::vector<std::uint8_t> stamp_;  ///< Per place: its star changed in this sweep.
    std::uint64_t triangles_ = 0, points_ = 0;

    // Of the point that is visited.
    std::array<Patch, 2> patches_;
    std::vector<Choice> choices_;
    std::vector<std::uint32_t> pending_;  ///< Samples of the patches, one patch after the other.
    std::vector<std::uint8_t> where_;     ///< Of each, the triangle of the new fan.
    float blocked_ = 0;                   ///< Least error that kept the point from going.
};

}  // namespace feelem::lod
