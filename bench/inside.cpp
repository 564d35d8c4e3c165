// SPDX-License-Identifier: Apache-2.0
// Times questions to the inside of a block of bricks, by processor time of one thread: milliseconds a million
// elements. JSON on stdout.
#include "feelem/inside.hpp"

#include "base/parallel.hpp"
#include "skin_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

using namespace feelem;

/// Bent a little, so that no plane of nodes is flat.
Mesh block_of(int side) {
    const auto cells = static_cast<std::size_t>(side);
    Mesh mesh = bench::make_mesh("hex8", cells * cells * cells, "natural");
    for (Point3& at : mesh.coordinates) at = {at[0] + 0.1 * std::sin(at[1]), at[1] + 0.1 * at[2], at[2]};
    return mesh;
}

template <class Work>
double milliseconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc > 1 ? std::atoi(argv[1]) : 100;
    set_thread_count(1);
    const Mesh mesh = block_of(side);
    Result result;
    result.info.components = {"value"};
    for (const Point3& p : mesh.coordinates)
        result.values.push_back(static_cast<float>(p[0] + 0.01 * p[1] * p[2]));
    const double millions = 1e-6 * static_cast<double>(mesh.element_count());
    Solids solids;
    const double found = milliseconds([&] { solids = find_solids(mesh); });
    std::optional<Section> plane, surface;
    const double cut = milliseconds([&] {
        plane = cut_plane(solids, {&result, 0}, {{1, 0.3, 0.2}, 0.7 * side});
    });
    const double level = milliseconds([&] { surface = isosurface(solids, {&result, 0}, 0.6 * side); });
    std::optional<InteriorFinder> finder;
    const double index = milliseconds([&] { finder.emplace(solids); });
    constexpr int kPlaces = 10'000;
    int inside = 0;
    const double places = milliseconds([&] {
        for (int i = 0; i < kPlaces; ++i) {
            const double t = (i + 0.5) / kPlaces * (side - 1);
            inside += finder->find({t, std::fmod(7 * t, side - 1) + 0.5, std::fmod(13 * t, side - 1) + 0.5})
                          ? 1
                          : 0;
        }
    });
    fmt::print(
        "{{\"elements\": {}, \"solids_ms_per_million\": {:.0f}, \"plane_ms_per_million\": {:.0f}, "
        "\"plane_triangles\": {}, "
        "\"surface_ms_per_million\": {:.0f}, \"surface_triangles\": {}, \"index_ms_per_million\": {:.0f}, "
        "\"place_us\": {:.1f}, \"places_inside\": {}}}\n",
        mesh.element_count(),
        found / millions,
        cut / millions,
        plane->triangles.size(),
        level / millions,
        surface->triangles.size(),
        index / millions,
        1000 * places / kPlaces,
        inside
    );
    return 0;
}
