// SPDX-License-Identifier: Apache-2.0
// Element id -> index of a finished mesh, for results and sets that name elements.
#pragma once

#include "feelem/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace feelem {

class ElementLookup {
public:
    explicit ElementLookup(const Mesh& mesh) : count_(mesh.element_count()) {
        if (count_ == 0 || is_consecutive(mesh)) return;
        entries_.reserve(count_);
        std::uint32_t index = 0;
        for (const ElementBlock& block : mesh.blocks) {
            for (const ElementId id : block.ids) entries_.push_back({id, ElementIndex{index++}});
        }
        if (!std::ranges::is_sorted(entries_, {}, &Entry::id))
            std::ranges::stable_sort(entries_, {}, &Entry::id);
    }
    /// kNoElement when there is no such element; the first of equal ids.
    ElementIndex operator()(ElementId id) const {
        if (entries_.empty()) {  // Elements are numbered first_, first_ + 1 ...
            const auto offset = static_cast<std::uint64_t>(raw(id)) - static_cast<std::uint64_t>(first_);
            return offset < count_ ? ElementIndex{static_cast<std::uint32_t>(offset)} : kNoElement;
        }
        const auto found = std::ranges::lower_bound(entries_, id, {}, &Entry::id);
        return found != entries_.end() && found->id == id ? found->index : kNoElement;
    }

private:
    struct Entry {
        ElementId id;
        ElementIndex index;
    };

    bool is_consecutive(const Mesh& mesh) {
        std::uint64_t index = 0;
        for (const ElementBlock& block : mesh.blocks) {
            for (const ElementId id : block.ids) {
                if (index == 0) first_ = raw(id);
                const auto offset = static_cast<std::uint64_t>(raw(id)) - static_cast<std::uint64_t>(first_);
                if (offset != index++) return false;
            }
        }
        return true;
    }

    std::size_t count_;
    std::int64_t first_ = 0;
    std::vector<Entry> entries_;
};

/// Adds a set of the elements that the mesh has; none when it has none of them.
inline void add_element_set(
    Mesh& mesh, const ElementLookup& lookup, std::string name, std::span<const ElementId> ids
) {
    ElementSet set{std::move(name), {}};
    for (const ElementId id : ids) {
        if (const ElementIndex index = lookup(id); index != kNoElement) set.elements.push_back(index);
    }
    if (!set.elements.empty()) mesh.element_sets.push_back(std::move(set));
}

}  // namespace feelem
