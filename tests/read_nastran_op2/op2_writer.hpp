// SPDX-License-Identifier: Apache-2.0
// Writes small .op2 files from the format's description, in any word form; shares no code with the reader.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace feelem::test {

struct Op2Form {
    int word = 4;  ///< Bytes.
    bool big_endian = false;
};

/// One word of a record: an integer, a real, or up to four characters; a WideReal fills eight bytes.
struct WideReal {
    double value = 0;
};
using Op2Word = std::variant<std::int64_t, double, std::string, WideReal>;
using Op2Words = std::vector<Op2Word>;

/// What the ident in front of a block of results says.
struct Op2Ident {
    int approach = 1;
    int table_code = 1;  ///< With its thousands: 1000 complex, 2000 sorted by node.
    int element_type = 0;
    int subcase = 1;
    Op2Word word5 = std::int64_t{1};
    Op2Word word6 = std::int64_t{0};
    int format = 1;
    int row_words = 8;
    int stress_bits = 0;
    int thermal = 0;
    std::string label = {};
};

class Op2Writer {
public:
    explicit Op2Writer(Op2Form form = {}) : form_(form) {}

    void head(std::string_view version = "XXXXXXXX");
    void begin_table(std::string_view name);
    /// In pieces of at most `piece` words.
    void record(const Op2Words& words, std::size_t piece = 1000000);
    void block(const Op2Ident& ident, const Op2Words& data, std::size_t piece = 1000000);
    void end_table();
    void matrix_column(const Op2Words& words);
    /// The file so far, ended.
    std::string finish() const;

private:
    void fortran(const std::string& bytes);
    void key(std::int64_t value);
    std::string bytes_of(const Op2Word& word) const;
    std::string bytes_of(const Op2Words& words) const;
    std::string number(std::uint64_t bits, int size) const;

    Op2Form form_;
    std::string out_;
    std::int64_t next_end_ = 0;
};

/// Words of a text, four characters each.
Op2Words text_words(std::string_view text, std::size_t words);
/// The words of several lists.
Op2Words joined(std::initializer_list<Op2Words> lists);

}  // namespace feelem::test
