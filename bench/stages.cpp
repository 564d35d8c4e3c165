// SPDX-License-Identifier: Apache-2.0
// Converts one file and says, for each stage, the time it took and the highest memory it held. JSON on
// stdout.
#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// Peak resident memory in KiB since the last call of forget_peak(), as Linux counts it.
long peak_kib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6));
    }
    return 0;
}
void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

struct Stage {
    std::string name;
    double seconds = 0;
    long peak = 0;
};

/// Told of progress by the library: a new stage name closes the stage before it.
class StageClock {
public:
    void enter(std::string_view name) {
        if (name == name_) return;
        close();
        name_ = name;
        start_ = Clock::now();
        forget_peak();
    }
    void close() {
        if (name_.empty()) return;
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        const long peak = peak_kib();
        for (Stage& stage : stages_) {
            if (stage.name != name_) continue;
            stage.seconds += seconds;
            stage.peak = std::max(stage.peak, peak);
            return;
        }
        stages_.push_back({name_, seconds, peak});
    }
    const std::vector<Stage>& stages() const { return stages_; }

private:
    using Clock = std::chrono::steady_clock;
    std::string name_;
    Clock::time_point start_;
    std::vector<Stage> stages_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: bench_stages INPUT OUTPUT\n", stderr);
        return 2;
    }
    feelem::Job job;
    job.inputs = {argv[1]};
    job.output = argv[2];
    StageClock clock;
    clock.enter("start");
    try {
        feelem::Diagnostics diagnostics;
        feelem::convert(job, diagnostics, [&](std::string_view stage, double) {
            clock.enter(stage);
            return true;
        });
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_stages: {}\n", error.what());
        return 1;
    }
    clock.close();
    fmt::print("[");
    const char* separator = "\n";
    for (const Stage& stage : clock.stages()) {
        fmt::print(
            "{} {{\"stage\": \"{}\", \"seconds\": {:.3f}, \"peak_kib\": {}}}",
            separator,
            stage.name,
            stage.seconds,
            stage.peak
        );
        separator = ",\n";
    }
    fmt::print("\n]\n");
}
