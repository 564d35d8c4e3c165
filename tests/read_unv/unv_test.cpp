// SPDX-License-Identifier: Apache-2.0
// What a universal file says, on a small plate and on short texts.
#include "read/read_format.hpp"
#include "support/exchange_checks.hpp"
#include "support/mesh_text.hpp"
#include "support/meshes.hpp"
#include "support/opened_model.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feelem {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<test::OpenedModel> open_text(const std::string& text) {
    return test::open_bytes({{"test.unv", text}});
}

std::unique_ptr<test::OpenedModel> open_plate() {
    return open_text(test::read_file(test::project_file("tests/data/unv/plate.unv")));
}

Error error_of(const std::string& text) {
    return test::error_of({{"test.unv", text}});
}

std::string dataset(int number, const std::string& records) {
    return fmt::format("    -1\n{:6}\n{}    -1\n", number, records);
}

std::string nodes_text(const Mesh& mesh) {
    std::string out;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        const Point3& at = mesh.coordinates[i];
        out += fmt::format(
            "{:10}{:10}{:10}{:10}\n{:25.16E}{:25.16E}{:25.16E}\n",
            raw(mesh.node_ids[i]),
            1,
            1,
            11,
            at[0],
            at[1],
            at[2]
        );
    }
    return out;
}

const Result load_named(ModelSource& model, const std::string& name) {
    for (std::size_t i = 0; i < model.results().size(); ++i) {
        if (model.results()[i].name == name) return model.load(i);
    }
    ADD_FAILURE() << "no result " << name;
    return {};
}

std::vector<float> row_of(const Mesh& mesh, const Result& result, std::int64_t node) {
    const auto row = static_cast<std::ptrdiff_t>(raw(find_node(mesh, NodeId{node}))) *
                     static_cast<std::ptrdiff_t>(result.component_count());
    return {
        result.values.begin() + row,
        result.values.begin() + row + static_cast<std::ptrdiff_t>(result.component_count())};
}

TEST(Unv, plate_has_its_nodes_elements_parts_and_sets) {
    const auto plate = open_plate();
    const Mesh& mesh = plate->model->mesh();

    EXPECT_EQ(mesh.node_count(), 7U);
    EXPECT_EQ(mesh.coordinates[raw(find_node(mesh, NodeId{22}))], (Point3{2, 1.5, 0.25}));
    ASSERT_EQ(mesh.blocks.size(), 3U);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Quad4);
    EXPECT_EQ(mesh.blocks[1].type, ElementType::Tri3);
    EXPECT_EQ(mesh.blocks[2].type, ElementType::Line2);
    EXPECT_EQ(mesh.parts[raw(mesh.blocks[1].parts[0])].name, "property 4");
    EXPECT_THAT(
        mesh.skipped_elements,
        ElementsAre(
            std::pair<const std::string, std::uint64_t>("lumped mass (161)", 1),
            std::pair<const std::string, std::uint64_t>("spring (136)", 1)
        )
    );
    ASSERT_EQ(mesh.node_sets.size(), 1U);
    EXPECT_EQ(mesh.node_sets[0].name, "clamped edge");
    EXPECT_THAT(mesh.node_sets[0].nodes, ElementsAre(NodeIndex{0}, NodeIndex{3}));
    ASSERT_EQ(mesh.element_sets.size(), 1U);
    EXPECT_EQ(mesh.element_sets[0].name, "triangles");
    EXPECT_THAT(mesh.element_sets[0].elements, ElementsAre(ElementIndex{1}, ElementIndex{2}));
    ASSERT_TRUE(mesh.length_unit);
    EXPECT_EQ(mesh.length_unit->name, "mm");
}

TEST(Unv, nodal_scalars_of_a_time_step_are_read_and_gaps_stay_gaps) {
    const auto plate = open_plate();
    const Result result = load_named(*plate->model, "temperature");
    const Step& step = plate->model->steps()[result.info.step];

    EXPECT_EQ(step.kind, StepKind::Time);
    EXPECT_EQ(step.step, 3);
    EXPECT_EQ(step.value, 90);
    EXPECT_EQ(result.info.solver_name, "Temperatures");
    EXPECT_THAT(row_of(plate->model->mesh(), result, 12), ElementsAre(22.5F));
    EXPECT_TRUE(std::isnan(row_of(plate->model->mesh(), result, 22)[0]));
    EXPECT_EQ(plate->diagnostics.count(Code::ResultWithoutNode), 1U);
}

TEST(Unv, complex_six_dof_vectors_are_translations_and_rotations_in_two_parts) {
    const auto plate = open_plate();
    const auto infos = plate->model->results();
    const Mesh& mesh = plate->model->mesh();

    ASSERT_GE(infos.size(), 5U);
    EXPECT_EQ(infos[1].name, "displacement");
    EXPECT_EQ(infos[1].complex, Complex::Real);
    EXPECT_EQ(infos[2].complex, Complex::Imaginary);
    EXPECT_EQ(infos[3].name, "rotation");
    EXPECT_THAT(row_of(mesh, plate->model->load(1), 22), ElementsAre(1, 3, 5));
    EXPECT_THAT(row_of(mesh, plate->model->load(2), 22), ElementsAre(2, 4, 6));
    EXPECT_THAT(row_of(mesh, plate->model->load(3), 22), ElementsAre(0, -9, 11));  // -7e-101 is 0 as a float
    EXPECT_THAT(row_of(mesh, plate->model->load(4), 22), ElementsAre(-8, 10, 12));
    const Step& step = plate->model->steps()[infos[1].step];
    EXPECT_EQ(step.kind, StepKind::Mode);
    EXPECT_EQ(step.step, 4);
    EXPECT_EQ(step.value, 125.5);
}

TEST(Unv, stresses_at_nodes_of_elements_are_reordered_and_sorted_by_element) {
    const auto plate = open_plate();
    const Result result = load_named(*plate->model, "stress");

    EXPECT_EQ(result.info.location, Location::ElementNodal);
    EXPECT_EQ(result.info.shape, Shape::SymmetricTensor);
    EXPECT_THAT(result.row_owner, ElementsAre(0, 0, 0, 0, 1, 1, 1));
    const Mesh& mesh = plate->model->mesh();
    EXPECT_EQ(mesh.node_ids[raw(result.row_node[4])], NodeId{11});
    const std::vector<float> quad(result.values.begin(), result.values.begin() + 6);
    EXPECT_THAT(quad, ElementsAre(100, 300, 600, 200, 500, 400));
    const std::vector<float> corner(result.values.begin() + 30, result.values.begin() + 36);
    EXPECT_THAT(corner, ElementsAre(4.1F, 5.2F, 6.3F, 4.2F, 5.3F, 4.3F));
}

TEST(Unv, older_datasets_are_read) {
    const auto plate = open_plate();
    const Result energy = load_named(*plate->model, "strain_energy");
    EXPECT_EQ(energy.info.location, Location::Elemental);
    EXPECT_EQ(energy.values[0], 1.5F);
    EXPECT_EQ(energy.values[2], 5.5F);
    EXPECT_TRUE(std::isnan(energy.values[1]));
    EXPECT_EQ(plate->diagnostics.count(Code::SeveralValuesAtNode), 1U);

    const auto infos = plate->model->results();
    const auto old = std::ranges::find(infos, "Old displacements", &ResultInfo::solver_name);
    ASSERT_NE(old, infos.end());
    const Result shape = plate->model->load(static_cast<std::size_t>(old - infos.begin()));
    EXPECT_THAT(row_of(plate->model->mesh(), shape, 10), ElementsAre(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(plate->model->steps()[old->step].value, 125.5);
}

struct Parabolic {
    ElementType type;
    int descriptor;
    std::vector<int> order;  ///< Node ids of the reference element, in the file's interleaved order.
};

TEST(Unv, parabolic_elements_have_their_mid_side_nodes_between_the_corners) {
    const std::vector<Parabolic> cases{
        {ElementType::Line3, 24, {1, 3, 2}},
        {ElementType::Tri6, 92, {1, 4, 2, 5, 3, 6}},
        {ElementType::Quad8, 95, {1, 5, 2, 6, 3, 7, 4, 8}},
        {ElementType::Tet10, 118, {1, 5, 2, 6, 3, 7, 8, 9, 10, 4}},
        {ElementType::Wedge15, 113, {1, 7, 2, 8, 3, 9, 13, 14, 15, 4, 10, 5, 11, 6, 12}},
        {ElementType::Hex20, 116, {1, 9, 2, 10, 3, 11, 4, 12, 17, 18, 19, 20, 5, 13, 6, 14, 7, 15, 8, 16}}};
    for (const Parabolic& one : cases) {
        const Mesh reference = test::one_element(one.type);
        std::string row =
            fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, one.descriptor, 1, 1, 7, one.order.size());
        if (one.descriptor == 24) row += fmt::format("{:10}{:10}{:10}\n", 0, 1, 1);
        for (std::size_t i = 0; i < one.order.size(); ++i)
            row += fmt::format("{:10}{}", one.order[i], i % 8 == 7 || i + 1 == one.order.size() ? "\n" : "");
        const auto opened = open_text(dataset(2411, nodes_text(reference)) + dataset(2412, row));
        const Mesh& mesh = opened->model->mesh();
        ASSERT_EQ(mesh.blocks.size(), 1U);
        EXPECT_EQ(mesh.blocks[0].type, one.type);
        EXPECT_EQ(mesh.blocks[0].nodes, reference.blocks[0].nodes) << element_row(one.type).name;
        EXPECT_EQ(test::wrong_node_order(mesh), "");
    }
}

TEST(Unv, oldest_nodes_stand_in_their_own_coordinate_system) {
    const std::string systems = dataset(
        2420,
        "         1\npart\n         2         1         8\ncylinder\n"
        "  0.0  1.0  0.0\n  -1.0  0.0  0.0\n  0.0  0.0  1.0\n  10.0  20.0  30.0\n"
    );
    const auto opened = open_text(
        systems +
        dataset(15, "         1         2         0         0  2.00000E+00  9.00000E+01  5.00000E+00\n")
    );
    const Point3 at = opened->model->mesh().coordinates[0];
    EXPECT_NEAR(at[0], 8, 1e-12);
    EXPECT_NEAR(at[1], 20, 1e-12);
    EXPECT_NEAR(at[2], 35, 1e-12);
}

TEST(Unv, elements_of_dataset_780_are_read) {
    const Mesh quad = test::one_element(ElementType::Quad4);
    const auto opened = open_text(
        dataset(781, nodes_text(quad)) +
        dataset(
            780,
            "        77        94         1         6         1         2         7         4\n"
            "         1         2         3         4\n"
        )
    );
    const Mesh& mesh = opened->model->mesh();
    ASSERT_EQ(mesh.element_count(), 1U);
    EXPECT_EQ(mesh.blocks[0].ids[0], ElementId{77});
    EXPECT_EQ(mesh.parts[0].name, "property 6");
}

TEST(Unv, file_that_ends_within_a_dataset_is_reported) {
    std::string text = dataset(2411, nodes_text(test::one_element(ElementType::Tet4)));
    text.resize(text.size() - 7);
    const auto opened = open_text(text);
    EXPECT_EQ(opened->model->mesh().node_count(), 4U);
    EXPECT_TRUE(opened->diagnostics.has(Code::TruncatedInput));
}

TEST(Unv, damaged_node_is_an_error_with_its_line) {
    const Error error = error_of(dataset(2411, "         1         1         1        11\n  0.0  x  0.0\n"));
    EXPECT_EQ(error.code(), Code::BadNumber);
    EXPECT_EQ(error.where(), "test.unv:4");
}

TEST(Unv, unknown_shapes_are_named) {
    const Mesh quad = test::one_element(ElementType::Quad4);
    const auto opened = open_text(
        dataset(2411, nodes_text(quad)) +
        dataset(2412, "         1       114         1         1         7         2\n         1         2\n")
    );
    EXPECT_EQ(opened->model->mesh().element_count(), 0U);
    EXPECT_EQ(opened->diagnostics.count(Code::UnknownElementType), 1U);
}

TEST(Unv, results_alone_say_that_the_mesh_is_missing) {
    const Error error = error_of(dataset(55, "a\n\n\n\n\n"));
    EXPECT_EQ(error.code(), Code::NoNodes);
    EXPECT_THAT(error.what(), HasSubstr("Were results exported alone?"));
}

TEST(Unv, other_text_is_not_taken_for_a_universal_file) {
    EXPECT_EQ(error_of("    -1\nnot a number\n").code(), Code::UnknownFormat);
    EXPECT_EQ(error_of("         1\n").code(), Code::UnknownFormat);
}

std::string mesh_written_out(const std::string& file) {
    const auto opened = test::open_bytes({{"test.unv", file}});
    return test::mesh_text(opened->model->mesh()) + test::diagnostics_text(opened->diagnostics);
}

TEST(Unv, numbers_parted_by_tabs_are_the_same_mesh) {
    std::string file = "    -1\n  2411\n";
    for (int i = 1; i <= 600; ++i) {
        std::string reals = fmt::format("{:25.16E}{:25.16E}{:25.16E}", 1.0 / i, -1e5 / 3 * i, 2e-9 * i);
        std::ranges::replace(reals, 'E', 'D');
        file += fmt::format("{:10}{:10}{:10}{:10}\n{}\n", i, 1, 1, 11, reals);
    }
    file += "    -1\n    -1\n  2412\n";
    for (int i = 1; i <= 500; ++i) {
        // Bricks; now and then a beam with its own line, a mass, a long tetrahedron, a node that is not
        // there.
        if (i % 41 == 0) {
            file += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", i, 21, 7, 1, 7, 2);
            file += fmt::format("{:10}{:10}{:10}\n{:10}{:10}\n", 0, 1, 1, i, i + 1);
        } else if (i % 43 == 0) {
            file += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n{:10}\n", i, 161, 7, 1, 7, 1, i);
        } else if (i % 17 == 0) {
            file += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", i, 118, 2, 1, 7, 10);
            for (int k = 0; k < 10; ++k) file += fmt::format("{:10}{}", i + k, k == 7 || k == 9 ? "\n" : "");
        } else {
            file += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", i, 115, 1 + i / 200, 1, 7, 8);
            for (int k = 0; k < 8; ++k) file += fmt::format("{:10}", i % 71 == 0 && k == 7 ? 900 : i + k);
            file += '\n';
        }
    }
    file += "    -1\n";
    std::string odd;
    for (std::size_t at = 0; at < file.size();) {
        const std::size_t end = file.find('\n', at);
        std::string line = file.substr(at, end + 1 - at);
        if (line.size() > 8) std::ranges::replace(line, ' ', '\t');
        odd += line;
        at = end + 1;
    }

    EXPECT_EQ(mesh_written_out(file), mesh_written_out(odd));
    EXPECT_NE(mesh_written_out(file).find("tet10: 17"), std::string::npos);
}

}  // namespace
}  // namespace feelem
