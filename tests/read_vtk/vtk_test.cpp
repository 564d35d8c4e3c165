// SPDX-License-Identifier: Apache-2.0
// Files that the helper program reads through VTK: the boiler in each of them, our own .vtu back again, real
// Exodus and d3plot files against their right answers, and small files of each further kind.
#include "support/exchange_checks.hpp"
#include "support/meshes.hpp"
#include "support/opened_model.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"
#include "feelem/write.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

namespace feelem {
namespace {

using nlohmann::json;
using test::error_of;
using test::open_bytes;
using test::open_path;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kWedge = R"(# vtk DataFile Version 3.0
one wedge, its triangle 0 1 2 facing away from 3 4 5
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 double
0 0 0
0 1 0
1 0 0
0 0 2
0 1 2
1 0 2
CELLS 1 7
6 0 1 2 3 4 5
CELL_TYPES 1
13
POINT_DATA 6
SCALARS Temp double 1
LOOKUP_TABLE default
1.5 2.5 3.5 4.5 5.5 6.5
VECTORS disp double
1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18
CELL_DATA 1
SCALARS density float 1
LOOKUP_TABLE default
7.75
)";

/// Skips where the helper or VTK is not there (builds without programs, machines without libvtk9-dev).
class Vtk : public testing::Test {
protected:
    void SetUp() override {
        try {
            open_bytes({{"wedge.vtk", kWedge}});
        } catch (const Error& error) {
            if (error.code() == Code::UnsupportedFormat) GTEST_SKIP() << error.what();
            throw;
        }
    }
    static std::string corpus(const std::string& path) { return test::corpus_file(path).value_or(""); }
};

TEST_F(Vtk, wedge_of_a_legacy_file_is_turned_into_feelems_order) {
    const auto opened = open_bytes({{"wedge.vtk", kWedge}});
    const Mesh& mesh = opened->model->mesh();
    ASSERT_EQ(mesh.blocks.size(), 1U);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Wedge6);
    EXPECT_EQ(test::wrong_node_order(mesh), "");
    EXPECT_THAT(
        mesh.blocks[0].nodes,
        ElementsAre(NodeIndex{0}, NodeIndex{2}, NodeIndex{1}, NodeIndex{3}, NodeIndex{5}, NodeIndex{4})
    );
    EXPECT_EQ(mesh.node_ids[0], NodeId{1});
}

TEST_F(Vtk, arrays_of_a_legacy_file_are_results) {
    const auto opened = open_bytes({{"wedge.vtk", kWedge}});
    const auto infos = opened->model->results();
    ASSERT_EQ(infos.size(), 3U);
    EXPECT_EQ(infos[0].name, "temperature");
    EXPECT_EQ(infos[0].solver_name, "Temp");
    const Result temperature = opened->model->load(0);
    EXPECT_EQ(temperature.values[2], 3.5F);
    EXPECT_EQ(temperature.values[3], 4.5F);
    EXPECT_EQ(infos[1].name, "displacement");
    EXPECT_EQ(opened->model->load(1).values[4], 5.0F);
    EXPECT_EQ(infos[2].location, Location::Elemental);
    EXPECT_EQ(opened->model->load(2).values[0], 7.75F);
}

TEST_F(Vtk, every_element_of_our_own_vtu_comes_back_as_it_was) {
    const std::string folder = test::scratch_folder("vtk_back");
    for (std::size_t i = 0; i < kElementTypeCount; ++i) {
        const Mesh mesh = test::one_element(static_cast<ElementType>(i));
        const std::string file = fmt::format("{}/{}.vtu", folder, i);
        write_vtu(file, mesh, {});
        const auto opened = open_path(file);
        const Mesh& back = opened->model->mesh();
        EXPECT_EQ(back.node_ids, mesh.node_ids);
        EXPECT_EQ(back.coordinates, mesh.coordinates);
        ASSERT_EQ(back.blocks.size(), 1U);
        EXPECT_EQ(back.blocks[0].type, mesh.blocks[0].type);
        EXPECT_EQ(back.blocks[0].ids, mesh.blocks[0].ids);
        EXPECT_EQ(back.blocks[0].nodes, mesh.blocks[0].nodes) << element_row(mesh.blocks[0].type).name;
    }
}

TEST_F(Vtk, boilers_are_the_boilers_of_the_frd) {
    if (corpus("converted/ORIGINS.md").empty()) GTEST_SKIP() << "the corpus is not here";
    for (const char* name :
         {"boiler_linear.vtk",
          "boiler_linear_ascii.vtk",
          "boiler_linear.vtu",
          "boiler_linear_bin.vtu",
          "boiler_linear.exo",
          "boiler_tet10.exo",
          "boiler_tet10_bin.vtu"}) {
        SCOPED_TRACE(name);
        const bool linear = std::string(name).find("linear") != std::string::npos;
        const test::Boiler boiler = linear ? test::Boiler::Linear : test::Boiler::Quadratic;
        const auto opened = open_path(corpus(std::string("converted/") + name));
        EXPECT_TRUE(opened->diagnostics.entries().empty());
        test::expect_boiler_mesh(opened->model->mesh(), boiler);
        test::expect_boiler_results(*opened->model, boiler);
    }
}

TEST_F(Vtk, series_has_the_temperatures_of_the_transient_run) {
    const std::string file = corpus("converted/series/boiler.pvd");
    if (file.empty()) GTEST_SKIP() << "the corpus is not here";
    const auto opened = open_path(file);
    const json answers =
        json::parse(test::read_file(test::project_file("examples/boiler/hex_linear/results.json")));
    const json& results = answers["transient"]["results"];
    const auto infos = opened->model->results();
    EXPECT_EQ(opened->model->inputs().size(), 9U);
    ASSERT_EQ(opened->model->steps().size(), 8U);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].name != "temperature") continue;
        const Step& step = opened->model->steps()[infos[i].step];
        const auto answer = std::ranges::find_if(results, [&](const json& one) {
            return one["name"] == "NDTEMP" && one["value"].get<double>() == step.value;
        });
        ASSERT_NE(answer, results.end()) << step.value;
        const Result result = opened->model->load(i);
        const Range range = range_of(result, 0);
        EXPECT_EQ(range.min, (*answer)["comps"]["T"]["min"].get<float>()) << step.value;
        EXPECT_EQ(range.max, (*answer)["comps"]["T"]["max"].get<float>()) << step.value;
        ++compared;
    }
    EXPECT_EQ(compared, 8U);
}

TEST_F(Vtk, series_in_memory_finds_its_files_among_the_inputs) {
    const std::string file = corpus("converted/series/boiler.pvd");
    if (file.empty()) GTEST_SKIP() << "the corpus is not here";
    const std::string folder = std::filesystem::path(file).parent_path().string() + "/";
    std::vector<NamedBytes> files{{"boiler.pvd", test::read_file(file)}};
    for (int i = 0; i < 8; ++i) {
        const std::string name = fmt::format("t{:02}.vtu", i);
        files.push_back({name, test::read_file(folder + name)});
    }
    const auto opened = open_bytes(std::move(files));
    EXPECT_EQ(opened->model->mesh().element_count(), 1272U);
}

std::vector<std::string> exodus_names(const json& answers) {
    std::vector<std::string> names;
    for (const auto& [name, answer] : answers.items()) names.push_back(name);
    return names;
}

/// Nodes of a part, each once.
std::vector<NodeIndex> nodes_of_part(const Mesh& mesh, std::size_t part) {
    std::vector<NodeIndex> nodes;
    for (const ElementBlock& block : mesh.blocks) {
        const std::size_t width = element_row(block.type).node_count;
        for (std::size_t e = 0; e < block.ids.size(); ++e) {
            if (raw(block.parts[e]) != part) continue;
            for (std::size_t i = 0; i < width; ++i) nodes.push_back(block.nodes[e * width + i]);
        }
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::size_t elements_of_part(const Mesh& mesh, std::size_t part) {
    std::size_t count = 0;
    for (const ElementBlock& block : mesh.blocks)
        count += static_cast<std::size_t>(
            std::ranges::count(block.parts, PartIndex{static_cast<std::uint32_t>(part)})
        );
    return count;
}

void expect_exodus_block(ModelSource& model, std::size_t part, const json& answer) {
    const Mesh& mesh = model.mesh();
    const std::vector<NodeIndex> nodes = nodes_of_part(mesh, part);
    EXPECT_EQ(nodes.size(), answer["points"].get<std::size_t>());
    EXPECT_EQ(elements_of_part(mesh, part), answer["cells"].get<std::size_t>());
    for (const auto& [array, range] : answer["point_arrays_last_step"].items()) {
        SCOPED_TRACE(array);
        std::size_t last = model.results().size();
        for (std::size_t i = 0; i < model.results().size(); ++i) {
            if (model.results()[i].solver_name == array) last = i;
        }
        ASSERT_LT(last, model.results().size());
        EXPECT_EQ(model.results()[last].step + 1, model.steps().size());
        const Result result = model.load(last);
        float min = std::numeric_limits<float>::infinity(), max = -min;
        for (const NodeIndex node : nodes) {
            for (std::size_t c = 0; c < result.component_count(); ++c) {
                const float value = result.values[raw(node) * result.component_count() + c];
                min = std::min(min, value);
                max = std::max(max, value);
            }
        }
        EXPECT_EQ(min, range[0].get<float>());
        EXPECT_EQ(max, range[1].get<float>());
    }
}

TEST_F(Vtk, exodus_files_agree_with_their_answers) {
    const std::string file = corpus("exodus/answers.json");
    if (file.empty()) GTEST_SKIP() << "the corpus is not here";
    const json answers = json::parse(test::read_file(file));
    for (const std::string& name : exodus_names(answers)) {
        SCOPED_TRACE(name);
        const json& answer = answers[name];
        const auto opened = open_path(std::filesystem::path(file).parent_path().string() + "/" + name);
        const Mesh& mesh = opened->model->mesh();
        ASSERT_EQ(mesh.parts.size(), answer["blocks"].size());
        if (!opened->model->results().empty()) {
            EXPECT_EQ(opened->model->steps().size(), answer["steps"].get<std::size_t>());
        }
        for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
            SCOPED_TRACE(mesh.parts[part].name);
            expect_exodus_block(*opened->model, part, answer["blocks"][part]);
        }
        EXPECT_EQ(test::wrong_node_order(mesh), "");
    }
}

TEST_F(Vtk, d3plot_family_agrees_with_its_answer) {
    const std::string file = corpus("lsdyna/test/test_data/simple_d3plot/d3plot");
    if (file.empty()) GTEST_SKIP() << "the corpus is not here";
    const json answer = json::parse(test::read_file(corpus("lsdyna/answers.json")));
    const auto opened = open_path(file);
    const Mesh& mesh = opened->model->mesh();
    EXPECT_EQ(opened->model->inputs().size(), 2U);
    EXPECT_EQ(mesh.node_count(), answer["nodes"].get<std::size_t>());
    EXPECT_EQ(mesh.element_count(), answer["shells"].get<std::size_t>());
    EXPECT_EQ(opened->model->steps().size(), answer["steps"].get<std::size_t>());
    std::map<std::string, std::size_t> results;
    for (std::size_t i = 0; i < opened->model->results().size(); ++i)
        results[opened->model->results()[i].solver_name] = i;
    for (const auto& [array, range] : answer["last_step_ranges"].items()) {
        if (array == "UserID") continue;  // Rubbish by a fault of VTK's reader; it is no result of ours.
        SCOPED_TRACE(array);
        ASSERT_TRUE(results.contains(array));
        const Result result = opened->model->load(results[array]);
        EXPECT_EQ(std::ranges::min(result.values), range[0].get<float>());
        EXPECT_EQ(std::ranges::max(result.values), range[1].get<float>());
    }
    EXPECT_FALSE(results.contains("UserID"));
    EXPECT_FALSE(results.contains("UserIds"));
}

TEST_F(Vtk, pieces_of_a_pvtu_are_found_and_recorded) {
    const std::string folder = test::scratch_folder("pvtu");
    const Mesh hex = test::one_element(ElementType::Hex8);
    write_vtu(folder + "/a.vtu", hex, {});
    test::write_file(
        folder + "/all.pvtu",
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints><PDataArray "
        "type=\"Float64\" "
        "NumberOfComponents=\"3\"/></PPoints>\n<Piece Source=\"a.vtu\"/>\n</PUnstructuredGrid>\n</VTKFile>\n"
    );
    const auto opened = open_path(folder + "/all.pvtu");
    EXPECT_EQ(opened->model->mesh().element_count(), 1U);
    EXPECT_EQ(opened->model->inputs().size(), 2U);
}

/// A list of two times: the wedge, and one at another time.
std::vector<NamedBytes> two_times(const std::string& first, const std::string& second) {
    return {
        {"two.pvd",
         "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>\n"
         "<DataSet timestep=\"1\" file=\"a.vtu\"/>\n<DataSet timestep=\"2\" file=\"b.vtu\"/>\n"
         "</Collection></VTKFile>\n"},
        {"a.vtu", first},
        {"b.vtu", second}};
}

/// A triangle whose middle array is its nodes' ids.
std::string triangle(const std::string& ids, const std::string& nodes) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>"
           "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n<PointData>"
           "<DataArray type=\"Int32\" Name=\"GlobalNodeId\" format=\"ascii\">" +
           ids +
           "</DataArray><DataArray type=\"Float32\" Name=\"T\" format=\"ascii\">1 2 "
           "3</DataArray></PointData>\n"
           "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
           "0</DataArray></Points>\n<Cells><DataArray type=\"Int32\" Name=\"connectivity\" "
           "format=\"ascii\">" +
           nodes +
           "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
           "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells>\n"
           "</Piece></UnstructuredGrid></VTKFile>\n";
}

TEST_F(Vtk, later_times_must_have_the_nodes_and_elements_of_the_first) {
    const std::string first = triangle("7 8 9", "0 1 2");
    EXPECT_EQ(open_bytes(two_times(first, first))->model->load(1).values[2], 3.0F);
    for (const std::string& other : {triangle("7 9 8", "0 1 2"), triangle("7 8 9", "1 2 0")}) {
        const auto opened = open_bytes(two_times(first, other));
        EXPECT_EQ(opened->model->load(0).values[2], 3.0F);
        try {
            opened->model->load(1);
            ADD_FAILURE() << "values of other nodes were taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Code::MeshesDiffer);
            EXPECT_THAT(error.what(), HasSubstr("at step 2"));
        }
    }
}

TEST_F(Vtk, points_of_pieces_with_one_id_at_two_places_stay_two_nodes) {
    const std::string one = triangle("1 2 3", "0 1 2");
    std::string moved = one;
    moved.replace(moved.find("0 0 0 1 0 0"), 11, "0 0 5 1 0 5");
    auto files = two_times(one, moved);
    const std::string later = "timestep=\"2\"";
    files[0].bytes.replace(files[0].bytes.find(later), later.size(), "timestep=\"1\"");
    const auto opened = open_bytes(std::move(files));
    EXPECT_EQ(opened->model->mesh().node_count(), 6U);
    EXPECT_EQ(opened->model->mesh().parts[1].name, "block 2");
}

TEST_F(Vtk, damaged_files_are_errors_with_words) {
    const std::string text = kWedge;
    const Error cut = error_of({{"wedge.vtk", text.substr(0, text.find("CELL_TYPES"))}});
    EXPECT_EQ(cut.code(), Code::BadStructure) << cut.what();
    const Error empty = error_of({{"wedge.vtk", "# vtk DataFile Version 3.0\n"}});
    EXPECT_EQ(empty.code(), Code::BadStructure) << empty.what();
    const Error pvd =
        error_of({{"x.pvd", "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n</VTKFile>"}});
    EXPECT_EQ(pvd.code(), Code::BadStructure);
    EXPECT_THAT(pvd.what(), HasSubstr("names no file"));
    const Error lonely = error_of(
        {{"x.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: is not here.geo**\nTIME\ntime set: 1\n"}}
    );
    EXPECT_THAT(lonely.what(), HasSubstr("which is not beside it"));
}

std::size_t temporary_folders() {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
        count += entry.path().filename().string().starts_with("feelem-") ? 1U : 0U;
    return count;
}

TEST_F(Vtk, copies_of_inputs_in_memory_go_with_the_model) {
    const std::string own = test::scratch_folder("vtk_temporary");
    setenv("TMPDIR", own.c_str(), 1);
    {
        const auto opened = open_bytes({{"wedge.vtk", kWedge}});
        EXPECT_EQ(temporary_folders(), 1U);
    }
    EXPECT_EQ(temporary_folders(), 0U);
    unsetenv("TMPDIR");
}

TEST_F(Vtk, med_boilers_are_the_boilers_of_the_frd) {
    if (corpus("converted/ORIGINS.md").empty()) GTEST_SKIP() << "the corpus is not here";
    for (const char* name : {"boiler_linear.med", "boiler_tet10.med"}) {
        SCOPED_TRACE(name);
        const bool linear = std::string(name).find("linear") != std::string::npos;
        const test::Boiler boiler = linear ? test::Boiler::Linear : test::Boiler::Quadratic;
        const auto opened = open_path(corpus(std::string("converted/") + name));
        EXPECT_EQ(opened->model->mesh().parts.size(), 1U);
        test::expect_boiler_mesh(opened->model->mesh(), boiler);
        test::expect_boiler_results(*opened->model, boiler);
    }
}

}  // namespace
}  // namespace feelem
