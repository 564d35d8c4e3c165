// SPDX-License-Identifier: Apache-2.0
// A model of the panels with something in each, and surfaces to draw it on without a window.
#pragma once

#include "viewer/render/gl_context.hpp"
#include "viewer/ui/gui.hpp"

#include "feelem/present.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer::tests {

/// The boiler as it is reviewed: three results, two parts, a plane, notes, and a place beyond its limit.
UiModel boiler_ui();

/// Rows from the top, RGBA.
struct UiPicture {
    glm::ivec2 pixels{0};
    std::vector<std::uint8_t> rgba;
    Rgb at(int x, int y) const;
};
/// A framebuffer of this size, filled with the stage's grey.
class Canvas {
public:
    Canvas(glm::ivec2 pixels, const Rgb& background);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
    void clear();
    UiPicture read() const;

private:
    glm::ivec2 pixels_;
    Rgb background_;
    std::uint32_t texture_ = 0, framebuffer_ = 0;
};
UiPicture read_framebuffer(std::uint32_t framebuffer, glm::ivec2 pixels);

/// Skips the test where there is no OpenGL.
class WithGl : public ::testing::Test {
protected:
    void SetUp() override;
    std::unique_ptr<GlContext> context;
};

/// The middle of a target by name; fails the test when it is not in sight.
glm::vec2 middle_of(const std::vector<UiTarget>& targets, std::string_view name);

/// Numbers of a picture beside tests/viewer/ui/golden/NAME.txt, which FEELEM_UPDATE_GOLDEN=1 writes anew.
void compare_with_golden(const std::vector<int>& numbers, const std::string& name);

/// Where a picture is written for people when FEELEM_UI_PICTURES names a folder.
void keep_for_people(const UiPicture& picture, const std::string& name);

}  // namespace feelem::viewer::tests
