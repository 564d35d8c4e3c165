// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_keywords.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace feelem::abaqus {
namespace {

constexpr std::size_t kMostIncludes = 4096;
constexpr std::size_t kDeepestInclude = 32;
/// Smaller files need not be let go of: they are read again at once.
constexpr std::size_t kKeptMapped = std::size_t{32} << 20U;

std::string squeezed(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c != ' ' && c != '\t' && c != '\r' && c != '\0') out.push_back(to_capital(c));
    }
    return out;
}

/// Keywords whose lines say something about the mesh.
bool is_used(std::string_view name) {
    constexpr auto kUsed =
        std::to_array<std::string_view>({"NODE",    "ELEMENT",  "NSET",        "ELSET",       "PART",
                                         "ENDPART", "ASSEMBLY", "ENDASSEMBLY", "INSTANCE",    "SYSTEM",
                                         "NGEN",    "NFILL",    "ENDINSTANCE", "NCOPY",       "ELGEN",
                                         "ELCOPY",  "NMAP",     "TRANSFORM",   "USERELEMENT", "IMPORT"});
    return name.ends_with("SECTION") || std::ranges::find(kUsed, name) != kUsed.end();
}

Keyword parse_keyword(std::string_view text) {
    Keyword keyword;
    text = trim(text);
    text.remove_prefix(1);
    keyword.name = squeezed(take_piece(text));
    while (!text.empty()) {
        const std::string_view piece = take_piece(text);
        const std::size_t equals = piece.find('=');
        Parameter parameter;
        parameter.key = squeezed(piece.substr(0, equals));
        if (equals != std::string_view::npos) parameter.value = unquoted(piece.substr(equals + 1));
        if (!parameter.key.empty()) keyword.parameters.push_back(std::move(parameter));
    }
    return keyword;
}

bool is_keyword(std::string_view line) {
    const std::string_view text = trim(line);
    return text.size() > 1 && text[0] == '*' && text[1] != '*';
}

/// Where the next line starts that is a keyword, from the line at `at` on; the text's end when there is none.
/// Looked for by its star: data lines, nearly all of a deck, are not looked at one by one.
std::size_t next_keyword(std::string_view text, std::size_t at) {
    const auto find = [&](char c, std::size_t from) {
        const void* found = std::memchr(text.data() + from, c, text.size() - from);
        return found == nullptr ? text.size()
                                : static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
    };
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0'; };
    for (std::size_t star = find('*', at); star < text.size();) {
        std::size_t start = star;
        while (start > at && is_blank(text[start - 1])) --start;
        const std::size_t end = find('\n', star);
        const bool leads = start == at || text[start - 1] == '\n';
        if (leads && is_keyword(text.substr(start, end - start))) return start;
        at = std::min(end + 1, text.size());
        star = at < text.size() ? find('*', at) : at;
    }
    return text.size();
}

/// Reads a keyword's line and the lines it goes on in; `lines` stands behind its first line.
Keyword read_keyword(std::string_view line, TextLines& lines) {
    std::string text(line);
    while (trim(text).ends_with(',')) {
        TextLines ahead = lines;
        auto further = ahead.next();
        while (further && is_comment(*further)) further = ahead.next();
        if (!further || is_keyword(*further) || text.size() > 65536) break;
        text += *further;
        lines = ahead;
    }
    return parse_keyword(text);
}

/// Walks the files in the order in which a solver reads them.
class Scanner {
public:
    Scanner(IncludeFiles* includes, Diagnostics& diagnostics)
        : includes_(includes), diagnostics_(diagnostics) {}

    void scan(const Input& input) {
        current_ = kNothing;
        deck_.files.push_back(input);
        scan_file(static_cast<std::uint32_t>(deck_.files.size() - 1));
    }
    Deck take() { return std::move(deck_); }

private:
    static constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

    void scan_file(std::uint32_t file) {
        open_.push_back(file);
        const Input input = deck_.files[file];
        LineRange data{file, 0, 0};
        while (data.begin < input.size()) {
            if (wants_title_) find_title(input, data.begin);
            data.end = next_keyword(input.text(), data.begin);
            add_data(data);
            if (data.end == input.size()) break;
            TextLines lines(input, data.end, input.size());
            const std::string_view line = lines.next().value_or(std::string_view{});
            Keyword keyword = read_keyword(line, lines);
            keyword.file = file;
            keyword.offset = data.end;
            data.begin = lines.offset();
            use(std::move(keyword), input);
        }
        if (input.size() > kKeptMapped) input.release(0, input.size());
        open_.pop_back();
    }

    /// The title is the first line that says something behind *HEADING.
    void find_title(const Input& input, std::size_t first) {
        TextLines lines(input, first, input.size());
        for (auto line = lines.next(); line && wants_title_ && !is_keyword(*line); line = lines.next()) {
            if (!is_comment(*line)) take_title(*line);
        }
    }

    void use(Keyword keyword, const Input& input) {
        if (keyword.name == "INCLUDE") {
            include(keyword, input);
            return;
        }
        wants_title_ = keyword.name == "HEADING" && deck_.title.empty();
        deck_.has_parameters |= keyword.name == "PARAMETER";
        current_ = kNothing;
        if (!is_used(keyword.name)) return;
        const bool has_file = keyword.has("INPUT");
        deck_.keywords.push_back(std::move(keyword));
        current_ = deck_.keywords.size() - 1;
        if (has_file) include(Keyword(deck_.keywords.back()), input);
    }

    void include(const Keyword& keyword, const Input& from) {
        const std::string name = keyword.value("INPUT");
        std::string trouble;
        if (open_.size() >= kDeepestInclude || included_++ >= kMostIncludes) {
            trouble = "files include each other too often";
        } else if (auto found = includes_ != nullptr ? includes_->find(name, from) : std::nullopt) {
            const std::uint32_t file = index_of(*found);
            if (std::ranges::find(open_, file) == open_.end()) {
                scan_file(file);
                return;
            }
            trouble = "it includes itself";
        } else {
            trouble = "there is no such file beside the deck nor among the inputs";
        }
        diagnostics_.add(
            Code::UnknownBlock,
            [&] { return deck_.where(keyword); },
            fmt::format("the included file \"{}\" is left out: {}", name, trouble)
        );
    }

    std::uint32_t index_of(const Input& input) {
        const auto known = std::ranges::find(deck_.files, input.name(), &Input::name);
        if (known != deck_.files.end()) return static_cast<std::uint32_t>(known - deck_.files.begin());
        deck_.files.push_back(input);
        return static_cast<std::uint32_t>(deck_.files.size() - 1);
    }

    void add_data(const LineRange& range) {
        if (current_ != kNothing && range.end > range.begin) deck_.keywords[current_].data.push_back(range);
    }

    void take_title(std::string_view line) {
        deck_.title = std::string(trim(line));
        wants_title_ = deck_.title.empty();
    }

    IncludeFiles* includes_;
    Diagnostics& diagnostics_;
    Deck deck_;
    std::size_t current_ = kNothing;
    std::vector<std::uint32_t> open_;  ///< Files that are being read, outermost first.
    std::size_t included_ = 0;
    bool wants_title_ = false;
};

}  // namespace

std::string_view take_piece(std::string_view& rest) {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < rest.size() && (quoted || rest[end] != ','); ++end) quoted ^= rest[end] == '"';
    const std::string_view piece = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return piece;
}

bool is_comment(std::string_view line) {
    const std::string_view text = trim(line);
    return text.starts_with("**") || text == "*";
}

std::string unquoted(std::string_view label) {
    label = trim(label);
    if (label.size() > 1 && label.front() == '"' && label.back() == '"')
        label = label.substr(1, label.size() - 2);
    return std::string(label);
}

std::string folded(std::string_view label) {
    return upper_case(unquoted(label));
}

bool Keyword::has(std::string_view key) const {
    return std::ranges::find(parameters, key, &Parameter::key) != parameters.end();
}

std::string Keyword::value(std::string_view key) const {
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    return found == parameters.end() ? std::string() : found->value;
}

std::string Deck::where(const Keyword& keyword) const {
    return files[keyword.file].where_line(keyword.offset);
}

Deck scan_decks(std::span<const Input> roots, IncludeFiles* includes, Diagnostics& diagnostics) {
    Scanner scanner(includes, diagnostics);
    for (const Input& root : roots) scanner.scan(root);
    return scanner.take();
}

std::vector<std::string> included_names(const Input& input) {
    std::vector<std::string> names;
    std::size_t at = next_keyword(input.text(), 0);
    while (at < input.size()) {
        TextLines lines(input, at, input.size());
        const std::string_view line = lines.next().value_or(std::string_view{});
        if (squeezed(line).find("INPUT=") != std::string::npos) {
            const Keyword keyword = read_keyword(line, lines);
            if (keyword.has("INPUT")) names.push_back(keyword.value("INPUT"));
        }
        at = lines.offset() < input.size() ? next_keyword(input.text(), lines.offset()) : input.size();
    }
    return names;
}

bool starts_like_deck(std::string_view head) {
    constexpr auto kFirst = std::to_array<std::string_view>(
        {"HEADING",
         "NODE",
         "ELEMENT",
         "NSET",
         "ELSET",
         "PART",
         "INCLUDE",
         "PREPRINT",
         "PARAMETER",
         "RESTART",
         "SYSTEM",
         "MATERIAL",
         "STEP",
         "BOUNDARY",
         "SURFACE",
         "ASSEMBLY",
         "DLOAD",
         "CLOAD",
         "TEMPERATURE",
         "FILM",
         "DFLUX",
         "CFLUX",
         "EQUATION",
         "MPC",
         "AMPLITUDE",
         "ORIENTATION",
         "SOLIDSECTION",
         "SHELLSECTION",
         "NGEN",
         "DSLOAD",
         "TRANSFORM",
         "USERELEMENT",
         "PHYSICALCONSTANTS",
         "INITIALCONDITIONS",
         "TIE",
         "RADIATE"}
    );
    const Input input = Input::from_memory("", std::string(head));
    TextLines lines(input, 0, input.size());
    while (const auto line = lines.next()) {
        if (trim(*line).empty() || is_comment(*line)) continue;
        if (!is_keyword(*line)) return false;
        std::string_view rest = trim(*line);
        rest.remove_prefix(1);
        return std::ranges::find(kFirst, squeezed(take_piece(rest))) != kFirst.end();
    }
    return false;
}

}  // namespace feelem::abaqus
