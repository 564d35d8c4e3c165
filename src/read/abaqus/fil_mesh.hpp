// SPDX-License-Identifier: Apache-2.0
// The records of a results file that describe its mesh.
#pragma once

#include "base/number.hpp"
#include "model/mesh_builder.hpp"
#include "read/abaqus/deck_types.hpp"
#include "read/abaqus/fil_contents.hpp"
#include "read/element_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace feelem::fil {

/// The words from `first` on as one text.
inline std::string joined_text(const Record& record, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < record.words.size(); ++i) text += record.words[i].as_text();
    return std::string(trim(text));
}

struct RawElement {
    std::int64_t id = 0;
    std::uint32_t type = 0;  ///< Into type names.
    std::uint32_t part = 0;
    std::size_t first = 0, count = 0;  ///< Into nodes.
};
struct RawSet {
    std::string label;
    bool of_nodes = false;
    std::vector<std::int64_t> members;
};

/// Records before the first increment.
class MeshRecords {
public:
    explicit MeshRecords(Diagnostics& diagnostics) : diagnostics_(diagnostics), builder_(diagnostics) {}

    void use(const Record& record) {
        const auto& words = record.words;
        switch (record.key) {
        case 1900: begin_element(record); break;
        case 1990:
            if (!elements_.empty()) add_nodes(record, 0);
            break;
        case 1901:
            if (words.size() >= 2) add_node(record);
            break;
        case 1931:
        case 1933:
            if (words.empty()) break;
            sets_.push_back({std::string(trim(words[0].as_text())), record.key == 1931, {}});
            add_members(record, 1);
            break;
        case 1932:
        case 1934:
            if (!sets_.empty()) add_members(record, 0);
            break;
        case 1940:
            if (words.size() >= 2) labels_[words[0].as_integer()] = joined_text(record, 1);
            break;
        case kPartKey: part_ = index_of(parts_, joined_text(record, 0)); break;
        default: break;
        }
    }

    Mesh finish() {
        builder_.seal_nodes();
        for (const RawElement& element : elements_) add_element(element);
        for (const RawSet& set : sets_) {
            if (!set.of_nodes) continue;
            std::vector<NodeId> ids;
            for (const std::int64_t id : set.members) ids.push_back(NodeId{id});
            builder_.add_node_set(label_of_set(set), ids);
        }
        Mesh mesh = builder_.finish();
        const ElementLookup lookup(mesh);
        for (const RawSet& set : sets_) {
            if (set.of_nodes) continue;
            std::vector<ElementId> ids;
            for (const std::int64_t id : set.members) ids.push_back(ElementId{id});
            add_element_set(mesh, lookup, label_of_set(set), ids);
        }
        return mesh;
    }

private:
    void begin_element(const Record& record) {
        if (record.words.size() < 2) return;
        RawElement element;
        element.id = record.words[0].as_integer();
        element.type = index_of(types_, std::string(trim(record.words[1].as_text())));
        element.part = part_;
        element.first = nodes_.size();
        elements_.push_back(element);
        add_nodes(record, 2);
    }
    void add_nodes(const Record& record, std::size_t first) {
        for (std::size_t i = first; i < record.words.size(); ++i)
            nodes_.push_back(record.words[i].as_integer());
        elements_.back().count = nodes_.size() - elements_.back().first;
    }
    void add_node(const Record& record) {
        Point3 place{};
        for (std::size_t i = 1; i < std::min<std::size_t>(record.words.size(), 4); ++i)
            place[i - 1] = record.words[i].as_real();
        builder_.add_node(NodeId{record.words[0].as_integer()}, place);
    }
    void add_members(const Record& record, std::size_t first) {
        for (std::size_t i = first; i < record.words.size(); ++i)
            sets_.back().members.push_back(record.words[i].as_integer());
    }

    void add_element(const RawElement& element) {
        const std::string& name = types_[element.type];
        const abaqus::DeckType type = abaqus::deck_type(name);
        if (type.use == abaqus::Use::Skip) builder_.skip_element(name);
        if (type.use == abaqus::Use::Unknown ||
            (type.use == abaqus::Use::Shape && element.count < type.least_nodes)) {
            diagnostics_.add(
                Code::UnknownElementType,
                std::string(),
                fmt::format("elements of type \"{}\" are left out: Feelem does not know it", name)
            );
        }
        if (type.use != abaqus::Use::Shape || element.count < type.least_nodes) return;
        std::array<NodeId, kMaxElementNodes> ids{};
        const std::size_t count = std::min<std::size_t>(type.most_nodes, element.count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t from = type.order.empty() ? i : type.order[i];
            if (from < element.count) ids[i] = NodeId{nodes_[element.first + from]};
        }
        builder_.add_element(
            ElementId{element.id},
            type.shape,
            std::span(ids).first(count),
            builder_.part(parts_[element.part]),
            [] { return std::string(); }
        );
    }

    /// Long names are numbers that records 1940 explain.
    std::string label_of_set(const RawSet& set) const {
        const auto number = parse_integer(set.label);
        const auto found = number ? labels_.find(*number) : labels_.end();
        return found == labels_.end() ? set.label : found->second;
    }

    static std::uint32_t index_of(std::vector<std::string>& names, const std::string& name) {
        const auto found = std::ranges::find(names, name);
        if (found != names.end()) return static_cast<std::uint32_t>(found - names.begin());
        names.push_back(name);
        return static_cast<std::uint32_t>(names.size() - 1);
    }

    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    std::vector<RawElement> elements_;
    std::vector<std::int64_t> nodes_;
    std::vector<RawSet> sets_;
    std::vector<std::string> types_, parts_{"model"};
    std::uint32_t part_ = 0;
    std::map<std::int64_t, std::string> labels_;
};

}  // namespace feelem::fil
