// SPDX-License-Identifier: Apache-2.0
#include "support/exchange_checks.hpp"

#include "model/vector.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace feelem::test {
namespace {

/// By fans of the corners' facets round the first corner.
double corner_volume(ElementType type, const std::vector<Point3>& at) {
    double six = 0;
    for (const FacetRow& facet : facets_of(type)) {
        const auto corners = facet_corners(facet);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Point3 a = minus(at[corners[i]], at[0]), b = minus(at[corners[i + 1]], at[0]);
            six += dot(minus(at[corners[0]], at[0]), cross(a, b));
        }
    }
    return six / 6;
}

std::string wrong_edges(ElementType type, const std::vector<Point3>& at) {
    const auto edges = edges_of(type);
    for (const EdgeRow& edge : edges) {
        if (edge.middle == kNoLocalNode) continue;
        const auto distance = [&](const EdgeRow& other) {
            Point3 centre;
            for (std::size_t k = 0; k < 3; ++k) centre[k] = 0.5 * (at[other.first][k] + at[other.second][k]);
            return length(minus(at[edge.middle], centre));
        };
        const auto nearest = std::ranges::min_element(edges, {}, distance);
        if (distance(*nearest) < distance(edge))
            return fmt::format("node {} is not on its own edge", edge.middle);
    }
    return {};
}

const char* file_of(Boiler boiler, const char* analysis) {
    static std::string path;
    path = project_file(
        fmt::format("examples/boiler/{}/{}.frd", boiler == Boiler::Linear ? "hex_linear" : "small", analysis)
    );
    return path.c_str();
}

std::unique_ptr<ModelSource> open_frd(Boiler boiler, const char* analysis) {
    Diagnostics diagnostics;
    return open_model(std::vector<std::string>{file_of(boiler, analysis)}, {}, diagnostics);
}

Result load_named(ModelSource& model, const std::string& name) {
    const auto infos = model.results();
    const auto found = std::ranges::find(infos, name, &ResultInfo::name);
    EXPECT_NE(found, infos.end()) << name;
    return found == infos.end() ? Result{} : model.load(static_cast<std::size_t>(found - infos.begin()));
}

}  // namespace

std::string wrong_node_order(const Mesh& mesh, bool mirrored) {
    for (const ElementBlock& block : mesh.blocks) {
        const ElementRow& row = element_row(block.type);
        for (std::size_t e = 0; e < block.ids.size(); ++e) {
            std::vector<Point3> at;
            for (std::size_t i = 0; i < row.node_count; ++i)
                at.push_back(mesh.coordinates[raw(block.nodes[e * row.node_count + i])]);
            std::string wrong = wrong_edges(block.type, at);
            if (!mirrored && row.dimension == 3 && corner_volume(block.type, at) <= 0)
                wrong = "the volume is not positive";
            if (!wrong.empty()) return fmt::format("{} {}: {}", row.name, raw(block.ids[e]), wrong);
        }
    }
    return {};
}

void expect_boiler_mesh(const Mesh& mesh, Boiler boiler) {
    EXPECT_EQ(wrong_node_order(mesh), "");
    const auto own = open_frd(boiler, "static");
    const Mesh& right = own->mesh();
    ASSERT_EQ(mesh.node_ids, right.node_ids);
    for (std::size_t i = 0; i < right.node_count(); ++i)
        ASSERT_LT(length(minus(mesh.coordinates[i], right.coordinates[i])), 1e-3) << i;
    ASSERT_EQ(mesh.element_count(), right.element_count());
    Diagnostics diagnostics;
    const SkinReport found = make_skin(mesh, {}, diagnostics).report;
    const SkinReport expected = make_skin(right, {}, diagnostics).report;
    EXPECT_EQ(found.solid_facets_kept, boiler == Boiler::Linear ? 2568U : 2576U);
    EXPECT_EQ(found.solid_facets_kept, expected.solid_facets_kept);
    EXPECT_TRUE(found.closed);
    EXPECT_EQ(found.inverted_elements, 0U);
    EXPECT_NEAR(found.area, expected.area, 1e-5 * expected.area);
    EXPECT_NEAR(found.volume, expected.volume, 1e-5 * expected.volume);
}

void expect_boiler_results(ModelSource& model, Boiler boiler) {
    const Result temperature = load_named(model, "temperature");
    const Result displacement = load_named(model, "displacement");
    const auto heat = open_frd(boiler, "heat");
    const auto load = open_frd(boiler, "static");
    EXPECT_EQ(temperature.values, load_named(*heat, "temperature").values);
    EXPECT_EQ(displacement.values, load_named(*load, "displacement").values);
    const Range range = range_of(temperature, 0);
    const bool linear = boiler == Boiler::Linear;
    EXPECT_EQ(range.min, linear ? 124.052F : 130.749F);
    EXPECT_EQ(range.max, linear ? 227.511F : 237.151F);
    const Range size = range_of(component_of(displacement, "magnitude"), 0);
    EXPECT_NEAR(size.max, linear ? 4.246207 : 4.085325, 1e-6);
}

}  // namespace feelem::test
