// SPDX-License-Identifier: Apache-2.0
// Reads an archive of commands again and again and says how fast its parts are read by one core: processor
// time of the best round. JSON on stdout.
#include "read/ansys/cdb_deck.hpp"
#include "read/ansys/cdb_mesh.hpp"
#include "read/ansys/cdb_rows.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <limits>
#include <string>

namespace {

using namespace feelem;
using namespace feelem::ansys;

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double best_of(int rounds, const Work& work) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const double start = processor_seconds();
        work();
        best = std::min(best, processor_seconds() - start);
    }
    return best;
}

std::size_t bytes_of(const cdb::BlockRows& rows) {
    return rows.end - rows.begin;
}

void say(const char* part, std::size_t bytes, double seconds, const char* end) {
    fmt::print(
        " {{\"part\": \"{}\", \"bytes\": {}, \"cpu_seconds\": {:.4f}, \"gb_per_second\": {:.2f}}}{}\n",
        part,
        bytes,
        seconds,
        1e-9 * static_cast<double>(bytes) / seconds,
        end
    );
}

void measure(const Input& input, int rounds) {
    Diagnostics diagnostics;
    cdb::Deck deck;
    const double scan = best_of(rounds, [&] { deck = cdb::scan_deck(input, nullptr, diagnostics); });
    std::size_t node_bytes = 0;
    std::size_t element_bytes = 0;
    for (const cdb::BlockRows& rows : deck.node_blocks) node_bytes += bytes_of(rows);
    for (const cdb::ElementRows& block : deck.element_blocks) element_bytes += bytes_of(block.rows);
    double sum = 0;  // Printed, so that no compiler leaves the work out.
    const double nodes = best_of(rounds, [&] {
        for (const cdb::BlockRows& rows : deck.node_blocks) {
            cdb::NodeRows reader(deck, rows, {rows.begin, rows.end});
            while (reader.next()) sum += reader.node().position[0];
        }
    });
    const double elements = best_of(rounds, [&] {
        for (const cdb::ElementRows& block : deck.element_blocks) {
            const cdb::RowRange whole{block.rows.begin, block.rows.end};
            cdb::ElementRowsReader reader(deck, block, whole, [](std::int64_t) { return std::size_t{20}; });
            while (reader.next()) sum += static_cast<double>(reader.row().nodes[0]);
        }
    });
    const double mesh = best_of(rounds, [&] {
        sum += static_cast<double>(
            cdb::read_mesh(cdb::scan_deck(input, nullptr, diagnostics), {}, diagnostics).node_count()
        );
    });
    fmt::print("[\n");
    say("scan", input.size(), scan, ",");
    say("NBLOCK rows", node_bytes, nodes, ",");
    say("EBLOCK rows", element_bytes, elements, ",");
    say("mesh", input.size(), mesh, "");
    fmt::print("]\n");
    fmt::print(stderr, "checksum {}\n", sum);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: bench_read_cdb FILE.cdb [ROUNDS]\n", stderr);
        return 2;
    }
    try {
        measure(Input::from_file(argv[1]), argc == 3 ? std::max(std::atoi(argv[2]), 1) : 9);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_read_cdb: {}\n", error.what());
        return 1;
    }
}
