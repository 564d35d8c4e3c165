// SPDX-License-Identifier: Apache-2.0
// Lists with their tail cut off or bytes changed: an error or a diagnostic, never a crash.
#include "read_ansys/opened_lists.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace feelem {
namespace {

std::string shipped(const std::string& name) {
    return test::read_file(test::project_file("examples/boiler/hex_linear/" + name));
}

/// Opens and loads everything; false when an Error said no.
bool reads(std::vector<std::string> texts) {
    try {
        auto opened = test::open_texts(texts);
        for (std::size_t i = 0; i < opened.model->results().size(); ++i) {
            const Result result = opened.model->load(i);
            EXPECT_EQ(result.values.size() % result.component_count(), 0u);
        }
        return true;
    } catch (const Error&) {
        return false;
    }
}

TEST(HostileLists, cuts_and_flips_never_crash) {
    std::mt19937 random(20250211);
    for (const char* name : {"NLIST_all.lis", "ELIST.lis", "ETLIST.lis", "PRNSOL_U.lis", "PRNSOL_S.lis"}) {
        const std::string text = shipped(name).substr(0, 20000);
        for (int i = 0; i < 20; ++i) {
            const std::string cut = text.substr(0, random() % text.size());
            reads({cut});
            reads({cut, shipped("ELIST.lis")});
            std::string flipped = text;
            for (int flips = 0; flips < 5; ++flips) {
                flipped[random() % flipped.size()] ^= static_cast<char>(1U << (random() % 8));
            }
            reads({flipped});
        }
    }
}

TEST(HostileLists, a_cut_never_changes_a_value) {
    const std::string text = shipped("PRNSOL_TEMP.lis");
    auto whole = test::open_texts({text});
    const Result right = test::load_only(whole, "temperature");
    std::mt19937 random(7);
    for (int i = 0; i < 60; ++i) {
        const std::string cut = text.substr(0, 2000 + random() % (text.size() - 2000));
        auto opened = test::open_texts({cut});
        const Result result = opened.model->load(0);
        const Mesh& mesh = opened.model->mesh();
        for (const NodeId id : mesh.node_ids) {
            const float value = test::value_at(mesh, result, "value", raw(id));
            if (std::isnan(value)) continue;
            ASSERT_EQ(value, test::value_at(whole.model->mesh(), right, "value", raw(id))) << raw(id);
        }
    }
}

TEST(HostileLists, long_lines_and_endless_digits_are_refused_or_left_out) {
    const std::string head = "   NODE        X                   Y                   Z\n";
    reads({head + std::string(1U << 20U, '9')});
    reads({head + "1 " + std::string(1U << 20U, '9') + "\n"});
    reads({"    ELEM MAT TYP REL ESY SEC        NODES\n" + std::string(1U << 20U, '1') + "\n"});
    reads({"    NODE" + std::string(1U << 18U, ' ') + "UX\n   1 2.0\n"});
    reads({"ELEMENT TYPE 99999999999999999999 IS SOLID185\n"});
    std::string columns = "  ***** POST1 NODAL STRESS LISTING *****\n    NODE ";
    for (int i = 0; i < 10000; ++i) columns += " C" + std::to_string(i);
    reads({columns + "\n   1 2.0\n"});
}

TEST(HostileLists, ids_of_eighteen_digits_need_no_table_of_that_size) {
    auto opened = test::open_texts(
        {"   NODE        X                   Y                   Z\n"
         "       1     0.00000000000       0.00000000000       0.00000000000    \n"
         " 999999999999999999     1.00000000000       0.00000000000       0.00000000000    \n"}
    );
    EXPECT_EQ(opened.model->mesh().node_count(), 2u);
}

}  // namespace
}  // namespace feelem
