// SPDX-License-Identifier: Apache-2.0
// Decks opened for tests, and short questions about the mesh.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace feelem::test {

struct OpenedDeck {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;

    const Mesh& mesh() const { return model->mesh(); }
};

OpenedDeck open_deck_file(const std::string& path);
/// From text; the file is called "deck.cdb".
OpenedDeck open_deck(const std::string& text, const std::string& types = "");
OpenedDeck open_decks(std::vector<NamedBytes> files);

/// "hex8" -> how many.
std::map<std::string, std::size_t> element_counts(const Mesh& mesh);
/// Node ids of an element; 0 for a left-out mid-side node. Empty when there is no such element.
std::vector<std::int64_t> nodes_of(const Mesh& mesh, std::int64_t element);
/// Name of the part of an element.
std::string part_of(const Mesh& mesh, std::int64_t element);
Point3 position_of(const Mesh& mesh, std::int64_t node);

/// Words and texts of all diagnostics, a line each.
std::string all_texts(const Diagnostics& diagnostics);

}  // namespace feelem::test
