// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/bulk_cards.hpp"

#include "read/nastran/bulk_card.hpp"
#include "read/nastran/nastran_elements.hpp"
#include "read/nastran/plain_chunk.hpp"
#include "read/text_chunks.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::nastran {
namespace {

constexpr std::uint64_t kMostScalarPoints = 1'000'000;
constexpr std::uint8_t kSecondPlotel = 4;

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

class CardCollector {
public:
    CardCollector(BulkDeck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

    BulkCards collect() {
        CardHead head;
        while (take_plain_cards(), deck_.next(head)) read_any(head);
        for (std::size_t i = 0; i < out_.elements.runs.size(); ++i) {
            const BulkElements::Run& run = out_.elements.runs[i];
            out_.element_cards[std::string(run.card->name)] += out_.elements.end_of(i) - run.first;
        }
        return std::move(out_);
    }

private:
    /// Cards that need no care, as long as they follow each other: those of a mesh, nearly always.
    void take_plain_cards() {
        const auto ahead = deck_.ahead();
        if (!ahead) return;
        // Threads for those alone of which there are many.
        const std::size_t size = ahead->text.size();
        const std::size_t some = ahead->offset + std::min(kTextChunk, size - ahead->offset);
        std::size_t at = take_plain_cards(ahead->text, ahead->offset, some);
        if (at >= some && is_worth_chunks(size - at)) {
            read_in_text_chunks<PlainCards>(at, size, ChunkRows{this, ahead->text, deck_.file()});
        } else if (at >= some) {
            take_plain_cards(ahead->text, at, size);
        }
    }

    /// Those that begin in [from, stop); where the deck goes on.
    std::size_t take_plain_cards(std::string_view text, std::size_t from, std::size_t stop) {
        const PlainCards::Read read =
            PlainCards::read(text, deck_.file(), from, stop, out_.grids, out_.elements);
        deck_.go_on_at(read.end, read.cards);
        return read.end;
    }

    /// How read_in_text_chunks() reads cards.
    struct ChunkRows {
        CardCollector* self;
        std::string_view text;
        std::uint32_t file;

        std::size_t start(std::size_t at) const { return PlainCards::start_of_card(text, at); }
        std::size_t read(PlainCards& chunk, std::size_t from, std::size_t stop) const {
            return chunk.read(text, file, from, stop);
        }
        void take(const PlainCards& chunk) const {
            self->out_.grids.add(chunk.grids);
            self->out_.elements.add(chunk.elements);
            self->deck_.go_on_at(chunk.end, chunk.cards);
        }
        std::optional<std::size_t> go_on(std::size_t, std::size_t stop) const {
            return self->go_on(text, stop);
        }
    };

    /// Cards of any kind up to `stop`; empty when the deck goes on elsewhere or ends.
    std::optional<std::size_t> go_on(std::string_view text, std::size_t stop) {
        for (CardHead head; deck_.next(head);) {
            read_any(head);
            const auto ahead = deck_.ahead();
            if (!ahead || ahead->text.data() != text.data()) return {};
            const std::size_t at = take_plain_cards(text, ahead->offset, stop);
            if (at >= stop) return at;
        }
        return {};
    }

    void read_any(const CardHead& head) {
        for (const std::string_view comment : deck_.take_names()) out_.names.add_comment(comment);
        read_card(head);
    }

    void add_element(const ElementCard& card, std::int64_t id, const CardHead& head, std::uint8_t shift) {
        out_.elements.add(UnreadElement{&card, id, head.large, shift}, deck_.file(), head.offset);
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
            ++out_.element_cards[std::string(name)];
            ++out_.skipped[std::string(name)];
        } else if (name.starts_with("CORD")) {
            fetch(head);
            read_system(name);
        } else if (is_property_card(name)) {
            fetch(head);
            if (const auto property = card_.integer(1)) out_.names.add_card(name, *property);
        } else {
            read_other(head);
        }
    }

    void fetch(const CardHead& head) {
        card_.read(deck_.input(deck_.file()).text(), head);
        if (!card_.marks_differ()) return;
        diagnostics_.add(
            Code::BadStructure,
            [&] { return here(); },
            "cards go on with lines that bear another mark; lines are taken in their order in the file. If "
            "the "
            "deck is not in order, run it with ECHO=PUNCH: the .pch file is"
        );
    }

    /// Decks list the same card many times in a row.
    const ElementCard* element_card(std::string_view name) {
        if (last_card_ == nullptr || last_card_->name != name) last_card_ = find_element_card(name);
        return last_card_;
    }

    void read_other(const CardHead& head) {
        const std::string_view name = head.name();
        if (name == "GRDSET") {
            fetch(head);
            out_.place_system = integer(name, 2, 0);
            out_.value_system = integer(name, 6, 0);
        } else if (name == "SPOINT" || name == "EPOINT") {
            fetch(head);
            read_scalar_points(name);
        } else if (name == "BAROR" || name == "BEAMOR") {
            fetch(head);
            (name == "BAROR" ? out_.bar_property : out_.beam_property) = integer(name, 2, kBlankField);
        } else if (name == "SET3" || name == "SET") {
            fetch(head);
            read_set(name);
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
        BulkGrid grid;
        grid.id = id("GRID", 1);
        grid.place_system = integer("GRID", 2, kBlankField);
        for (std::size_t i = 0; i < 3; ++i) grid.place[i] = real("GRID", 3 + i);
        grid.value_system = integer("GRID", 6, kBlankField);
        out_.grids.add(grid);
    }

    void read_scalar_points(std::string_view name) {
        if (card_.size() >= 4 && (card_.field(2) == "THRU" || card_.field(2) == "thru")) {
            const std::int64_t first = id(name, 1), last = id(name, 3);
            const auto count = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
            if (last < first || count >= kMostScalarPoints - out_.scalar_points.size()) {
                throw Error(
                    Code::TooLarge,
                    here(),
                    fmt::format("{} {} THRU {}: more than a million scalar points", name, first, last)
                );
            }
            for (std::int64_t point = first; point <= last; ++point) out_.scalar_points.push_back(point);
            return;
        }
        for (std::size_t i = 1; i < card_.size(); ++i) {
            if (!card_.is_blank(i)) out_.scalar_points.push_back(id(name, i));
        }
    }

    /// SET3: number, kind, ids. OptiStruct's SET: number, kind, LIST, and ids from the second line on.
    void read_set(std::string_view name) {
        const std::string_view kind = card_.field(2);
        const bool of_grids = kind == "GRID" || kind == "grid";
        const bool of_elements = kind.starts_with("ELEM") || kind.starts_with("elem");
        if (!(of_grids || of_elements) || (name == "SET" && card_.field(3) != "LIST" && !card_.is_blank(3)))
            return;
        BulkSet set{id(name, 1), of_grids, {}};
        const std::size_t first = name == "SET" ? 9 : 3;
        bool through = false;
        for (std::size_t i = first; i < card_.size(); ++i) {
            if (card_.is_blank(i)) continue;
            const auto value = card_.integer(i);
            if (!value) {
                through = true;
            } else if (std::exchange(through, false) && !set.ranges.empty()) {
                set.ranges.back().second = *value;
            } else {
                set.ranges.emplace_back(*value, *value);
            }
        }
        out_.sets.push_back(std::move(set));
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
        // The deck outlives this collector.
        const auto where = [deck = &deck_, file = deck_.file(), at = card_offset_] {
            return deck->where(file, at);
        };
        if (name[4] == '2') {
            SystemCard card{id(name, 1), *found, integer(name, 2, 0), {}, {}, false, where};
            for (std::size_t i = 0; i < 9; ++i) card.points[i / 3][i % 3] = real(name, 3 + i);
            out_.systems.add(std::move(card));
            return;
        }
        for (std::size_t i = 1; i <= 5 && !card_.is_blank(i); i += 4) {
            out_.systems.add(
                {id(name, i), *found, 0, {}, {id(name, i + 1), id(name, i + 2), id(name, i + 3)}, true, where}
            );
        }
    }

    void note_element(const CardHead& head, const ElementCard& card) {
        add_element(card, id(card.name, 1), head, 0);
        if (card.name != "PLOTEL" || card_.is_blank(1 + kSecondPlotel)) return;
        add_element(card, id(card.name, 1 + kSecondPlotel), head, kSecondPlotel);
    }

    BulkDeck& deck_;
    Diagnostics& diagnostics_;
    BulkCard card_;
    std::uint64_t card_offset_ = 0;
    const ElementCard* last_card_ = nullptr;
    BulkCards out_;
};

}  // namespace

BulkCards read_cards(BulkDeck& deck, Diagnostics& diagnostics) {
    return CardCollector(deck, diagnostics).collect();
}

}  // namespace feelem::nastran
