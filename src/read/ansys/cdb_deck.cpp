// SPDX-License-Identifier: Apache-2.0
// Must: find every block and mesh command of a deck in one pass, whatever else stands in it.
// Assumes: the deck is a list of commands as CDWRITE and Workbench write it; of the language around them only
// scalar parameters are followed. Loops and conditions are not: what depends on them is counted and said.
// Algorithm: lines that start with a digit are data and skipped; of the others the first word decides.
// Data: places of blocks, so that a deck of any size costs no memory here.
#include "read/ansys/cdb_deck.hpp"

#include "base/number.hpp"
#include "read/ansys/ansys_units.hpp"
#include "read/ansys/cdb_commands.hpp"
#include "read/ansys/cdb_remarks.hpp"
#include "read/ansys/cdb_row_counter.hpp"
#include "read/ansys/cdb_singles.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace feelem::ansys::cdb {
namespace {

constexpr int kDeepestInclude = 8;
constexpr std::size_t kMostInputs = 64;
constexpr std::size_t kChunkBytes = 1U << 20U;  ///< Of text that is read in one go.

/// Commands that make or change meshes by rules that Feelem does not follow.
constexpr std::array<std::string_view, 20> kNotFollowed{
    "NGEN",  "FILL", "NSYM",   "NSCALE", "NMODIF", "NMOVE",  "NROTAT", "NDELE", "NREAD", "EGEN",
    "ENGEN", "ESYM", "EMODIF", "EDELE",  "EREAD",  "NUMMRG", "NUMCMP", "AMESH", "VMESH", "LMESH"};

std::string_view without_quotes(std::string_view text) {
    text = trim(text);
    if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'')
        text = text.substr(1, text.size() - 2);
    return trim(text);
}

class DeckScanner {
public:
    DeckScanner(const Input& input, IncludeFiles* includes, Diagnostics& diagnostics, bool by_counts)
        : includes_(includes), diagnostics_(diagnostics), by_counts_(by_counts),
          singles_(deck_, settings_, diagnostics) {
        deck_.inputs.push_back(input);
    }

    Deck scan() {
        scan_input(0);
        return std::move(deck_);
    }

private:
    void scan_input(std::size_t index) {
        const std::size_t outer = input_;
        input_ = index;
        const Input input = deck_.inputs[index];
        const std::string_view text = input.text();
        const char outer_line_end = line_end_;
        line_end_ = line_end_of(text);
        ReleaseBehind* const outer_release = release_;
        ReleaseBehind release(input);
        release_ = &release;
        for (Lines lines(text, 0, text.size(), line_end_); !finished_ && lines.next();) {
            release.at(lines.begin());
            const char mark = first_mark(lines.line());
            const bool is_data = is_digit(mark) || mark == '-' || mark == '+' || mark == '.' || mark == '(';
            if (is_data || mark == '\0') continue;
            offset_ = lines.begin();
            next_ = lines.end();
            take_line(trim(lines.line()), mark);
            if (next_ != lines.end()) lines = Lines(text, next_, text.size(), line_end_);
        }
        finished_ = false;  // /EOF ends one file.
        input_ = outer;
        line_end_ = outer_line_end;
        release_ = outer_release;
    }

    const Input& input() const { return deck_.inputs[input_]; }
    std::string where() const { return input().where_line(offset_); }

    void take_line(std::string_view line, char mark) {
        if (mark == '!') {
            take_remark(line.substr(1));
            return;
        }
        const Command whole(line);
        if (whole.is("/COM")) {
            take_remark(whole.rest());
        } else if (whole.is("/TITLE")) {
            deck_.title = trim(whole.rest());
        } else if (!whole.name().starts_with("C***")) {
            for_each_command(without_comment(line), [&](std::string_view command) { take_command(command); });
        }
    }

    void take_remark(std::string_view text) {
        if (const auto system = unit_system_in(text)) set_unit(*system);
        if (const auto body = body_in(text)) settings_.body = *body;
        if (const auto release = release_in(text)) deck_.version = *release;
    }

    void set_unit(std::string_view system) {
        if (auto unit = length_unit_of_system(trim(system))) deck_.unit = std::move(unit);
    }

    void take_command(std::string_view text) {
        if (settings_.parameters.take_assignment(text)) return;
        const Command command(text);
        if (command.name().empty()) return;
        const char first = command.name().front();
        if (first == '/') {
            take_slash_command(command);
        } else if (first == '*') {
            take_star_command(command);
        } else {
            take_mesh_command(command);
        }
    }

    void take_slash_command(const Command& command) {
        if (command.is("/UNITS")) set_unit(command[1]);
        if (command.is("/INPUT")) include(command[1], command[2]);
        if (command.is("/WB") && command.rest().find("elem,end") != std::string_view::npos)
            settings_.body.clear();
        if (command.is("/EOF") && conditions_ == 0) finished_ = true;
    }

    void take_star_command(const Command& command) {
        if (command.is("*SET")) settings_.parameters.set(command[1], command[2]);
        if (command.is("*GET") || command.is("*DIM")) settings_.parameters.forget(command[1]);
        if (command.is("*IF")) {
            const std::string_view last = command[command.field_count()];
            conditions_ += upper_case(last) == "THEN" ? 1 : 0;
        }
        if (command.name().starts_with("*ENDIF")) conditions_ = std::max(conditions_ - 1, 0);
        if (command.name() == "*DO" || command.name().starts_with("*DOWHIL")) ++settings_.loops;
        if (command.name().starts_with("*ENDDO")) settings_.loops = std::max(settings_.loops - 1, 0);
    }

    void take_mesh_command(const Command& command) {
        if (command.is("NBLOCK")) return take_node_block(command);
        if (command.is("EBLOCK")) return take_element_block(command);
        if (command.is("ETBLOCK")) return take_type_block(command);
        if (command.is("CMBLOCK")) return take_component(command);
        if (command.is("ET")) {
            if (!take_type(command, settings_, deck_.types)) not_followed(command);
            return;
        }
        if (command.is("KEYOPT")) return take_key_option(command, settings_.parameters, deck_.types);
        if (command.is("CDREAD")) return include(command[2], command[3]);
        if (command.is("MAT")) settings_.material = settings_.parameters.integer(command[1]).value_or(1);
        if (command.is("CSYS")) settings_.system = settings_.parameters.integer(command[1]).value_or(0);
        if (command.is("TYPE")) {
            settings_.type = settings_.parameters.integer(command[1]).value_or(1);
            settings_.has_type = true;
        }
        if (singles_.take(command, input_, offset_)) return;
        // Workbench sets the sections and systems of elements so: no matter for the mesh.
        const std::string option = command.is("EMODIF") ? upper_case(command[2]).substr(0, 4) : std::string();
        if (option == "SECN" || option == "REAL" || option == "ESYS") return;
        for (const std::string_view name : kNotFollowed) {
            if (command.is(name)) return not_followed(command);
        }
    }

    void not_followed(const Command& command) {
        diagnostics_.add(
            Code::UnknownBlock,
            [&] { return where(); },
            fmt::format(
                "{} is not followed: Feelem reads blocks and the commands N, E, EN. CDWRITE,DB writes the "
                "finished "
                "mesh.",
                command.name()
            )
        );
    }

    void include(std::string_view name, std::string_view extension) {
        name = without_quotes(name);
        extension = without_quotes(extension);
        // %name% stands for a parameter: Workbench's file of preferences.
        if (name.empty() || name.find('%') != std::string_view::npos || includes_ == nullptr) return;
        const std::string file =
            extension.empty() ? std::string(name) : fmt::format("{}.{}", name, extension);
        if (by_counts_) throw NotAsAssumed{};
        std::optional<Input> found;
        if (depth_ < kDeepestInclude && deck_.inputs.size() < kMostInputs)
            found = includes_->find(file, input());
        if (!found) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return where(); },
                fmt::format("{} is named here, but not found", file)
            );
            return;
        }
        const std::size_t offset = offset_, next = next_;
        deck_.inputs.push_back(std::move(*found));
        ++depth_;
        scan_input(deck_.inputs.size() - 1);
        --depth_;
        offset_ = offset;
        next_ = next;
    }

    /// The format on the next line, and the rows behind it. `ranges`: negative numbers are no end.
    BlockRows take_rows(const Command& command, bool ranges, std::optional<ElementForm> form = std::nullopt) {
        const std::string_view text = input().text();
        Lines lines(text, next_, text.size(), line_end_);
        const bool has_line = lines.next();
        const auto format = has_line ? parse_format(lines.line()) : std::nullopt;
        if (!format) {
            throw Error(
                has_line ? Code::BadStructure : Code::Truncated,
                where(),
                fmt::format(
                    "{} needs its columns on the next line, as in (3i9,6e21.13e3), but finds \"{}\"",
                    command.name(),
                    has_line ? trim(lines.line()).substr(0, 60) : "the end of the file"
                )
            );
        }
        BlockRows rows;
        rows.input = input_;
        rows.begin = rows.end = lines.end();
        rows.format = *format;
        rows.line_end = line_end_;
        if (by_counts_ && !ranges && assume_rows(text, announced(command), form, rows)) {
            next_ = rows.end;
            return rows;
        }
        RowCounter counter(*format, form);
        while (lines.next()) {
            rows.ended = ends_block(lines.line(), *format, ranges);
            if (rows.ended) break;
            if (counter.begins(lines.line())) {
                ++rows.rows;
                const std::size_t last = rows.cuts.empty() ? rows.begin : rows.cuts.back();
                if (lines.begin() >= last + kChunkBytes) rows.cuts.push_back(lines.begin());
            }
            rows.end = lines.end();
            release_->at(rows.end);
        }
        next_ = rows.end;
        return rows;
    }

    /// As many rows as announced, each as long as the first, and then an end.
    static bool assume_rows(
        std::string_view text, std::int64_t count, std::optional<ElementForm> form, BlockRows& rows
    ) {
        constexpr std::int64_t kFewest = 1000;
        if (count < kFewest || (form && *form != ElementForm::Solid)) return false;
        const std::size_t size = first_row_size(text, rows, form);
        if (size == 0 || static_cast<std::size_t>(count) > (text.size() - rows.begin) / size) return false;
        const std::size_t end = rows.begin + static_cast<std::size_t>(count) * size;
        Lines behind(text, end, text.size(), rows.line_end);
        const bool leads_there = text[end - 1] == rows.line_end && text[end - size - 1] == rows.line_end &&
                                 behind.next() && ends_block(behind.line(), rows.format, false);
        if (!leads_there) return false;
        rows.end = end;
        rows.ended = rows.assumed = true;
        rows.rows = static_cast<std::size_t>(count);
        const std::size_t chunk = std::max<std::size_t>(1, kChunkBytes / size) * size;
        for (std::size_t cut = rows.begin + chunk; cut < end; cut += chunk) rows.cuts.push_back(cut);
        return true;
    }

    /// The last number of the command.
    std::int64_t announced(const Command& command) const {
        const std::size_t last = command.field_count();
        return last < 3 ? 0 : settings_.parameters.integer(command[last]).value_or(0);
    }

    void take_node_block(const Command& command) {
        BlockRows rows = take_rows(command, false);
        rows.announced = announced(command);
        deck_.node_blocks.push_back(rows);
    }

    void take_element_block(const Command& command) {
        ElementRows block;
        const std::string key = upper_case(command[2]);
        block.form = key.starts_with("SOL")   ? ElementForm::Solid
                     : key.starts_with("COM") ? ElementForm::Compact
                                              : ElementForm::Plain;
        block.rows = take_rows(command, false, block.form);
        block.rows.announced = announced(command);
        if (block.rows.format.id_width != block.rows.format.integer_width || block.rows.format.others != 0) {
            throw Error(
                Code::BadStructure, where(), "EBLOCK needs integer columns of one width, as in (19i10)"
            );
        }
        block.type = settings_.has_type ? settings_.type : settings_.last_type;
        block.material = settings_.material;
        block.body = settings_.body;
        deck_.element_blocks.push_back(std::move(block));
    }

    void take_component(const Command& command) {
        ComponentRows component;
        component.name = command[1];
        component.of_nodes = upper_case(command[2]).starts_with("NOD");
        component.rows = take_rows(command, true);
        deck_.components.push_back(std::move(component));
    }

    void take_type_block(const Command& command) {
        const BlockRows rows = take_rows(command, false);
        const std::string_view text = input().text();
        for (Lines lines(text, rows.begin, rows.end, line_end_); lines.next();) {
            Cursor cursor(lines.line());
            const auto number = parse_integer(next_word(cursor));
            const std::string_view name = next_word(cursor);
            const std::int64_t keyopt1 = parse_integer(next_word(cursor)).value_or(0);
            if (define_type(number.value_or(0), name, keyopt1, deck_.types)) settings_.last_type = *number;
        }
    }

    Deck deck_;
    IncludeFiles* includes_;
    Diagnostics& diagnostics_;
    bool by_counts_;
    Settings settings_;
    SingleCommands singles_;
    std::size_t input_ = 0;   ///< Being read,
    std::size_t offset_ = 0;  ///< this line of it,
    std::size_t next_ = 0;    ///< and where to go on.
    char line_end_ = '\n';
    ReleaseBehind* release_ = nullptr;
    int depth_ = 0;       ///< Of /INPUT.
    int conditions_ = 0;  ///< *IF ... THEN around this place.
    bool finished_ = false;
};

}  // namespace

Deck scan_deck(const Input& input, IncludeFiles* includes, Diagnostics& diagnostics, bool by_counts) {
    return DeckScanner(input, includes, diagnostics, by_counts).scan();
}

}  // namespace feelem::ansys::cdb
