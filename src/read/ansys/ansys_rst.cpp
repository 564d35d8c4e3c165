// SPDX-License-Identifier: Apache-2.0
// Which files are result files, and which of them are parts of one distributed run.
#include "read/ansys/ansys_rst.hpp"

#include "read/ansys/rst_cyclic.hpp"
#include "read/ansys/rst_domains.hpp"
#include "read/ansys/rst_source.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace feelem {
namespace rst {
namespace {

std::int32_t word_of(std::string_view head, std::size_t number) {
    std::int32_t word = 0;
    if (head.size() >= 4 * number + 4) std::memcpy(&word, head.data() + 4 * number, sizeof word);
    return word;
}

/// Every binary file of Ansys begins with a record of 100 integers; the first says what kind of file it is.
Likelihood recognise_rst(const Input& input) {
    constexpr std::int32_t kResultFile = 12;
    const std::string_view head = head_of(input);
    const bool is_ansys =
        word_of(head, 0) == 100 && static_cast<std::uint32_t>(word_of(head, 1)) >> 24 == 0x80;
    if (!is_ansys) return Likelihood::No;
    return word_of(head, 2) == kResultFile ? Likelihood::Sure : Likelihood::Maybe;
}

/// A result file, and where it stands among the inputs.
struct Opened {
    std::unique_ptr<RstSource> source;
    std::uint32_t input = 0;

    const ResultHeader& header() const { return source->header(); }
    const std::string& name() const { return source->records().input().name(); }
    /// Holds a part of the nodes only: one of the files that a distributed run leaves.
    bool is_domain() const { return header().nodes_of_all > header().nodes; }
};

bool of_one_run(const ResultHeader& a, const ResultHeader& b) {
    return a.nodes_of_all == b.nodes_of_all && a.date == b.date && a.time == b.time &&
           a.analysis == b.analysis;
}

void note_sectors(const Opened& opened, Diagnostics& diagnostics) {
    diagnostics.add(
        Code::ResultForPartOfModel,
        opened.name(),
        fmt::format(
            "the model is one of {} equal sectors round an axis; only the sector in the file is shown "
            "(--expand-cyclic shows all)",
            opened.header().sectors
        )
    );
}

class Opener {
public:
    Opener(std::span<const Input> inputs, const ReadOptions& options, Diagnostics& diagnostics)
        : inputs_(inputs), options_(options), diagnostics_(diagnostics) {
        for (std::uint32_t i = 0; i < inputs.size(); ++i)
            opened_.push_back({std::make_unique<RstSource>(inputs[i], diagnostics), i});
    }

    std::unique_ptr<ModelSource> open() {
        for (Opened& opened : opened_) {
            if (!opened.source) continue;
            if (opened.is_domain()) {
                add_run(opened);
            } else {
                sources_.push_back({with_sectors(opened), {opened.input}});
            }
        }
        if (sources_.size() == 1) return std::move(sources_.front().source);
        std::vector<UsedInput> used;
        for (const Input& input : inputs_) used.push_back({input, "ansys-rst"});
        return merge_sources(std::move(sources_), {}, std::move(used), diagnostics_);
    }

private:
    std::unique_ptr<ModelSource> with_sectors(Opened& opened) {
        if (opened.header().sectors <= 1) return std::move(opened.source);
        if (options_.expand_cyclic) return expand_sectors(std::move(opened.source), diagnostics_);
        note_sectors(opened, diagnostics_);
        return std::move(opened.source);
    }

    /// All files of the run that this one belongs to, as one source.
    void add_run(const Opened& first) {
        const ResultHeader header = first.header();
        std::vector<Opened*> members;
        for (Opened& opened : opened_) {
            if (opened.source && opened.is_domain() && of_one_run(opened.header(), header))
                members.push_back(&opened);
        }
        if (has_whole(header)) {
            for (Opened* member : members) {
                diagnostics_.add(
                    Code::UnknownBlock,
                    member->name(),
                    "files of parts of a distributed run are left out, for another input holds the whole"
                );
                member->source.reset();
            }
            return;
        }
        std::vector<std::unique_ptr<ModelSource>> domains;
        std::vector<std::string> names;
        std::vector<std::uint32_t> inputs;
        for (Opened* member : members) {
            names.push_back(member->name());
            inputs.push_back(member->input);
            domains.push_back(std::move(member->source));
        }
        auto source = domains.size() == 1 ? std::move(domains.front())
                                          : merge_domains(std::move(domains), names, diagnostics_);
        note_missing(header, names.front(), source->mesh().node_count());
        sources_.push_back({std::move(source), std::move(inputs)});
    }

    bool has_whole(const ResultHeader& header) const {
        // One that was moved to the sources already held all of its nodes, too.
        const auto holds_all = [&](std::size_t nodes) { return nodes == header.nodes_of_all; };
        for (const Opened& opened : opened_) {
            if (opened.source && !opened.is_domain() && holds_all(opened.header().nodes)) return true;
        }
        return std::ranges::any_of(sources_, [&](const OpenedSource& source) {
            return holds_all(source.source->mesh().node_count());
        });
    }

    void note_missing(const ResultHeader& header, const std::string& name, std::size_t nodes) {
        if (nodes >= header.nodes_of_all) return;
        diagnostics_.add(
            Code::ResultForPartOfModel,
            name,
            fmt::format(
                "the files of this distributed run hold {} of {} nodes. Give all of them (file0.rst, "
                "file1.rst ...), or the combined file.rst",
                nodes,
                header.nodes_of_all
            )
        );
    }

    std::span<const Input> inputs_;
    const ReadOptions& options_;
    Diagnostics& diagnostics_;
    std::vector<Opened> opened_;
    std::vector<OpenedSource> sources_;
};

std::unique_ptr<ModelSource> open_rst(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return Opener(inputs, context.options, diagnostics).open();
}

}  // namespace
}  // namespace rst

ReadFormat ansys_rst_format() {
    return {
        {"ansys-rst", "Ansys results, binary", ".rst .rth .rmg", true, true},
        true,
        rst::recognise_rst,
        rst::open_rst};
}

}  // namespace feelem
