// SPDX-License-Identifier: Apache-2.0
// Keywords that make nodes and elements out of others: *NGEN *NFILL *NCOPY *NMAP *ELGEN *ELCOPY, and *NSET,
// ELSET=.
#pragma once

#include "read/abaqus/deck_model.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::abaqus {

/// A few lines can ask for any number of nodes, so what they may make is limited: coordinates, labels and
/// nodes of rows, over a whole deck. 8 million are two million nodes, or 880,000 bricks of 8 nodes.
inline constexpr std::uint64_t kMostGenerated = 8'000'000;

/// What is left of the limits; runs out over a whole deck.
struct GenerationBudget {
    std::uint64_t numbers = kMostGenerated;
    std::uint64_t visits = 2 * kMostGenerated;  ///< Members of sets that were gone through.
};

/// One keyword at work.
struct Generation {
    const Deck& deck;
    const Keyword& keyword;
    std::size_t index = 0;  ///< Of the keyword in deck.keywords.
    Scope& scope;
    const Placement& system;                        ///< *SYSTEM in effect.
    std::map<std::string, std::uint64_t>& skipped;  ///< Rows by type, of elements without a surface.
    GenerationBudget& budget;
    Diagnostics& diagnostics;
};

/// Whether generate() knows the keyword.
bool is_generator(std::string_view keyword);
/// Carries the keyword out. What it does not do is reported with its line, and leaves the deck as it is.
/// Throws Error(TooLarge) beyond the limits.
void generate(Generation& job);

void generate_nodes(Generation& job);     ///< *NGEN
void fill_nodes(Generation& job);         ///< *NFILL
void copy_nodes(Generation& job);         ///< *NCOPY
void map_nodes(Generation& job);          ///< *NMAP
void generate_elements(Generation& job);  ///< *ELGEN
void copy_elements(Generation& job);      ///< *ELCOPY
/// *NSET, ELSET=: the nodes of the elements that are in that set by now.
void add_nodes_of_elements(Generation& job);

/// Reports what is not carried out at `where`.
void report_left_out(Generation& job, const std::string& where, const std::string& text);
/// Throws Error(TooLarge) when the deck has made too much.
void spend_numbers(Generation& job, std::uint64_t count);
void spend_visits(Generation& job, std::uint64_t count);

/// The next field as a whole number, also written as 2.0; `fallback` where it is empty. Throws
/// Error(BadNumber).
std::int64_t take_whole(
    std::string_view& rest, std::int64_t fallback, const Generation& job, const DataLines& lines
);
/// A parameter's value as a whole number. Throws Error(BadNumber).
std::int64_t whole_parameter(const Generation& job, std::string_view key, std::int64_t fallback);
/// Throws Error(TooLarge) when no node or element can have that number.
Label generated_label(const Generation& job, std::int64_t number);

/// Nodes or elements of a set of the scope as it is by now.
struct SetContents {
    std::vector<Label> labels;    ///< In the set's order: ascending, or as given when it is unsorted.
    std::uint64_t undefined = 0;  ///< Members that are not defined (yet).
    bool unsorted = false;
};
/// Empty contents where there is no such set.
SetContents nodes_of_set(Generation& job, const std::string& name);
SetContents elements_of_set(Generation& job, const std::string& name);

/// The place of a node in Scope::places; of its last definition.
std::optional<std::size_t> find_place(Scope& scope, Label label);
/// A new node, or a new place for one that is there.
void put_node(Generation& job, Label label, const Point3& place);

struct ElementAt {
    const ElementRun* run = nullptr;  ///< Null: there is none.
    std::size_t row = 0;
};
ElementAt find_row(Scope& scope, Label label);

}  // namespace feelem::abaqus
