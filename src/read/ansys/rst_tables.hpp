// SPDX-License-Identifier: Apache-2.0
// The records of one element after the other: a set has an index of elements, an element a table of records.
#pragma once

#include "read/ansys/rst_record.hpp"
#include "read/ansys/rst_steps.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::rst {

/// Places in an element's table, from 1.
inline constexpr std::size_t kSummableEntry = 1;  ///< EMS: Ansys' SMISC.
inline constexpr std::size_t kStressEntry = 3;
inline constexpr std::size_t kEnergyEntry = 4;
inline constexpr std::size_t kElasticStrainEntry = 6;
inline constexpr std::size_t kEulerEntry = 10;
inline constexpr std::size_t kNotSummableEntry = 13;  ///< EMN: Ansys' NMISC.

class ElementTables {
public:
    /// `name`: of the result, for messages. Throws Error when the index of elements is too short.
    ElementTables(
        const Records& records, const ResultSet& set, std::size_t element_count, std::string_view name
    );

    /// To the element at a place in the file. False when it has no results.
    bool go_to(std::uint32_t place);

    /// False when the element has no such record. A record that is said to be all zero becomes zeros.
    bool read(std::size_t entry, std::vector<double>& values);

private:
    [[noreturn]] void bad(const std::string& text) const;

    const Records& records_;
    const ResultSet& set_;
    std::string name_;
    std::size_t element_count_;
    std::uint64_t left_;
    std::vector<std::int32_t> index_, table_;
    Word table_at_ = 0;
};

}  // namespace feelem::rst
