// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_elements.hpp"

#include "read/abaqus/keyword_rows.hpp"
#include "read/abaqus/plain_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace feelem::abaqus {
namespace {

class RowReader {
public:
    RowReader(const Deck& deck, const Keyword& keyword, Diagnostics& diagnostics)
        : deck_(deck), lines_(deck, keyword), diagnostics_(diagnostics) {}

    void read_shapes(ElementRun& run) {
        PlainElementRows rows{&run.type, {}, {}};
        read_rows(lines_, rows, [&](std::string_view line) {
            const Label id = take_label(line, deck_, lines_);
            if (id == 0) throw_bad_number("", "the number of an element", deck_, lines_);
            if (!read_nodes(line, run)) {
                diagnostics_.add(
                    Code::TruncatedInput,
                    [&] { return fmt::format("{} (element {})", lines_.where(), id); },
                    fmt::format("elements of type {} with too few nodes are left out", run.type_name)
                );
                return false;
            }
            rows.add(id, nodes_);
            return true;
        });
        run.ids = std::move(rows.ids);
        run.nodes = std::move(rows.nodes);
    }

    /// Without the number of nodes of a row, a comma at the end of a line says that it goes on.
    void count_rows(ElementRun& run) {
        bool goes_on = false;
        while (auto line = lines_.next()) {
            const bool is_head = !goes_on;
            goes_on = line->ends_with(',');
            if (is_head) run.ids.push_back(label_of(take_field(*line)).value_or(0));
        }
    }

    void release() const { lines_.release(); }

private:
    /// A row goes on in the next line until it has its nodes. Where a type may have fewer, a line without a
    /// comma at its end is the last one. False: the lines end before.
    bool read_nodes(std::optional<std::string_view> line, const ElementRun& run) {
        const std::size_t most = run.type.most_nodes, least = run.type.least_nodes;
        nodes_.fill(0);
        std::size_t count = 0;
        for (; line; line = lines_.next()) {
            const bool goes_on = line->ends_with(',');
            while (count < most && !line->empty()) nodes_[count++] = take_label(*line, deck_, lines_);
            if (count < most && (count < least || goes_on)) continue;
            // Beams may name a node for their direction.
            if (!line->empty() && element_row(run.type.shape).dimension != 1) report_rest(run);
            return true;
        }
        return count >= least;
    }

    void report_rest(const ElementRun& run) {
        diagnostics_.add(
            Code::UnknownBlock,
            [&] { return lines_.where(); },
            fmt::format(
                "rows of *ELEMENT, TYPE={} hold more than {} nodes; the rest is not used",
                run.type_name,
                run.type.most_nodes
            )
        );
    }

    const Deck& deck_;
    DataLines lines_;
    Diagnostics& diagnostics_;
    std::array<Label, kMaxElementNodes> nodes_{};
};

}  // namespace

ElementRun read_elements(const Deck& deck, const Keyword& keyword, Diagnostics& diagnostics) {
    ElementRun run;
    run.type_name = folded(keyword.value("TYPE"));
    run.type = deck_type(run.type_name);
    run.set = keyword.value("ELSET");
    RowReader rows(deck, keyword, diagnostics);
    if (run.type.use == Use::Shape) {
        rows.read_shapes(run);
    } else {
        rows.count_rows(run);
    }
    rows.release();
    if (run.type.use == Use::Unknown && !run.ids.empty()) {
        diagnostics.add(
            Code::UnknownElementType,
            [&] { return deck.where(keyword); },
            fmt::format("elements of type \"{}\" are left out: Feelem does not know it", run.type_name),
            run.ids.size()
        );
    }
    return run;
}

}  // namespace feelem::abaqus
