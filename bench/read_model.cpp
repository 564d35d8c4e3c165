// SPDX-License-Identifier: Apache-2.0
// Reads a file as `feelem` does, from its bytes to mesh and values, again and again, and says how long it
// took and what was found, so that another reader's findings can be compared. JSON on stdout.
#include "base/parallel.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace feelem;

/// Of all threads.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Times {
    double open_cpu = 0, open_wall = 0;  ///< To mesh and sets.
    double load_cpu = 0, load_wall = 0;  ///< All values of all results.
};

/// What was found, in words that any reader can give.
struct Found {
    std::uint64_t nodes = 0, elements = 0, values = 0, set_members = 0;
    std::int64_t node_ids = 0, element_ids = 0, corners = 0;  ///< Sums.
    double x = 0, y = 0, z = 0, value_sum = 0;
};

void add_mesh(Found& found, const Mesh& mesh) {
    found.nodes = mesh.node_count();
    found.elements = mesh.element_count();
    for (const NodeId id : mesh.node_ids) found.node_ids += raw(id);
    for (const Point3& p : mesh.coordinates) {
        found.x += p[0];
        found.y += p[1];
        found.z += p[2];
    }
    for (const ElementBlock& block : mesh.blocks) {
        for (const ElementId id : block.ids) found.element_ids += raw(id);
        for (const NodeIndex node : block.nodes) {
            if (node != kNoNode) found.corners += raw(mesh.node_ids[raw(node)]);
        }
    }
    for (const NodeSet& set : mesh.node_sets) found.set_members += set.nodes.size();
    for (const ElementSet& set : mesh.element_sets) found.set_members += set.elements.size();
}

Times read_once(const std::string& path, Found& found) {
    Diagnostics diagnostics;
    ReadOptions options;
    options.hash_inputs = false;
    Times times;
    found = {};
    const double cpu = processor_seconds();
    const double wall = wall_seconds();
    const auto source = open_model(std::vector{path}, options, diagnostics);
    times.open_cpu = processor_seconds() - cpu;
    times.open_wall = wall_seconds() - wall;
    add_mesh(found, source->mesh());
    for (std::size_t i = 0; i < source->results().size(); ++i) {
        const double load_cpu = processor_seconds();
        const double load_wall = wall_seconds();
        const Result result = source->load(i);
        times.load_cpu += processor_seconds() - load_cpu;
        times.load_wall += wall_seconds() - load_wall;
        found.values += result.values.size();
        for (const float value : result.values) found.value_sum += std::isnan(value) ? 0 : value;
    }
    return times;
}

void measure(const std::string& path, int rounds, unsigned threads) {
    set_thread_count(threads);
    Found found;
    std::vector<Times> all;
    for (int i = 0; i < rounds; ++i) all.push_back(read_once(path, found));
    const auto best =
        std::ranges::min_element(all, {}, [](const Times& t) { return t.open_cpu + t.load_cpu; });
    fmt::print(
        "{{\"open_cpu\": {:.5f}, \"open_wall\": {:.5f}, \"load_cpu\": {:.5f}, \"load_wall\": {:.5f},\n",
        best->open_cpu,
        best->open_wall,
        best->load_cpu,
        best->load_wall
    );
    fmt::print(
        " \"nodes\": {}, \"elements\": {}, \"node_ids\": {}, \"element_ids\": {}, \"corners\": {},\n",
        found.nodes,
        found.elements,
        found.node_ids,
        found.element_ids,
        found.corners
    );
    fmt::print(
        " \"x\": {:.17g}, \"y\": {:.17g}, \"z\": {:.17g}, \"values\": {}, \"value_sum\": {:.17g}, "
        "\"set_members\": {}}}\n",
        found.x,
        found.y,
        found.z,
        found.values,
        found.value_sum,
        found.set_members
    );
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 4) {
        std::fputs("usage: bench_read_model FILE [ROUNDS [THREADS]]\n", stderr);
        return 2;
    }
    try {
        measure(
            argv[1],
            argc > 2 ? std::max(std::atoi(argv[2]), 1) : 1,
            argc > 3 ? static_cast<unsigned>(std::max(std::atoi(argv[3]), 0)) : 0
        );
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_read_model: {}\n", error.what());
        return 1;
    }
}
