// SPDX-License-Identifier: Apache-2.0
// Files of one model whose meshes are not equal: which is shown, what is said, where values go.
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace feelem {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A .frd file of our own making: a strip of unit squares along x, square n between x = n - 1 and n, with the
/// nodes 2n - 1 and 2n at its left side.
struct Strip {
    int first = 1, last = 1;
    double temperature_of_node = 0;  ///< Times the node's id; 0: no results.
    std::map<int, std::array<double, 3>> moved{};
    double scale = 1;
    bool is_solid = false;  ///< As CalculiX writes shells with OUTPUT=3D: bricks on nodes of their own.
    std::string solver_label = "NDTEMP";

    std::string text() const {
        std::string nodes, elements, values;
        int count = 0;
        const auto add_node = [&](int id, double x, double y, double z) {
            if (const auto at = moved.find(id); at != moved.end()) {
                x = at->second[0];
                y = at->second[1];
                z = at->second[2];
            }
            nodes += fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", id, x * scale, y * scale, z * scale);
            values += fmt::format(" -1{:10}{:12.5E}\n", id, temperature_of_node * id);
            ++count;
        };
        for (int n = first; n <= last + 1; ++n) {
            if (is_solid) {
                for (int k = 0; k < 4; ++k)
                    add_node(1000 + 4 * n + k, n - 1, k == 1 || k == 2, k < 2 ? -0.1 : 0.1);
            } else {
                add_node(2 * n - 1, n - 1, 0, 0);
                add_node(2 * n, n - 1, 1, 0);
            }
        }
        for (int n = first; n <= last; ++n) {
            elements += fmt::format(" -1{:10}{:5}    0    1\n -2", n, is_solid ? 1 : 9);
            if (is_solid) {
                for (const int side : {4 * n, 4 * n + 4})
                    for (const int k : {0, 1, 2, 3}) elements += fmt::format("{:10}", 1000 + side + k);
            } else {
                for (const int node : {2 * n - 1, 2 * n + 1, 2 * n + 2, 2 * n})
                    elements += fmt::format("{:10}", node);
            }
            elements += "\n";
        }
        std::string text =
            "    1C\n" + fmt::format("    2C{:18}{:12}{:37}1\n", "", count, "") + nodes + " -3\n";
        text += fmt::format("    3C{:18}{:12}{:37}1\n", "", last - first + 1, "") + elements + " -3\n";
        if (temperature_of_node != 0) {
            text += fmt::format("  100CL  101{:12.5E}{:12}{:20}{:2}{:5}{:10} 1\n", 1.0, count, "", 0, 1, "");
            text += fmt::format(" -4  {:8}    1    1\n -5  T           1    1    0    0\n", solver_label) +
                    values + " -3\n";
        }
        return text + " 9999\n";
    }
};

struct Opened {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;

    /// "text (count)" of what the sources disagree in.
    std::vector<std::string> disagreements() const {
        std::vector<std::string> texts;
        for (const Diagnostic& entry : diagnostics.entries()) {
            if (entry.code == Code::SourcesDisagree)
                texts.push_back(fmt::format("{}: {} ({})", entry.where, entry.text, entry.count));
        }
        return texts;
    }
    /// Temperature of a node as that input has it.
    float temperature(std::uint32_t input, std::int64_t node) {
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            if (model->steps()[model->results()[i].step].input != input) continue;
            const Result result = model->load(i);
            EXPECT_EQ(result.row_count(), model->mesh().node_count());
            return result.values.at(raw(find_node(model->mesh(), NodeId{node})));
        }
        ADD_FAILURE() << "no result of input " << input;
        return 0;
    }
};

std::unique_ptr<Opened> open(std::vector<NamedBytes> files) {
    auto opened = std::make_unique<Opened>();
    opened->model = open_model(std::move(files), {}, opened->diagnostics);
    return opened;
}

TEST(OneDoor, the_mesh_with_results_is_shown_and_what_it_lacks_is_counted) {
    const auto opened = open({{"model.frd", Strip{1, 3}.text()}, {"part.frd", Strip{1, 2, 10}.text()}});

    EXPECT_EQ(opened->model->mesh().element_count(), 2U);
    EXPECT_EQ(opened->temperature(1, 6), 60);
    EXPECT_THAT(
        opened->disagreements(),
        ElementsAre(
            "model.frd: nodes are not in the mesh shown, that of part.frd: 7, 8 (2)",
            "model.frd: elements are not in the mesh shown, that of part.frd: 3 (1)"
        )
    );
}

TEST(OneDoor, results_of_a_part_go_to_the_whole_mesh_by_node_id) {
    const auto opened = open({{"part.frd", Strip{2, 2, 10}.text()}, {"whole.frd", Strip{1, 3, 1}.text()}});

    EXPECT_EQ(opened->model->mesh().element_count(), 3U);
    EXPECT_EQ(opened->temperature(1, 8), 8);
    EXPECT_EQ(opened->temperature(0, 3), 30);
    EXPECT_EQ(opened->temperature(0, 6), 60);
    EXPECT_TRUE(std::isnan(opened->temperature(0, 1)));
    EXPECT_THAT(
        opened->disagreements(),
        ElementsAre(
            "part.frd: lacks nodes of the mesh shown, that of whole.frd: 1, 2, 7, 8; they have no values of "
            "its "
            "results (4)",
            "part.frd: lacks elements of the mesh shown, that of whole.frd: 1, 3 (2)"
        )
    );
    EXPECT_EQ(opened->diagnostics.count(Code::ResultWithoutNode), 0U);
}

TEST(OneDoor, a_moved_node_is_named_with_its_distance_and_gets_no_value_from_there) {
    const auto opened =
        open({{"a.frd", Strip{1, 3, 1}.text()}, {"b.frd", Strip{1, 3, 10, {{4, {1.25, 1, 0}}}}.text()}});

    EXPECT_EQ(opened->temperature(0, 4), 4);
    EXPECT_EQ(opened->temperature(1, 5), 50);
    EXPECT_TRUE(std::isnan(opened->temperature(1, 4)));
    EXPECT_THAT(
        opened->disagreements(),
        ElementsAre(
            "b.frd: nodes stand elsewhere, by up to 0.25 (node 4), than in the mesh shown, that of a.frd: 4; "
            "their "
            "values are left out (1)",
            HasSubstr("elements have other nodes, or in another order, than in the mesh shown, that of "
                      "a.frd: 1, 2 (2)")
        )
    );
    EXPECT_EQ(opened->diagnostics.count(Code::ResultWithoutNode), 1U);
}

TEST(OneDoor, shells_that_the_solver_made_solid_are_shown_as_solids) {
    const auto opened =
        open({{"deck.frd", Strip{1, 2}.text()}, {"run.frd", Strip{1, 2, 1, {}, 1, true}.text()}});

    EXPECT_EQ(opened->model->mesh().blocks.front().type, ElementType::Hex8);
    EXPECT_THAT(
        opened->disagreements(),
        testing::Contains(HasSubstr("elements are of another type (quad4, hex8 in the mesh shown) than in "
                                    "the mesh shown, that of run.frd: 1, 2 (2)"))
    );
}

TEST(OneDoor, a_mesh_of_which_nothing_fits_is_refused_with_counts) {
    try {
        open({{"a.frd", Strip{1, 3, 1}.text()}, {"b.frd", Strip{11, 13, 1}.text()}});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(error.what(), HasSubstr("b.frd: has 8 nodes, a.frd has 8; 0 agree in number and place"));
    }
}

TEST(OneDoor, coordinates_in_another_unit_are_refused_with_the_factor) {
    try {
        open({{"a.frd", Strip{1, 3, 1}.text()}, {"b.frd", Strip{1, 3, 1, {}, 1000}.text()}});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(
            error.what(), HasSubstr("Its coordinates are 1000 times the others: are both in one unit?")
        );
    }
}

/// Node and element lists of the strip, as Ansys prints them; elements in the order given.
std::vector<NamedBytes> lists_of_strip(int last, const std::vector<int>& elements) {
    std::string nodes = "   NODE        X           Y           Z         THXY    THYZ    THZX\n";
    for (int n = 1; n <= 2 * last + 2; ++n) {
        nodes += fmt::format(
            "{:8}{:12.4f}{:12.4f}{:12.4f}{:8.2f}{:8.2f}{:8.2f}\n",
            n,
            (n - 1) / 2 * 1.0,
            (n - 1) % 2 * 1.0,
            0.0,
            0.0,
            0.0,
            0.0
        );
    }
    std::string rows = "    ELEM MAT TYP REL ESY SEC        NODES\n\n";
    for (const int n : elements) {
        rows += fmt::format(
            "{:8}   1   1   1   0   1  {:5} {:5} {:5} {:5}\n", n, 2 * n - 1, 2 * n + 1, 2 * n + 2, 2 * n
        );
    }
    return {
        {"n.lis", nodes},
        {"e.lis", rows},
        {"t.lis", " ELEMENT TYPE        1 IS SHELL181      4-NODE SHELL\n"}};
}

TEST(OneDoor, a_list_mesh_in_another_order_is_the_same_model_and_says_nothing) {
    std::vector<NamedBytes> files = lists_of_strip(3, {3, 1, 2});
    files.push_back({"run.frd", Strip{1, 3, 10}.text()});

    const auto opened = open(std::move(files));

    EXPECT_EQ(opened->temperature(3, 8), 80);
    EXPECT_THAT(opened->disagreements(), IsEmpty());
}

TEST(OneDoor, values_alone_find_their_nodes_in_the_mesh_that_is_shown) {
    const std::string temperatures =
        " PRINT TEMP NODAL SOLUTION PER NODE\n\n  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****\n\n"
        "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n\n"
        "    NODE       TEMP\n       3   33.000\n       7   77.000\n";
    const auto opened = open(
        {{"t.lis", temperatures}, {"model.frd", Strip{1, 3}.text()}, {"part.frd", Strip{1, 2, 10}.text()}}
    );

    EXPECT_EQ(opened->model->mesh().element_count(), 2U) << "that of part.frd, which carries results";
    EXPECT_EQ(opened->temperature(0, 3), 33);
}

/// The strip as a deck, with sets.
std::string deck_of_strip(int last, const std::string& sets) {
    std::string text = "*NODE, NSET=ALL\n";
    for (int n = 1; n <= 2 * last + 2; ++n)
        text += fmt::format("{}, {}., {}., 0.\n", n, (n - 1) / 2, (n - 1) % 2);
    text += "*ELEMENT, TYPE=S4, ELSET=SKIN\n";
    for (int n = 1; n <= last; ++n)
        text += fmt::format("{}, {}, {}, {}, {}\n", n, 2 * n - 1, 2 * n + 1, 2 * n + 2, 2 * n);
    return text + sets;
}

std::vector<std::int64_t> members_of(const Mesh& mesh, std::string_view set) {
    std::vector<std::int64_t> ids;
    for (const ElementSet& one : mesh.element_sets) {
        if (one.name != set) continue;
        for (const ElementIndex element : one.elements) ids.push_back(raw(element_at(mesh, element).id()));
    }
    return ids;
}

TEST(OneDoor, sets_of_a_deck_are_carried_over_to_the_mesh_of_the_results) {
    const auto opened = open(
        {{"model.inp", deck_of_strip(3, "*ELSET, ELSET=ENDS\n1, 3\n")}, {"run.frd", Strip{1, 3, 10}.text()}}
    );

    EXPECT_EQ(opened->temperature(1, 8), 80) << "those of the .frd";
    EXPECT_THAT(members_of(opened->model->mesh(), "ENDS"), ElementsAre(1, 3));
    EXPECT_THAT(members_of(opened->model->mesh(), "SKIN"), ElementsAre(1, 2, 3));
    EXPECT_THAT(opened->disagreements(), IsEmpty());
}

TEST(OneDoor, members_of_sets_that_the_mesh_shown_does_not_have_are_counted) {
    const auto opened = open(
        {{"model.inp", deck_of_strip(3, "*ELSET, ELSET=ENDS\n1, 3\n*ELSET, ELSET=FAR\n3\n")},
         {"part.frd", Strip{1, 2, 10}.text()}}
    );

    EXPECT_THAT(members_of(opened->model->mesh(), "ENDS"), ElementsAre(1));
    EXPECT_THAT(members_of(opened->model->mesh(), "FAR"), IsEmpty());
    EXPECT_THAT(
        opened->disagreements(),
        testing::Contains(
            "model.inp: sets lose 3 of 6 elements, which are not in the mesh shown: SKIN, ENDS, FAR (3)"
        )
    );
}

TEST(OneDoor, sets_of_one_name_with_other_members_are_told_and_the_first_stays) {
    const auto opened = open(
        {{"a.inp", deck_of_strip(3, "*ELSET, ELSET=ENDS\n1, 3\n")},
         {"b.inp", deck_of_strip(3, "*ELSET, ELSET=ENDS\n1, 2\n*ELSET, ELSET=MORE\n2\n")}}
    );

    EXPECT_THAT(members_of(opened->model->mesh(), "ENDS"), ElementsAre(1, 3));
    EXPECT_THAT(members_of(opened->model->mesh(), "MORE"), ElementsAre(2));
    EXPECT_THAT(
        opened->disagreements(),
        ElementsAre("b.inp: sets hold other elements than those of the same name in the mesh shown, which "
                    "stay: ENDS (1)")
    );
}

TEST(OneDoor, a_folder_leaves_out_a_file_that_cannot_be_read_and_says_why) {
    const std::string folder = test::scratch_folder("one_door_folder");
    test::write_file(folder + "/good.frd", Strip{1, 2, 10}.text());
    std::string broken = Strip{1, 2, 10}.text();
    broken.replace(broken.find(" -1"), 3, " 77");
    test::write_file(folder + "/broken.frd", broken);
    Diagnostics diagnostics;

    const auto model = open_model(std::vector<std::string>{folder}, {}, diagnostics);

    EXPECT_EQ(model->mesh().element_count(), 2U);
    ASSERT_EQ(diagnostics.count(Code::InputLeftOut), 1U);
    EXPECT_THAT(diagnostics.entries()[0].text, HasSubstr("left out, it cannot be read: "));
    const std::vector<std::string> named{folder + "/good.frd", folder + "/broken.frd"};
    EXPECT_THROW(open_model(named, {}, diagnostics), Error) << "named by the user: it must be there";
}

TEST(OneDoor, results_of_several_analyses_in_a_folder_are_all_there) {
    Diagnostics diagnostics;
    const std::vector<std::string> folder{test::project_file("examples/boiler/hex_linear")};

    const auto model = open_model(folder, {}, diagnostics);

    std::map<std::string, int> results;
    for (const ResultInfo& info : model->results()) ++results[info.name];
    EXPECT_GE(results["temperature"], 11) << "heat, static, eight of transient, the list";
    EXPECT_GE(results["displacement"], 2);
    EXPECT_EQ(model->mesh().node_count(), 2546U);
    EXPECT_FALSE(diagnostics.has(Code::SourcesDisagree));
}

}  // namespace
}  // namespace feelem
