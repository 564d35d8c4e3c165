// SPDX-License-Identifier: Apache-2.0
// Must: give every grid its place and every element card its shape, or say which card it could not.
// Assumes: nothing about the order of cards.
// Algorithm: one walk over the deck (read_cards) collects grids and systems and notes where element cards
// are; then systems are resolved, grids placed, and the element cards read where they stand.
// Data: 48 bytes a grid and 24 an element card beside the mesh.
#include "read/nastran/bulk_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/nastran/bulk_card.hpp"
#include "read/nastran/bulk_cards.hpp"
#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/nastran_elements.hpp"
#include "read/nastran/plain_cards.hpp"

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

class BulkMeshMaker {
public:
    BulkMeshMaker(BulkDeck& deck, BulkCards cards, Diagnostics& diagnostics)
        : deck_(deck), cards_(std::move(cards)), diagnostics_(diagnostics), builder_(diagnostics) {}

    BulkModel make() {
        place_grids();
        for (const auto& [card, count] : cards_.skipped) builder_.skip_element(card, count);
        read_elements();
        add_grid_sets();
        BulkModel model;
        model.title = deck_.title();
        model.cards = deck_.card_count();
        model.grids = cards_.grids.size();
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
        std::ranges::stable_sort(by_id, {}, [&](std::uint32_t i) { return cards_.grids[i].id; });
        return [this, by_id = std::move(by_id)](std::int64_t grid) -> std::optional<GridPlace> {
            const auto id_of = [&](std::uint32_t i) { return cards_.grids[i].id; };
            const auto found = std::ranges::lower_bound(by_id, grid, {}, id_of);
            if (found == by_id.end() || id_of(*found) != grid) return std::nullopt;
            return GridPlace{cards_.grids[*found].place_system, cards_.grids[*found].place};
        };
    }

    void place_grids() {
        for (BulkGrid& grid : cards_.grids) {
            if (grid.place_system == kBlankField) grid.place_system = cards_.place_system;
            if (grid.value_system == kBlankField) grid.value_system = cards_.value_system;
        }
        if (cards_.systems.count() > 0) cards_.systems.resolve(grid_finder(), diagnostics_);
        builder_.reserve_nodes(cards_.grids.size() + cards_.scalar_points.size());
        for (const BulkGrid& grid : cards_.grids) {
            if (!cards_.systems.known(grid.place_system))
                report_system(grid, grid.place_system, "have no place");
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
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        // SPOINT cards may overlap, also the ends of ranges.
        std::ranges::sort(cards_.scalar_points);
        const auto unused = std::unique(cards_.scalar_points.begin(), cards_.scalar_points.end());
        cards_.scalar_points.erase(unused, cards_.scalar_points.end());
        for (const std::int64_t point : cards_.scalar_points)
            builder_.add_node(NodeId{point}, {kNowhere, kNowhere, kNowhere});
        builder_.seal_nodes();
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

    /// Elements in order; of equal ids the first real element, never a PLOTEL beside one.
    void read_elements() {
        const auto is_plot = [](const BulkElement& place) {
            return element_cards()[place.card].name.starts_with("PLOTEL");
        };
        const auto before = [&](const BulkElement& a, const BulkElement& b) {
            return std::pair(a.id, is_plot(a)) < std::pair(b.id, is_plot(b));
        };
        if (!std::ranges::is_sorted(cards_.elements, before))
            std::ranges::stable_sort(cards_.elements, before);
        builder_.expect_elements(cards_.elements.size());
        std::int64_t previous = 0;
        for (const BulkElement& place : cards_.elements) {
            const ElementCard& card = element_cards()[place.card];
            if (place.id != previous) {
                read_element(place, card);
            } else if (card.name.starts_with("PLOTEL")) {
                builder_.skip_element(card.name);
            } else {
                diagnostics_.add(
                    Code::DuplicateElement,
                    [&] { return deck_.where(place.file, place.offset); },
                    "elements have the number of an earlier one and are left out"
                );
            }
            previous = place.id;
        }
    }

    void read_element(const BulkElement& place, const ElementCard& card) {
        const auto where = [&] { return deck_.where(place.file, place.offset); };
        RowNodes nodes{};
        std::int64_t property = kBlankField;
        if (!read_plain(place, card, nodes, property)) read_card(place, card, nodes, property);
        if (add_corners(place, card, nodes, property, where)) return;
        const auto arranged = arrange_nodes(card, std::span(nodes).first(card.node_count()));
        if (!arranged) {
            throw Error(
                Code::BadStructure, where(), fmt::format("{} {} has a blank corner", card.name, place.id)
            );
        }
        builder_.add_element(
            ElementId{place.id},
            arranged->type,
            std::span(arranged->nodes).first(arranged->count),
            part_of(card, place.id, property),
            where
        );
    }

    using RowNodes = std::array<std::int64_t, kMaxElementNodes>;

    /// A card with its corners alone: nearly every one of a linear mesh. False: it has more, or less.
    bool add_corners(
        const BulkElement& place,
        const ElementCard& card,
        const RowNodes& nodes,
        std::int64_t property,
        const MeshBuilder::Where& where
    ) {
        const ElementRow& row = element_row(card.type);
        std::array<NodeId, 8> corners{};
        unsigned odd = 0;
        for (std::size_t i = 0; i < row.corner_count; ++i) {
            corners[i] = NodeId{nodes[card.order[i]]};
            odd += corners[i] == NodeId{0};
        }
        for (std::size_t i = row.corner_count; i < row.node_count; ++i) odd += nodes[card.order[i]] != 0;
        if (odd != 0) return false;
        builder_.add_element(
            ElementId{place.id},
            row.order == 2 ? row.linear : card.type,
            std::span(corners).first(row.corner_count),
            part_of(card, place.id, property),
            where
        );
        return true;
    }

    bool read_plain(
        const BulkElement& place, const ElementCard& card, RowNodes& nodes, std::int64_t& property
    ) {
        const std::size_t first = card.first_node - std::size_t{1};
        PlainFields fields;
        const std::string_view text = deck_.input(place.file).text();
        const bool is_plain =
            place.shift == 0 &&
            free_cards_.read(text, place.offset, card.name.size(), first + card.node_count(), fields);
        if (!is_plain) return false;
        const std::size_t count = card.node_count();
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t node = fields.values[first + i];
            if (node > std::numeric_limits<std::int32_t>::max()) return false;
            nodes[i] = node == kBlankField ? 0 : node;
        }
        property = card.property == 0 ? kBlankField : fields.values[card.property - std::size_t{1}];
        return true;
    }

    void read_card(
        const BulkElement& place, const ElementCard& card, RowNodes& nodes, std::int64_t& property
    ) {
        CardHead head;
        head.offset = place.offset;
        head.large = place.large;
        card_.read(deck_.input(place.file).text(), head);
        const std::size_t first = card.first_node + std::size_t{place.shift};
        for (std::size_t i = 0; i < card.node_count(); ++i) {
            const std::string_view field = card_.field(first + i);
            const auto node = field.empty() ? std::optional<std::int64_t>(0) : parse_node(field);
            if (!node) {
                throw Error(
                    Code::BadNumber,
                    deck_.where(place.file, place.offset),
                    fmt::format("{} {}: \"{}\" is no grid number", card.name, place.id, field)
                );
            }
            nodes[i] = *node;
        }
        if (card.property != 0 && !card_.is_blank(card.property))
            property = card_.integer(card.property).value_or(place.id);
    }

    static std::optional<std::int64_t> parse_node(std::string_view field);

    PartIndex part_of(const ElementCard& card, std::int64_t element, std::int64_t property) {
        if (card.property == 0) return builder_.part(card.name);
        if (property == kBlankField && card.name == "CBAR") property = cards_.bar_property;
        if (property == kBlankField && card.name == "CBEAM") property = cards_.beam_property;
        // Blank: the property has the element's number.
        const std::int64_t id = property != kBlankField ? property : element;
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
                for (const BulkGrid& grid : cards_.grids) sorted.push_back(NodeId{grid.id});
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
        std::vector<ElementId> sorted;
        for (const BulkElement& element : cards_.elements) sorted.push_back(ElementId{element.id});
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
    FreeCards free_cards_;
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
    if (cards.grids.empty() && cards.scalar_points.empty()) {
        throw Error(
            Code::NoNodes,
            name,
            cards.elements.empty()
                ? "the deck holds neither GRID nor element cards: it is no model"
                : "the deck holds elements but no GRID: give the deck that includes it, or the file with the "
                  "grids too"
        );
    }
    return BulkMeshMaker(deck, std::move(cards), diagnostics).make();
}

}  // namespace feelem::nastran
