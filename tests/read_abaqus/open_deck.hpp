// SPDX-License-Identifier: Apache-2.0
// Decks out of a test's text, and what their mesh holds, by the solver's numbers.
#pragma once

#include "feelem/read.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace feelem::tests {

struct Opened {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;
    const Mesh& mesh() const { return model->mesh(); }
};

inline Opened open_decks(std::vector<NamedBytes> files) {
    Opened opened;
    opened.model = open_model(std::move(files), {}, *opened.diagnostics);
    return opened;
}
inline Opened open_deck(std::string text) {
    return open_decks({{"job.inp", std::move(text)}});
}

inline std::vector<std::int64_t> node_ids(const Mesh& mesh) {
    std::vector<std::int64_t> ids;
    for (const NodeId id : mesh.node_ids) ids.push_back(raw(id));
    return ids;
}
inline std::vector<std::int64_t> element_ids(const Mesh& mesh) {
    std::vector<std::int64_t> ids;
    for (const ElementBlock& block : mesh.blocks)
        for (const ElementId id : block.ids) ids.push_back(raw(id));
    return ids;
}
inline std::vector<std::int64_t> set_nodes(const Mesh& mesh, const std::string& name) {
    std::vector<std::int64_t> ids;
    for (const NodeSet& set : mesh.node_sets) {
        if (set.name != name) continue;
        for (const NodeIndex node : set.nodes) ids.push_back(raw(mesh.node_ids[raw(node)]));
    }
    return ids;
}
inline std::vector<std::int64_t> set_elements(const Mesh& mesh, const std::string& name) {
    std::vector<std::int64_t> ids;
    for (const ElementSet& set : mesh.element_sets) {
        if (set.name != name) continue;
        for (const ElementIndex element : set.elements) ids.push_back(raw(element_at(mesh, element).id()));
    }
    return ids;
}
inline std::vector<std::string> part_of_each_element(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const ElementBlock& block : mesh.blocks)
        for (const PartIndex part : block.parts) names.push_back(mesh.parts[raw(part)].name);
    return names;
}
inline Point3 place_of(const Mesh& mesh, std::int64_t id) {
    return mesh.coordinates.at(raw(find_node(mesh, NodeId{id})));
}
inline void expect_place(const Mesh& mesh, std::int64_t id, const Point3& expected) {
    const Point3 found = place_of(mesh, id);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << id << " axis " << i;
}

}  // namespace feelem::tests
