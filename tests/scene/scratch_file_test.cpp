// SPDX-License-Identifier: Apache-2.0
#include "scene/scratch_file.hpp"
#include "support/paths.hpp"
#include "support/threads.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace feelem::test {
namespace {

TEST(ScratchFile, keeps_the_order_of_its_blocks_while_threads_come_and_go) {
    const std::string path = scratch_folder("scratch_file") + "/blocks";
    const ThreadsComeAndGo changing;
    std::string expected;
    auto digest = std::make_shared<Sha256>();
    ScratchFile file(path, ScratchFile::Kind::Named);
    for (std::size_t i = 0; i < 3000; ++i) {
        const std::string block = std::to_string(i) + std::string(i % 4096, '.') + "\n";
        expected += block;
        const auto bytes = std::as_bytes(std::span(block));
        file.write_behind({bytes.begin(), bytes.end()}, digest);
    }
    file.finish();
    EXPECT_EQ(file.size(), expected.size());
    EXPECT_TRUE(read_file(path) == expected);
    Sha256 whole;
    whole.add(std::as_bytes(std::span(expected)));
    EXPECT_EQ(digest->hex(), whole.hex());
}

}  // namespace
}  // namespace feelem::test
