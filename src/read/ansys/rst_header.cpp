// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_header.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace feelem::rst {
namespace {

constexpr Word kResultHeader = 103;
constexpr std::int32_t kResultFile = 12;

/// Characters in words: four each, the first one in the highest byte.
std::string text_of(const std::vector<std::int32_t>& header, std::size_t first, std::size_t count) {
    std::string text;
    for (std::size_t i = first; i < first + count; ++i) {
        const auto word = static_cast<std::uint32_t>(item(header, i));
        for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(word >> shift & 0xFF);
    }
    return std::string(trim(text.substr(0, text.find('\0'))));
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        const int more = lead < 0x80       ? 0
                         : lead >> 5 == 6  ? 1
                         : lead >> 4 == 14 ? 2
                         : lead >> 3 == 30 ? 3
                                           : -1;
        if (more < 0) return false;
        for (int k = 0; k < more; ++k, ++i) {
            if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return false;
        }
    }
    return true;
}

/// Titles are UTF-8 or Latin-1, whatever the user's machine had.
std::string utf8_of_title(std::string text) {
    if (is_utf8(text)) return text;
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            out += c;
        } else {
            out += static_cast<char>(0xC0 | byte >> 6);
            out += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return out;
}

std::size_t count_of(const Records& records, const std::vector<std::int32_t>& header, std::size_t number) {
    const std::int32_t count = item(header, number);
    // A node or an element takes several words, a set hundreds.
    if (count >= 0 && static_cast<std::size_t>(count) <= records.words())
        return static_cast<std::size_t>(count);
    throw Error(
        Code::BadStructure,
        records.where(kResultHeader),
        fmt::format("item {} of the result header is {}: the file is damaged or cut", number, count)
    );
}

[[noreturn]] void other_file(const Records& records, std::int32_t number) {
    throw Error(
        Code::UnknownFormat,
        records.input().name(),
        fmt::format(
            "this is an Ansys binary file of kind {}, but no result file. Give the .rst, .rth or .rmg of the "
            "same run.",
            number
        )
    );
}

}  // namespace

std::int32_t item(const std::vector<std::int32_t>& header, std::size_t number) {
    return number - 1 < header.size() ? header[number - 1] : 0;
}

Word pointer(const std::vector<std::int32_t>& header, std::size_t low, std::size_t high) {
    return wide(item(header, low), item(header, high));
}

ResultHeader read_header(const Records& records) {
    const std::vector<std::int32_t> standard = records.integers(0);
    if (item(standard, 1) != kResultFile) other_file(records, item(standard, 1));
    const std::vector<std::int32_t> head = records.integers(kResultHeader);

    ResultHeader header;
    header.version = text_of(standard, 10, 1);
    header.time = item(standard, 3);
    header.date = item(standard, 4);
    header.title = utf8_of_title(text_of(standard, 41, 20));
    header.nodes = count_of(records, head, 3);
    header.set_table = count_of(records, head, 4);
    header.elements = count_of(records, head, 7);
    header.analysis = item(head, 8);
    header.sets = count_of(records, head, 9);
    header.units = item(head, 20);
    header.sectors = std::max(1, item(head, 21));
    header.sector_system = item(head, 22);
    header.sector_elements = item(head, 19);
    header.sector_nodes = item(head, 32);
    header.is_complex = item(head, 33) != 0;
    header.has_principal = item(head, 40) == 0;
    header.nodes_of_all = count_of(records, head, 49);
    header.set_pointers = pointer(head, 11, 41);
    header.times = pointer(head, 12, 42);
    header.load_steps = pointer(head, 13, 43);
    header.element_ids = pointer(head, 14, 45);
    header.node_ids = pointer(head, 15, 46);
    header.geometry = pointer(head, 16, 47);
    header.cyclic = pointer(head, 17, 44);
    // The heads of a set alone take some 600 words.
    constexpr std::size_t kLeastWordsOfASet = 128;
    if (header.sets > header.set_table || header.sets > records.words() / kLeastWordsOfASet) {
        throw Error(
            Code::BadStructure,
            records.where(kResultHeader),
            fmt::format(
                "{} sets of results in a table of {}, in a file of {} bytes: it is damaged or cut",
                header.sets,
                header.set_table,
                records.input().size()
            )
        );
    }
    return header;
}

Units units_of(std::int32_t code) {
    // The systems of Ansys' command /UNITS, in the order of their codes.
    static constexpr std::array kSystems{
        Units{},
        Units{"m", "N", "Pa", "K", "W/m^2", "V", "s"},        // SI
        Units{"cm", "dyn", "dyn/cm^2", "degC", "", "", "s"},  // CGS
        Units{"ft", "lbf", "lbf/ft^2", "degF", "", "", "s"},  // BFT
        Units{"in", "lbf", "psi", "degF", "", "", "s"},       // BIN
        Units{"m", "N", "Pa", "degC", "W/m^2", "V", "s"},     // MKS
        Units{"mm", "N", "MPa", "degC", "mW/mm^2", "", "s"},  // MPA: mm, t, s
        Units{"um", "uN", "MPa", "degC", "", "", "s"},        // uMKS: um, kg, s
    };
    const auto at = static_cast<std::size_t>(code);
    return code >= 0 && at < kSystems.size() ? kSystems[at] : Units{};
}

}  // namespace feelem::rst
