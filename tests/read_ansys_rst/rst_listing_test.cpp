// SPDX-License-Identifier: Apache-2.0
// How much of a file is touched: listing reads heads, loading reads one result.
#include "read_ansys_rst/opened_rst.hpp"
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace feelem {
namespace {

constexpr std::size_t kNodes = 6000, kUnknowns = 30, kSets = 40;

/// Steps of values that are far more than the mesh: 1.4 MB each on a mesh of half a megabyte.
std::string write_series(const std::string& path) {
    test::WrittenModel model = test::two_bricks();
    for (std::size_t i = model.nodes.size(); i < kNodes; ++i) {
        model.nodes.push_back({1000.0 + double(i), double(i), 0, 0, 0, 0, 0});
        model.storage.push_back(static_cast<std::int32_t>(1000 + i));
    }
    model.dofs.clear();
    for (int code = 0; code < static_cast<int>(kUnknowns); ++code) model.dofs.push_back(34 + code);
    model.analysis = 4;
    for (std::size_t s = 0; s < kSets; ++s) {
        test::WrittenSet set;
        set.substep = static_cast<std::int32_t>(s) + 1;
        set.time = static_cast<double>(s) / 4;
        set.solution.assign(kNodes * kUnknowns, static_cast<double>(s));
        model.sets.push_back(std::move(set));
    }
    std::ofstream(path, std::ios::binary) << test::write_rst(model);
    return path;
}

/// Share of a file that the system holds in memory.
double share_in_memory(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const std::size_t size = std::filesystem::file_size(path);
    void* map = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
    std::vector<unsigned char> pages((size + 4095) / 4096);
    const bool known = map != MAP_FAILED && mincore(map, size, pages.data()) == 0;
    if (map != MAP_FAILED) munmap(map, size);
    close(file);
    if (!known) return 1;
    const auto held = std::ranges::count_if(pages, [](unsigned char page) { return (page & 1U) != 0; });
    return static_cast<double>(held) / static_cast<double>(pages.size());
}

/// Lets the system forget a file's bytes, where its kind of file system can.
void forget(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    fsync(file);
    posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    close(file);
}

// What is read from a disk, reading ahead and all: the mesh stands at the front and is read in one go.
TEST(RstListing, of_a_series_reads_less_than_a_third_of_the_file_from_the_disk) {
    const std::string path = write_series(test::scratch_folder("rst_listing") + "/series.rst");
    forget(path);
    if (share_in_memory(path) > 0.01) GTEST_SKIP() << "this file system keeps files in memory";
    Diagnostics diagnostics;

    const auto model = open_model(std::vector{path}, {}, diagnostics);

    ASSERT_EQ(model->steps().size(), kSets);
    ASSERT_EQ(model->results().size(), kSets * kUnknowns);
    const double share = share_in_memory(path);
    std::cout << "listing read " << 100 * share << " % of the file\n";
    EXPECT_GT(share, 0);
    EXPECT_LT(share, 1.0 / 3);
}

/// Makes records of values worthless: lengths and all.
void spoil_values_of_other_sets(std::string& bytes, double kept) {
    const std::size_t record = kNodes * kUnknowns * 8;
    const auto words = static_cast<std::int32_t>(record / 4);
    for (std::size_t at = 0; at + record + 12 <= bytes.size(); at += 4) {
        std::int32_t length = 0, footer = 0;
        double first = 0;
        std::memcpy(&length, bytes.data() + at, 4);
        if (length != words) continue;
        std::memcpy(&footer, bytes.data() + at + 8 + record, 4);
        std::memcpy(&first, bytes.data() + at + 8, 8);
        if (footer != words) continue;
        if (first != kept) std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), record + 12, '\xAA');
        at += record + 8;
    }
}

TEST(RstListing, needs_no_values_and_loading_needs_those_of_its_own_step) {
    const std::string path = write_series(test::scratch_folder("rst_spoiled") + "/series.rst");
    std::string bytes = test::read_file(path);
    spoil_values_of_other_sets(bytes, 20);

    const test::OpenedRst opened = test::open_bytes(bytes);

    EXPECT_TRUE(opened.diagnostics->entries().empty());
    ASSERT_EQ(opened.model->results().size(), kSets * kUnknowns);
    const Result one = opened.model->load(20 * kUnknowns + 7);
    EXPECT_EQ(one.info.step, 20U);
    EXPECT_EQ(one.values[100], 20);
    EXPECT_THROW(opened.model->load(0), Error) << "its values are spoiled";
}

TEST(RstListing, of_a_brief_report_hashes_no_input) {
    const std::string path = write_series(test::scratch_folder("rst_listing_brief") + "/series.rst");
    Job job;
    job.inputs = {path};
    job.brief = true;
    Diagnostics diagnostics;

    const auto report = report_model(job, diagnostics, {});

    ASSERT_TRUE(report);
    EXPECT_EQ(report->results.size(), kSets * kUnknowns);
    ASSERT_EQ(report->inputs.size(), 1U);
    EXPECT_EQ(report->inputs[0].sha256, "");
    EXPECT_EQ(report->inputs[0].bytes, std::filesystem::file_size(path));
    EXPECT_NE(info_json(*report, diagnostics).find("\"sha256\": null"), std::string::npos);
    job.brief = false;
    job.results = "te2";
    job.steps = "1.1";
    const auto whole = report_model(job, diagnostics, {});
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->inputs[0].sha256.size(), 64U);
}

}  // namespace
}  // namespace feelem
