// SPDX-License-Identifier: Apache-2.0
// Must: give every grid its place and every element card its shape, or say which card it could not.
// Assumes: nothing about the order of cards.
// Algorithm: one walk over the deck reads grids, systems and properties and notes where element cards are;
// then systems are resolved, grids placed, and the element cards read where they stand.
// Data: 56 bytes a grid and 24 an element card beside the mesh.
#include "read/nastran/bulk_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/nastran/bulk_card.hpp"
#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/bulk_names.hpp"
#include "read/nastran/coordinate_systems.hpp"
#include "read/nastran/nastran_elements.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace feelem::nastran {
namespace {

constexpr std::int64_t kBlank = std::numeric_limits<std::int64_t>::min();
constexpr std::uint64_t kMostScalarPoints = 1'000'000;
constexpr std::uint8_t kSecondPlotel = 4;  ///< A PLOTEL card holds two elements.

struct Grid {
    std::int64_t id = 0;
    std::int64_t place_system = 0;  ///< CP
    std::int64_t value_system = 0;  ///< CD
    Point3 place{};
};

struct ElementPlace {
    std::int64_t id = 0;
    std::uint64_t offset = 0;
    std::uint32_t file = 0;
    std::uint16_t card = 0;  ///< Into element_cards().
    bool large = false;
    std::uint8_t shift = 0;  ///< Of its fields.
};

/// Cards that start with C and are no elements.
bool is_other_card(std::string_view name) {
    constexpr std::array<std::string_view, 21> kOthers{
        "CBARAO",  "CLOAD",   "CNTSTB", "COMBIN", "CONCRL", "CONTACT", "CONTPRM",
        "CONTRLT", "CONV",    "CONVM",  "CREEP",  "CSET",   "CSET1",   "CSSCHD",
        "CSUPER",  "CSUPEXT", "CYAX",   "CYJOIN", "CYSUP",  "CYSYM",   "CAUTOSE",
    };
    return !name.starts_with('C') || name.starts_with("CORD") ||
           std::ranges::find(kOthers, name) != kOthers.end();
}

class DeckReader {
public:
    DeckReader(std::vector<Input> decks, IncludeFiles* includes, Diagnostics& diagnostics)
        : first_name_(decks.front().name()), deck_(std::move(decks), includes, diagnostics),
          diagnostics_(diagnostics), builder_(diagnostics) {}

    BulkModel read() {
        CardHead head;
        while (deck_.next(head)) {
            for (const std::string_view comment : deck_.take_names()) names_.add_comment(comment);
            read_card(head);
        }
        if (grids_.empty() && scalar_points_.empty()) throw_no_nodes();
        place_grids();
        read_elements();
        model_.title = deck_.title();
        model_.cards = deck_.card_count();
        model_.grids = grids_.size();
        model_.systems = systems_.count();
        model_.mesh = builder_.finish();
        return std::move(model_);
    }

private:
    [[noreturn]] void throw_no_nodes() const {
        throw Error(
            Code::NoNodes,
            first_name_,
            elements_.empty() ? "the deck holds neither GRID nor element cards: it is no model"
                              : "the deck holds elements but no GRID: give the deck that includes it, or the "
                                "file with the grids too"
        );
    }

    std::string here() const { return deck_.where(deck_.file(), card_offset_); }

    [[noreturn]] void bad_field(std::string_view card, std::size_t field, std::string_view expected) const {
        throw Error(
            Code::BadNumber,
            here(),
            fmt::format(
                "{}: \"{}\" stands in field {} where {} must be",
                card,
                card_.field(field),
                field + 1,
                expected
            )
        );
    }

    /// Blank fields give `blank`.
    std::int64_t integer(std::string_view card, std::size_t field, std::int64_t blank) const {
        if (card_.is_blank(field)) return blank;
        const auto value = card_.integer(field);
        if (!value) bad_field(card, field, "a whole number");
        return *value;
    }
    std::int64_t id(std::string_view card, std::size_t field) const {
        const std::int64_t value = integer(card, field, 0);
        if (value <= 0) bad_field(card, field, "a positive number");
        return value;
    }
    double real(std::string_view card, std::size_t field) const {
        if (card_.is_blank(field)) return 0;
        const auto value = card_.real(field);
        if (!value || !std::isfinite(*value)) bad_field(card, field, "a number");
        return *value;
    }

    void read_card(const CardHead& head) {
        const std::string_view name = head.name();
        card_offset_ = head.offset;
        if (name == "GRID") {
            fetch(head);
            read_grid();
        } else if (const ElementCard* card = element_card(name)) {
            fetch(head);
            note_element(head, *card);
        } else if (is_element_without_surface(name)) {
            ++model_.element_cards[std::string(name)];
            builder_.skip_element(name);
        } else if (name.starts_with("CORD")) {
            fetch(head);
            read_system(name);
        } else if (is_property_card(name)) {
            fetch(head);
            if (const auto property = card_.integer(1)) names_.add_card(name, *property);
        } else {
            read_other(head);
        }
    }

    void fetch(const CardHead& head) { card_.read(deck_.input(deck_.file()).text(), head); }

    /// Decks list the same card many times in a row.
    const ElementCard* element_card(std::string_view name) {
        if (last_card_ == nullptr || last_card_->name != name) last_card_ = find_element_card(name);
        return last_card_;
    }

    void read_other(const CardHead& head) {
        const std::string_view name = head.name();
        if (name == "GRDSET") {
            fetch(head);
            default_place_system_ = integer(name, 2, 0);
            default_value_system_ = integer(name, 6, 0);
        } else if (name == "SPOINT" || name == "EPOINT") {
            fetch(head);
            read_scalar_points(name);
        } else if (name == "BAROR" || name == "BEAMOR") {
            fetch(head);
            (name == "BAROR" ? default_bar_ : default_beam_) = integer(name, 2, kBlank);
        } else if (name.starts_with('=')) {
            throw Error(
                Code::BadStructure,
                here(),
                "the deck repeats cards (\"=\"), which Feelem does not read. Run it with ECHO=PUNCH: the "
                ".pch "
                "file holds the cards in full."
            );
        } else if (!is_other_card(name)) {
            diagnostics_.add(
                Code::UnknownElementType,
                [&] { return here(); },
                fmt::format("{} cards are not known; if they are elements, these are left out", name)
            );
        }
    }

    void read_grid() {
        Grid& grid = grids_.emplace_back();
        grid.id = id("GRID", 1);
        grid.place_system = integer("GRID", 2, kBlank);
        for (std::size_t i = 0; i < 3; ++i) grid.place[i] = real("GRID", 3 + i);
        grid.value_system = integer("GRID", 6, kBlank);
    }

    void read_scalar_points(std::string_view name) {
        if (card_.size() >= 4 && (card_.field(2) == "THRU" || card_.field(2) == "thru")) {
            const std::int64_t first = id(name, 1), last = id(name, 3);
            const auto count = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
            if (last < first || count >= kMostScalarPoints - scalar_points_.size()) {
                throw Error(
                    Code::TooLarge,
                    here(),
                    fmt::format("{} {} THRU {}: more than a million scalar points", name, first, last)
                );
            }
            for (std::int64_t point = first; point <= last; ++point) scalar_points_.push_back(point);
            return;
        }
        for (std::size_t i = 1; i < card_.size(); ++i) {
            if (!card_.is_blank(i)) scalar_points_.push_back(id(name, i));
        }
    }

    void read_system(std::string_view name) {
        const auto kind = [](char letter) -> std::optional<SystemKind> {
            if (letter == 'R') return SystemKind::Rectangular;
            if (letter == 'C') return SystemKind::Cylindrical;
            if (letter == 'S') return SystemKind::Spherical;
            return std::nullopt;
        };
        const auto found = name.size() == 6 ? kind(name[5]) : std::nullopt;
        if (!found || (name[4] != '1' && name[4] != '2')) {
            diagnostics_.add(
                Code::CoordinateSystem,
                [&] { return here(); },
                fmt::format("{} systems are not known; grids in them have no place", name)
            );
            return;
        }
        const auto where = [this, file = deck_.file(), at = card_offset_] { return deck_.where(file, at); };
        if (name[4] == '2') {
            SystemCard card{id(name, 1), *found, integer(name, 2, 0), {}, {}, false, where};
            for (std::size_t i = 0; i < 9; ++i) card.points[i / 3][i % 3] = real(name, 3 + i);
            systems_.add(std::move(card));
            return;
        }
        for (std::size_t i = 1; i <= 5 && !card_.is_blank(i); i += 4) {
            systems_.add(
                {id(name, i), *found, 0, {}, {id(name, i + 1), id(name, i + 2), id(name, i + 3)}, true, where}
            );
        }
    }

    void note_element(const CardHead& head, const ElementCard& card) {
        ElementPlace place;
        place.id = id(card.name, 1);
        place.offset = head.offset;
        place.file = deck_.file();
        place.card = static_cast<std::uint16_t>(&card - element_cards().data());
        place.large = head.large;
        elements_.push_back(place);
        ++model_.element_cards[std::string(card.name)];
        if (card.name != "PLOTEL" || card_.is_blank(1 + kSecondPlotel)) return;
        place.id = id(card.name, 1 + kSecondPlotel);
        place.shift = kSecondPlotel;
        elements_.push_back(place);
        ++model_.element_cards[std::string(card.name)];
    }

    /// Where CORD1x cards find their grids.
    CoordinateSystems::FindGrid grid_finder() {
        std::vector<std::uint32_t> by_id(grids_.size());
        std::iota(by_id.begin(), by_id.end(), 0U);
        std::ranges::stable_sort(by_id, {}, [&](std::uint32_t i) { return grids_[i].id; });
        return [this, by_id = std::move(by_id)](std::int64_t grid) -> std::optional<GridPlace> {
            const auto id_of = [&](std::uint32_t i) { return grids_[i].id; };
            const auto found = std::ranges::lower_bound(by_id, grid, {}, id_of);
            if (found == by_id.end() || id_of(*found) != grid) return std::nullopt;
            return GridPlace{grids_[*found].place_system, grids_[*found].place};
        };
    }

    void place_grids() {
        for (Grid& grid : grids_) {
            if (grid.place_system == kBlank) grid.place_system = default_place_system_;
            if (grid.value_system == kBlank) grid.value_system = default_value_system_;
        }
        if (systems_.count() > 0) systems_.resolve(grid_finder(), diagnostics_);
        builder_.reserve_nodes(grids_.size() + scalar_points_.size());
        for (const Grid& grid : grids_) {
            if (!systems_.known(grid.place_system)) report_system(grid, grid.place_system, "have no place");
            const Point3 place = systems_.to_basic(grid.place_system, grid.place);
            // -1 marks grids of a fluid: a pressure has no direction.
            const bool turned = grid.value_system > 0;
            if (turned && !systems_.known(grid.value_system))
                report_system(grid, grid.value_system, "have values along axes that are not known");
            builder_.add_node(
                NodeId{grid.id}, place, turned ? systems_.angles_at(grid.value_system, place) : NodalAngles{}
            );
        }
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        for (const std::int64_t point : scalar_points_)
            builder_.add_node(NodeId{point}, {kNowhere, kNowhere, kNowhere});
        builder_.seal_nodes();
    }

    void report_system(const Grid& grid, std::int64_t system, std::string_view what) {
        diagnostics_.add(
            Code::CoordinateSystem,
            [&] { return fmt::format("grid {}", grid.id); },
            fmt::format(
                "grids that refer to coordinate system {}, which the deck does not define, {}", system, what
            )
        );
    }

    /// Elements in order; of equal ids the first real element, never a PLOTEL beside one.
    void read_elements() {
        const auto is_plot = [](const ElementPlace& place) {
            return element_cards()[place.card].name.starts_with("PLOTEL");
        };
        const auto before = [&](const ElementPlace& a, const ElementPlace& b) {
            return std::pair(a.id, is_plot(a)) < std::pair(b.id, is_plot(b));
        };
        if (!std::ranges::is_sorted(elements_, before)) std::ranges::stable_sort(elements_, before);
        std::int64_t previous = 0;
        for (const ElementPlace& place : elements_) {
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

    void read_element(const ElementPlace& place, const ElementCard& card) {
        CardHead head;
        head.offset = place.offset;
        head.large = place.large;
        card_.read(deck_.input(place.file).text(), head);
        const auto where = [&] { return deck_.where(place.file, place.offset); };
        std::array<std::int64_t, kMaxElementNodes> nodes{};
        const std::size_t first = card.first_node + std::size_t{place.shift};
        for (std::size_t i = 0; i < card.node_count(); ++i) {
            const std::string_view field = card_.field(first + i);
            const auto node = field.empty() ? std::optional<std::int64_t>(0) : parse_node(field);
            if (!node) {
                throw Error(
                    Code::BadNumber,
                    where(),
                    fmt::format("{} {}: \"{}\" is no grid number", card.name, place.id, field)
                );
            }
            nodes[i] = *node;
        }
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
            part_of(card, place.id),
            where
        );
    }

    static std::optional<std::int64_t> parse_node(std::string_view field);

    PartIndex part_of(const ElementCard& card, std::int64_t element) {
        if (card.property == 0) return builder_.part(card.name);
        auto property = card_.is_blank(card.property) ? std::optional(kBlank) : card_.integer(card.property);
        if (property == kBlank && card.name == "CBAR") property = default_bar_;
        if (property == kBlank && card.name == "CBEAM") property = default_beam_;
        // Blank: the property has the element's number.
        const std::int64_t id = property && *property != kBlank ? *property : element;
        const bool by_material = card.name == "CTRIAX6";
        if (id != last_property_ || by_material != last_by_material_) {
            last_part_ = builder_.part(by_material ? fmt::format("material {}", id) : names_.part_name(id));
            last_property_ = id;
            last_by_material_ = by_material;
        }
        return last_part_;
    }

    std::string first_name_;
    BulkDeck deck_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    BulkCard card_;
    std::uint64_t card_offset_ = 0;
    const ElementCard* last_card_ = nullptr;
    std::vector<Grid> grids_;
    std::vector<std::int64_t> scalar_points_;
    std::vector<ElementPlace> elements_;
    CoordinateSystems systems_;
    PropertyNames names_;
    std::int64_t default_place_system_ = 0, default_value_system_ = 0;
    std::int64_t default_bar_ = kBlank, default_beam_ = kBlank;
    std::int64_t last_property_ = kBlank;
    bool last_by_material_ = false;
    PartIndex last_part_{};
    BulkModel model_;
};

std::optional<std::int64_t> DeckReader::parse_node(std::string_view field) {
    std::int64_t value = 0;
    for (const char c : field) {
        if (c < '0' || c > '9' || value > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
        value = 10 * value + (c - '0');
    }
    return value;
}

}  // namespace

BulkModel read_bulk(std::vector<Input> decks, IncludeFiles* includes, Diagnostics& diagnostics) {
    return DeckReader(std::move(decks), includes, diagnostics).read();
}

}  // namespace feelem::nastran
