// SPDX-License-Identifier: Apache-2.0
// docs/formats/coverage.md: what comes out of every real file we have, written by this test.
#include "support/exercise.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace feelem {
namespace {

namespace fs = std::filesystem;

/// Files of one model, by their paths from the corpus.
struct Group {
    std::string name;
    std::vector<std::string> files;
};

std::vector<std::string> sorted_entries(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

/// Each file with this ending alone.
std::vector<Group> single_files(
    const fs::path& corpus, const std::string& folder, const std::string& ending
) {
    std::vector<Group> groups;
    for (const std::string& name : sorted_entries(corpus / folder)) {
        if (name.ends_with(ending)) groups.push_back({name, {folder + "/" + name}});
    }
    return groups;
}

/// Each printed table of CalculiX that is not empty, with the results that bring its mesh.
std::vector<Group> tables_with_results(const fs::path& corpus) {
    std::vector<Group> groups;
    for (Group& group : single_files(corpus, "calculix/test", ".dat.ref")) {
        if (fs::file_size(corpus / group.files[0]) == 0) continue;
        std::string results = group.files[0];
        results.replace(results.size() - 7, 3, "frd");
        group.files.push_back(std::move(results));
        groups.push_back(std::move(group));
    }
    return groups;
}

/// Each folder as one model, but excerpts, which are cuttings of many.
std::vector<Group> folders(const fs::path& corpus, const std::string& parent) {
    std::vector<Group> groups;
    for (const std::string& name : sorted_entries(corpus / parent)) {
        const std::string folder = parent + "/" + name;
        if (name == "excerpts") {
            for (Group& group : single_files(corpus, folder, "")) groups.push_back(std::move(group));
            continue;
        }
        Group group{name, {}};
        for (const std::string& file : sorted_entries(corpus / folder))
            group.files.push_back(folder + "/" + file);
        groups.push_back(std::move(group));
    }
    return groups;
}

/// Each file with this ending in the folder or below.
std::vector<Group> files_below(const fs::path& corpus, const std::string& folder, const std::string& ending) {
    std::vector<Group> groups;
    for (const auto& entry : fs::recursive_directory_iterator(corpus / folder)) {
        if (!entry.is_regular_file() || entry.path().extension() != ending) continue;
        groups.push_back(
            {fs::relative(entry.path(), corpus / folder).string(),
             {fs::relative(entry.path(), corpus).string()}}
        );
    }
    std::ranges::sort(groups, {}, &Group::name);
    return groups;
}

/// Nastran decks, each with the files that it names in one line.
std::vector<Group> decks_below(const fs::path& corpus, const std::string& folder, const std::string& ending) {
    std::vector<Group> groups = files_below(corpus, folder, ending);
    for (Group& group : groups) {
        const fs::path deck = corpus / group.files.front();
        std::istringstream lines(test::read_file(deck.string()));
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with("INCLUDE '")) continue;
            const std::string name = line.substr(9, line.find('\'', 9) - 9);
            const fs::path file = (deck.parent_path() / name).lexically_normal();
            if (fs::is_regular_file(file)) group.files.push_back(fs::relative(file, corpus).string());
        }
    }
    return groups;
}

/// Nastran's print files, each with the deck of the same name and what that includes.
std::vector<Group> prints_below(const fs::path& corpus, const std::string& folder) {
    std::vector<Group> groups = files_below(corpus, folder, ".f06");
    for (Group& group : groups) {
        for (const char* ending : {".bdf", ".dat"}) {
            for (const Group& deck : decks_below(corpus, folder, ending)) {
                if (deck.name.substr(0, deck.name.size() - 4) != group.name.substr(0, group.name.size() - 4))
                    continue;
                group.files.insert(group.files.end(), deck.files.begin(), deck.files.end());
            }
        }
    }
    return groups;
}

/// Each file of the exchange formats; others' files lie there as well.
std::vector<Group> exchange_files(const fs::path& corpus, const std::string& folder) {
    std::vector<Group> groups;
    for (const std::string& name : sorted_entries(corpus / folder)) {
        const std::string ending = fs::path(name).extension().string();
        const bool other =
            ending == ".md" || ending == ".json" || ending == ".inp" || ending == ".bdf" || ending == ".h5";
        if (!other && fs::is_regular_file(corpus / folder / name))
            groups.push_back({name, {folder + "/" + name}});
    }
    return groups;
}

/// The row that the page has already: where the helper program is not built, nothing new can be said.
std::string row_as_it_was(const std::string& name) {
    const std::string page = test::read_file(test::project_file("docs/formats/coverage.md"));
    const std::size_t first = page.find("| " + name + " |");
    return first == std::string::npos ? "" : page.substr(first, page.find('\n', first) + 1 - first);
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
    return out.empty() ? "none" : out;
}

std::string elements_of(const Mesh& mesh) {
    std::vector<std::string> words;
    for (const ElementBlock& block : mesh.blocks)
        words.push_back(fmt::format("{} {}", block.ids.size(), element_row(block.type).name));
    for (const auto& [name, count] : mesh.skipped_elements)
        words.push_back(fmt::format("({} {})", count, name));
    return joined(words);
}

/// Names, each once, with how often it is there.
std::string results_of(const ModelSource& model) {
    std::vector<std::string> order;
    std::map<std::string, int> counts;
    for (const ResultInfo& info : model.results()) {
        std::string name = info.name;
        if (info.layer != Layer::No) name += " " + std::string(word(info.layer));
        if (info.complex != Complex::No) name += " " + std::string(word(info.complex));
        if (counts[name]++ == 0) order.push_back(name);
    }
    std::vector<std::string> words;
    for (const std::string& name : order)
        words.push_back(counts[name] == 1 ? name : fmt::format("{} x {}", counts[name], name));
    return joined(words);
}

std::string notes_of(const Diagnostics& diagnostics) {
    std::set<std::string> words;
    for (const Diagnostic& entry : diagnostics.entries())
        words.insert(std::string(code_info(entry.code).word));
    return joined({words.begin(), words.end()});
}

/// One row of the table; `unsound` is set when a model is not what a model must be.
std::string row_of(const Group& group, const fs::path& corpus, bool& unsound) {
    std::vector<NamedBytes> files;
    for (const std::string& file : group.files)
        files.push_back({fs::path(file).filename().string(), test::read_file((corpus / file).string())});
    Diagnostics diagnostics;
    try {
        const auto model = open_model(std::move(files), {}, diagnostics);
        const std::string wrong = test::exercise(*model);
        if (!wrong.empty()) unsound = true;
        std::size_t damaged = 0;
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            try {
                model->load(i);
            } catch (const Error&) {
                ++damaged;
            }
        }
        std::string verdict = !wrong.empty()                  ? "unsound: " + wrong
                              : diagnostics.entries().empty() ? "read whole"
                                                              : "read";
        if (damaged > 0) verdict += fmt::format(", {} results refused", damaged);
        return fmt::format(
            "| {} | {} | {} | {} | {} | {} |\n",
            group.name,
            model->mesh().node_count(),
            elements_of(model->mesh()),
            results_of(*model),
            verdict,
            notes_of(diagnostics)
        );
    } catch (const Error& error) {
        const std::string before = row_as_it_was(group.name);
        if (error.code() == Code::UnsupportedFormat && !before.empty()) return before;
        return fmt::format(
            "| {} | | | | refused: {} | {} |\n",
            group.name,
            code_info(error.code()).word,
            notes_of(diagnostics)
        );
    }
}

std::string table_of(const std::vector<Group>& groups, const fs::path& corpus, bool& unsound) {
    std::string out =
        "| model | nodes | elements | results | verdict | diagnostics |\n|---|---:|---|---|---|---|\n";
    for (const Group& group : groups) out += row_of(group, corpus, unsound);
    return out + "\n";
}

TEST(Coverage, page_says_what_comes_out_of_every_real_file) {
    const auto found = test::corpus_file("calculix/ORIGINS.md");
    if (!found) GTEST_SKIP() << "the corpus is not here";
    const fs::path corpus = fs::path(*found).parent_path().parent_path();
    bool unsound = false;

    std::string page =
        "# What comes out of real files\n\nWritten by the test `Coverage` from files that others made; "
        "`FEELEM_UPDATE_GOLDEN=1` writes it again.\nElements in brackets have no surface of their own. "
        "A result that stands in several steps is counted.\n\n";
    page += "## CalculiX: the solver's own test suite\n\n";
    page += table_of(single_files(corpus, "calculix/test", ".frd.ref"), corpus, unsound);
    page += "## CalculiX: printed tables\n\nEach with the .frd of its job; empty ones are left out.\n\n";
    page += table_of(tables_with_results(corpus), corpus, unsound);
    page += "## Ansys: archives of commands\n\n";
    page += table_of(single_files(corpus, "ansys/cdb", ""), corpus, unsound);
    page += "## Ansys: text lists\n\nA folder is one model; excerpts are single pages.\n\n";
    page += table_of(folders(corpus, "ansys/lists"), corpus, unsound);
    page += "## Ansys: binary results\n\n";
    std::vector<Group> binary = files_below(corpus, "ansys", ".rst");
    for (Group& group : files_below(corpus, "ansys", ".rth")) binary.push_back(std::move(group));
    const std::string run = "ansys/rst/distributed_v211/file";
    binary.push_back({"rst/distributed_v211, both", {run + "0.rst", run + "1.rst"}});
    page += table_of(binary, corpus, unsound);
    page += "## Ansys Mechanical: exported tables\n\n";
    page += table_of(folders(corpus, "ansys/workbench"), corpus, unsound);
    page += "## Nastran: decks\n\nEach with what it includes.\n\n";
    for (const char* ending : {".bdf", ".dat", ".fem"})
        page += table_of(decks_below(corpus, "nastran/models", ending), corpus, unsound);
    page += "## Nastran: .f06\n\nEach with its deck.\n\n";
    page += table_of(prints_below(corpus, "nastran/models"), corpus, unsound);
    page += "## Nastran: .op2\n\nEach alone, without its deck.\n\n";
    page += table_of(files_below(corpus, "nastran/models", ".op2"), corpus, unsound);
    page += "## Universal files\n\n";
    page += table_of(single_files(corpus, "unv", ".unv"), corpus, unsound);
    page += "## Abaqus and CalculiX: decks\n\n";
    page += table_of(files_below(corpus, "abaqus", ".inp"), corpus, unsound);
    page += table_of(single_files(corpus, "calculix/test", ".inp"), corpus, unsound);
    page += table_of(single_files(corpus, "unv", ".inp"), corpus, unsound);
    page += "## The boiler in exchange formats\n\n";
    page += table_of(exchange_files(corpus, "converted"), corpus, unsound);
    page += table_of(single_files(corpus, "converted", ".bdf"), corpus, unsound);
    page += table_of(single_files(corpus, "converted", ".inp"), corpus, unsound);
    page += "## Exodus\n\n";
    page += table_of(exchange_files(corpus, "exodus"), corpus, unsound);
    page += "## LS-DYNA\n\n";
    const std::string states = "lsdyna/test/test_data/simple_d3plot/d3plot";
    page += table_of({{"d3plot and d3plot01", {states, states + "01"}}}, corpus, unsound);
    page.pop_back();

    EXPECT_FALSE(unsound) << page;
    const std::string file = test::project_file("docs/formats/coverage.md");
    if (std::getenv("FEELEM_UPDATE_GOLDEN") != nullptr) test::write_file(file, page);
    EXPECT_EQ(test::read_file(file), page) << "FEELEM_UPDATE_GOLDEN=1 writes the page again";
}

}  // namespace
}  // namespace feelem
