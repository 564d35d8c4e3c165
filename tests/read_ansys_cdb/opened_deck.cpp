// SPDX-License-Identifier: Apache-2.0
#include "read_ansys_cdb/opened_deck.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace feelem::test {
namespace {

/// Calls with each element; stops when the answer is true.
template <class Take>
void find_element(const Mesh& mesh, std::int64_t id, const Take& take) {
    for (std::size_t i = 0; i < mesh.element_count(); ++i) {
        const ElementRef element = element_at(mesh, ElementIndex{static_cast<std::uint32_t>(i)});
        if (raw(element.id()) == id) take(element);
    }
}

}  // namespace

OpenedDeck open_deck_file(const std::string& path) {
    OpenedDeck opened;
    const std::vector<std::string> paths{path};
    opened.model = open_model(paths, {}, *opened.diagnostics);
    return opened;
}

OpenedDeck open_deck(const std::string& text, const std::string& types) {
    OpenedDeck opened;
    std::vector<NamedBytes> files;
    files.push_back({"deck.cdb", text});
    opened.model = open_model(std::move(files), ReadOptions{"", types}, *opened.diagnostics);
    return opened;
}

OpenedDeck open_decks(std::vector<NamedBytes> files) {
    OpenedDeck opened;
    opened.model = open_model(std::move(files), {}, *opened.diagnostics);
    return opened;
}

std::map<std::string, std::size_t> element_counts(const Mesh& mesh) {
    std::map<std::string, std::size_t> counts;
    for (const ElementBlock& block : mesh.blocks)
        counts[std::string(element_row(block.type).name)] += block.ids.size();
    return counts;
}

std::vector<std::int64_t> nodes_of(const Mesh& mesh, std::int64_t id) {
    std::vector<std::int64_t> nodes;
    find_element(mesh, id, [&](const ElementRef& element) {
        for (const NodeIndex node : element.nodes())
            nodes.push_back(node == kNoNode ? 0 : raw(mesh.node_ids[raw(node)]));
    });
    return nodes;
}

std::string part_of(const Mesh& mesh, std::int64_t id) {
    std::string name = "no such element";
    find_element(mesh, id, [&](const ElementRef& element) { name = mesh.parts[raw(element.part())].name; });
    return name;
}

Point3 position_of(const Mesh& mesh, std::int64_t node) {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    const NodeIndex index = find_node(mesh, NodeId{node});
    return index == kNoNode ? Point3{kNowhere, kNowhere, kNowhere} : mesh.coordinates[raw(index)];
}

std::string all_texts(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& entry : diagnostics.entries()) {
        text += std::string(code_info(entry.code).word) + " x" + std::to_string(entry.count) + " at " +
                entry.where + ": " + entry.text + "\n";
    }
    return text;
}

}  // namespace feelem::test
