// SPDX-License-Identifier: Apache-2.0
// What the native viewer does with a scene, timed step by step without a window: load it, send it to the
// card, draw it from afar and from near, for one eye and two, change what is shown. One JSON object; with a
// second argument the last picture as PNG. Usage: bench_viewer SCENE.glb [PICTURE.png]
#include "viewer/render/gl_context.hpp"
#include "viewer/render/renderer.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace feelem;
using namespace feelem::viewer;

struct Spent {
    double wall = 0, cpu = 0;
};

Spent now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    const auto wall = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch());
    return {wall.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

double peak_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The steps in order, each with its times, the peak of memory so far, and what was drawn.
class Steps {
public:
    template <typename Work>
    void time(const std::string& name, Work work) {
        const Spent before = now();
        work();
        const Spent after = now();
        rows_.push_back(fmt::format(
            R"({{"step": "{}", "wall": {:.4f}, "cpu": {:.4f}, "peak_mib": {:.0f})",
            name,
            after.wall - before.wall,
            after.cpu - before.cpu,
            peak_mib()
        ));
    }
    void add(const std::string& key, std::uint64_t number) {
        rows_.back() += fmt::format(R"(, "{}": {})", key, number);
    }
    std::string json() const {
        std::string out;
        for (const std::string& row : rows_) out += (out.empty() ? "" : ",\n  ") + row + "}";
        return "[" + out + "]";
    }

private:
    std::vector<std::string> rows_;
};

std::optional<FieldChoice> first_of(const Scene& scene, std::string_view id) {
    for (std::size_t r = 0; r < scene.results.size(); ++r)
        if (scene.results[r].id == id) return FieldChoice{r, 0, 0};
    return std::nullopt;
}

ValueRange range_of(const Scene& scene, const FieldChoice& choice) {
    const SceneValues& values = scene.results[choice.result].values[choice.values];
    if (!values.min || !values.max) return {};
    return {values.min->value, values.max->value, Scale::Linear};
}

Camera camera_from(const glm::vec3& from, const glm::vec3& to, float shift) {
    Camera out{glm::lookAt(from, to, glm::vec3(0, 1, 0)), glm::perspective(0.7F, 4.0F / 3, 0.02F, 50.0F)};
    out.view = glm::translate(glm::mat4(1), {-shift, 0, 0}) * out.view;
    return out;
}

/// The second of two draws: the first may make programs or clusters.
void draw_twice(Steps& steps, const std::string& name, Renderer& renderer, const DrawInput& input) {
    renderer.draw(input);
    renderer.read(0);
    steps.time(name, [&] {
        renderer.draw(input);
        renderer.read(0);
    });
    const DrawCounts& counts = renderer.counts();
    steps.add("triangles", counts.triangles);
    steps.add("clusters", counts.clusters);
    steps.add("clusters_culled", counts.clusters_culled);
    steps.add("draw_calls", counts.draw_calls);
}

void change_and_draw(
    Steps& steps,
    const std::string& name,
    Renderer& renderer,
    const DrawInput& input,
    LoadedScene& scene,
    const FieldChoice& choice
) {
    steps.time(name + ": read", [&] { scene.values(choice.result, choice.values); });
    const DrawCounts before = renderer.counts();
    steps.time(name + ": send and draw", [&] {
        do renderer.draw(input);
        while (!renderer.is_complete());
        renderer.read(0);
    });
    const DrawCounts& after = renderer.counts();
    steps.add("field_bytes", after.uploaded.field - before.uploaded.field);
    steps.add("displacement_bytes", after.uploaded.displacement - before.uploaded.displacement);
    steps.add("geometry_bytes", after.uploaded.geometry - before.uploaded.geometry);
}

int run(int argc, char** argv) {
    Steps steps;
    std::unique_ptr<LoadedScene> scene;
    steps.time("load the scene", [&] { scene = std::make_unique<LoadedScene>(argv[1]); });
    const Geometry& geometry = scene->geometry();
    std::unique_ptr<GlContext> context;
    std::unique_ptr<Renderer> renderer;
    steps.time("start OpenGL", [&] {
        context = std::make_unique<GlContext>();
        renderer = std::make_unique<Renderer>();
    });
    const Scene& about = scene->about();
    const auto temperature = first_of(about, "temperature"),
               magnitude = first_of(about, "displacement_magnitude"),
               vectors = first_of(about, "displacement");
    if (!temperature || !magnitude || !vectors)
        throw std::runtime_error("the scene lacks temperature or displacement");

    const glm::vec3 low(geometry.low[0], geometry.low[1], geometry.low[2]);
    const glm::vec3 high(geometry.high[0], geometry.high[1], geometry.high[2]);
    const glm::vec3 size = high - low;
    const glm::mat4 metres = scene->to_metres();
    const glm::vec3 middle(metres * glm::vec4(0.5F * (low + high), 1));
    const float scale = 0.8F / glm::length(glm::mat3(metres) * size);
    Look look;
    look.model_to_world = glm::translate(glm::scale(glm::mat4(1), glm::vec3(scale)), -middle) * metres;
    look.field = temperature;
    look.range = range_of(about, *temperature);
    const Camera afar = camera_from({0.5F, 0.45F, 0.8F}, {0, 0, 0}, 0),
                 near = camera_from({0.18F, 0.12F, 0.32F}, {0.1F, 0.05F, 0}, 0);
    const std::array<Camera, 2> both{
        camera_from({0.5F, 0.45F, 0.8F}, {0, 0, 0}, -0.032F),
        camera_from({0.5F, 0.45F, 0.8F}, {0, 0, 0}, 0.032F)};
    DrawInput input;
    input.eyes = {&afar, 1};
    input.width = 640;
    input.height = 480;
    input.look = &look;

    steps.time("make clusters and buffers", [&] { renderer->set_model(drawn_model(*scene)); });
    change_and_draw(steps, "first picture", *renderer, input, *scene, *temperature);
    draw_twice(steps, "whole, one eye, 640 x 480", *renderer, input);
    input.eyes = both;
    draw_twice(steps, "whole, two eyes, 2 x 640 x 480", *renderer, input);
    input.eyes = {&near, 1};
    draw_twice(steps, "near, one eye, 640 x 480", *renderer, input);
    input.eyes = {&afar, 1};
    look.field = magnitude;
    look.range = range_of(about, *magnitude);
    change_and_draw(steps, "another result", *renderer, input, *scene, *magnitude);
    look.shape = viewer::Shape{*vectors, std::nullopt, 150, 0};
    change_and_draw(steps, "deformation", *renderer, input, *scene, *vectors);
    look.cuts = {{{1, 0, 0}, 0.5F * (low.x + high.x)}};
    draw_twice(steps, "cut and deformed, one eye, 640 x 480", *renderer, input);
    if (argc > 2) std::ofstream(argv[2], std::ios::binary) << png_of(renderer->read(0));
    fmt::print(
        "{{\"renderer\": \"{}\", \"vertices\": {}, \"triangles\": {}, \"edges\": {},\n \"steps\": {}}}\n",
        context->renderer(),
        geometry.positions.size(),
        geometry.triangles.size(),
        geometry.edges.size(),
        steps.json()
    );
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: bench_viewer SCENE.glb [PICTURE.png]\n", stderr);
        return 2;
    }
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_viewer: {}\n", error.what());
        return 1;
    }
}
