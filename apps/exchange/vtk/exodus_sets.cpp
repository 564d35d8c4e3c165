// SPDX-License-Identifier: Apache-2.0
#include "vtk/exodus_sets.hpp"

#include "vtk/netcdf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>
#include <utility>

namespace feelem::exchange {
namespace {

using Corners = std::vector<std::uint8_t>;

/// The corners of each side, in the order of the Exodus manual. Shells count their two faces first.
std::span<const Corners> sides_of(ElementType type, bool is_flat) {
    static const std::vector<Corners> kHex{
        {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    static const std::vector<Corners> kTet{{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}};
    static const std::vector<Corners> kWedge{{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}};
    static const std::vector<Corners> kPyramid{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}};
    static const std::vector<Corners> kQuad{{0, 1, 2, 3}, {0, 3, 2, 1}, {0, 1}, {1, 2}, {2, 3}, {3, 0}};
    static const std::vector<Corners> kTri{{0, 1, 2}, {0, 2, 1}, {0, 1}, {1, 2}, {2, 0}};
    const std::size_t faces = is_flat ? 2 : 0;
    switch (element_row(type).linear) {
    case ElementType::Hex8: return kHex;
    case ElementType::Tet4: return kTet;
    case ElementType::Wedge6: return kWedge;
    case ElementType::Pyramid5: return kPyramid;
    case ElementType::Quad4: return std::span(kQuad).subspan(faces);
    case ElementType::Tri3: return std::span(kTri).subspan(faces);
    default: return {};
    }
}

bool same_corners(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}

/// Local nodes of a side with its mid-side nodes.
std::vector<std::uint8_t> nodes_of_side(ElementType type, const Corners& corners) {
    for (const FacetRow& facet : facets_of(type)) {
        if (!same_corners(facet_corners(facet), corners)) continue;
        const auto nodes = facet_nodes(facet);
        return {nodes.begin(), nodes.end()};
    }
    for (const EdgeRow& edge : edges_of(type)) {
        if (!same_corners(std::array{edge.first, edge.second}, corners)) continue;
        std::vector<std::uint8_t> nodes{edge.first, edge.second};
        if (edge.middle != kNoLocalNode) nodes.push_back(edge.middle);
        return nodes;
    }
    return {};
}

/// Position in the file, from 1 -> index in the model, by the file's map of numbers or 1, 2, 3 ...
class Places {
public:
    Places(const NetcdfFile& file, const char* map, const std::vector<std::int64_t>& ids)
        : numbers_(file.integers(map)) {
        for (std::size_t i = 0; i < ids.size(); ++i) index_[ids[i]] = static_cast<std::uint32_t>(i);
    }
    /// Null when the model does not have it.
    const std::uint32_t* find(std::int64_t position) const {
        std::int64_t id = position;
        if (!numbers_.empty()) {
            if (position < 1 || position > static_cast<std::int64_t>(numbers_.size())) return nullptr;
            id = numbers_[static_cast<std::size_t>(position - 1)];
        }
        const auto at = index_.find(id);
        return at == index_.end() ? nullptr : &at->second;
    }

private:
    std::vector<std::int64_t> numbers_;
    std::unordered_map<std::int64_t, std::uint32_t> index_;
};

/// The names of all sets of a kind; those without are called by their ids.
class Names {
public:
    Names(const NetcdfFile& file, const std::string& kind, const char* words)
        : words_(words), names_(file.texts(kind + "_names")), ids_(file.integers(kind + "_prop1")) {}
    std::string of(std::size_t number) const {
        if (number <= names_.size() && !names_[number - 1].empty()) return names_[number - 1];
        return fmt::format(
            "{} {}", words_, number <= ids_.size() ? ids_[number - 1] : static_cast<std::int64_t>(number)
        );
    }

private:
    const char* words_;
    std::vector<std::string> names_;
    std::vector<std::int64_t> ids_;
};

class Sets {
public:
    Sets(const std::string& path, NeutralModel& model) : file_(path), model_(model) {}

    void add_all(bool has_element_ids) {
        const std::size_t node_sets = file_.dimension("num_node_sets");
        const std::size_t side_sets = file_.dimension("num_side_sets");
        if (node_sets + side_sets == 0 || node_sets > kMostSets || side_sets > kMostSets) return;
        const Places nodes(file_, "node_num_map", model_.node_ids);
        const Names node_names(file_, "ns", "node set"), side_names(file_, "ss", "side set");
        for (std::size_t i = 1; i <= node_sets; ++i)
            add(node_names.of(i), nodes_at(file_.integers(fmt::format("node_ns{}", i)), nodes));
        if (side_sets == 0 || !has_element_ids) return;
        const Places elements(file_, "elem_num_map", model_.element_ids);
        find_rows();
        for (std::size_t i = 1; i <= side_sets; ++i) add(side_names.of(i), nodes_of_sides(i, elements));
    }

private:
    static constexpr std::size_t kMostSets = 100'000;
    using Indexes = std::vector<std::uint32_t>;

    static Indexes nodes_at(const std::vector<std::int64_t>& positions, const Places& places) {
        Indexes found;
        for (const std::int64_t position : positions) {
            if (const auto* const at = places.find(position)) found.push_back(*at);
        }
        return found;
    }

    /// Where each element's nodes begin in the model.
    void find_rows() {
        std::size_t at = 0;
        for (const ElementType type : model_.types) {
            rows_.push_back(at);
            at += element_row(type).node_count;
        }
    }

    Indexes nodes_of_sides(std::size_t number, const Places& elements) const {
        const auto owners = file_.integers(fmt::format("elem_ss{}", number));
        const auto sides = file_.integers(fmt::format("side_ss{}", number));
        const bool is_flat = file_.dimension("num_dim") == 2;
        Indexes found;
        for (std::size_t i = 0; i < owners.size() && i < sides.size(); ++i) {
            const auto* const element = elements.find(owners[i]);
            if (element == nullptr) continue;
            const ElementType type = model_.types[*element];
            const auto all = sides_of(type, is_flat);
            if (sides[i] < 1 || sides[i] > static_cast<std::int64_t>(all.size())) continue;
            for (const std::uint8_t node : nodes_of_side(type, all[static_cast<std::size_t>(sides[i] - 1)]))
                found.push_back(model_.element_nodes[rows_[*element] + node]);
        }
        return found;
    }

    void add(std::string name, Indexes nodes) {
        std::ranges::sort(nodes);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        if (!nodes.empty()) model_.node_sets.emplace_back(std::move(name), std::move(nodes));
    }

    const NetcdfFile file_;
    NeutralModel& model_;
    std::vector<std::size_t> rows_;
};

}  // namespace

void add_exodus_sets(const std::string& path, bool has_element_ids, NeutralModel& model) {
    Sets(path, model).add_all(has_element_ids);
}

}  // namespace feelem::exchange
