// SPDX-License-Identifier: Apache-2.0
// Which reader gets which file, and what is said of files that nobody can read.
#include "base/parallel.hpp"
#include "base/text_encoding.hpp"
#include "read/include_files.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace feelem {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

Code code_of_opening(const std::vector<std::string>& paths, const ReadOptions& options = {}) {
    Diagnostics diagnostics;
    try {
        open_model(paths, options, diagnostics);
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return Code::BadScene;
}

TEST(OpenModel, names_the_missing_file) {
    EXPECT_EQ(code_of_opening({"/nowhere/at_all.frd"}), Code::FileNotFound);
}

TEST(OpenModel, rejects_a_file_that_no_reader_knows) {
    const std::string file = test::scratch_folder("open_model") + "/poem.txt";
    test::write_file(file, "Two roads diverged in a yellow wood\n");
    EXPECT_EQ(code_of_opening({file}), Code::UnknownFormat);
}

void expect_advice(const std::string& bytes, const std::string& advice) {
    Diagnostics diagnostics;
    try {
        open_model(std::vector<NamedBytes>{{"stranger", bytes}}, {}, diagnostics);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnsupportedFormat);
        EXPECT_THAT(error.what(), HasSubstr(advice));
    }
}

TEST(OpenModel, says_what_to_do_with_formats_that_it_knows_but_does_not_read) {
    expect_advice("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n", "meshio convert");
    expect_advice("TITLE = \"x\"\nVARIABLES = \"X\", \"Y\"\nZONE NODES = 3\n", "ParaView");
    expect_advice("#!TDV112", "ParaView");
    expect_advice("\x89HDF\r\n\x1A\n", "HDF5");
}

TEST(OpenModel, real_strangers_are_refused_with_advice) {
    for (const char* name :
         {"boiler_linear.xdmf",
          "boiler_linear_h5.xdmf",
          "boiler_linear_h5.h5",
          "boiler_linear_tecplot.dat"}) {
        const auto file = test::corpus_file(std::string("converted/") + name);
        if (!file) GTEST_SKIP() << "the corpus is not here";
        EXPECT_EQ(code_of_opening({*file}), Code::UnsupportedFormat) << name;
    }
}

TEST(OpenModel, rejects_an_empty_folder) {
    EXPECT_EQ(code_of_opening({test::scratch_folder("open_model_empty")}), Code::UnknownFormat);
}

TEST(OpenModel, answers_an_unknown_reader_with_the_nearest_one) {
    Diagnostics diagnostics;
    try {
        open_model(std::vector<NamedBytes>{{"x", ""}}, {.from = "calculix_frd", .types = ""}, diagnostics);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownName);
        EXPECT_THAT(error.what(), HasSubstr("Did you mean \"calculix-frd\"?"));
    }
}

TEST(OpenModel, answers_an_unknown_reader_with_the_known_ones) {
    EXPECT_EQ(
        code_of_opening({test::project_file("README.md")}, {.from = "autocad", .types = ""}),
        Code::UnknownName
    );
}

std::string boiler(const std::string& name) {
    return test::project_file("examples/boiler/" + name);
}

TEST(OpenModel, digests_that_are_made_while_reading_are_those_that_are_made_when_asked_for) {
    set_thread_count(2);
    const std::vector<std::string> paths{boiler("hex_linear/heat.frd"), boiler("hex_linear/static.frd")};
    Diagnostics diagnostics;
    ReadOptions early;
    early.hash_early = true;
    const auto model = open_model(paths, {}, diagnostics);
    const auto ahead = open_model(paths, early, diagnostics);
    ASSERT_EQ(ahead->inputs().size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(ahead->inputs()[i].sha256, model->inputs()[i].sha256);
    // Nobody need wait for them.
    open_model(paths, early, diagnostics).reset();
    early.hash_inputs = false;
    EXPECT_EQ(open_model(paths, early, diagnostics)->inputs()[0].sha256, "");
    set_thread_count(0);
}

TEST(OpenModel, results_of_two_files_of_one_model_know_their_input) {
    Diagnostics diagnostics;
    const std::vector<std::string> paths{boiler("hex_linear/heat.frd"), boiler("hex_linear/static.frd")};
    const auto model = open_model(paths, {}, diagnostics);
    EXPECT_EQ(model->mesh().node_count(), 2546U);
    ASSERT_EQ(model->inputs().size(), 2U);
    EXPECT_EQ(model->inputs()[1].format, "calculix-frd");
    EXPECT_EQ(model->inputs()[1].sha256.size(), 64U);
    EXPECT_NE(model->inputs()[0].sha256, model->inputs()[1].sha256);
    std::vector<std::string> found;
    for (std::size_t i = 0; i < model->results().size(); ++i) {
        const ResultInfo& info = model->results()[i];
        found.push_back(info.name + "@" + std::to_string(model->steps()[info.step].input));
        EXPECT_EQ(model->load(i).row_count(), 2546U);
    }
    EXPECT_THAT(found, testing::IsSupersetOf({"temperature@0", "heat_flux@0", "displacement@1", "stress@1"}));
    EXPECT_TRUE(diagnostics.entries().empty());
}

TEST(OpenModel, different_meshes_are_an_error_with_numbers) {
    Diagnostics diagnostics;
    const std::vector<std::string> paths{boiler("hex_linear/heat.frd"), boiler("small/heat.frd")};
    try {
        open_model(paths, {}, diagnostics);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(error.what(), HasSubstr("has 2546 nodes, heat.frd has 7670;"));
    }
}

TEST(OpenModel, a_node_elsewhere_is_told_with_its_number) {
    Diagnostics diagnostics;
    const std::string first = test::read_file(boiler("hex_linear/heat.frd"));
    std::string second = first;
    second.replace(second.find("1.16469E+02"), 11, "1.16669E+02");
    const auto model =
        open_model(std::vector<NamedBytes>{{"a.frd", first}, {"b.frd", second}}, {}, diagnostics);
    EXPECT_EQ(model->mesh().coordinates[0][1], 116.469);
    ASSERT_TRUE(diagnostics.has(Code::SourcesDisagree));
    EXPECT_EQ(diagnostics.entries()[0].where, "b.frd");
    EXPECT_THAT(diagnostics.entries()[0].text, HasSubstr("nodes stand elsewhere, by up to 0.2 (node 1)"));
}

TEST(OpenModel, other_elements_on_the_same_nodes_are_told) {
    Diagnostics diagnostics;
    const std::string first = test::read_file(test::project_file("tests/data/calculix/static.frd"));
    std::string second = first;
    const std::size_t row = second.find(" -2         5         6");
    second.replace(row, 23, " -2         6         5");
    open_model(std::vector<NamedBytes>{{"a.frd", first}, {"b.frd", second}}, {}, diagnostics);
    ASSERT_EQ(diagnostics.count(Code::SourcesDisagree), 1U);
    EXPECT_THAT(
        diagnostics.entries().back().text, HasSubstr("elements have other nodes, or in another order")
    );
}

TEST(OpenModel, text_and_binary_of_one_model_are_one_mesh) {
    Diagnostics diagnostics;
    const std::vector<std::string> paths{
        test::project_file("tests/data/calculix/static.frd"),
        test::project_file("tests/data/calculix/static_binary.frd")};
    EXPECT_EQ(open_model(paths, {}, diagnostics)->results().size(), 12U);
}

TEST(OpenModel, a_listing_of_results_finds_the_nodes_of_another_format) {
    Diagnostics diagnostics;
    const std::vector<std::string> paths{boiler("hex_linear/PRNSOL_TEMP.lis"), boiler("hex_linear/heat.frd")};
    const auto model = open_model(paths, {}, diagnostics);
    EXPECT_EQ(model->inputs()[0].format, "ansys-lists");
    std::vector<Result> temperatures;
    for (std::size_t i = 0; i < model->results().size(); ++i) {
        if (model->results()[i].name == "temperature") temperatures.push_back(model->load(i));
    }
    ASSERT_EQ(temperatures.size(), 2U);
    EXPECT_EQ(model->steps()[temperatures[0].info.step].input, 1U);
    EXPECT_EQ(model->steps()[temperatures[1].info.step].input, 0U);
    ASSERT_EQ(temperatures[0].row_count(), temperatures[1].row_count());
    for (std::size_t i = 0; i < temperatures[0].values.size(); ++i)
        ASSERT_NEAR(temperatures[0].values[i], temperatures[1].values[i], 1e-2);
}

TEST(OpenModel, a_folder_is_its_files_and_strangers_are_named) {
    const std::string folder = test::scratch_folder("open_model_folder");
    test::write_file(
        folder + "/b.frd", test::read_file(test::project_file("tests/data/calculix/static.frd"))
    );
    test::write_file(folder + "/a.txt", "Two roads diverged in a yellow wood\n");
    test::write_file(folder + "/c.txt", "And sorry I could not travel both\n");
    test::write_file(folder + "/.hidden", "no matter\n");
    Diagnostics diagnostics;
    const auto model = open_model(std::vector<std::string>{folder}, {}, diagnostics);
    ASSERT_EQ(model->inputs().size(), 1U);
    EXPECT_EQ(model->inputs()[0].path, folder + "/b.frd");
    ASSERT_EQ(diagnostics.entries().size(), 1U) << "one note for all";
    EXPECT_EQ(diagnostics.entries()[0].code, Code::UnknownBlock);
    EXPECT_EQ(diagnostics.entries()[0].count, 2U);
    EXPECT_THAT(diagnostics.entries()[0].text, HasSubstr("no reader recognises them: a.txt, c.txt"));
}

TEST(TextEncoding, utf16_of_either_byte_order_and_marked_utf8_become_plain_utf8) {
    const std::string plain = "a\xC3\xA9\xF0\x9F\x99\x82\n";  // a, e acute, a face beyond 16 bits
    const std::string little = "\xFF\xFE"s + "a\0\xE9\0\x3D\xD8\x42\xDE\n\0"s;
    const std::string big = "\xFE\xFF"s + "\0a\0\xE9\xD8\x3D\xDE\x42\0\n"s;
    const auto converted = [](const std::string& bytes) {
        return std::string(without_encoding(Input::from_memory("x", bytes)).text());
    };
    EXPECT_EQ(converted(little), plain);
    EXPECT_EQ(converted(big), plain);
    EXPECT_EQ(converted("\xEF\xBB\xBF"s + plain), plain);
    EXPECT_EQ(converted(plain), plain);
}

TEST(TextEncoding, half_a_surrogate_becomes_the_replacement_character) {
    const Input input = Input::from_memory("x", "\xFF\xFE\x3D\xD8"s + "a\0"s + "\x42\xDE"s + "b"s);
    EXPECT_EQ(without_encoding(input).text(), "\xEF\xBF\xBD"s + "a" + "\xEF\xBF\xBD");
}

TEST(OpenModel, every_reader_has_a_fuzz_harness) {
    std::string list = test::read_file(test::project_file("fuzz/CMakeLists.txt"));
    const std::size_t begin = list.find("set(formats ");
    ASSERT_NE(begin, std::string::npos);
    list = list.substr(begin, list.find(')', begin) - begin) + " ";
    std::ranges::replace(list, '\n', ' ');
    for (const ReadFormatInfo& format : read_formats())
        EXPECT_THAT(list, HasSubstr(" " + std::string(format.id) + " ")) << "see fuzz/CMakeLists.txt";
}

TEST(IncludeFiles, finds_a_file_beside_the_deck_and_remembers_it_once) {
    const std::string folder = test::scratch_folder("includes");
    std::filesystem::create_directories(folder + "/sub");
    test::write_file(folder + "/deck.inp", "deck");
    test::write_file(folder + "/sub/mesh.inc", "mesh");
    const Input deck = Input::from_file(folder + "/deck.inp");
    IncludeFiles includes({});
    for (const char* name : {"sub/mesh.inc", "sub\\mesh.inc"}) {
        const auto found = includes.find(name, deck);
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->text(), "mesh");
    }
    EXPECT_FALSE(includes.find("other.inc", deck));
    ASSERT_EQ(includes.opened().size(), 1U);
    EXPECT_EQ(includes.opened()[0].name(), folder + "/sub/mesh.inc");
}

TEST(IncludeFiles, prefers_an_input_of_that_name_and_asks_no_disk_for_a_deck_in_memory) {
    const std::vector<Input> given{
        Input::from_memory("deck.inp", "deck"), Input::from_memory("far/mesh.inc", "given")};
    IncludeFiles includes(given);
    EXPECT_EQ(includes.find("C:\\run\\mesh.inc", given[0])->text(), "given");
    EXPECT_FALSE(includes.find(test::project_file("README.md"), given[0]));
    EXPECT_TRUE(includes.opened().empty());
}

}  // namespace
}  // namespace feelem
