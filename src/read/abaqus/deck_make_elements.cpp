// SPDX-License-Identifier: Apache-2.0
// *ELGEN, *ELCOPY, and *NSET, ELSET=: elements out of others, and nodes out of elements.
#include "read/abaqus/deck_generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace feelem::abaqus {
namespace {

struct GridDirection {
    std::int64_t count = 1, nodes = 0, elements = 0;
};

/// A line of *ELGEN: the master and its row, rows and layers.
struct ElementGrid {
    std::int64_t master = 0;
    std::array<GridDirection, 3> directions{};

    bool is_sound() const {
        return std::ranges::all_of(directions, [](const GridDirection& d) {
            constexpr std::int64_t kMost = 1'000'000'000;
            return d.count >= 1 && (d.count == 1 || d.elements != 0) && d.count <= kMost &&
                   std::abs(d.nodes) <= kMost && std::abs(d.elements) <= kMost;
        });
    }
};

ElementGrid read_element_grid(std::string_view line, const Generation& job, const DataLines& lines) {
    ElementGrid grid;
    grid.master = take_whole(line, 0, job, lines);
    // Within a row both increments are 1 unless given; from row to row and layer to layer nothing is said.
    for (std::size_t i = 0; i < 3; ++i) {
        GridDirection& direction = grid.directions[i];
        direction.count = take_whole(line, 1, job, lines);
        direction.nodes = take_whole(line, i == 0 ? 1 : 0, job, lines);
        direction.elements = take_whole(line, i == 0 ? 1 : 0, job, lines);
    }
    return grid;
}

/// Elements that a keyword makes of one type, before they become a run of the scope.
ElementRun new_run(const Generation& job, const ElementRun& like, std::string set) {
    ElementRun run;
    run.type_name = like.type_name;
    run.type = like.type;
    run.set = std::move(set);
    run.keyword = job.index;
    return run;
}

void add_row(Generation& job, ElementRun& into, const ElementAt& from, std::int64_t id, std::int64_t shift) {
    const std::size_t width = from.run->nodes.empty() ? 0 : from.run->type.most_nodes;
    spend_numbers(job, 1 + width);
    into.ids.push_back(generated_label(job, id));
    for (std::size_t i = 0; i < width; ++i) {
        const Label node = from.run->nodes[from.row * width + i];
        into.nodes.push_back(node == 0 ? 0 : generated_label(job, node + shift));
    }
}

/// Rows without a shape are counted as those that the deck lists.
void keep_run(Generation& job, ElementRun run) {
    if (run.ids.empty()) return;
    if (run.type.use == Use::Skip) job.skipped[run.type_name] += run.ids.size();
    if (run.type.use == Use::Unknown) {
        job.diagnostics.add(
            Code::UnknownElementType,
            job.deck.where(job.keyword),
            fmt::format("elements of type \"{}\" are left out: Feelem does not know it", run.type_name),
            run.ids.size()
        );
    }
    (run.type.use == Use::Shape ? job.scope.runs : job.scope.others).push_back(std::move(run));
}

void make_grid(Generation& job, const ElementGrid& grid, const ElementAt& master) {
    const std::string set = job.keyword.value("ELSET");
    ElementRun run = new_run(job, *master.run, set.empty() ? master.run->set : set);
    for (std::int64_t k = 0; k < grid.directions[2].count; ++k) {
        for (std::int64_t j = 0; j < grid.directions[1].count; ++j) {
            for (std::int64_t i = 0; i < grid.directions[0].count; ++i) {
                if (i == 0 && j == 0 && k == 0) continue;
                const auto& [a, b, c] = grid.directions;
                const std::int64_t id = grid.master + i * a.elements + j * b.elements + k * c.elements;
                add_row(job, run, master, id, i * a.nodes + j * b.nodes + k * c.nodes);
            }
        }
    }
    if (!set.empty()) {
        DeckSet& members = job.scope.element_sets.get(set);
        add_label(members, generated_label(job, grid.master));
        for (const Label id : run.ids) add_label(members, id);
    }
    keep_run(job, std::move(run));
}

/// The order of nodes that turns a mirrored element right side out: local X and Y change places. The order in
/// which the row holds them is Feelem's already.
std::array<std::uint8_t, kMaxElementNodes> mirrored_order(ElementType type) {
    const ElementRow& row = element_row(type);
    std::array<std::uint8_t, kMaxElementNodes> order{};
    for (std::uint8_t i = 0; i < row.node_count; ++i) {
        const auto& at = row.reference[i];
        for (std::uint8_t j = 0; j < row.node_count; ++j) {
            const auto& other = row.reference[j];
            if (other[0] == at[1] && other[1] == at[0] && other[2] == at[2]) order[i] = j;
        }
    }
    return order;
}

void reflect_rows(ElementRun& run) {
    if (run.nodes.empty() || element_row(run.type.shape).dimension < 2) return;
    const auto order = mirrored_order(run.type.shape);
    const std::size_t width = run.type.most_nodes;
    std::array<Label, kMaxElementNodes> old{};
    for (std::size_t first = 0; first < run.nodes.size(); first += width) {
        std::copy_n(run.nodes.begin() + static_cast<std::ptrdiff_t>(first), width, old.begin());
        for (std::size_t i = 0; i < width; ++i) run.nodes[first + i] = old[order[i]];
    }
}

}  // namespace

void generate_elements(Generation& job) {
    DataLines lines(job.deck, job.keyword);
    while (const auto line = lines.next()) {
        const ElementGrid grid = read_element_grid(*line, job, lines);
        const ElementAt master = find_row(job.scope, generated_label(job, grid.master));
        if (master.run == nullptr || !grid.is_sound()) {
            report_left_out(
                job,
                lines.where(),
                fmt::format(
                    "from element {} is left out: {}",
                    grid.master,
                    master.run == nullptr ? "it is not defined before"
                                          : "a number of rows or layers needs an increment of element numbers"
                )
            );
            continue;
        }
        make_grid(job, grid, master);
    }
    lines.release();
}

void copy_elements(Generation& job) {
    const SetContents old = elements_of_set(job, job.keyword.value("OLDSET"));
    if (old.labels.empty() || !job.keyword.has("ELEMENTSHIFT") || !job.keyword.has("SHIFTNODES")) {
        report_left_out(
            job,
            job.deck.where(job.keyword),
            fmt::format(
                "is left out: it needs ELEMENT SHIFT, SHIFT NODES and OLD SET, and the set \"{}\" has {} "
                "elements "
                "so far",
                job.keyword.value("OLDSET"),
                old.labels.size()
            )
        );
        return;
    }
    const std::int64_t shift = whole_parameter(job, "ELEMENTSHIFT", 0);
    const std::int64_t shift_nodes = whole_parameter(job, "SHIFTNODES", 0);
    const std::string set = job.keyword.value("NEWSET");
    // One run for each that rows come from: they differ in type and set.
    std::map<const ElementRun*, ElementRun> runs;
    std::vector<const ElementRun*> order;
    for (const Label label : old.labels) {
        const ElementAt at = find_row(job.scope, label);
        const auto [found, is_new] = runs.try_emplace(at.run);
        if (is_new) {
            found->second = new_run(job, *at.run, set.empty() ? at.run->set : set);
            order.push_back(at.run);
        }
        add_row(job, found->second, at, label + shift, shift_nodes);
    }
    for (const ElementRun* from : order) {
        ElementRun run = std::move(runs.at(from));
        if (job.keyword.has("REFLECT")) reflect_rows(run);
        if (!set.empty()) {
            DeckSet& members = job.scope.element_sets.get(set);
            for (const Label id : run.ids) add_label(members, id);
        }
        keep_run(job, std::move(run));
    }
}

void add_nodes_of_elements(Generation& job) {
    const SetContents elements = elements_of_set(job, job.keyword.value("ELSET"));
    std::vector<Label> nodes;
    for (const Label label : elements.labels) {
        const ElementAt at = find_row(job.scope, label);
        const std::size_t width = at.run->nodes.empty() ? 0 : at.run->type.most_nodes;
        spend_visits(job, width);
        for (std::size_t i = 0; i < width; ++i) {
            const Label node = at.run->nodes[at.row * width + i];
            if (node != 0) nodes.push_back(node);
        }
    }
    if (nodes.empty()) {
        report_left_out(
            job,
            job.deck.where(job.keyword),
            fmt::format("finds no nodes of elements of \"{}\"", job.keyword.value("ELSET"))
        );
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    DeckSet& set = job.scope.node_sets.get(job.keyword.value("NSET"));
    for (const Label node : nodes) add_label(set, node);
}

}  // namespace feelem::abaqus
