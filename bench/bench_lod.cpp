// SPDX-License-Identifier: Apache-2.0
// Times the levels of detail and proves them with the independent checker, beside meshoptimizer at equal
// proven error. JSON on stdout, one object a line.
//     bench_lod sheet SIDE | FILE.frd [--runs N] [--share S] [--eps E] [--no-centroids] [--peer]
#include "lod_models.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <string>
#include <string_view>

namespace {

using namespace feelem;

struct Settings {
    std::string model = "sheet";
    std::uint32_t side = 1000;
    int runs = 5;
    double share = 0.1;  ///< Of the triangles; 0: down to the bound.
    double eps = 0;      ///< Bound of the field, fraction of its range; 0: the goal of the model.
    bool centroids = true;
    double slip = 0.5;
    double first_step = 0.1, growth = 3;
    bool peer = false;
};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

long status_kib(std::string_view key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(key)) return std::stol(line.substr(key.size() + 1));
    }
    return 0;
}

std::vector<LodField> bounded(const bench::LodModel& model, double eps) {
    std::vector<LodField> fields;
    for (std::size_t k = 0; k < model.fields.size(); ++k)
        fields.push_back({model.fields[k], eps * model.range(k)});
    return fields;
}

double extent(const bench::LodModel& model) {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::ranges::minmax_element(model.positions, {}, [axis](const Point3& p) { return p[axis]; });
        most = std::max(most, (*high)[axis] - (*low)[axis]);
    }
    return most;
}

double measure(const bench::LodModel& model, const Settings& settings, LodLevel& level) {
    LodOptions options;
    options.centroids = settings.centroids;
    options.slip = settings.slip;
    options.first_step = settings.first_step;
    options.growth = settings.growth;
    const auto target = static_cast<double>(model.triangles.size()) * settings.share;
    options.targets = {{static_cast<std::uint64_t>(target), 1}};
    const auto fields = bounded(model, settings.eps);
    const LodSurface surface = model.surface();

    std::vector<double> seconds;
    long peak = 0;
    LodReport report;
    for (int run = 0; run < settings.runs; ++run) {
        std::ofstream("/proc/self/clear_refs") << "5";
        const long before = status_kib("VmRSS");
        const double start = cpu_seconds();
        LodResult result = simplify(surface, fields, options);
        seconds.push_back(cpu_seconds() - start);
        peak = std::max(peak, status_kib("VmHWM") - before);
        level = std::move(result.levels[0]);
        report = result.report;
    }
    std::ranges::sort(seconds);
    const double median = seconds[seconds.size() / 2];
    const LodCheck check = check_level(surface, fields, level.triangles, level.certificate.distance_bound);
    const auto triangles = static_cast<double>(model.triangles.size());
    double max = 0, rms = 0, strict = 0, strict_rms = 0;
    std::uint64_t over = 0;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        max = std::max(max, level.certificate.fields[k].max / model.range(k));
        rms = std::max(rms, level.certificate.fields[k].rms / model.range(k));
        strict = std::max(strict, check.fields[k].max / model.range(k));
        strict_rms = std::max(strict_rms, check.fields[k].rms / model.range(k));
        over += check.fields[k].over;
    }
    fmt::print(
        "{{\"what\": \"{}\", \"triangles\": {}, \"eps\": {}, \"centroids\": {}, \"slip\": {}, \"left\": {}, "
        "\"bound\": {:.4g}, \"worst_of_bound\": {:.5f}, \"max\": {:.3g}, \"rms\": {:.3g}, \"strict_max\": "
        "{:.3g}, "
        "\"strict_rms\": {:.3g}, \"over\": {}, \"max_distance\": {:.3g}, \"strict_distance\": {:.3g}, "
        "\"cpu_seconds\": "
        "{:.3f}, \"cpu_min\": {:.3f}, \"cpu_max\": {:.3f}, \"mtri_per_s\": {:.3f}, \"bytes_per_triangle\": "
        "{:.1f}, "
        "\"locked\": {}, \"creases\": {}, \"extremes\": {}, \"non_manifold\": {}}}\n",
        model.name,
        model.triangles.size(),
        settings.eps,
        settings.centroids,
        settings.slip,
        level.triangles.size(),
        level.certificate.bound,
        level.certificate.worst,
        max,
        rms,
        strict,
        strict_rms,
        over,
        level.certificate.max_distance / extent(model),
        check.max_distance / extent(model),
        median,
        seconds.front(),
        seconds.back(),
        triangles / median / 1e6,
        1024.0 * static_cast<double>(peak) / triangles,
        report.locked,
        report.creases,
        report.extremes,
        report.non_manifold
    );
    std::fflush(stdout);
    return strict;
}

/// Fewest triangles of meshopt_simplify whose strict error is at most `error` (fraction of the range):
/// bisection over its target count, to 5 %; "triangles" counts what its result has, or all when no
/// count reached it.
void measure_peer(const bench::LodModel& model, const Settings& settings, std::size_t ours, double error) {
    std::vector<float> positions;
    for (const Point3& p : model.positions) {
        for (const double x : p) positions.push_back(static_cast<float>(x));
    }
    // Vertices of one place are one vertex for it: otherwise it keeps every crease as a border.
    std::vector<unsigned int> indices;
    for (const auto& t : model.triangles) {
        for (const VertexIndex v : t) indices.push_back(model.places.empty() ? raw(v) : model.places[raw(v)]);
    }
    const auto fields = bounded(model, settings.eps);
    LodSurface surface = model.surface();
    surface.parts.clear();
    std::vector<std::array<VertexIndex, 3>> welded;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        welded.push_back({VertexIndex{indices[i]}, VertexIndex{indices[i + 1]}, VertexIndex{indices[i + 2]}});
    surface.triangles = welded;
    std::size_t low = indices.size() / 300, high = indices.size() / 3;
    double seconds = 0;
    std::vector<unsigned int> out(indices.size());
    std::size_t best = high;
    int rounds = 0;
    for (; 20 * high > 21 * low; ++rounds) {
        const auto middle =
            static_cast<std::size_t>(std::sqrt(static_cast<double>(low) * static_cast<double>(high)));
        const double start = cpu_seconds();
        const std::size_t count = meshopt_simplify(
            out.data(),
            indices.data(),
            indices.size(),
            positions.data(),
            model.positions.size(),
            12,
            middle * 3,
            1e9F,
            0,
            nullptr
        );
        seconds += cpu_seconds() - start;
        std::vector<std::array<VertexIndex, 3>> level;
        for (std::size_t i = 0; i < count; i += 3)
            level.push_back({VertexIndex{out[i]}, VertexIndex{out[i + 1]}, VertexIndex{out[i + 2]}});
        const LodCheck check = check_level(surface, fields, level, 0);
        double strict = 0;
        for (std::size_t k = 0; k < fields.size(); ++k)
            strict = std::max(strict, check.fields[k].max / model.range(k));
        if (strict <= error && check.without_place == 0) {
            best = level.size();
            high = middle;
        } else {
            low = middle;
        }
    }
    fmt::print(
        "{{\"what\": \"meshopt_simplify {}\", \"error\": {:.3g}, \"rounds\": {}, \"reached\": {}, "
        "\"triangles\": {}, "
        "\"ours\": {}, \"ratio\": "
        "{:.2f}, "
        "\"cpu_seconds\": {:.2f}}}\n",
        MESHOPTIMIZER_VERSION,
        error,
        rounds,
        best < model.triangles.size(),
        best,
        ours,
        static_cast<double>(best) / static_cast<double>(ours),
        seconds
    );
}

Settings settings_of(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const auto number = [&] { return i + 1 < argc ? std::stod(argv[++i]) : 0.0; };
        if (word == "sheet")
            settings.side = static_cast<std::uint32_t>(number());
        else if (word == "--runs")
            settings.runs = std::max(1, static_cast<int>(number()));
        else if (word == "--share")
            settings.share = number();
        else if (word == "--eps")
            settings.eps = number();
        else if (word == "--slip")
            settings.slip = number();
        else if (word == "--first")
            settings.first_step = number();
        else if (word == "--growth")
            settings.growth = number();
        else if (word == "--no-centroids")
            settings.centroids = false;
        else if (word == "--peer")
            settings.peer = true;
        else
            settings.model = word;
    }
    if (settings.eps == 0) settings.eps = settings.model == "sheet" ? 0.001 : 0.003;
    return settings;
}

}  // namespace

int main(int argc, char** argv) try {
    const Settings settings = settings_of(argc, argv);
    const bench::LodModel model =
        settings.model == "sheet" ? bench::wavy_sheet(settings.side) : bench::refined_model(settings.model);
    LodLevel level;
    const double strict = measure(model, settings, level);
    if (settings.peer) measure_peer(model, settings, level.triangles.size(), strict);
    return 0;
} catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
}
