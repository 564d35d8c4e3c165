// SPDX-License-Identifier: Apache-2.0
// Google Benchmark of the parts of the skin: the hashes of facets with AVX-512, AVX2 and without, the search,
// the edges and the smooth groups of what it finds. Elements a second, of one thread. bench_skin times the
// whole.
#include "base/parallel.hpp"
#include "skin/edge_table.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_cancellation.hpp"
#include "skin/smooth_groups.hpp"
#include "skin_mesh.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr std::size_t kCells = 500'000;

void tell_elements(benchmark::State& state, std::size_t elements) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(elements));
}

using Hash = bool (*)(feelem::ElementRun, feelem::FacetHashes, feelem::FacetBatch&);
bool portably(feelem::ElementRun run, feelem::FacetHashes what, feelem::FacetBatch& out) {
    feelem::hash_facets_portably(run, what, out);
    return true;
}

/// Of elements that stream from memory, as in the search.
void hash(benchmark::State& state, const std::string& kind, Hash hash_them) {
    const feelem::Mesh mesh = bench::make_mesh(kind, kCells, "natural");
    const feelem::ElementBlock& block = mesh.blocks.front();
    const std::size_t width = feelem::element_row(block.type).node_count;
    const auto batch = std::make_unique<feelem::FacetBatch>();
    constexpr std::size_t kAtOnce = feelem::FacetBatch::kElements;
    for (auto _ : state) {
        for (std::size_t i = 0; i + kAtOnce <= block.ids.size(); i += kAtOnce) {
            const feelem::ElementRun run{block.type, block.nodes.data() + i * width, kAtOnce};
            if (!hash_them(run, feelem::FacetHashes::Signed, *batch))
                return state.SkipWithError("not on this processor");
            benchmark::DoNotOptimize(batch->hashes[0]);
        }
    }
    tell_elements(state, block.ids.size());
}

void search(benchmark::State& state, const std::string& kind, const std::string& numbering) {
    const feelem::Mesh mesh = bench::make_mesh(kind, kCells, numbering);
    for (auto _ : state) benchmark::DoNotOptimize(feelem::find_outer_facets(mesh, {}).outer.data());
    tell_elements(state, mesh.element_count());
}

std::vector<feelem::Outline> outlines(const feelem::Mesh& mesh) {
    std::vector<feelem::Outline> facets;
    for (const feelem::FacetRef facet : feelem::find_outer_facets(mesh, {}).outer)
        facets.push_back(feelem::outline_of(mesh, facet));
    return facets;
}

void edges(benchmark::State& state, const std::string& kind) {
    const feelem::Mesh mesh = bench::make_mesh(kind, kCells, "natural");
    const auto facets = outlines(mesh);
    for (auto _ : state) benchmark::DoNotOptimize(feelem::find_edges(facets).first.data());
    tell_elements(state, facets.size());
}

void smooth_groups(benchmark::State& state, const std::string& kind) {
    const feelem::Mesh mesh = bench::make_mesh(kind, kCells, "natural");
    const auto facets = outlines(mesh);
    const feelem::EdgeTable table = feelem::find_edges(facets);
    const std::vector<std::uint32_t> pieces{0, static_cast<std::uint32_t>(facets.size())};
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            feelem::find_smooth_groups(facets, pieces, table, mesh.coordinates, 30).normals.data()
        );
    }
    tell_elements(state, facets.size());
}

}  // namespace

int main(int argc, char** argv) {
    feelem::set_thread_count(1);
    for (const char* kind : {"hex8", "tet4", "hex20", "tet10"}) {
        const auto add_hash = [&](const char* how, Hash way) {
            benchmark::RegisterBenchmark((std::string("hash/") + how + kind).c_str(), hash, kind, way);
        };
        const bool is_linear = std::string_view(kind) == "hex8" || std::string_view(kind) == "tet4";
        if (is_linear) add_hash("avx512/", feelem::hash_facets_with_avx512);
        add_hash("avx2/", feelem::hash_facets_with_avx2);
        add_hash("portable/", portably);
        benchmark::RegisterBenchmark(
            (std::string("search/natural/") + kind).c_str(), search, kind, "natural"
        );
    }
    for (const char* kind : {"hex8", "tet4"})
        benchmark::RegisterBenchmark((std::string("search/random/") + kind).c_str(), search, kind, "random");
    for (const char* kind : {"plate", "tet10"}) {
        benchmark::RegisterBenchmark((std::string("edges/") + kind).c_str(), edges, kind);
        benchmark::RegisterBenchmark((std::string("smooth_groups/") + kind).c_str(), smooth_groups, kind);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
