// SPDX-License-Identifier: Apache-2.0
// Blocks of results that are not used: one word for each kind in a table, whatever the number of steps.
#pragma once

#include "read/nastran/op2_ident.hpp"

#include "feelem/diagnostics.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace feelem::op2 {

class UnusedBlocks {
public:
    void add(const std::string& table, const Ident& ident);
    /// UnknownBlock, with the number of blocks.
    void report(const std::string& where, Diagnostics& diagnostics) const;

private:
    struct Blocks {
        std::set<std::int64_t> types;  ///< Of elements.
        std::uint64_t count = 0;
    };
    std::map<std::pair<std::string, std::string>, Blocks> blocks_;
};

}  // namespace feelem::op2
