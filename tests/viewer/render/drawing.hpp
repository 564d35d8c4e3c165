// SPDX-License-Identifier: Apache-2.0
// Helpers of the renderer's tests: a context for each, small models, pictures beside golden ones.
#pragma once

#include "viewer/render/gl_context.hpp"
#include "viewer/render/renderer.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace feelem::viewer::tests {

/// Skips the test where there is no OpenGL.
class WithGl : public ::testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

private:
    std::unique_ptr<GlContext> context_;
};

/// A model in memory with the results that a test gives it.
struct SmallModel {
    Geometry geometry;
    std::vector<bool> solid;
    std::map<std::size_t, FieldValues> fields;  ///< By result; one step.
    std::map<std::size_t, std::vector<std::array<std::uint32_t, 3>>> levels;

    DrawnModel drawn() const;
    /// From all vertices' places; `function` gives one number each.
    template <typename Function>
    void add_field(std::size_t result, Function function) {
        FieldValues& field = fields[result];
        field.components = 1;
        for (const auto& place : geometry.positions) field.values.push_back(function(place));
        field.validity.assign(field.values.size(), Validity::Solver);
    }
    template <typename Function>
    void add_vectors(std::size_t result, Function function) {
        FieldValues& field = fields[result];
        field.components = 3;
        for (const auto& place : geometry.positions)
            for (const float number : function(place)) field.values.push_back(number);
        field.validity.assign(geometry.positions.size(), Validity::Solver);
    }
};

/// A closed box of cells^2 squares a side, each of two triangles, with element edges; one part.
SmallModel box_model(std::array<float, 3> size, int cells);
/// A ball of about `triangles` triangles, radius 1.
SmallModel ball_model(int rings);
/// All parts of `two` after those of `one`.
void append(SmallModel& one, const SmallModel& two);

/// An eye at `from` that looks at `to`, `degrees` high.
Camera looking(const glm::vec3& from, const glm::vec3& to, float degrees = 40, float aspect = 4.0F / 3);

/// Draws until all has arrived.
void draw_whole(Renderer& renderer, const DrawInput& input);

Rgb pixel(const Pixels& picture, int x, int y);
/// Largest difference of one colour's byte between two pixels, and how many pixels differ at all.
struct Difference {
    int largest = 0;
    std::size_t pixels = 0;
};
Difference compare(const Pixels& one, const Pixels& two);

/// Beside tests/viewer/render/golden/NAME.png: no more than 0.2 % of the pixels differ by more than 12.
/// FEELEM_UPDATE_GOLDEN=1 writes it anew.
void expect_golden(const std::string& name, const Pixels& picture);

}  // namespace feelem::viewer::tests
