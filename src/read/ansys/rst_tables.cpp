// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_tables.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem::rst {
namespace {

constexpr std::size_t kTableEntries = 64;  ///< 25 or 26 in real files.
/// 250 layers with three surfaces of eight corners with eleven values.
constexpr std::size_t kMostValuesOfARecord = 1u << 16;

}  // namespace

ElementTables::ElementTables(
    const Records& records, const ResultSet& set, std::size_t element_count, std::string_view name
)
    : records_(records), set_(set), name_(name), element_count_(element_count),
      // Real files name a record once; damaged ones may name one a million times.
      left_(64 * std::uint64_t{records.words()} + (1u << 20)) {
    records_.unpack(records_.find(set_.elements), 2 * element_count_, index_);
    if (index_.size() < element_count_) bad("the index of elements is too short");
}

bool ElementTables::go_to(std::uint32_t place) {
    const bool is_wide = index_.size() >= 2 * element_count_;
    const Word offset = is_wide ? wide(index_[2 * std::size_t{place}], index_[2 * std::size_t{place} + 1])
                                : wide(index_[place], 0);
    if (offset == 0) return false;
    table_at_ = set_.elements + offset;
    records_.unpack(records_.find(table_at_), kTableEntries, table_);
    return true;
}

bool ElementTables::read(std::size_t entry, std::vector<double>& values) {
    const std::int32_t place = entry <= table_.size() ? table_[entry - 1] : 0;
    if (place == 0) return false;
    if (place < 0) {
        // Not stored: so many zeros.
        values.assign(
            std::min<std::size_t>(static_cast<std::uint32_t>(-std::int64_t{place}), kMostValuesOfARecord), 0
        );
    } else {
        records_.unpack(
            records_.find(table_at_ + static_cast<std::uint32_t>(place)), kMostValuesOfARecord, values
        );
    }
    if (values.size() > left_) bad("elements share more records than the file can hold");
    left_ -= values.size();
    return true;
}

void ElementTables::bad(const std::string& text) const {
    throw Error(
        Code::BadStructure,
        records_.where(table_at_ != 0 ? table_at_ : set_.elements),
        fmt::format("{} ({}): the file is damaged", text, name_)
    );
}

}  // namespace feelem::rst
