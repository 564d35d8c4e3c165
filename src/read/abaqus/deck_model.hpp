// SPDX-License-Identifier: Apache-2.0
// What a deck defines, scope by scope (model, part, instance, assembly), before it is flattened to a mesh.
#pragma once

#include "read/abaqus/deck_lines.hpp"
#include "read/abaqus/deck_types.hpp"
#include "read/abaqus/frames.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace feelem::abaqus {

using Label = std::int32_t;

struct LabelRange {
    Label first = 0, last = 0, step = 1;
};

/// Members of a set that are labels of one scope: `ranges` stand before `sets`.
struct SetPiece {
    std::string instance;  ///< Folded name; empty: the scope of the set itself.
    std::vector<LabelRange> ranges;
    std::vector<std::string> sets;  ///< Folded names of sets of that scope.
};

struct DeckSet {
    std::string name;
    bool internal = false;  ///< Made by the pre-processor for itself: not shown.
    bool unsorted = false;  ///< Its order is as given, for keywords that pair members of sets.
    std::vector<SetPiece> pieces;
};

/// Sets by folded name, in order of first appearance.
class SetTable {
public:
    DeckSet& get(const std::string& name);
    const DeckSet* find(const std::string& folded_name) const;
    std::span<const DeckSet> all() const noexcept { return sets_; }

private:
    std::vector<DeckSet> sets_;
    std::map<std::string, std::size_t, std::less<>> by_name_;
};
void add_label(DeckSet& set, Label label);
void add_range(DeckSet& set, const std::string& instance, LabelRange range);
void add_set(DeckSet& set, const std::string& instance, std::string folded_name);

/// Elements of one *ELEMENT. `nodes` holds type.most_nodes a row, 0 where a row ends early.
struct ElementRun {
    std::string type_name;
    DeckType type;
    std::string set;  ///< As written; may be empty.
    std::vector<Label> ids;
    std::vector<Label> nodes;
    std::size_t keyword = 0;  ///< Into Deck::keywords, for messages.
};

struct NodeTransform {
    std::string set;  ///< Folded.
    LocalSystem system;
};

/// Where labels are; filled when a keyword first asks for one.
struct ScopeIndex {
    struct Row {
        std::uint32_t run = 0, row = 0;
        bool shown = true;  ///< In Scope::runs, else in Scope::others.
    };
    std::unordered_map<Label, std::uint32_t> nodes;  ///< -> Scope::places.
    std::unordered_map<Label, Row> elements;
    std::size_t nodes_seen = 0, runs_seen = 0, others_seen = 0;
};

struct Scope {
    std::vector<Label> node_ids;  ///< As they come: neither sorted nor unique.
    std::vector<Point3> places;
    std::vector<ElementRun> runs;
    std::vector<ElementRun> others;  ///< Without a shape: ids alone.
    ScopeIndex index;
    SetTable node_sets, element_sets;
    std::vector<std::string> sections;  ///< Names of the element sets that sections are given to, as written.
    std::vector<NodeTransform> transforms;

    bool empty() const { return node_ids.empty() && runs.empty(); }
};

struct Instance {
    std::string name;
    std::string part;  ///< Folded.
    Placement placement;
    Scope own;
};

struct DeckModel {
    Scope model;
    std::map<std::string, Scope> parts;  ///< By folded name.
    std::vector<Instance> instances;
    Scope assembly;
    std::map<std::string, std::uint64_t> skipped;  ///< Rows by type name, of every scope but parts.
    std::map<std::string, std::map<std::string, std::uint64_t>> skipped_in_parts;
};

/// By the first letter: C, S, else rectangular.
SystemKind system_kind(const std::string& letter);

/// Reads the lines of all keywords. Throws Error(BadNumber) on a line that is none.
DeckModel read_deck(const Deck& deck, Diagnostics& diagnostics);

}  // namespace feelem::abaqus
