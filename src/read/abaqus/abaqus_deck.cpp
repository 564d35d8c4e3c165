// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/abaqus_deck.hpp"

#include "read/abaqus/deck_keywords.hpp"
#include "read/abaqus/deck_mesh.hpp"
#include "read/abaqus/deck_model.hpp"
#include "read/adopt_sets.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace feelem {
namespace {

using namespace abaqus;

Likelihood recognise_deck(const Input& input) {
    return starts_like_deck(head_of(input)) ? Likelihood::Sure : Likelihood::No;
}

std::string name_of_file(std::string path) {
    std::ranges::replace(path, '\\', '/');
    return std::filesystem::path(path).filename().string();
}

/// Decks that no other deck includes.
std::vector<Input> roots_of(std::span<const Input> inputs) {
    std::set<std::string> included;
    for (const Input& input : inputs) {
        for (const std::string& name : included_names(input)) {
            if (name_of_file(name) != name_of_file(input.name())) included.insert(name_of_file(name));
        }
    }
    std::vector<Input> roots;
    for (const Input& input : inputs) {
        if (!included.contains(name_of_file(input.name()))) roots.push_back(input);
    }
    return roots.empty() ? std::vector<Input>(inputs.begin(), inputs.end()) : roots;
}

bool has_block(const Deck& deck, std::string_view name) {
    return std::ranges::find(deck.keywords, name, &Keyword::name) != deck.keywords.end();
}

class DeckSource : public ModelSource {
public:
    DeckSource(std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics)
        : diagnostics_(diagnostics) {
        std::vector<Input> with_mesh;
        const std::vector<Input> roots = roots_of(inputs);
        // Nodes in one file and elements in another are one deck.
        std::vector<Deck> decks;
        bool in_pieces = false;
        for (const Input& root : roots) {
            Deck deck = scan_decks({&root, 1}, context.includes, diagnostics);
            const bool nodes = has_block(deck, "NODE"), elements = has_block(deck, "ELEMENT");
            in_pieces = in_pieces || nodes != elements;
            if (nodes || elements) {
                decks.push_back(std::move(deck));
                with_mesh.push_back(root);
            } else if (roots.size() > 1) {
                diagnostics.add(
                    Code::UnknownBlock,
                    root.name(),
                    fmt::format("{} has neither nodes nor elements", name_of_file(root.name()))
                );
            }
        }
        if (in_pieces && decks.size() > 1) {
            Diagnostics once;  // Includes were reported above.
            Deck whole = scan_decks(with_mesh, context.includes, once);
            decks.clear();
            decks.push_back(std::move(whole));
        }
        if (decks.empty()) throw_no_nodes(inputs.front().name());
        for (Deck& deck : decks) take(deck, context);
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return {}; }
    std::span<const ResultInfo> results() const override { return {}; }
    Result load(std::size_t) override { throw Error(Code::UnknownName, "", "a deck holds no results"); }
    std::span<const InputRecord> inputs() const override { return {}; }
    std::string title() const override { return title_; }

private:
    /// Several decks are jobs on one mesh: the first gives it, the others must have the same.
    void take(Deck& deck, const ReadContext& context) {
        if (title_.empty()) title_ = deck.title;
        DeckModel model = read_deck(deck, diagnostics_);
        Mesh mesh = build_mesh(deck, model, diagnostics_);
        const std::string& name = deck.files.front().name();
        if (mesh.node_count() == 0) throw_no_nodes(name);
        if (mesh_ == nullptr) {
            own_ = std::move(mesh);
            mesh_ = own_or_shared(own_, context.mesh);
            return;
        }
        check_same_mesh(*mesh_, mesh, name);
        // Ours, or of a source as young as this one: nobody has seen it yet.
        adopt_sets(mesh, nullptr, name, const_cast<Mesh&>(*mesh_), diagnostics_);
    }

    [[noreturn]] static void throw_no_nodes(const std::string& name) {
        throw Error(
            Code::NoNodes,
            name,
            "the deck defines no nodes. Does it include a file that is missing, or is it a part of a deck?"
        );
    }

    Diagnostics& diagnostics_;
    Mesh own_;
    const Mesh* mesh_ = nullptr;
    std::string title_;
};

std::unique_ptr<ModelSource> open_deck(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<DeckSource>(inputs, context, diagnostics);
}

}  // namespace

ReadFormat abaqus_deck_format() {
    return {
        {"abaqus-inp", "Abaqus and CalculiX decks", ".inp", true, false}, true, recognise_deck, open_deck};
}

}  // namespace feelem
