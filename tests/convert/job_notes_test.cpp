// SPDX-License-Identifier: Apache-2.0
// What a job says about its inputs: turned systems, filled gaps, unknown units, files that cannot be used.
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace feelem::test {
namespace {

/// A unit square of one shell whose node 1 is given, with its nodal system turned by `angle` about z.
std::string square(const std::string& first_node, const std::string& angle) {
    return "   NODE        X           Y           Z         THXY    THYZ    THZX\n" + first_node +
           "    0.0000     0.0000      0.0000       " + angle +
           "    0.00    0.00\n"
           "       2    1.0000     0.0000      0.0000        0.00    0.00    0.00\n"
           "       3    1.0000     1.0000      0.0000        0.00    0.00    0.00\n"
           "       4    0.0000     1.0000      0.0000        0.00    0.00    0.00\n";
}

std::string shell_of(const std::string& first_node) {
    return "    ELEM MAT TYP REL ESY SEC        NODES\n\n"
           "       1   1   1   1   0   1  " +
           first_node + "     2     3     4\n";
}

constexpr const char* kShellType = " ELEMENT TYPE        1 IS SHELL181      4-NODE SHELL\n";

Job job_of(const std::string& folder, const std::vector<std::string>& texts) {
    Job job;
    const std::string path = scratch_folder(folder);
    for (const std::string& text : texts) {
        job.inputs.push_back(path + "/" + std::to_string(job.inputs.size()) + ".lis");
        write_file(job.inputs.back(), text);
    }
    return job;
}

TEST(JobNotes, displacements_in_a_turned_nodal_system_become_global_and_are_noted) {
    const std::string displacement =
        " PRINT U    NODAL SOLUTION PER NODE\n\n"
        "  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****\n\n"
        "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n\n"
        "  THE FOLLOWING DEGREE OF FREEDOM RESULTS ARE IN THE NODAL COORDINATE SYSTEMS\n\n"
        "    NODE      UX          UY          UZ          USUM\n"
        "       1  2.0000      0.0000      0.0000      2.0000\n"
        "       2  0.0000      0.0000      0.0000      0.0000\n";
    const Job job =
        job_of("turned", {square("       1", "90.00"), shell_of("    1"), kShellType, displacement});

    Diagnostics diagnostics;
    const ModelReport report = report_model(job, diagnostics, {}).value();

    EXPECT_EQ(diagnostics.count(Code::NodalSystemRotated), 1U);
    ASSERT_EQ(report.results.size(), 1U);
    for (const ComponentRange& range : report.results[0].ranges) {
        if (range.component == "x") {
            EXPECT_NEAR(range.max, 0, 1e-6);
        }
        if (range.component == "y") {
            EXPECT_NEAR(range.max, 2, 1e-6);
        }
        if (range.component == "magnitude") {
            EXPECT_EQ(range.max, 2);
        }
    }
}

TEST(JobNotes, corner_only_stress_says_that_mid_side_nodes_are_filled) {
    Job job;
    for (const char* list : {"NLIST_all.lis", "ELIST.lis", "ETLIST.lis", "PRNSOL_S.lis"}) {
        job.inputs.push_back(project_file(std::string("examples/boiler/small/") + list));
    }
    job.output = scratch_folder("corner_only") + "/small.glb";

    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));

    EXPECT_GT(diagnostics.count(Code::MidsideInterpolated), 0U);
    EXPECT_TRUE(diagnostics.has(Code::UnitsUnknown));
}

TEST(JobNotes, a_declared_length_unit_is_not_asked_for) {
    Job job = job_of("declared", {square("       1", " 0.00"), shell_of("    1"), kShellType});
    job.length_unit = "mm";

    Diagnostics diagnostics;
    report_model(job, diagnostics, {});

    EXPECT_FALSE(diagnostics.has(Code::UnitsUnknown));
}

/// A .frd file of one shell with that number, no results.
std::string frd_square(std::int64_t element) {
    const auto head = [](const char* key, int count) {
        return fmt::format("    {}{:18}{:12}{:37}1\n", key, "", count, "");
    };
    std::string text = "    1C\n" + head("2C", 4);
    for (int i = 0; i < 4; ++i) {
        text +=
            fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", i + 1, (i + 1) / 2 % 2 + 0.0, i / 2 + 0.0, 0.0);
    }
    return text + " -3\n" + head("3C", 1) + fmt::format(" -1{:10}    9    0    1\n", element) +
           fmt::format(" -2{:10}{:10}{:10}{:10}\n", 1, 2, 3, 4) + " -3\n 9999\n";
}

TEST(JobNotes, an_element_id_that_a_scene_cannot_hold_is_refused_and_nothing_is_written) {
    Job fits = job_of("fitting_id", {frd_square(4'294'967'295)});
    fits.output = fits.inputs[0] + ".glb";
    Job job = job_of("huge_id", {frd_square(4'294'967'296)});
    job.output = job.inputs[0] + ".glb";

    Diagnostics diagnostics;
    EXPECT_TRUE(convert(fits, diagnostics, {}));
    try {
        convert(job, diagnostics, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::TooLarge);
        EXPECT_THAT(error.what(), testing::HasSubstr("4294967296"));
    }
    EXPECT_THROW(read_file(job.output), std::runtime_error);
}

TEST(JobNotes, a_frd_block_that_holds_no_records_is_refused_with_its_line) {
    std::string text = read_file(project_file("examples/boiler/hex_linear/heat.frd"));
    const std::size_t block = text.find(" -4  NDTEMP");
    const std::size_t row = text.find("\n -1", block) + 1;
    text.replace(row, 3, "what");
    Job job = job_of("bad_frd", {text});

    Diagnostics diagnostics;
    try {
        report_model(job, diagnostics, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadStructure);
        EXPECT_THAT(error.where(), testing::HasSubstr("0.lis:"));
    }
}

TEST(JobNotes, a_frd_file_without_nodes_is_refused) {
    Job job = job_of("no_nodes", {"    1C\n    1UDATE              01.january.2026\n 9999\n"});

    Diagnostics diagnostics;
    try {
        report_model(job, diagnostics, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::NoNodes);
    }
}

}  // namespace
}  // namespace feelem::test
