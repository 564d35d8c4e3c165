// SPDX-License-Identifier: Apache-2.0
// Rows read in chunks are those that one reader finds, wherever chunks are said to begin.
#include "read/text_chunks.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace feelem {
namespace {

/// Rows are words up to a ';'. One that starts with '!' is not plain; with '.' it ends all rows.
struct Words {
    const std::string& text;
    unsigned wrong_guesses;  ///< Of ten.
    std::vector<std::string>& out;

    std::size_t behind(std::size_t at) const { return std::min(text.find(';', at), text.size() - 1) + 1; }
    std::string word(std::size_t at) const { return text.substr(at, behind(at) - at); }

    std::size_t start(std::size_t at) const {
        const bool wrong = at * 2654435761U / 4096 % 10 < wrong_guesses;
        return wrong ? at : behind(at - 1);
    }
    std::size_t read(std::vector<std::string>& chunk, std::size_t from, std::size_t stop) const {
        chunk.clear();
        while (from < stop && text[from] != '!' && text[from] != '.') {
            chunk.push_back(word(from));
            from = behind(from);
        }
        return from;
    }
    void take(const std::vector<std::string>& chunk) const {
        out.insert(out.end(), chunk.begin(), chunk.end());
    }
    std::optional<std::size_t> go_on(std::size_t from, std::size_t stop) const {
        while (from < stop) {
            if (text[from] == '.') return {};
            out.push_back(word(from));
            from = behind(from);
        }
        return from;
    }
};

std::string words(std::size_t length, bool with_end) {
    std::mt19937 random(7);
    std::string text;
    while (text.size() < length) {
        const auto kind = random() % 1000;
        if (kind == 0) text += '!';
        text.append(kind == 1 ? 3'000'000 : 1 + random() % 2000, static_cast<char>('a' + random() % 26));
        text += ';';
        if (with_end && text.size() > length / 2) {
            text += ".;";
            with_end = false;
        }
    }
    return text;
}

TEST(TextChunks, give_the_rows_of_one_reader_whatever_the_threads_and_guesses) {
    for (const bool with_end : {false, true}) {
        const std::string text = words(40 * kTextChunk, with_end);
        std::vector<std::string> wanted;
        Words{text, 0, wanted}.go_on(0, text.size());
        ASSERT_GT(wanted.size(), 1000U);
        for (const unsigned threads : {1U, 2U, 4U}) {
            for (const unsigned wrong : {0U, 3U, 10U}) {
                set_thread_count(threads);
                std::vector<std::string> found;
                const auto end =
                    read_in_text_chunks<std::vector<std::string>>(0, text.size(), Words{text, wrong, found});
                EXPECT_EQ(end.has_value(), !with_end);
                EXPECT_EQ(found == wanted, true) << threads << " threads, " << wrong << " wrong of ten";
            }
        }
    }
    set_thread_count(0);
}

}  // namespace
}  // namespace feelem
