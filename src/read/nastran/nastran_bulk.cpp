// SPDX-License-Identifier: Apache-2.0
// Decks as a ModelSource: a mesh without results.
#include "read/nastran/nastran_bulk.hpp"

#include "base/number.hpp"
#include "read/merged_model.hpp"
#include "read/nastran/bulk_card.hpp"
#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/bulk_mesh.hpp"
#include "read/nastran/bulk_names.hpp"
#include "read/nastran/nastran_elements.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem {
namespace {

using namespace nastran;

/// Cards that pieces of a deck consist of, beside grids, elements and properties.
bool is_usual_card(std::string_view name) {
    constexpr std::array<std::string_view, 24> kUsual{
        "ASET1", "CORD1C", "CORD1R", "CORD1S", "CORD2C", "CORD2R", "CORD2S", "DESVAR",
        "EIGRL", "FORCE",  "GRAV",   "LOAD",   "MAT1",   "MAT2",   "MAT4",   "MAT8",
        "MAT9",  "MOMENT", "MPC",    "PLOAD4", "SPC",    "SPC1",   "SPCADD", "TEMP",
    };
    return std::ranges::binary_search(kUsual, name) || is_property_card(name) ||
           is_element_without_surface(name) || find_element_card(name) != nullptr;
}

/// How much a line looks like bulk data: its first word is a card and its first field a number.
bool has_card(std::string_view line, bool& is_mesh) {
    if (line[0] == ' ' || is_continuation(line)) return false;
    const CardHead head = card_head(line, 0);
    const std::string_view name = head.name();
    is_mesh = name == "GRID" || find_element_card(name) != nullptr;
    if (!is_mesh && !is_usual_card(name)) return false;
    BulkCard card;
    card.read(line, head);
    const auto id = card.integer(1);
    if (!id || *id <= 0) return false;
    // Cards of elements go on with two numbers more, GRID with a number or blank.
    if (name == "GRID") return card.is_blank(2) || card.integer(2).has_value();
    return !is_mesh || card.integer(3).has_value();
}

Likelihood recognise_bulk(const Input& input) {
    const std::string_view head = head_of(input);
    // Whole lines only.
    const bool whole = head.size() == input.size();
    BulkLines lines(whole ? head : head.substr(0, head.rfind('\n') + 1));
    Likelihood found = Likelihood::No;
    int strange = 0;
    bool after_control = false;
    while (lines.advance()) {
        const std::string_view line = lines.line();
        bool is_mesh = false;
        if (has_begin_bulk(line)) return Likelihood::Sure;
        if (line == "CEND" || line == "cend" || line.starts_with("CEND ")) after_control = true;
        if (has_card(line, is_mesh)) {
            if (is_mesh) return Likelihood::Sure;
            found = Likelihood::Maybe;
        } else if (include_at(line, 0)) {
            if (after_control) return Likelihood::Sure;
            // Prose may start with the word; a deck names its file in quotes.
            if (line.find_first_of("'\"") != std::string_view::npos) found = Likelihood::Maybe;
        } else if (found == Likelihood::No && !after_control && ++strange > 2000) {
            break;
        }
    }
    return found;
}

class BulkSource : public ModelSource {
public:
    BulkSource(BulkModel model) : model_(std::move(model)) {}

    const Mesh& mesh() const override { return model_.mesh; }
    std::span<const Step> steps() const override { return {}; }
    std::span<const ResultInfo> results() const override { return {}; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"Nastran", {}}; }
    std::string title() const override { return model_.title; }
    Result load(std::size_t) override { return {}; }

private:
    BulkModel model_;
};

/// The given decks that no other one includes.
std::vector<Input> roots_of(std::span<const Input> inputs, IncludeFiles* includes) {
    std::vector<std::string> included;
    for (const Input& input : inputs) {
        BulkLines lines(input.text());
        while (includes != nullptr && inputs.size() > 1 && lines.advance()) {
            const auto include = include_at(input.text(), lines.offset());
            if (!include) continue;
            if (const auto found = includes->find(include->name, input)) included.push_back(found->name());
        }
    }
    std::vector<Input> roots;
    for (const Input& input : inputs) {
        if (std::ranges::find(included, input.name()) == included.end()) roots.push_back(input);
    }
    if (roots.empty()) roots.push_back(inputs.front());
    return roots;
}

std::unique_ptr<ModelSource> open_bulk(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    std::vector<Input> decks, pieces;
    for (const Input& root : roots_of(inputs, context.includes))
        (has_begin_bulk(root.text()) ? decks : pieces).push_back(root);
    std::vector<Input> first = pieces;
    if (!decks.empty()) first.insert(first.begin(), decks.front());
    BulkModel model = read_bulk(std::move(first), context.includes, diagnostics);
    // Further whole decks are other runs of the same model, or the wrong files.
    for (std::size_t i = 1; i < decks.size(); ++i) {
        Diagnostics twice;
        std::vector<Input> other{decks[i]};
        other.insert(other.end(), pieces.begin(), pieces.end());
        check_same_mesh(
            model.mesh, read_bulk(std::move(other), context.includes, twice).mesh, decks[i].name()
        );
    }
    return std::make_unique<BulkSource>(std::move(model));
}

}  // namespace

ReadFormat nastran_bulk_format() {
    return {
        {"nastran-bulk", "Nastran bulk data", ".bdf .dat .nas .fem", true, false},
        true,
        recognise_bulk,
        open_bulk};
}

}  // namespace feelem
