// SPDX-License-Identifier: Apache-2.0
// The boiler, linear and quadratic: its sections against its skin, its places against its sections.
#include "inside/section_checks.hpp"
#include "model/vector.hpp"
#include "support/opened_model.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/inside.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace feelem {
namespace {

class BoilerInside : public testing::TestWithParam<const char*> {
protected:
    BoilerInside()
        : opened_(test::open_path(
              test::project_file(std::string("examples/boiler/") + GetParam() + "/static.frd")
          )),
          mesh_(opened_->model->mesh()), solids_(find_solids(mesh_)) {
        for (std::size_t i = 0; i < opened_->model->results().size(); ++i) {
            const ResultInfo& info = opened_->model->results()[i];
            if (info.name == "stress") stress_ = component_of(opened_->model->load(i), "von_mises");
        }
        skin_ = make_skin(mesh_, {}, opened_->diagnostics);
    }

    std::vector<Plane> planes() const {
        Point3 low = mesh_.coordinates[0], high = low;
        for (const Point3& p : mesh_.coordinates) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
        std::vector<Plane> out;
        for (const Point3& normal : {Point3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}, {-3, 1, 0.5}}) {
            for (const double share : {0.123, 0.3571, 0.5037, 0.881}) {
                Point3 through{};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    through[axis] = low[axis] + share * (high[axis] - low[axis]);
                out.push_back({normal, dot(normal, through)});
            }
        }
        return out;
    }

    std::unique_ptr<test::OpenedModel> opened_;
    const Mesh& mesh_;
    Solids solids_;
    Result stress_;
    Surface skin_;
};

TEST_P(BoilerInside, every_section_has_the_rim_and_the_area_that_the_skin_goes_round) {
    const SurfaceField field = carry(mesh_, skin_, stress_);
    int cut = 0;
    for (const Plane& plane : planes()) {
        const auto rim = test::rim_of_skin(skin_, field, plane);
        const Section section = cut_plane(solids_, {&stress_, 0}, plane).value();
        const double area = test::area_within(rim, plane);
        EXPECT_NEAR(section.area, area, 1e-9 * area);
        EXPECT_EQ(test::rim_difference(section, rim), "");
        EXPECT_EQ(section.triangles.empty(), rim.empty());
        if (area > 0) ++cut;
    }
    EXPECT_GE(cut, 16);  // The others pass the boiler by.
}

TEST_P(BoilerInside, the_rim_of_a_section_has_the_values_that_the_skin_shows_there) {
    const SurfaceField field = carry(mesh_, skin_, stress_);
    const float largest = *std::ranges::max_element(field.values);
    ASSERT_GT(largest, 0);
    for (const Plane& plane : planes()) {
        const auto rim = test::rim_of_skin(skin_, field, plane);
        const Section section = cut_plane(solids_, {&stress_, 0}, plane).value();
        EXPECT_EQ(test::rim_value_difference(section, rim, 2.4e-7 * double(largest)), "");
    }
}

TEST_P(BoilerInside, places_of_a_section_are_found_in_its_element_or_beside_it) {
    const InteriorFinder finder(solids_);
    const Section section = cut_plane(solids_, {&stress_, 0}, planes()[2]).value();
    std::size_t same = 0, found_count = 0;
    for (std::size_t t = 0; t < section.triangles.size(); ++t) {
        Point3 middle{};
        for (const std::uint32_t v : section.triangles[t]) {
            for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += section.positions[v][axis] / 3;
        }
        const auto found = finder.find(middle);
        if (!found) continue;
        ++found_count;
        if (found->element == section.triangle_element[t]) ++same;
        // In a brick or a curved element the section is a drawing by tetrahedra: near the true value, not on
        // it.
        const InteriorValue value = value_at(mesh_, {&stress_, 0}, *found);
        const auto [low, high] = std::ranges::minmax(value.node_values);
        const float shown = section.values[section.triangles[t][0]];
        EXPECT_GE(shown, low - 0.5F * (high - low) - 1);
        EXPECT_LE(shown, high + 0.5F * (high - low) + 1);
    }
    // Chords of the inner wall lie a little outside the curved material.
    EXPECT_GT(found_count, section.triangles.size() * 97 / 100);
    EXPECT_GT(same, found_count * 97 / 100);
}

TEST_P(BoilerInside, each_element_is_found_by_its_own_middle) {
    const InteriorFinder finder(solids_);
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < mesh_.element_count(); ++i) {
        const ElementRef element = element_at(mesh_, ElementIndex{i});
        Point3 middle{};
        const std::size_t corners = element_row(element.block->type).corner_count;
        for (std::size_t k = 0; k < corners; ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                middle[axis] += mesh_.coordinates[raw(element.nodes()[k])][axis] / double(corners);
        }
        const auto found = finder.find(middle);
        if (!found || found->element != ElementIndex{i}) ++wrong;
    }
    EXPECT_EQ(wrong, 0U);
}

INSTANTIATE_TEST_SUITE_P(Meshes, BoilerInside, testing::Values("hex_linear", "small"), [](const auto& mesh) {
    return std::string(mesh.param);
});

}  // namespace
}  // namespace feelem
