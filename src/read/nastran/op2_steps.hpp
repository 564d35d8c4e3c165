// SPDX-License-Identifier: Apache-2.0
// The steps of all tables of a .op2, each once, numbered within its subcase.
#pragma once

#include "read/nastran/op2_ident.hpp"

#include "feelem/result.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace feelem::op2 {

class StepList {
public:
    void add(const StepKey& key, double value, const Texts& texts);

    /// Of a mode that no added step has a value for.
    void set_frequency(std::int64_t mode, double hertz);

    /// Step::step is the subcase; substep the mode, or a count by ascending time, frequency or load factor.
    /// A subcase's one static step beside its modes is substep 0.
    std::vector<Step> finish();
    /// After finish().
    std::uint32_t index_of(const StepKey& key) const;

private:
    struct Entry {
        double value = 0;
        std::string label;
        std::uint32_t index = 0;
    };
    std::map<StepKey, Entry> entries_;
};

}  // namespace feelem::op2
