// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_element_cards.hpp"

#include <algorithm>

namespace feelem::op2 {
namespace {

/// By key, ascending. NX writes CHEXAL for composite solids: a CHEXA otherwise.
constexpr std::array kRecords{
    CardRecord{201, 2, "CDAMP1", {6}},
    CardRecord{301, 3, "CDAMP2", {6}},
    CardRecord{401, 4, "CDAMP3", {4}},
    CardRecord{501, 5, "CDAMP4", {4}},
    CardRecord{601, 6, "CELAS1", {6}},
    CardRecord{701, 7, "CELAS2", {8}},
    CardRecord{707, 7, {}, {1}},  // EPOINT
    CardRecord{801, 8, "CELAS3", {4}},
    CardRecord{901, 9, "CELAS4", {4}},
    CardRecord{1001, 10, "CMASS1", {6}},
    CardRecord{1101, 11, "CMASS2", {6}},
    CardRecord{1201, 12, "CMASS3", {4}},
    CardRecord{1301, 13, "CMASS4", {5, 4}},
    CardRecord{1401, 14, "CONM1", {24}},
    CardRecord{1501, 15, "CONM2", {13}},
    CardRecord{1601, 16, "CONROD", {8}, 1, 2},
    CardRecord{1908, 19, "CGAP", {9}},
    CardRecord{2408, 24, "CBAR", {16}, 2, 2},
    CardRecord{2608, 26, "CBUSH", {14, 15}},
    CardRecord{2958, 51, "CQUAD4", {14, 15}, 2, 4},
    CardRecord{3001, 30, "CROD", {4}, 2, 2},
    CardRecord{3101, 31, "CSHEAR", {6}, 2, 4},
    CardRecord{3701, 37, "CTUBE", {4}, 2, 2},
    CardRecord{3901, 39, "CVISC", {4}},
    CardRecord{4001, 40, {}, {9}},  // CBARAO
    CardRecord{4108, 41, "CPENTA", {17}, 2, 15},
    CardRecord{4601, 46, "CBEND", {13}, 2, 2},
    CardRecord{4701, 47, "CQUAD8", {17, 16, 18}, 2, 8},
    CardRecord{4801, 48, "CTRIA6", {14, 13}, 2, 6},
    CardRecord{5201, 52, "PLOTEL", {3}, 1, 2},
    CardRecord{5408, 54, "CBEAM", {18}, 2, 2},
    CardRecord{5508, 55, "CTETRA", {12}, 2, 10},
    CardRecord{5551, 49, {}, {1}},  // SPOINT: a node
    CardRecord{5608, 56, "CBUSH1D", {8}},
    CardRecord{5959, 59, "CTRIA3", {13, 14}, 2, 3},
    CardRecord{6108, 61, "CTRIAX6", {11}, 2, 6},
    CardRecord{7308, 73, "CHEXA", {22}, 2, 20},
    CardRecord{7708, 77, "CHEXA", {23}, 3, 20},
    CardRecord{8009, 80, "CQUADR", {14, 15}, 2, 4},
    CardRecord{8308, 83, "CHBDYE", {14}},
    CardRecord{8908, 89, {}, {7, 6}},  // CONVM
    CardRecord{9108, 91, "CQUAD", {11, 12}, 2, 9},
    CardRecord{9200, 92, "CTRIAR", {13, 14}, 2, 3},
    CardRecord{10608, 106, "CDAMP5", {4}},
    CardRecord{10808, 108, "CHBDYG", {16}},
    CardRecord{10908, 109, "CHBDYP", {15}},
    CardRecord{12701, 127, {}, {12}},  // CONV
    CardRecord{17200, 172, "CPYRAM", {16, 15}, 2, 13},
};
static_assert(std::ranges::is_sorted(kRecords, {}, &CardRecord::key));

bool fits(const CardRecord& card, const Words& entries, std::size_t width) {
    if (width == 0 || entries.count() % width != 0) return false;
    std::int64_t last = 0;
    for (std::size_t at = 0; at < entries.count(); at += width) {
        if (entries.integer(at) <= last) return false;
        last = entries.integer(at);
        if (card.node_words > 0 && entries.integer(at + card.first_node) <= 0) return false;
    }
    return true;
}

}  // namespace

const CardRecord* find_card_record(std::int64_t key, std::int64_t second_key) {
    const auto at = std::ranges::lower_bound(kRecords, key, {}, &CardRecord::key);
    return at != kRecords.end() && at->key == key && at->second_key == second_key ? &*at : nullptr;
}

std::size_t entry_words(const CardRecord& card, const Words& entries) {
    for (const std::size_t width : card.words) {
        if (fits(card, entries, width)) return width;
    }
    return 0;
}

}  // namespace feelem::op2
