// SPDX-License-Identifier: Apache-2.0
// Real decks against another reader's counts: grids, elements by card, coordinate systems, cards.
#include "read/nastran/bulk_mesh.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>

namespace feelem {
namespace {

using nastran::BulkModel;
using nlohmann::json;

BulkModel read_deck(const std::string& path, Diagnostics& diagnostics) {
    const Input input = Input::from_file(path);
    const std::vector<Input> given{input};
    IncludeFiles includes(given);
    return nastran::read_bulk({input}, &includes, diagnostics);
}

/// Cards that are elements for Feelem and something else (masses, rigid bodies, drawing aids) for the reader
/// behind the answers.
const std::set<std::string> kCountedByFeelemAlone{"CONM1", "CONM2", "PLOTEL", "RBAR", "RBE2", "RBE3"};

/// Decks that the reader behind the answers refuses and Feelem reads, and why that is right.
const std::map<std::string, std::string> kReadByFeelemAlone{
    {"models/plate/plate_openmdao.bdf",
     "a template: a thickness is still %t. The mesh, all that Feelem takes, is whole."},
    {"models/sol_101_elements/static_solid_shell_bar_global_radial_cd.bdf",
     "a free line with eleven data fields; Nastran ran it, and its .f06 agrees with the run in basic axes."},
    {"models/thermal/htflw47.bdf",
     "CHBDYE surfaces have numbers of their own solids; Nastran ran it, and Feelem does not draw them."},
};

TEST(BulkAnswers, every_real_deck_has_the_right_counts) {
    const auto file = test::corpus_file("nastran/answers_bdf.json");
    if (!file) GTEST_SKIP() << "the corpus is not here";
    const std::string root = file->substr(0, file->rfind('/') + 1);
    int compared = 0, alone = 0, pieces = 0;
    const json answers = json::parse(test::read_file(*file));
    for (const auto& [name, answer] : answers.items()) {
        SCOPED_TRACE(name);
        Diagnostics diagnostics;
        BulkModel model;
        if (answer.contains("grids") && answer["grids"] == 0) {
            // A piece of a deck: elements, but nowhere to draw them.
            EXPECT_THROW(read_deck(root + name, diagnostics), Error);
            ++pieces;
            continue;
        }
        ASSERT_NO_THROW(model = read_deck(root + name, diagnostics));
        EXPECT_FALSE(diagnostics.has(Code::FileNotFound));
        EXPECT_FALSE(diagnostics.has(Code::UnknownNode));
        EXPECT_FALSE(diagnostics.has(Code::UnknownElementType));
        if (answer.contains("pynastran_failed")) {
            EXPECT_TRUE(kReadByFeelemAlone.contains(name));
            ++alone;
            continue;
        }
        ++compared;
        EXPECT_EQ(model.grids, answer["grids"].get<std::uint64_t>());
        EXPECT_EQ(model.systems + 1, answer["coords"].get<std::uint64_t>());
        EXPECT_EQ(model.cards, answer["cards"].get<std::uint64_t>());
        std::map<std::string, std::uint64_t> found = model.element_cards, expected;
        for (const std::string& card : kCountedByFeelemAlone) found.erase(card);
        for (const auto& [card, count] : answer["elements"].items()) expected[card] = count;
        EXPECT_EQ(found, expected);
    }
    EXPECT_EQ(compared, 70);
    EXPECT_EQ(alone, 3);
    EXPECT_EQ(pieces, 1);
}

}  // namespace
}  // namespace feelem
