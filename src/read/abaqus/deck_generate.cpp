// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_generate.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace feelem::abaqus {
namespace {

struct Generator {
    std::string_view keyword;
    void (*carry_out)(Generation&);
};
constexpr auto kGenerators = std::to_array<Generator>({
    {"NGEN", generate_nodes},
    {"NFILL", fill_nodes},
    {"NCOPY", copy_nodes},
    {"NMAP", map_nodes},
    {"ELGEN", generate_elements},
    {"ELCOPY", copy_elements},
});

[[noreturn]] void throw_too_much(const Generation& job, const char* what) {
    throw Error(
        Code::TooLarge,
        job.deck.where(job.keyword),
        fmt::format(
            "*{} and the keywords before it that generate nodes and elements {}. The limit is {} numbers "
            "(two million nodes, or 880,000 bricks of 8 nodes). Write the mesh out plainly instead",
            job.keyword.name,
            what,
            kMostGenerated
        )
    );
}

std::optional<std::int64_t> whole_of(std::string_view field) {
    const auto value = parse_double(field);
    if (!value || !(std::abs(*value) <= 9e15) || *value != std::floor(*value)) return {};
    return static_cast<std::int64_t>(*value);
}

void index_nodes(Scope& scope) {
    ScopeIndex& index = scope.index;
    for (; index.nodes_seen < scope.node_ids.size(); ++index.nodes_seen)
        index.nodes[scope.node_ids[index.nodes_seen]] = static_cast<std::uint32_t>(index.nodes_seen);
}

void index_runs(const std::vector<ElementRun>& runs, std::size_t& seen, bool shown, ScopeIndex& index) {
    for (; seen < runs.size(); ++seen) {
        for (std::size_t row = 0; row < runs[seen].ids.size(); ++row)
            index.elements[runs[seen].ids[row]] = {
                static_cast<std::uint32_t>(seen), static_cast<std::uint32_t>(row), shown};
    }
}

void index_elements(Scope& scope) {
    index_runs(scope.runs, scope.index.runs_seen, true, scope.index);
    index_runs(scope.others, scope.index.others_seen, false, scope.index);
}

/// Goes through a set and the sets that it names, in order.
class SetWalk {
public:
    SetWalk(Generation& job, bool nodes) : job_(job), nodes_(nodes) {
        if (nodes) {
            index_nodes(job.scope);
        } else {
            index_elements(job.scope);
        }
    }

    SetContents contents(const std::string& name) {
        const SetTable& table = nodes_ ? job_.scope.node_sets : job_.scope.element_sets;
        const DeckSet* set = table.find(folded(name));
        if (set == nullptr) return {};
        enter(*set);
        while (!open_.empty()) step(table);
        found_.unsorted = set->unsorted;
        if (!set->unsorted) {
            std::ranges::sort(found_.labels);
            const auto last = std::unique(found_.labels.begin(), found_.labels.end());
            found_.labels.erase(last, found_.labels.end());
        }
        return std::move(found_);
    }

private:
    struct At {
        const DeckSet* set = nullptr;
        std::size_t piece = 0, name = 0;
        bool in_piece = false;
    };

    void enter(const DeckSet& set) {
        if (seen_.insert(&set).second) open_.push_back({&set});
    }

    void step(const SetTable& table) {
        At& at = open_.back();
        if (at.piece >= at.set->pieces.size()) {
            open_.pop_back();
            return;
        }
        const SetPiece& piece = at.set->pieces[at.piece];
        if (!at.in_piece && piece.instance.empty()) {
            for (const LabelRange& range : piece.ranges) add(range);
        }
        at.in_piece = true;
        if (at.name >= piece.sets.size() || !piece.instance.empty()) {
            ++at.piece;
            at.name = 0;
            at.in_piece = false;
            return;
        }
        spend_visits(job_, 1);
        const DeckSet* inner = table.find(piece.sets[at.name++]);
        if (inner != nullptr) enter(*inner);
    }

    bool is_there(Label label) const {
        const ScopeIndex& index = job_.scope.index;
        return nodes_ ? index.nodes.contains(label) : index.elements.contains(label);
    }

    void add(const LabelRange& range) {
        const std::size_t there = nodes_ ? job_.scope.index.nodes.size() : job_.scope.index.elements.size();
        const auto count =
            static_cast<std::uint64_t>((std::int64_t{range.last} - range.first) / range.step + 1);
        const std::size_t before = found_.labels.size();
        if (count <= there + 16) {
            spend_visits(job_, count);
            for (std::int64_t label = range.first; label <= range.last; label += range.step) {
                if (is_there(static_cast<Label>(label))) found_.labels.push_back(static_cast<Label>(label));
            }
        } else {
            add_from_all(range);
        }
        found_.undefined += count - (found_.labels.size() - before);
    }

    /// Of a range that is wider than all there is.
    void add_from_all(const LabelRange& range) {
        const auto before = static_cast<std::ptrdiff_t>(found_.labels.size());
        const auto take = [&](Label label) {
            if (label >= range.first && label <= range.last && (label - range.first) % range.step == 0)
                found_.labels.push_back(label);
        };
        const auto take_all = [&](const std::vector<Label>& ids) {
            spend_visits(job_, ids.size());
            std::ranges::for_each(ids, take);
        };
        if (nodes_) {
            take_all(job_.scope.node_ids);
        } else {
            for (const ElementRun& run : job_.scope.runs) take_all(run.ids);
            for (const ElementRun& run : job_.scope.others) take_all(run.ids);
        }
        const auto first = found_.labels.begin() + before;
        std::sort(first, found_.labels.end());
        found_.labels.erase(std::unique(first, found_.labels.end()), found_.labels.end());
    }

    Generation& job_;
    bool nodes_;
    SetContents found_;
    std::vector<At> open_;
    std::set<const DeckSet*> seen_;
};

}  // namespace

bool is_generator(std::string_view keyword) {
    return std::ranges::find(kGenerators, keyword, &Generator::keyword) != kGenerators.end();
}

void generate(Generation& job) {
    const auto found = std::ranges::find(kGenerators, job.keyword.name, &Generator::keyword);
    found->carry_out(job);
}

void report_left_out(Generation& job, const std::string& where, const std::string& text) {
    job.diagnostics.add(Code::UnknownBlock, where, fmt::format("*{} {}", job.keyword.name, text));
}

void spend_numbers(Generation& job, std::uint64_t count) {
    if (count > job.budget.numbers) throw_too_much(job, "make too many of them");
    job.budget.numbers -= count;
}

void spend_visits(Generation& job, std::uint64_t count) {
    if (count > job.budget.visits) throw_too_much(job, "go through too many members of sets");
    job.budget.visits -= count;
}

std::int64_t take_whole(
    std::string_view& rest, std::int64_t fallback, const Generation& job, const DataLines& lines
) {
    const std::string_view field = take_field(rest);
    if (field.empty()) return fallback;
    const auto value = whole_of(field);
    if (!value) throw_bad_number(field, "a whole number", job.deck, lines);
    return *value;
}

std::int64_t whole_parameter(const Generation& job, std::string_view key, std::int64_t fallback) {
    const std::string text = job.keyword.value(key);
    if (text.empty()) return fallback;
    const auto value = whole_of(text);
    if (!value) throw_bad_number(text, "a whole number", job.deck, DataLines(job.deck, job.keyword));
    return *value;
}

Label generated_label(const Generation& job, std::int64_t number) {
    if (number < 1 || number > std::numeric_limits<Label>::max()) {
        throw Error(
            Code::TooLarge,
            job.deck.where(job.keyword),
            fmt::format(
                "*{} makes a node or element with the number {}; expected 1 to {}",
                job.keyword.name,
                number,
                std::numeric_limits<Label>::max()
            )
        );
    }
    return static_cast<Label>(number);
}

SetContents nodes_of_set(Generation& job, const std::string& name) {
    return SetWalk(job, true).contents(name);
}

SetContents elements_of_set(Generation& job, const std::string& name) {
    return SetWalk(job, false).contents(name);
}

std::optional<std::size_t> find_place(Scope& scope, Label label) {
    index_nodes(scope);
    const auto found = scope.index.nodes.find(label);
    if (found == scope.index.nodes.end()) return {};
    return found->second;
}

void put_node(Generation& job, Label label, const Point3& place) {
    if (const auto at = find_place(job.scope, label)) {
        job.scope.places[*at] = place;
        return;
    }
    spend_numbers(job, 4);
    job.scope.node_ids.push_back(label);
    job.scope.places.push_back(place);
}

ElementAt find_row(Scope& scope, Label label) {
    index_elements(scope);
    const auto found = scope.index.elements.find(label);
    if (found == scope.index.elements.end()) return {};
    const ScopeIndex::Row& row = found->second;
    return {&(row.shown ? scope.runs : scope.others)[row.run], row.row};
}

}  // namespace feelem::abaqus
