// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem::op2 {
namespace {

/// Nastran repeats the subcase in the last columns of a label.
std::string label_of(const StepKey& key, const Texts& texts) {
    std::string label = texts.label.substr(0, texts.label.find("SUBCASE"));
    while (label.ends_with(' ')) label.pop_back();
    std::string out = texts.subtitle.substr(0, texts.subtitle.find("SUBCASE"));
    while (out.ends_with(' ')) out.pop_back();
    if (!label.empty() && label != out) out += (out.empty() ? "" : ", ") + label;
    if (key.number != 0) out += fmt::format("{}mode {}", out.empty() ? "" : ", ", key.number);
    return out;
}

}  // namespace

void StepList::add(const StepKey& key, double value, const Texts& texts) {
    const auto [entry, is_new] = entries_.try_emplace(key);
    if (is_new) entry->second.label = label_of(key, texts);
    // Tables that are sorted by node know a mode's number alone.
    if (is_new || entry->second.value == 0) entry->second.value = value;
}

void StepList::set_frequency(std::int64_t mode, double hertz) {
    for (auto& [key, entry] : entries_) {
        const bool is_it = key.kind == StepKind::Mode && key.number == mode;
        if (is_it && entry.value == 0 && std::isfinite(hertz)) entry.value = hertz;
    }
}

std::vector<Step> StepList::finish() {
    std::vector<Step> steps;
    std::int32_t subcase = -1;
    std::int32_t next = 1;
    std::size_t first = 0;
    for (auto& [key, entry] : entries_) {
        if (key.subcase != subcase) {
            subcase = key.subcase;
            next = 1;
            first = steps.size();
        }
        std::int32_t substep = next;
        if (key.number > 0 && key.number < std::numeric_limits<std::int32_t>::max()) {
            substep = std::max(next, static_cast<std::int32_t>(key.number));
            const bool one_static = steps.size() == first + 1 && steps.back().kind == StepKind::Static;
            if (one_static) {
                steps.back().substep = 0;
                substep = static_cast<std::int32_t>(key.number);
            }
        }
        next = substep == std::numeric_limits<std::int32_t>::max() ? substep : substep + 1;
        entry.index = static_cast<std::uint32_t>(steps.size());
        steps.push_back({0, key.subcase, substep, key.kind, entry.value, entry.label});
    }
    return steps;
}

std::uint32_t StepList::index_of(const StepKey& key) const {
    return entries_.at(key).index;
}

}  // namespace feelem::op2
