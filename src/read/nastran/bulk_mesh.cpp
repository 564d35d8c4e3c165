// SPDX-License-Identifier: Apache-2.0
// Must: give every grid its place and every element card its shape, or say which card it could not.
// Assumes: nothing about the order of cards.
// Algorithm: one walk over the deck (read_cards) collects grids and systems and notes where element cards
// are; then systems are resolved, grids placed, and the element cards read where they stand.
// Data: 32 bytes a grid (they become the mesh's where no system turns them), 16 and its nodes an element card
// beside the mesh.
#include "read/nastran/bulk_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/nastran/bulk_card.hpp"
#include "read/nastran/bulk_cards.hpp"
#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/nastran_elements.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace feelem::nastran {
namespace {

/// Fewer elements are added one by one.
constexpr std::size_t kFewElements = 8;

class BulkMeshMaker {
public:
    BulkMeshMaker(BulkDeck& deck, BulkCards cards, Diagnostics& diagnostics)
        : deck_(deck), cards_(std::move(cards)), diagnostics_(diagnostics), builder_(diagnostics) {}

    BulkModel make() {
        const std::size_t grids = cards_.grids.size();
        place_grids();
        for (const auto& [card, count] : cards_.skipped) builder_.skip_element(card, count);
        read_elements();
        add_grid_sets();
        BulkModel model;
        model.title = deck_.title();
        model.cards = deck_.card_count();
        model.grids = grids;
        model.systems = cards_.systems.count();
        model.element_cards = std::move(cards_.element_cards);
        model.mesh = builder_.finish();
        add_element_sets(model.mesh);
        return model;
    }

private:
    /// Where CORD1x cards find their grids.
    CoordinateSystems::FindGrid grid_finder() {
        std::vector<std::uint32_t> by_id(cards_.grids.size());
        std::iota(by_id.begin(), by_id.end(), 0U);
        std::ranges::stable_sort(by_id, {}, [&](std::uint32_t i) { return cards_.grids.ids[i]; });
        return [this, by_id = std::move(by_id)](std::int64_t grid) -> std::optional<GridPlace> {
            const auto id_of = [&](std::uint32_t i) { return raw(cards_.grids.ids[i]); };
            const auto found = std::ranges::lower_bound(by_id, grid, {}, id_of);
            if (found == by_id.end() || id_of(*found) != grid) return std::nullopt;
            const BulkGrid at = grid_at(*found);
            return GridPlace{at.place_system, at.place};
        };
    }

    /// With what GRDSET gives where fields are blank.
    BulkGrid grid_at(std::size_t i) const {
        BulkGrid grid = cards_.grids.at(i);
        if (grid.place_system == kBlankField) grid.place_system = cards_.place_system;
        if (grid.value_system == kBlankField) grid.value_system = cards_.value_system;
        return grid;
    }

    void place_grids() {
        BulkGrids& grids = cards_.grids;
        if (cards_.systems.count() > 0) cards_.systems.resolve(grid_finder(), diagnostics_);
        builder_.reserve_nodes(cards_.scalar_points.empty() ? 0 : grids.size() + cards_.scalar_points.size());
        if (grids.systems.empty() && cards_.place_system == 0 && cards_.value_system <= 0) {
            // As they stand: the mesh's own, where nothing else asks for them.
            if (cards_.sets.empty()) {
                builder_.add_nodes(std::move(grids.ids), std::move(grids.places));
            } else {
                builder_.add_nodes(std::span<const NodeId>(grids.ids), grids.places);
            }
        } else {
            builder_.reserve_nodes(grids.size() + cards_.scalar_points.size());
            for (std::size_t i = 0; i < grids.size(); ++i) place_grid(grid_at(i));
        }
        add_scalar_points();
        builder_.seal_nodes();
    }

    void place_grid(const BulkGrid& grid) {
        if (!cards_.systems.known(grid.place_system)) report_system(grid, grid.place_system, "have no place");
        const Point3 place = cards_.systems.to_basic(grid.place_system, grid.place);
        // -1 marks grids of a fluid: a pressure has no direction.
        const bool turned = grid.value_system > 0;
        if (turned && !cards_.systems.known(grid.value_system))
            report_system(grid, grid.value_system, "have values along axes that are not known");
        builder_.add_node(
            NodeId{grid.id},
            place,
            turned ? cards_.systems.angles_at(grid.value_system, place) : NodalAngles{}
        );
    }

    void add_scalar_points() {
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        // SPOINT cards may overlap, also the ends of ranges.
        std::ranges::sort(cards_.scalar_points);
        const auto unused = std::unique(cards_.scalar_points.begin(), cards_.scalar_points.end());
        cards_.scalar_points.erase(unused, cards_.scalar_points.end());
        for (const std::int64_t point : cards_.scalar_points)
            builder_.add_node(NodeId{point}, {kNowhere, kNowhere, kNowhere});
    }

    void report_system(const BulkGrid& grid, std::int64_t system, std::string_view what) {
        diagnostics_.add(
            Code::CoordinateSystem,
            [&] { return fmt::format("grid {}", grid.id); },
            fmt::format(
                "grids that refer to coordinate system {}, which is missing or cannot be used, {}",
                system,
                what
            )
        );
    }

    void read_elements() {
        const BulkElements& all = cards_.elements;
        builder_.expect_elements(all.size());
        if (std::ranges::adjacent_find(all.ids, std::ranges::greater_equal{}) != all.ids.end()) {
            read_sorted();
            return;
        }
        for (std::size_t i = 0; i < all.runs.size(); ++i) add_run(all.runs[i], all.end_of(i));
    }

    /// Elements in order; of equal ids the first real element, never a PLOTEL beside one.
    void read_sorted() {
        const BulkElements& all = cards_.elements;
        const auto is_plot = [&](std::size_t i) { return all.run_of(i).card->name.starts_with("PLOTEL"); };
        const bool has_plots = std::ranges::any_of(all.runs, [](const BulkElements::Run& run) {
            return run.card->name.starts_with("PLOTEL");
        });
        std::vector<std::size_t> order(all.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            if (all.ids[a] != all.ids[b] || !has_plots) return all.ids[a] < all.ids[b];
            return !is_plot(a) && is_plot(b);
        });
        ElementId previous{0};
        for (const std::size_t i : order) {
            const BulkElements::Run& run = all.run_of(i);
            if (all.ids[i] != previous) {
                add_one(run, i);
            } else if (run.card->name.starts_with("PLOTEL")) {
                builder_.skip_element(run.card->name);
            } else {
                diagnostics_.add(
                    Code::DuplicateElement,
                    [&] { return where(run, i); },
                    "elements have the number of an earlier one and are left out"
                );
            }
            previous = all.ids[i];
        }
    }

    std::string where(const BulkElements::Run& run, std::size_t i) const {
        return deck_.where(run.file, cards_.elements.offsets[i]);
    }

    void add_run(const BulkElements::Run& run, std::size_t end) {
        const BulkElements& all = cards_.elements;
        const std::size_t count = end - run.first;
        // A blank property has its element's number.
        if (!run.whole || count < kFewElements || property_of(*run.card, 0, run.property) == 0) {
            for (std::size_t i = run.first; i < end; ++i) add_one(run, i);
            return;
        }
        builder_.add_elements(
            *run.whole,
            part_of(*run.card, 0, run.property),
            std::span(all.ids).subspan(run.first, count),
            std::span(all.nodes).subspan(run.first_node, count * run.width),
            [&](std::size_t row) { return where(run, run.first + row); }
        );
    }

    void add_one(const BulkElements::Run& run, std::size_t i) {
        const BulkElements& all = cards_.elements;
        const std::int64_t id = raw(all.ids[i]);
        const auto here = [&] { return where(run, i); };
        RowNodes nodes{};
        std::int64_t property = run.property;
        if (run.is_unread) {
            read_card(run, i, nodes, property);
        } else {
            std::ranges::copy(all.nodes_of(run, i), nodes.begin());
        }
        ElementNodes found;
        if (run.whole) {
            found.type = *run.whole;
            found.count = run.width;
            for (std::size_t k = 0; k < run.width; ++k) found.nodes[k] = NodeId{nodes[k]};
        } else if (const auto arranged = arrange_nodes(*run.card, std::span(nodes).first(run.card->node_count()))) {
            found = *arranged;
        } else {
            throw Error(
                Code::BadStructure, here(), fmt::format("{} {} has a blank corner", run.card->name, id)
            );
        }
        builder_.add_element(
            ElementId{id},
            found.type,
            std::span(found.nodes).first(found.count),
            part_of(*run.card, id, property),
            here
        );
    }

    using RowNodes = std::array<std::int64_t, kMaxElementNodes>;

    void read_card(const BulkElements::Run& run, std::size_t i, RowNodes& nodes, std::int64_t& property) {
        const ElementCard& card = *run.card;
        CardHead head;
        head.offset = cards_.elements.offsets[i];
        head.large = run.large;
        card_.read(deck_.input(run.file).text(), head);
        const std::size_t first = card.first_node + std::size_t{run.shift};
        for (std::size_t k = 0; k < card.node_count(); ++k) {
            const std::string_view field = card_.field(first + k);
            const auto node = field.empty() ? std::optional<std::int64_t>(0) : parse_node(field);
            if (!node) {
                throw Error(
                    Code::BadNumber,
                    where(run, i),
                    fmt::format(
                        "{} {}: \"{}\" is no grid number", card.name, raw(cards_.elements.ids[i]), field
                    )
                );
            }
            nodes[k] = *node;
        }
        if (card.property != 0 && !card_.is_blank(card.property))
            property = card_.integer(card.property).value_or(raw(cards_.elements.ids[i]));
    }

    static std::optional<std::int64_t> parse_node(std::string_view field);

    /// Blank: what BAROR or BEAMOR gives, else the property has the element's number.
    std::int64_t property_of(const ElementCard& card, std::int64_t element, std::int64_t property) const {
        if (property == kBlankField && card.name == "CBAR") property = cards_.bar_property;
        if (property == kBlankField && card.name == "CBEAM") property = cards_.beam_property;
        return property != kBlankField ? property : element;
    }

    PartIndex part_of(const ElementCard& card, std::int64_t element, std::int64_t property) {
        if (card.property == 0) return builder_.part(card.name);
        const std::int64_t id = property_of(card, element, property);
        const bool by_material = card.name == "CTRIAX6";
        if (id != last_property_ || by_material != last_by_material_) {
            last_part_ =
                builder_.part(by_material ? fmt::format("material {}", id) : cards_.names.part_name(id));
            last_property_ = id;
            last_by_material_ = by_material;
        }
        return last_part_;
    }

    /// The ids within the ranges of a set, out of all ids in ascending order; at most `room`.
    template <class Id>
    std::vector<Id> ids_of(const BulkSet& set, const std::vector<Id>& sorted) {
        std::vector<Id> ids;
        for (const auto& [first, last] : set.ranges) {
            auto at = std::ranges::lower_bound(sorted, Id{first});
            for (; at != sorted.end() && raw(*at) <= last; ++at) {
                if (room_for_sets_ == 0) {
                    diagnostics_.add(
                        Code::UnknownBlock,
                        std::string(),
                        "sets with more members than the deck could hold are cut"
                    );
                    return ids;
                }
                --room_for_sets_;
                ids.push_back(*at);
            }
        }
        return ids;
    }

    void add_grid_sets() {
        room_for_sets_ = 1'000'000 + 16 * (cards_.grids.size() + cards_.elements.size());
        std::vector<NodeId> sorted;
        for (const BulkSet& set : cards_.sets) {
            if (!set.of_grids) continue;
            if (sorted.empty()) {
                sorted = cards_.grids.ids;
                std::ranges::sort(sorted);
            }
            const std::vector<NodeId> ids = ids_of(set, sorted);
            if (!ids.empty()) builder_.add_node_set(cards_.names.set_name(set.id), ids);
        }
    }

    void add_element_sets(Mesh& mesh) {
        const auto is_of_elements = [](const BulkSet& set) { return !set.of_grids; };
        if (std::ranges::none_of(cards_.sets, is_of_elements)) return;
        const ElementLookup lookup(mesh);
        std::vector<ElementId> sorted = cards_.elements.ids;
        std::ranges::sort(sorted);
        for (const BulkSet& set : cards_.sets) {
            if (!is_of_elements(set)) continue;
            const std::vector<ElementId> ids = ids_of(set, sorted);
            add_element_set(mesh, lookup, cards_.names.set_name(set.id), ids);
        }
    }

    BulkDeck& deck_;
    BulkCards cards_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    BulkCard card_;
    std::int64_t last_property_ = kBlankField;
    bool last_by_material_ = false;
    PartIndex last_part_{};
    std::size_t room_for_sets_ = 0;
};

std::optional<std::int64_t> BulkMeshMaker::parse_node(std::string_view field) {
    std::int64_t value = 0;
    for (const char c : field) {
        if (c < '0' || c > '9' || value > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
        value = 10 * value + (c - '0');
    }
    return value;
}

}  // namespace

BulkModel read_bulk(std::vector<Input> decks, IncludeFiles* includes, Diagnostics& diagnostics) {
    const std::string name = decks.front().name();
    BulkDeck deck(std::move(decks), includes, diagnostics);
    BulkCards cards = read_cards(deck, diagnostics);
    if (cards.grids.size() == 0 && cards.scalar_points.empty()) {
        throw Error(
            Code::NoNodes,
            name,
            cards.elements.size() == 0
                ? "the deck holds neither GRID nor element cards: it is no model"
                : "the deck holds elements but no GRID: give the deck that includes it, or the file with the "
                  "grids too"
        );
    }
    return BulkMeshMaker(deck, std::move(cards), diagnostics).make();
}

}  // namespace feelem::nastran
