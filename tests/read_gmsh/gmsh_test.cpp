// SPDX-License-Identifier: Apache-2.0
// gmsh's files: a small box with everything in it, every version and coding, every node order by geometry,
// and the boiler.
#include "read_gmsh/msh_writer.hpp"
#include "support/exchange_checks.hpp"
#include "support/mesh_text.hpp"
#include "support/opened_model.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace feelem {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<test::OpenedModel> open_text(const std::string& text) {
    return test::open_bytes({{"test.msh", text}});
}

Error error_of(const std::string& text) {
    return test::error_of({{"test.msh", text}});
}

std::unique_ptr<test::OpenedModel> open_box() {
    return open_text(test::read_file(test::project_file("tests/data/gmsh/box.msh")));
}

/// gmsh's manual: which corners each node after the corners lies between, in gmsh's order.
struct GmshShape {
    int number;
    ElementType type;
    std::vector<std::vector<int>> between;
};
const std::vector<std::vector<int>> kHexEdges{
    {0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
const std::vector<std::vector<int>> kHexFaces{
    {0, 3, 2, 1},
    {0, 1, 5, 4},
    {0, 4, 7, 3},
    {1, 2, 6, 5},
    {2, 3, 7, 6},
    {4, 5, 6, 7},
    {0, 1, 2, 3, 4, 5, 6, 7}};
const std::vector<std::vector<int>> kPrismEdges{
    {0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
const std::vector<std::vector<int>> kPrismFaces{{0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}};

std::vector<std::vector<int>> joined(
    std::vector<std::vector<int>> a, const std::vector<std::vector<int>>& b
) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const std::vector<GmshShape> kShapes{
    {1, ElementType::Line2, {}},
    {2, ElementType::Tri3, {}},
    {3, ElementType::Quad4, {}},
    {4, ElementType::Tet4, {}},
    {5, ElementType::Hex8, {}},
    {6, ElementType::Wedge6, {}},
    {7, ElementType::Pyramid5, {}},
    {8, ElementType::Line3, {{0, 1}}},
    {9, ElementType::Tri6, {{0, 1}, {1, 2}, {2, 0}}},
    {10, ElementType::Quad9, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}}},
    {11, ElementType::Tet10, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}}},
    {12, ElementType::Hex27, joined(kHexEdges, kHexFaces)},
    {13, ElementType::Wedge18, joined(kPrismEdges, kPrismFaces)},
    {15, ElementType::Point1, {}},
    {16, ElementType::Quad8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
    {17, ElementType::Hex20, kHexEdges},
    {18, ElementType::Wedge15, kPrismEdges},
    {19, ElementType::Pyramid13, {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}}};

std::vector<std::vector<double>> places_of(const GmshShape& shape) {
    std::vector<std::vector<double>> places;
    const ElementRow& row = element_row(shape.type);
    for (std::size_t i = 0; i < row.corner_count; ++i)
        places.emplace_back(row.reference[i].begin(), row.reference[i].end());
    for (const std::vector<int>& corners : shape.between) {
        std::vector<double> centre(3);
        for (const int corner : corners) {
            for (std::size_t k = 0; k < 3; ++k)
                centre[k] +=
                    places[static_cast<std::size_t>(corner)][k] / static_cast<double>(corners.size());
        }
        places.push_back(centre);
    }
    return places;
}

TEST(Gmsh, every_shape_has_its_nodes_where_the_element_table_has_them) {
    for (const GmshShape& shape : kShapes) {
        const ElementRow& row = element_row(shape.type);
        const auto opened = open_text(test::write_msh({}, shape.number, places_of(shape)));
        const Mesh& mesh = opened->model->mesh();
        ASSERT_EQ(mesh.blocks.size(), 1U) << row.name;
        ASSERT_EQ(mesh.blocks[0].type, shape.type);
        for (std::size_t i = 0; i < row.node_count; ++i) {
            const Point3& at = mesh.coordinates[raw(mesh.blocks[0].nodes[i])];
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(at[k], row.reference[i][k], 1e-6) << row.name << " " << i;
        }
    }
}

class GmshForms : public testing::TestWithParam<std::tuple<int, bool, bool>> {};

TEST_P(GmshForms, say_the_same) {
    const auto [version, binary, big_endian] = GetParam();
    const GmshShape& tet = kShapes[10];
    const auto opened = open_text(test::write_msh({version, binary, big_endian}, tet.number, places_of(tet)));
    const Mesh& mesh = opened->model->mesh();

    EXPECT_TRUE(opened->diagnostics.entries().empty());
    EXPECT_EQ(mesh.node_count(), 10U);
    ASSERT_EQ(mesh.element_count(), 1U);
    EXPECT_EQ(mesh.blocks[0].ids[0], ElementId{7});
    EXPECT_EQ(mesh.parts[0].name, version == 22 ? "physical 4" : "volume 3");
    EXPECT_EQ(test::wrong_node_order(mesh), "");
    ASSERT_EQ(opened->model->results().size(), 1U);
    const Result result = opened->model->load(0);
    EXPECT_EQ(result.info.name, "temperature");
    EXPECT_EQ(result.values[9], 10.25F);
    EXPECT_EQ(opened->model->steps()[0].step, 4);
    EXPECT_EQ(opened->model->steps()[0].value, 2.5);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    GmshForms,
    testing::Values(
        std::tuple{22, false, false},
        std::tuple{22, true, false},
        std::tuple{22, true, true},
        std::tuple{40, false, false},
        std::tuple{40, true, false},
        std::tuple{40, true, true},
        std::tuple{41, false, false},
        std::tuple{41, true, false},
        std::tuple{41, true, true}
    )
);

TEST(Gmsh, faces_of_solids_are_sets_and_no_shells) {
    const auto box = open_box();
    const Mesh& mesh = box->model->mesh();
    ASSERT_EQ(mesh.blocks.size(), 1U);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);
    EXPECT_EQ(mesh.skipped_elements.at("quadrangle on the side of another element"), 1U);
    ASSERT_EQ(mesh.node_sets.size(), 1U);
    EXPECT_EQ(mesh.node_sets[0].name, "clamped face");
    EXPECT_EQ(mesh.node_sets[0].nodes.size(), 4U);
    EXPECT_EQ(mesh.parts[0].name, "steel");
    ASSERT_EQ(mesh.element_sets.size(), 1U);
    EXPECT_EQ(mesh.element_sets[0].name, "all of it");
}

/// Everything that a mesh says.
std::string written_out(const std::string& file) {
    const auto opened = open_text(file);
    return test::mesh_text(opened->model->mesh()) + test::diagnostics_text(opened->diagnostics);
}

/// The numbers of a section with more blanks between them than the fast way takes.
std::string spaced_out(std::string file, const std::string& section) {
    const std::size_t first = file.find("$" + section + "\n");
    const std::size_t last = file.find("$End" + section);
    std::string spaced;
    for (const char c : file.substr(first, last - first)) {
        if (c == ' ')
            spaced += "   \t \t  ";
        else
            spaced += c;
    }
    return file.replace(first, last - first, spaced);
}

TEST(Gmsh, numbers_far_apart_are_the_same_mesh) {
    const std::string box = test::read_file(test::project_file("tests/data/gmsh/box.msh"));
    std::string old = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n400\n";
    for (int i = 1; i <= 400; ++i)
        old +=
            fmt::format("{} {:.16g} {:.17g} {}\n", i, 0.1 * i, 1e7 / (i + 0.3), i % 3 == 0 ? "-1e-300" : "7");
    old += "$EndNodes\n$Elements\n391\n";
    // Now and then one that repeats nodes, names one that is not there or one beyond 32 bits.
    for (int i = 1; i <= 391; ++i) {
        const std::int64_t last = i % 97 == 0   ? std::int64_t{5'000'000'000}
                                  : i % 61 == 0 ? 1000
                                  : i % 31 == 0 ? i
                                                : i + 7;
        old += fmt::format(
            "{} 5 2 {} {} {} {} {} {} {} {} {} {}\n",
            i,
            i / 50,
            i / 70,
            i,
            i + 1,
            i + 2,
            i + 3,
            i + 4,
            i + 5,
            i + 6,
            last
        );
    }
    old += "$EndElements\n";
    for (const std::string& file : {box, old}) {
        const std::string plain = written_out(file);
        EXPECT_EQ(plain, written_out(spaced_out(file, "Nodes")));
        EXPECT_EQ(plain, written_out(spaced_out(file, "Elements")));
    }
}

TEST(Gmsh, a_plate_that_no_solid_has_stays_a_shell) {
    std::string text = test::read_file(test::project_file("tests/data/gmsh/box.msh"));
    const std::string row = "8 1 2 3 4\n";
    text.replace(text.find(row), row.size(), "8 1 2 30 40\n");
    const auto box = open_text(text);
    EXPECT_EQ(box->model->mesh().blocks.size(), 2U);
}

TEST(Gmsh, partitions_of_a_view_are_one_result) {
    const auto box = open_box();
    ASSERT_EQ(box->model->results().size(), 4U);
    const Result result = box->model->load(0);
    EXPECT_EQ(result.info.name, "temperature");
    EXPECT_EQ(result.values[0], 20.25F);
    EXPECT_EQ(result.values[1], 30.5F);
    EXPECT_TRUE(std::isnan(result.values[2]));
    EXPECT_EQ(result.values[raw(find_node(box->model->mesh(), NodeId{37}))], 80.75F);
}

TEST(Gmsh, views_of_vectors_elements_and_element_nodes_are_read) {
    const auto box = open_box();
    const Result displacement = box->model->load(1);
    EXPECT_EQ(displacement.info.shape, Shape::Vector);
    EXPECT_EQ(displacement.values[7], -0.2F);
    EXPECT_EQ(box->model->steps()[displacement.info.step].value, 1.5);

    const Result density = box->model->load(2);
    EXPECT_EQ(density.info.location, Location::Elemental);
    EXPECT_TRUE(std::isnan(density.values[0]));
    EXPECT_EQ(density.values[1], 7.8F);
    EXPECT_EQ(box->diagnostics.count(Code::ResultWithoutNode), 1U);

    const Result stress = box->model->load(3);
    EXPECT_EQ(stress.info.name, "stress");
    EXPECT_EQ(stress.info.shape, Shape::SymmetricTensor);
    EXPECT_EQ(stress.row_count(), 8U);
    const std::vector<float> first(stress.values.begin(), stress.values.begin() + 9);
    EXPECT_THAT(first, ElementsAre(11, 22, 33, 12, 23, 13, 12, 23, 13));
    EXPECT_EQ(box->model->mesh().node_ids[raw(stress.row_node[0])], NodeId{10});
}

TEST(Gmsh, elements_of_higher_order_are_named_and_left_out) {
    const auto opened = open_text(test::write_msh({}, 21, std::vector(10, std::vector<double>{0, 0, 0})));
    EXPECT_EQ(opened->model->mesh().element_count(), 0U);
    EXPECT_EQ(opened->diagnostics.count(Code::UnknownElementType), 1U);
}

TEST(Gmsh, other_versions_are_refused_with_a_hint) {
    const Error error = error_of("$MeshFormat\n3.0 0 8\n$EndMeshFormat\n");
    EXPECT_EQ(error.code(), Code::BadStructure);
    EXPECT_THAT(error.what(), HasSubstr("-format msh41"));
}

TEST(Gmsh, counts_beyond_the_file_are_refused) {
    const Error error =
        error_of("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n999999999999\n1 0 0 0\n$EndNodes\n");
    EXPECT_EQ(error.code(), Code::Truncated);
    EXPECT_EQ(error.where(), "test.msh:5");
}

TEST(Gmsh, section_without_end_is_reported) {
    std::string text = test::write_msh({}, 4, places_of(kShapes[3]));
    text.resize(text.find("$EndNodeData"));
    const auto opened = open_text(text);
    EXPECT_TRUE(opened->model->results().empty());
    EXPECT_TRUE(opened->diagnostics.has(Code::TruncatedInput));
}

void expect_boiler(const std::string& name, test::Boiler boiler, bool has_results) {
    SCOPED_TRACE(name);
    Diagnostics diagnostics;
    const auto model =
        open_model(std::vector<std::string>{*test::corpus_file("converted/" + name)}, {}, diagnostics);
    EXPECT_TRUE(diagnostics.entries().empty());
    test::expect_boiler_mesh(model->mesh(), boiler);
    if (has_results) test::expect_boiler_results(*model, boiler);
}

TEST(Gmsh, boilers_are_the_boilers_of_the_frd) {
    if (!test::corpus_file("converted/ORIGINS.md")) GTEST_SKIP() << "the corpus is not here";
    expect_boiler("boiler_linear_22.msh", test::Boiler::Linear, true);
    expect_boiler("boiler_linear_41.msh", test::Boiler::Linear, false);
    expect_boiler("boiler_tet10_22.msh", test::Boiler::Quadratic, true);
}

}  // namespace
}  // namespace feelem
