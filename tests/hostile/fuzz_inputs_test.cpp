// SPDX-License-Identifier: Apache-2.0
// What fuzzers found beside the readers: it is refused, or comes back as it was.
#include "read/exchange/neutral_form.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

namespace feelem {
namespace {

namespace fs = std::filesystem;

using WriteAgain = std::function<std::string(const std::string&)>;

/// `write_again` reads bytes and writes them; what it accepts, it must accept again and leave as it is.
void expect_sound(const std::string& harness, const WriteAgain& write_again) {
    const fs::path folder = test::project_file("tests/data/fuzz_corpus/" + harness);
    std::size_t accepted = 0, refused = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::string once;
        try {
            once = write_again(test::read_file(entry.path().string()));
        } catch (const Error&) {
            ++refused;
            continue;
        }
        ++accepted;
        EXPECT_EQ(write_again(once), once) << entry.path();
    }
    EXPECT_GT(accepted, 0U);
    EXPECT_GT(refused, 0U);
}

TEST(FuzzInputs, presentations_are_refused_or_come_back) {
    expect_sound("fuzz_presentation", [](const std::string& bytes) {
        return presentation_json(parse_presentation(bytes, "fuzz"));
    });
}

TEST(FuzzInputs, answers_of_the_helper_program_are_refused_or_come_back) {
    expect_sound("fuzz_neutral_form", [](const std::string& bytes) {
        return exchange::write_model(exchange::read_model(bytes, "fuzz"));
    });
}

}  // namespace
}  // namespace feelem
