// SPDX-License-Identifier: Apache-2.0
// Real result files of releases 13.0 to 25.1 against answers that other programs computed.
#include "read_ansys_rst/opened_rst.hpp"
#include "support/paths.hpp"

#include "feelem/skin.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>

namespace feelem {
namespace {

using nlohmann::json;
using test::OpenedRst;
using test::Wanted;

struct Column {
    const char* label;
    const char* name;
    const char* component;
};
constexpr std::array kColumns{
    Column{"UX", "displacement", "x"},
    Column{"UY", "displacement", "y"},
    Column{"UZ", "displacement", "z"},
    Column{"ROTX", "rotation", "x"},
    Column{"ROTY", "rotation", "y"},
    Column{"ROTZ", "rotation", "z"},
    Column{"TEMP", "temperature", "value"},
    Column{"VOLT", "electric_potential", "value"},
};

/// Eight digits are given.
void expect_close(double found, double right, const std::string& what) {
    EXPECT_NEAR(found, right, 1e-6 * std::abs(right) + 1e-30) << what;
}

/// Drawn elements by shape, others by name, as the answers name them.
std::map<std::string, std::uint64_t> shapes_of(const Mesh& mesh) {
    const std::map<ElementType, std::string> names{
        {ElementType::Line2, "line"},
        {ElementType::Tri3, "tri"},
        {ElementType::Tri6, "tri"},
        {ElementType::Quad4, "quad"},
        {ElementType::Quad8, "quad"},
        {ElementType::Tet4, "tet"},
        {ElementType::Tet10, "tet"},
        {ElementType::Pyramid5, "pyr"},
        {ElementType::Pyramid13, "pyr"},
        {ElementType::Wedge6, "wedge"},
        {ElementType::Wedge15, "wedge"},
        {ElementType::Hex8, "hex"},
        {ElementType::Hex20, "hex"},
    };
    std::map<std::string, std::uint64_t> shapes;
    for (const ElementBlock& block : mesh.blocks) shapes[names.at(block.type)] += block.ids.size();
    for (const auto& [name, count] : mesh.skipped_elements) shapes[name] += count;
    return shapes;
}

std::map<std::string, std::uint64_t> shapes_of(const json& answer, const Mesh& mesh) {
    std::map<std::string, std::uint64_t> shapes;
    for (const auto& [key, count] : answer["shapes"].items()) {
        const std::string name = key.substr(0, key.find(':')), shape = key.substr(key.find(':') + 1);
        shapes[mesh.skipped_elements.count(name) > 0 ? name : shape] += count.get<std::uint64_t>();
    }
    return shapes;
}

class RstAnswers : public testing::Test {
protected:
    void SetUp() override {
        const auto path = test::corpus_file("ansys/answers.json");
        if (!path) GTEST_SKIP() << "the corpus is not here";
        answers_ = json::parse(test::read_file(*path))["rst"];
    }

    void expect_mesh(const OpenedRst& opened, const json& answer) {
        const Mesh& mesh = opened.model->mesh();
        EXPECT_EQ(mesh.node_count(), answer["nodes"].get<std::size_t>());
        std::uint64_t elements = mesh.element_count();
        for (const auto& [name, count] : mesh.skipped_elements) elements += count;
        EXPECT_EQ(elements, answer["elements"].get<std::uint64_t>());
        EXPECT_EQ(shapes_of(mesh), shapes_of(answer, mesh));
        EXPECT_EQ(opened.model->solver().version, answer["version"].get<std::string>());
        Diagnostics ignored;
        const Surface surface = make_skin(mesh, {}, ignored);
        EXPECT_EQ(surface.report.solid_tri_kept, answer["exterior_solid_faces"]["tri"].get<std::uint64_t>());
        EXPECT_EQ(
            surface.report.solid_quad_kept, answer["exterior_solid_faces"]["quad"].get<std::uint64_t>()
        );
    }

    std::uint32_t find_step(const OpenedRst& opened, const json& set) {
        const auto steps = opened.model->steps();
        for (std::uint32_t i = 0; i < steps.size(); ++i) {
            if (steps[i].step == set["load_step"].get<int>() && steps[i].substep == set["substep"].get<int>())
                return i;
        }
        ADD_FAILURE() << "no step " << set["load_step"] << "." << set["substep"];
        return 0;
    }

    void expect_extremes(const OpenedRst& opened, const Wanted& wanted, const json& set) {
        const auto& components = set["components"];
        for (const Column& column : kColumns) {
            if (!components.contains(column.label)) continue;
            Wanted one = wanted;
            one.name = column.name;
            const Result result = test::load_wanted(opened, one);
            const int c = component_index(result.info, column.component);
            ASSERT_GE(c, 0) << column.label;
            const Range range = range_of(result, static_cast<std::size_t>(c));
            const auto& right = components[column.label];
            expect_close(static_cast<double>(range.min), right["min"], column.label);
            expect_close(static_cast<double>(range.max), right["max"], column.label);
            // Of equal extremes the answers name another node.
            for (const char* end : {"min", "max"}) {
                const std::int64_t node = right[std::string(end) + "_node"];
                const double there =
                    static_cast<double>(test::value_at(opened, result, node, column.component));
                expect_close(there, right[end], std::string(column.label) + " at its node");
            }
            ++compared_;
        }
        if (components.contains("USUM")) expect_sum(opened, wanted, components["USUM"]);
    }

    void expect_sum(const OpenedRst& opened, Wanted wanted, const json& right) {
        wanted.name = "displacement";
        const Result u = test::load_wanted(opened, wanted);
        double most = 0;
        for (std::size_t row = 0; row < u.row_count(); ++row) {
            double sum = 0;
            for (std::size_t c = 0; c < 3; ++c)
                sum += std::pow(static_cast<double>(u.values[3 * row + c]), 2);
            most = std::max(most, std::isnan(sum) ? 0 : std::sqrt(sum));
        }
        expect_close(most, right["max"], "USUM");
    }

    /// Unknowns that nodes of the solution do not have.
    std::uint64_t missing_of(const OpenedRst& opened, const Wanted& wanted) {
        std::uint64_t missing = 0;
        const auto results = opened.model->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            const bool other =
                results[i].averaging == Averaging::Solver || results[i].name.starts_with("reaction");
            const bool rate =
                results[i].name.ends_with("velocity") || results[i].name.ends_with("acceleration");
            if (results[i].step != wanted.step || results[i].complex != wanted.complex || other || rate ||
                results[i].location != Location::Nodal)
                continue;
            for (const float value : opened.model->load(i).values) missing += std::isnan(value) ? 1U : 0U;
        }
        return missing;
    }

    json answers_;
    int compared_ = 0;
};

TEST_F(RstAnswers, every_file_agrees_in_mesh_steps_and_extremes) {
    int files = 0;
    for (const auto& [path, answer] : answers_.items()) {
        SCOPED_TRACE(path);
        const OpenedRst opened = test::open_corpus({path});
        ASSERT_TRUE(opened.model);
        ++files;
        expect_mesh(opened, answer);
        bool is_complex = false;
        for (const ResultInfo& info : opened.model->results())
            is_complex = is_complex || info.complex != Complex::No;
        const auto sets = answer["sets_in_file"].get<std::size_t>();
        EXPECT_EQ(opened.model->steps().size() * (is_complex ? 2 : 1), sets);
        for (const auto& set : answer["sets"]) {
            SCOPED_TRACE("set " + set["set"].dump());
            Wanted wanted;
            wanted.step = find_step(opened, set);
            const bool imaginary = set["set"].get<int>() % 2 == 0;
            if (is_complex) wanted.complex = imaginary ? Complex::Imaginary : Complex::Real;
            EXPECT_NEAR(
                opened.model->steps()[wanted.step].value,
                set["time"].get<double>(),
                1e-5 * set["time"].get<double>()
            );
            expect_extremes(opened, wanted, set);
            const std::uint64_t outside =
                answer["nodes"].get<std::uint64_t>() - answer["result_nodes"].get<std::uint64_t>();
            const std::uint64_t unknowns = set["components"].size() - set["components"].count("USUM");
            EXPECT_EQ(
                missing_of(opened, wanted) - outside * unknowns,
                set.contains("missing") ? set["missing"].get<std::uint64_t>() : 0u
            );
        }
    }
    EXPECT_GE(files, 24);
    EXPECT_GE(compared_, 170);
}

// It holds its unknowns in the packing with both bits, which public readers turn into 1e300.
TEST_F(RstAnswers, grouped_columns_give_displacements_and_rotations_that_are_missing_on_solids) {
    const OpenedRst opened = test::open_corpus({"workbench/extract_shell_layer/mixed_shell_solid.rst"});
    ASSERT_TRUE(opened.model);
    const Result u = test::load_wanted(opened, {"displacement"});
    const Result rotation = test::load_wanted(opened, {"rotation"});
    EXPECT_FLOAT_EQ(test::value_at(opened, u, 66, "x"), 0.000702445F);
    EXPECT_FLOAT_EQ(test::value_at(opened, rotation, 71, "y"), -9.062928e-05F);
    std::uint64_t without = 0;
    for (const float value : u.values) EXPECT_LT(std::abs(value), 1e-3F);
    for (const float value : rotation.values) without += std::isnan(value) ? 1U : 0U;
    EXPECT_EQ(without, 132u);  // 44 nodes of solids, three rotations each.
    EXPECT_EQ(u.info.unit, "mm");
}

}  // namespace
}  // namespace feelem
