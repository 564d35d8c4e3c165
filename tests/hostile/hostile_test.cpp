// SPDX-License-Identifier: Apache-2.0
// Every file that a reader takes, cut and damaged: each attempt must end soon, in bounded memory, with a
// model or an Error, and with nothing else.
//
// FEELEM_HOSTILE=200 makes 200 cuts and 200 damages of each file, whatever its size; by default 10 of files
// up to 1.5 MB. A failing input is kept in build/*/scratch/hostile; once understood it moves to
// tests/data/fuzz_regressions, where it is tried by every run.
#include "read/read_format.hpp"
#include "support/exercise.hpp"
#include "support/memory.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <sstream>

namespace feelem {
namespace {

namespace fs = std::filesystem;

using test::kSanitized;

constexpr std::size_t kAttempts = kSanitized ? 3 : 10;
/// For files that the helper program reads: each attempt starts it several times.
constexpr std::size_t kFewAttempts = 1;
constexpr double kMostSeconds = kSanitized ? 20 : 2;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kLargeFile = 1'500'000;

struct Case {
    std::string name;               ///< Path from its root.
    std::vector<NamedBytes> files;  ///< The first is damaged; others belong to the same model.
};

std::uint64_t seed_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return hash;
}

/// Opens and uses; empty when that ended as it must.
std::string attempt_to(const std::function<std::unique_ptr<ModelSource>(Diagnostics&)>& open) {
    // Processor time: a busy machine must not fail it. A sleep for ever is left to CTest's timeout.
    const std::clock_t start = std::clock();
    test::reset_peak_memory();
    const std::uint64_t before = test::peak_memory();
    std::string wrong;
    try {
        Diagnostics diagnostics;
        const auto model = open(diagnostics);
        wrong = test::exercise(*model);
    } catch (const Error& error) {
        if (std::string(error.what()).size() < 10) wrong = "an error without words";
    } catch (const std::exception& error) {
        wrong = fmt::format("not an Error: {}", error.what());
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (seconds > kMostSeconds) wrong += fmt::format(" took {:.1f} s", seconds);
    const std::uint64_t used = test::peak_memory() - std::min(before, test::peak_memory());
    if (!kSanitized && used > kMostBytes) wrong += fmt::format(" used {} MiB", used >> 20);
    return wrong;
}

std::string attempt(std::vector<NamedBytes> files, const ReadOptions& options = {}) {
    return attempt_to([&](Diagnostics& diagnostics) {
        return open_model(std::move(files), options, diagnostics);
    });
}

std::string cut(const std::string& bytes, std::mt19937_64& random) {
    return bytes.substr(0, random() % (bytes.size() + 1));
}

void overwrite(std::string& bytes, std::size_t at, std::string_view with) {
    at = std::min(at, bytes.size());
    bytes.replace(at, std::min(with.size(), bytes.size() - at), with.substr(0, bytes.size() - at));
}

/// Bits turned, digits changed, huge and negative counts, lines lost or doubled.
std::string damage(std::string bytes, std::mt19937_64& random) {
    const auto somewhere = [&] { return bytes.empty() ? 0 : random() % bytes.size(); };
    const std::size_t times = 1 + random() % 4;
    for (std::size_t i = 0; i < times && !bytes.empty(); ++i) {
        const std::size_t at = somewhere();
        switch (random() % 7) {
        case 0: bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8)); break;
        case 1: bytes[at] = static_cast<char>('0' + random() % 10); break;
        case 2: overwrite(bytes, at, "999999999"); break;
        case 3: overwrite(bytes, at, "-2147483648"); break;
        case 4: overwrite(bytes, at, "\xFF\xFF\xFF\x7F"); break;
        case 5: bytes.erase(at, random() % 200); break;
        default: bytes.insert(at, bytes.substr(somewhere(), random() % 400)); break;
        }
    }
    // Heads are where counts stand: half of the damage goes there.
    if (random() % 2 == 0 && !bytes.empty()) {
        const std::size_t at = random() % std::min<std::size_t>(bytes.size(), 4096);
        bytes[at] = static_cast<char>('0' + random() % 10);
    }
    return bytes;
}

void expect_survival(const Case& one, std::size_t count) {
    std::mt19937_64 random(seed_of(one.name));
    for (std::size_t i = 0; i < 2 * count; ++i) {
        std::vector<NamedBytes> files = one.files;
        std::string& bytes = files.front().bytes;
        bytes = i < count ? cut(bytes, random) : damage(std::move(bytes), random);
        const std::string hostile = bytes;
        const std::string wrong = attempt(std::move(files));
        if (wrong.empty()) continue;
        static const std::string folder = test::scratch_folder("hostile");
        const std::string kept = fmt::format("{}/{}-{}", folder, fs::path(one.name).filename().string(), i);
        test::write_file(kept, hostile);
        ADD_FAILURE() << one.name << ", attempt " << i << ": " << wrong << " (kept: " << kept << ")";
    }
}

const ReadFormat* reader_of(const std::string& bytes) {
    const Input input = Input::from_memory("x", bytes.substr(0, 64u << 10));
    for (const ReadFormat& format : read_format_list()) {
        if (format.recognise(input) != Likelihood::No) return &format;
    }
    return nullptr;
}

/// Every file below the folder that a reader takes; listings together with the listings beside them.
std::vector<Case> cases_below(const std::string& root, std::uint64_t largest) {
    std::vector<Case> cases;
    std::map<std::string, std::vector<std::size_t>> listings;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (!entry.is_regular_file() || entry.file_size() > largest) continue;
        const std::string path = entry.path().string();
        std::string bytes = test::read_file(path);
        const ReadFormat* format = reader_of(bytes);
        if (format == nullptr) continue;
        // Result files and decks in one folder are many models here.
        const bool one_model = format->many_inputs && format->info.id == "ansys-lists";
        if (one_model) listings[entry.path().parent_path().string()].push_back(cases.size());
        cases.push_back({fs::relative(path, root).string(), {{path, std::move(bytes)}}});
    }
    for (const auto& [folder, members] : listings) {
        std::vector<NamedBytes> all;
        for (const std::size_t i : members) all.push_back(cases[i].files.front());
        for (std::size_t i = 0; i < members.size(); ++i) {
            std::swap(all[0], all[i]);
            cases[members[i]].files = all;
            std::swap(all[0], all[i]);
        }
    }
    std::ranges::sort(cases, {}, &Case::name);
    return cases;
}

void expect_survival_below(const std::string& root, std::size_t attempts = kAttempts) {
    const char* count = std::getenv("FEELEM_HOSTILE");
    const std::vector<Case> cases =
        cases_below(root, count != nullptr ? std::numeric_limits<std::uint64_t>::max() : kLargeFile);
    EXPECT_FALSE(cases.empty()) << root;
    for (const Case& one : cases) expect_survival(one, count != nullptr ? std::stoul(count) : attempts);
    std::cout << fmt::format("{} files\n", cases.size());
}

/// Copies a folder, damages one of its files, and opens `main`, for each file and each attempt.
void expect_family_survival(const std::string& from, const std::string& main, std::size_t count) {
    const std::string folder = test::scratch_folder("hostile_family");
    for (const auto& entry : fs::directory_iterator(from)) {
        const std::string name = entry.path().filename().string();
        // Files of other families in the folder.
        if (!entry.is_regular_file() || name.substr(0, 5) != main.substr(0, 5)) continue;
        std::mt19937_64 random(seed_of(name));
        for (std::size_t i = 0; i < 2 * count; ++i) {
            fs::copy(from, folder, fs::copy_options::overwrite_existing | fs::copy_options::recursive);
            const std::string bytes = test::read_file(entry.path().string());
            test::write_file(folder + "/" + name, i < count ? cut(bytes, random) : damage(bytes, random));
            const std::vector<std::string> paths{folder + "/" + main};
            EXPECT_EQ(
                attempt_to([&](Diagnostics& diagnostics) { return open_model(paths, {}, diagnostics); }), ""
            ) << name
              << ", attempt " << i;
        }
    }
}

class Hostile : public testing::Test {
protected:
    /// A request for far too much memory fails at once instead of bringing the machine down.
    static void SetUpTestSuite() {
        if (kSanitized) return;
        const rlimit limit{std::uint64_t{8} << 30, std::uint64_t{8} << 30};
        setrlimit(RLIMIT_AS, &limit);
    }
};

TEST_F(Hostile, shipped_files_cut_and_damaged_are_survived) {
    expect_survival_below(test::project_file("examples"));
    expect_survival_below(test::project_file("tests/data/calculix"));
    expect_survival_below(test::project_file("tests/data/nastran"));
    expect_survival_below(test::project_file("tests/data/unv"));
    expect_survival_below(test::project_file("tests/data/gmsh"));
    expect_survival_below(test::project_file("tests/data/ansys"));
    expect_survival_below(test::project_file("tests/data/abaqus"));
}

TEST_F(Hostile, shipped_exchange_files_cut_and_damaged_are_survived) {
    expect_survival_below(test::project_file("tests/data/exchange"), kFewAttempts);
}

TEST_F(Hostile, files_that_belong_together_are_survived_whichever_is_damaged) {
    const char* count = std::getenv("FEELEM_HOSTILE");
    const std::size_t attempts = count != nullptr ? std::stoul(count) : kFewAttempts;
    expect_family_survival(test::project_file("tests/data/exchange/ensight"), "stack.case", attempts);
    expect_family_survival(test::project_file("tests/data/exchange/vtk"), "stack.pvd", attempts);
    expect_family_survival(test::project_file("tests/data/exchange/vtk"), "stack.pvtu", attempts);
    const auto states = test::corpus_file("lsdyna/test/test_data/simple_d3plot/d3plot");
    if (states) expect_family_survival(fs::path(*states).parent_path().string(), "d3plot", attempts);
}

TEST_F(Hostile, corpus_of_calculix_cut_and_damaged_is_survived) {
    const auto corpus = test::corpus_file("calculix");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*corpus);
}

TEST_F(Hostile, corpus_of_ansys_cut_and_damaged_is_survived) {
    const auto corpus = test::corpus_file("ansys");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*corpus);
}

TEST_F(Hostile, corpus_of_nastran_cut_and_damaged_is_survived) {
    const auto corpus = test::corpus_file("nastran");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*corpus);
}

TEST_F(Hostile, corpus_of_abaqus_cut_and_damaged_is_survived) {
    const auto corpus = test::corpus_file("abaqus");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*corpus);
}

TEST_F(Hostile, corpus_of_exchange_formats_cut_and_damaged_is_survived) {
    const auto universal = test::corpus_file("unv");
    if (!universal) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*universal);
    for (const char* folder : {"converted", "exodus", "lsdyna"}) {
        const auto corpus = test::corpus_file(folder);
        if (corpus) expect_survival_below(*corpus, kFewAttempts);
    }
}

TEST_F(Hostile, corpus_of_boilers_cut_and_damaged_is_survived) {
    if (std::getenv("FEELEM_HOSTILE") == nullptr) GTEST_SKIP() << "the shipped ones are like them";
    const auto corpus = test::corpus_file("boiler");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    expect_survival_below(*corpus);
}

TEST_F(Hostile, a_short_file_ends_at_every_byte) {
    const std::string path = test::project_file("tests/data/calculix/static_binary.frd");
    const std::string bytes = test::read_file(path);
    for (std::size_t length = 0; length <= bytes.size(); ++length)
        ASSERT_EQ(attempt({{"cut.frd", bytes.substr(0, length)}}), "") << length;
}

TEST_F(Hostile, past_troubles_stay_past) {
    for (const auto& entry : fs::directory_iterator(test::project_file("tests/data/fuzz_regressions"))) {
        EXPECT_EQ(attempt({{entry.path().string(), test::read_file(entry.path().string())}}), "")
            << entry.path();
    }
}

/// tests/data/fuzz_corpus/fuzz_<reader>: what a fuzzer found to reach the most code of that reader.
TEST_F(Hostile, inputs_that_fuzzing_found_are_survived_by_their_reader) {
    const std::string root = test::project_file("tests/data/fuzz_corpus");
    if (!fs::is_directory(root)) GTEST_SKIP() << "no fuzzer has run yet";
    std::size_t tried = 0;
    for (const ReadFormat& format : read_format_list()) {
        const fs::path folder = fs::path(root) / ("fuzz_" + std::string(format.info.id));
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder)) {
            ReadOptions options;
            if (format.info.has_mesh) options.from = format.info.id;
            EXPECT_EQ(attempt({{"fuzz", test::read_file(entry.path().string())}}, options), "")
                << entry.path();
            ++tried;
        }
    }
    EXPECT_GT(tried, 0U);
}

}  // namespace
}  // namespace feelem
