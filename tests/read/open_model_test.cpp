// SPDX-License-Identifier: Apache-2.0
// Which reader gets which file, and what is said of files that nobody can read.
#include "base/text_encoding.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(OpenModel, rejects_an_empty_folder) {
    EXPECT_EQ(code_of_opening({test::scratch_folder("open_model_empty")}), Code::UnknownFormat);
}

TEST(OpenModel, answers_an_unknown_reader_with_the_known_ones) {
    EXPECT_EQ(
        code_of_opening({test::project_file("README.md")}, {.from = "autocad", .types = ""}),
        Code::UnknownName
    );
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

}  // namespace
}  // namespace feelem
