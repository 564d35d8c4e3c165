// SPDX-License-Identifier: Apache-2.0
// An archive of commands as a ModelSource: a mesh without results.
#include "read/ansys/ansys_cdb.hpp"

#include "read/ansys/cdb_commands.hpp"
#include "read/ansys/cdb_deck.hpp"
#include "read/ansys/cdb_mesh.hpp"
#include "read/ansys/list_text.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <array>
#include <utility>

namespace feelem {
namespace {

using namespace ansys;

/// First words of lines that only a deck of another program has.
constexpr std::array<std::string_view, 10> kOthers{
    "*NODE", "*HEADING", "*ELEMENT", "*PART", "*INCLUDE", "*KEYWORD", "GRID", "CEND", "BEGIN BULK", "SOL "};

bool starts_with_any(std::string_view line, std::span<const std::string_view> words) {
    for (const std::string_view word : words) {
        if (line.starts_with(word)) return true;
    }
    return false;
}

Likelihood recognise_cdb(const Input& input) {
    constexpr std::array<std::string_view, 8> kOurs{
        "NBLOCK,",
        "EBLOCK,",
        "ETBLOCK,",
        "CMBLOCK,",
        "/PREP7",
        "/COM,ANSYS RELEASE",
        "/WB,FILE",
        "N,R5.3,LOC"};
    const std::string_view head = head_of(input);
    bool nodes = false;
    bool elements = false;
    for (Lines lines(head, 0, head.size(), line_end_of(head)); lines.next();) {
        const std::string line = upper_case(trim(lines.line().substr(0, 80)));
        if (starts_with_any(line, kOthers)) return Likelihood::No;
        if (starts_with_any(line, kOurs)) return Likelihood::Sure;
        nodes = nodes || line.starts_with("N,");
        elements = elements || line.starts_with("E,") || line.starts_with("EN,");
    }
    return nodes && elements ? Likelihood::Maybe : Likelihood::No;
}

class CdbSource : public ModelSource {
public:
    CdbSource(const Input& input, const ReadContext& context, Diagnostics& diagnostics) {
        if (!read_by_counts(input, context, diagnostics)) read(input, context, diagnostics, false);
        mesh_ = own_or_shared(own_mesh_, context.mesh);
        if (mesh_ == &own_mesh_ && own_mesh_.node_count() == 0) {
            throw Error(
                Code::NoNodes,
                input.name(),
                "the commands define no nodes: there is no NBLOCK and no N. CDWRITE,DB writes them."
            );
        }
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return {}; }
    std::span<const ResultInfo> results() const override { return {}; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"Ansys", version_}; }
    std::string title() const override { return title_; }

    Result load(std::size_t) override {
        throw Error(Code::UnknownName, "", "an archive of commands holds no results");
    }

private:
    void read(const Input& input, const ReadContext& context, Diagnostics& diagnostics, bool by_counts) {
        const cdb::Deck deck = cdb::scan_deck(input, context.includes, diagnostics, by_counts);
        title_ = deck.title;
        version_ = deck.version;
        own_mesh_ = cdb::read_mesh(deck, read_types({}, context.options.types, diagnostics), diagnostics);
    }

    /// Touches long blocks once, not twice. What is wrong with a deck is told by the other way.
    bool read_by_counts(const Input& input, const ReadContext& context, Diagnostics& diagnostics) {
        Diagnostics found;
        try {
            read(input, context, found, true);
        } catch (const cdb::NotAsAssumed&) {
            return false;
        } catch (const Error&) {
            return false;
        }
        for (const Diagnostic& entry : found.entries())
            diagnostics.add(entry.code, entry.where, entry.text, entry.count);
        return true;
    }

    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    std::string title_;
    std::string version_;
};

std::unique_ptr<ModelSource> open_cdb(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<CdbSource>(inputs.front(), context, diagnostics);
}

}  // namespace

ReadFormat ansys_cdb_format() {
    return {
        {"ansys-cdb",
         "Ansys archives of commands (CDWRITE, Workbench ds.dat)",
         ".cdb .dat .inp",
         true,
         false},
        false,
        recognise_cdb,
        open_cdb};
}

}  // namespace feelem
