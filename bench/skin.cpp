// SPDX-License-Identifier: Apache-2.0
// Times the skin of a mesh made in memory. `search`: which facets are outer. `compact`: the search, then
// points and triangles as VTK's filter gives them (compact_skin.hpp). `stage`: the whole stage, as convert
// runs it, with one result carried: triangles round centres, creases, normals, edges. Two floors below which
// `compact` cannot come, whatever it does: `hash`, the facets' hashes alone, once; `arrays`, what it gives,
// written in order into new memory. JSON on stdout, a line each; peers/vtk_skin.cpp says the same of VTK.
#include "feelem/skin.hpp"

#include "base/parallel.hpp"
#include "compact_skin.hpp"
#include "model/element_table.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_cancellation.hpp"
#include "skin_mesh.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Found {
    bench::FacetSum facets;
    double value_sum = 0, area = 0, volume = 0;
    std::size_t triangles = 0;
};

bench::FacetSum sum_of(const feelem::Mesh& mesh, const feelem::OuterFacets& outer) {
    bench::FacetSum sum;
    for (const feelem::FacetRef ref : outer.outer) {
        const feelem::Outline outline = feelem::outline_of(mesh, ref);
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t i = 0; i < outline.count; ++i) corners[i] = feelem::raw(outline.corners[i]);
        sum.add(std::span(corners).first(outline.count));
    }
    return sum;
}

feelem::Result one_result(const feelem::Mesh& mesh) {
    feelem::Result result;
    result.info.name = "temperature";
    result.info.location = feelem::Location::Nodal;
    result.info.components = {"value"};
    result.values.resize(mesh.node_count());
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        result.values[i] = bench::value_at(static_cast<std::uint32_t>(i));
    return result;
}

/// Each node of the skin once, though creases split vertices.
double sum_of_nodes(
    const feelem::Mesh& mesh, const feelem::Surface& surface, const feelem::SurfaceField& field
) {
    std::vector<bool> seen(mesh.node_count());
    double sum = 0;
    for (std::size_t i = 0; i < surface.vertex_node.size(); ++i) {
        const feelem::NodeIndex node = surface.vertex_node[i];
        if (node == feelem::kNoNode || seen[feelem::raw(node)]) continue;
        seen[feelem::raw(node)] = true;
        sum += static_cast<double>(field.values[i]);
    }
    return sum;
}

}  // namespace

namespace {

/// Processor and wall time, and the most memory beyond what was held before.
struct Used {
    double cpu = 0, wall = 0;
    std::size_t extra = 0;
};

template <class Work>
Used timed(Work work) {
    Used used;
    const std::size_t before = bench::resident_bytes();
    bench::forget_peak();
    const double cpu = bench::cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    work();
    used.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    used.cpu = bench::cpu_seconds() - cpu;
    used.extra = bench::peak_bytes() - std::min(before, bench::peak_bytes());
    return used;
}

/// Hashes of all facets of linear and quadratic solids, and nothing done with them.
std::uint64_t hash_all(const feelem::Mesh& mesh) {
    feelem::FacetBatch batch;
    std::uint64_t any = 0;
    for (const feelem::ElementBlock& block : mesh.blocks) {
        const std::size_t width = feelem::element_row(block.type).node_count;
        for (std::size_t i = 0; i < block.ids.size(); i += feelem::FacetBatch::kElements) {
            const std::size_t count = std::min(block.ids.size() - i, feelem::FacetBatch::kElements);
            feelem::hash_facets(
                {block.type, block.nodes.data() + i * width, count}, feelem::FacetHashes::Signed, batch
            );
            any ^= batch.hashes[0];
        }
    }
    return any;
}

/// A skin of that size, with anything in it.
bench::CompactSkin any_skin(std::size_t points, std::size_t triangles) {
    bench::CompactSkin skin(points, triangles);
    for (std::uint32_t i = 0; i < triangles; ++i) {
        skin.triangles[i] = {i, i + 1, i + 2};
        skin.facets[i] = i;
    }
    for (std::uint32_t i = 0; i < points; ++i) {
        skin.points[i] = {1, 2, 3};
        skin.values[i] = 4;
        skin.nodes[i] = feelem::NodeIndex{i};
    }
    return skin;
}

/// What is told of the answer, after the clock has stopped.
Found run(const std::string& stage, const feelem::Mesh& mesh, const feelem::Result& result, Used& used) {
    Found found;
    if (stage == "search") {
        feelem::OuterFacets outer;
        used = timed([&] { outer = feelem::find_outer_facets(mesh, {}); });
        found.facets = sum_of(mesh, outer);
    } else if (stage == "hash") {
        std::uint64_t any = 0;
        used = timed([&] { any = hash_all(mesh); });
        found.facets.sum = any;
    } else if (stage == "arrays") {
        std::size_t points = 0;
        {
            const bench::CompactSkin skin =
                bench::compact(mesh, feelem::find_outer_facets(mesh, {}).outer, result.values);
            points = skin.point_count;
            found.triangles = skin.triangle_count;
        }
        bench::CompactSkin skin(0, 0);
        used = timed([&] { skin = any_skin(points, found.triangles); });
        found.value_sum = static_cast<double>(skin.values[points / 2]);
    } else if (stage == "compact") {
        bench::CompactSkin skin(0, 0);
        used = timed([&] {
            skin = bench::compact(mesh, feelem::find_outer_facets(mesh, {}).outer, result.values);
        });
        bench::measure(skin, found.area, found.volume);
        for (const float value : skin.values.span().first(skin.point_count))
            found.value_sum += static_cast<double>(value);
        found.triangles = skin.triangle_count;
    } else {
        feelem::Diagnostics diagnostics;
        feelem::Surface surface;
        feelem::SurfaceField field;
        used = timed([&] {
            surface = feelem::make_skin(mesh, {}, diagnostics);
            field = feelem::carry(mesh, surface, result);
        });
        found.facets.count = surface.report.solid_facets_kept;
        found.area = surface.report.area;
        found.volume = surface.report.volume;
        found.triangles = surface.report.triangles;
        found.value_sum = sum_of_nodes(mesh, surface, field);
    }
    return found;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fputs("usage: bench_skin STAGE,STAGE... KIND CELLS NUMBERING THREADS\n", stderr);
        return 2;
    }
    try {
        // Every stage starts with memory it has not touched, as the first one does.
        mallopt(M_MMAP_THRESHOLD, 128 * 1024);
        const feelem::Mesh mesh = bench::make_mesh(argv[2], std::stoul(argv[3]), argv[4]);
        const feelem::Result result = one_result(mesh);
        feelem::set_thread_count(static_cast<unsigned>(std::stoul(argv[5])));
        std::istringstream stages(argv[1]);
        for (std::string stage; std::getline(stages, stage, ',');) {
            malloc_trim(0);
            Used used;
            const Found found = run(stage, mesh, result, used);
            fmt::print(
                "{{\"stage\": \"{}\", \"cells\": {}, \"nodes\": {}, \"cpu\": {:.6f}, \"wall\": {:.6f}, "
                "\"extra_bytes\": {}, \"facets\": {}, \"facet_sum\": {}, \"triangles\": {}, \"area\": "
                "{:.9g}, "
                "\"volume\": {:.9g}, \"value_sum\": {:.9g}}}\n",
                stage,
                mesh.element_count(),
                mesh.node_count(),
                used.cpu,
                used.wall,
                used.extra,
                found.facets.count,
                found.facets.sum,
                found.triangles,
                found.area,
                found.volume,
                found.value_sum
            );
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_skin: {}\n", error.what());
        return 1;
    }
}
