// SPDX-License-Identifier: Apache-2.0
// Real archives against the answers that a reader of other people gave.
#include "read_ansys_cdb/opened_deck.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/skin.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

namespace feelem {
namespace {

using Counts = std::map<std::string, std::uint64_t>;

/// Solver's types that have no surface of their own; of those that have, the mesh keeps the shape alone.
bool is_skipped(const std::string& type) {
    return type.starts_with("CONTA") || type.starts_with("TARGE") || type.starts_with("SURF");
}

std::string shape_word(ElementType type) {
    switch (element_row(element_row(type).linear).type) {
    case ElementType::Hex8: return "hex";
    case ElementType::Wedge6: return "wedge";
    case ElementType::Pyramid5: return "pyr";
    case ElementType::Tet4: return "tet";
    case ElementType::Quad4: return "quad";
    case ElementType::Tri3: return "tri";
    case ElementType::Line2: return "line";
    default: return "point";
    }
}

/// By shape ("hex"), and by name where there is no surface ("CONTA174").
Counts counts_of(const Mesh& mesh) {
    Counts counts;
    for (const ElementBlock& block : mesh.blocks) counts[shape_word(block.type)] += block.ids.size();
    for (const auto& [name, count] : mesh.skipped_elements) counts[name] += count;
    return counts;
}

struct Answer {
    std::uint64_t nodes = 0, elements = 0;
    std::int64_t first_node = 0, last_node = 0;
    Counts counts;
    std::uint64_t tri = 0, quad = 0;
    std::size_t components = 0;
};

Answer read_answer(const nlohmann::json& from) {
    Answer answer;
    answer.nodes = from["nodes"];
    answer.elements = from["elements"];
    answer.first_node = from["min_node_id"];
    answer.last_node = from["max_node_id"];
    answer.components = from["components"];
    answer.tri = from["exterior_solid_faces"]["tri"];
    answer.quad = from["exterior_solid_faces"]["quad"];
    for (const auto& [key, count] : from["shapes"].items()) {
        const std::string type = key.substr(0, key.find(':'));
        answer.counts[is_skipped(type) ? type : key.substr(key.find(':') + 1)] += count.get<std::uint64_t>();
    }
    return answer;
}

/// Where the answers stop short of what the file says.
void correct(const std::string& file, Answer& answer) {
    if (file == "cdb/mesh200.cdb") {
        // Its reader did not know MESH200; KEYOPT(1)=11 makes bricks: 10 x 10 x 10, six sides of 100 facets.
        EXPECT_EQ(answer.counts, (Counts{{"other", 1000}}));
        answer.counts = {{"hex", 1000}};
        answer.quad = 600;
    }
    if (file == "cdb/Panel_Transient.dat") {
        // et,cid,174 after *set,cid,3 was not resolved; the two pilot nodes made by EN were not counted.
        EXPECT_EQ(answer.counts["other"], 16u);
        answer.counts.erase("other");
        answer.counts["CONTA174"] = 16;
        answer.counts["TARGE170"] = 2;
        answer.elements += 2;
    }
}

void expect_answer(const std::string& file, const std::string& path, Answer answer) {
    SCOPED_TRACE(file);
    correct(file, answer);
    const auto opened = test::open_deck_file(path);
    const Mesh& mesh = opened.mesh();
    ASSERT_EQ(mesh.node_count(), answer.nodes);
    EXPECT_EQ(raw(mesh.node_ids.front()), answer.first_node);
    EXPECT_EQ(raw(mesh.node_ids.back()), answer.last_node);
    EXPECT_EQ(counts_of(mesh), answer.counts) << test::all_texts(*opened.diagnostics);
    std::uint64_t elements = mesh.element_count();
    for (const auto& [name, count] : mesh.skipped_elements) elements += count;
    EXPECT_EQ(elements, answer.elements);
    EXPECT_EQ(mesh.node_sets.size() + mesh.element_sets.size(), answer.components);
    // Names of types are all known, and no element lost a node.
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownElementType)) << test::all_texts(*opened.diagnostics);
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownNode)) << test::all_texts(*opened.diagnostics);
    if (mesh.element_count() == 0) return;

    Diagnostics of_skin;
    const SkinReport report = make_skin(mesh, {}, of_skin).report;
    EXPECT_EQ(report.solid_tri_kept, answer.tri);
    EXPECT_EQ(report.solid_quad_kept, answer.quad);
}

TEST(CdbAnswers, every_real_archive_agrees) {
    const auto path = test::corpus_file("ansys/answers.json");
    if (!path) GTEST_SKIP() << "the corpus is not here";
    const auto answers = nlohmann::json::parse(test::read_file(*path))["cdb"];
    EXPECT_EQ(answers.size(), 16u);
    for (const auto& [file, answer] : answers.items())
        expect_answer(file, *test::corpus_file("ansys/" + file), read_answer(answer));
}

/// Four digits of the smallest and largest coordinates: "['0', '0', '-0.099'] ['0.099', '0.099', '0']".
std::string bounds_of(const Mesh& mesh) {
    std::string text;
    for (const bool largest : {false, true}) {
        text += largest ? " [" : "[";
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double bound = mesh.coordinates.front()[axis];
            for (const Point3& point : mesh.coordinates)
                bound = largest ? std::max(bound, point[axis]) : std::min(bound, point[axis]);
            text += fmt::format("{}'{:.4g}'", axis == 0 ? "" : ", ", bound + 0.0);
        }
        text += "]";
    }
    return text;
}

TEST(CdbAnswers, nodes_stand_where_others_read_them) {
    const auto path = test::corpus_file("ansys/ORIGINS.md");
    if (!path) GTEST_SKIP() << "the corpus is not here";
    std::istringstream lines(test::read_file(*path));
    int compared = 0;
    bool in_section = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) in_section = line == "## cdb";
        const std::size_t bounds = line.find("| bbox ");
        if (!in_section || bounds == std::string::npos) continue;
        const std::string name = line.substr(4, line.find("**", 4) - 4);
        const std::size_t first = bounds + 7;
        const std::string expected = line.substr(first, line.find(" |", first) - first);
        const auto opened = test::open_deck_file(*test::corpus_file("ansys/cdb/" + name));
        EXPECT_EQ(bounds_of(opened.mesh()), expected) << name;
        ++compared;
    }
    EXPECT_EQ(compared, 16);
}

TEST(CdbAnswers, an_archive_that_was_cut_and_filled_with_zeros_is_refused) {
    const auto path = test::corpus_file("ansys/cdb/corrupt_a.cdb");
    if (!path) GTEST_SKIP() << "the corpus is not here";
    try {
        test::open_deck_file(*path);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::Truncated);
        EXPECT_TRUE(error.where().ends_with("corrupt_a.cdb:143")) << error.where();
    }
}

}  // namespace
}  // namespace feelem
