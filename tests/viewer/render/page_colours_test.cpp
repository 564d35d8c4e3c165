// SPDX-License-Identifier: Apache-2.0
// The page and the native viewer show the same colours: tests/contract/pixels.json holds what the page's
// pixels are at places of the boiler (web/test/e2e/native.mjs writes and holds it).
#include "support/paths.hpp"
#include "viewer/render/colouring.hpp"
#include "viewer/render/drawing.hpp"

#include "feelem/convert.hpp"
#include "feelem/pick.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <optional>

namespace feelem::viewer::tests {
namespace {

using PageColours = WithGl;

/// An eye straight before a place, so near that nothing stands between; one pixel is a small step on the
/// skin.
Camera before(const glm::vec3& place, const glm::vec3& normal, float pixel) {
    const glm::vec3 up = std::abs(normal.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const float half = 4.5F * pixel;
    return {
        glm::lookAt(place + 4.0F * half * normal, place, up),
        glm::ortho(-half, half, -half, half, 0.1F * half, 20.0F * half)};
}

int step_of(const std::vector<std::uint8_t>& palette, const Rgb& colour) {
    for (std::size_t i = 0; 4 * i < palette.size(); ++i)
        if (std::equal(colour.begin(), colour.end(), palette.begin() + static_cast<std::ptrdiff_t>(4 * i)))
            return static_cast<int>(i);
    return -1000;
}

TEST_F(PageColours, are_the_native_viewers_at_two_hundred_places) {
    Job job;
    job.inputs = {test::project_file("examples/boiler/boiler.frd")};
    job.output = test::scratch_folder("viewer_page_colours") + "/boiler.glb";
    job.length_unit = "mm";
    job.presentation_file = test::project_file("examples/boiler/boiler.presentation.json");
    Diagnostics diagnostics;
    convert(job, diagnostics, {});
    LoadedScene scene(job.output);
    const Geometry& geometry = scene.geometry();
    const Picker picker(geometry.positions, geometry.triangles);
    const Point3& origin = scene.about().origin;
    Renderer renderer;
    renderer.set_model(drawn_model(scene));
    Look look;
    look.edges = false;
    look.shade_floor = 1;
    look.model_to_world = scene.to_metres();
    std::ifstream file(test::project_file("tests/contract/pixels.json"));
    const auto places = nlohmann::json::parse(file).at("places");
    ASSERT_GE(places.size(), 200U);

    int equal = 0;
    for (const auto& place : places) {
        for (const PresentedResult& result : scene.about().presentation.results) {
            if (result.key != place.at("key")) continue;
            look.field = scene.find(result, 0);
            look.range = value_range(result);
        }
        ASSERT_TRUE(look.field);
        const auto at = place.at("at").get<std::array<double, 3>>();
        const auto hit = picker.nearest({at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]});
        ASSERT_TRUE(hit);
        const FieldValues& field = scene.values(look.field->result, look.field->values);
        std::array<glm::vec3, 3> corners;
        glm::vec3 here(0);
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = geometry.triangles[hit->triangle][k];
            const auto& p = geometry.positions[vertex];
            corners[k] = glm::vec3(look.model_to_world * glm::vec4(p[0], p[1], p[2], 1));
            here += static_cast<float>(hit->weights[k]) * corners[k];
            value += hit->weights[k] * double{field.values[vertex]};
        }
        EXPECT_NEAR(value, place.at("value").get<double>(), 1e-3 * (look.range.hi - look.range.lo)) << place;
        const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const Camera eye = before(here, normal, 1e-4F);
        DrawInput input;
        input.eyes = {&eye, 1};
        input.width = input.height = 9;
        input.look = &look;
        draw_whole(renderer, input);

        const Rgb native = pixel(renderer.read(0), 4, 4), page = place.at("colour").get<Rgb>();
        const auto palette = palette_texels(look.colour);
        ASSERT_GE(step_of(palette, page), 0) << place;
        EXPECT_LE(std::abs(step_of(palette, native) - step_of(palette, page)), 1) << place;
        equal += native == page;
    }
    // A border of two bands may lie within the pixel.
    EXPECT_GE(equal, static_cast<int>(places.size()) - 4);
    RecordProperty("equal", equal);
}

}  // namespace
}  // namespace feelem::viewer::tests
