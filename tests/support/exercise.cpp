// SPDX-License-Identifier: Apache-2.0
#include "support/exercise.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem::test {
namespace {

std::string check_block(const Mesh& mesh, const ElementBlock& block) {
    const ElementRow& row = element_row(block.type);
    if (block.parts.size() != block.ids.size() || block.nodes.size() != block.ids.size() * row.node_count)
        return "a block's arrays differ in length";
    for (const PartIndex part : block.parts) {
        if (raw(part) >= mesh.parts.size()) return "a part that does not exist";
    }
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {
        const bool corner = i % row.node_count < row.corner_count;
        const NodeIndex node = block.nodes[i];
        if (node == kNoNode ? corner : raw(node) >= mesh.node_count()) return "a node that does not exist";
    }
    return {};
}

std::string check_mesh(const Mesh& mesh) {
    if (mesh.coordinates.size() != mesh.node_count()) return "coordinates and nodes differ in number";
    const auto unordered = std::ranges::adjacent_find(mesh.node_ids, std::ranges::greater_equal{});
    if (unordered != mesh.node_ids.end()) return "node ids do not ascend";
    for (const ElementBlock& block : mesh.blocks) {
        if (std::string wrong = check_block(mesh, block); !wrong.empty()) return wrong;
    }
    return {};
}

std::string check_result(const ModelSource& model, const Result& result) {
    const Mesh& mesh = model.mesh();
    if (result.info.step >= model.steps().size()) return "a step that does not exist";
    if (result.component_count() == 0 || result.values.size() % result.component_count() != 0)
        return "values that fill no rows";
    const std::size_t rows = result.row_count();
    switch (result.info.location) {
    case Location::Nodal: return rows == mesh.node_count() ? "" : "not a row a node";
    case Location::Elemental: return rows == mesh.element_count() ? "" : "not a row an element";
    default: break;
    }
    if (result.row_owner.size() != rows || result.row_node.size() != rows)
        return "rows without owner or node";
    const std::size_t owners =
        result.info.location == Location::PartNodal ? mesh.parts.size() : mesh.element_count();
    for (std::size_t i = 0; i < rows; ++i) {
        if (result.row_owner[i] >= owners) return "a row's owner does not exist";
        if (raw(result.row_node[i]) >= mesh.node_count()) return "a row's node does not exist";
    }
    return {};
}

}  // namespace

std::string exercise(ModelSource& model) {
    if (std::string wrong = check_mesh(model.mesh()); !wrong.empty()) return wrong;
    for (std::size_t i = 0; i < model.results().size(); ++i) {
        try {
            const std::string wrong = check_result(model, model.load(i));
            if (!wrong.empty()) return fmt::format("{}: {}", model.results()[i].name, wrong);
        } catch (const Error& error) {
            if (std::string(error.what()).empty()) return "an error without words";
        }
    }
    return {};
}

}  // namespace feelem::test
