// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/ensight_case.hpp"

#include "base/number.hpp"
#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <utility>

namespace feelem::exchange {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostSteps = 10'000;

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trim(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

Words words_of(std::string_view line) {
    Words words;
    for (auto word = take_word(line); !word.empty(); word = take_word(line)) words.push_back(word);
    return words;
}

int small_integer(std::string_view word) {
    const auto value = parse_integer(word);
    return value && *value >= 0 && *value < 1'000'000'000 ? static_cast<int>(*value) : -1;
}

/// Takes "time set, file set" from the front, as long as `names` words are left behind them.
int take_sets(Words& words, std::size_t names) {
    int time_set = 0;
    for (int i = 0; i < 2 && words.size() > names && small_integer(words.front()) >= 0; ++i) {
        if (i == 0) time_set = small_integer(words.front());
        words.erase(words.begin());
    }
    return time_set;
}

class CaseReader {
public:
    EnsightCase read(std::string_view text) {
        while (!text.empty()) {
            const std::string_view line = next_line(text);
            if (line.empty() || line.starts_with("#")) continue;
            const std::size_t colon = line.find(':');
            if (colon == std::string_view::npos)
                read_more(line);
            else
                read_entry(trim(line.substr(0, colon)), words_of(line.substr(colon + 1)));
        }
        for (auto& [id, set] : case_.time_sets) complete(id, set);
        return std::move(case_);
    }

private:
    void read_entry(std::string_view key, Words words) {
        list_ = nullptr;
        if (key == "type") {
            case_.is_gold = std::ranges::find(words, "gold") != words.end();
        } else if (key == "model") {
            if (!words.empty() && words.back() == "change_coords_only") words.pop_back();
            const int time_set = take_sets(words, 1);
            if (!words.empty()) case_.geometry = {std::string(words.front()), time_set};
        } else if (key.find(" per ") != std::string_view::npos) {
            read_variable(key, std::move(words));
        } else {
            read_time(key, words);
        }
    }

    void read_variable(std::string_view key, Words words) {
        if (key.starts_with("constant")) return;
        const bool complex = key.starts_with("complex");
        const int time_set = take_sets(words, complex ? 3 : 2);
        for (std::size_t i = 1; i < words.size() && i < (complex ? 3U : 2U); ++i) {
            EnsightCase::Variable variable;
            variable.name = complex ? "" : std::string(words[0]);
            variable.nodal = key.ends_with("node");
            variable.measured = key.find("measured") != std::string_view::npos;
            variable.file = {std::string(words[i]), time_set};
            case_.variables.push_back(std::move(variable));
        }
    }

    void read_time(std::string_view key, const Words& words) {
        if (words.empty()) return;
        if (key == "time set") {
            id_ = small_integer(words.front());
            case_.time_sets[id_];
            return;
        }
        if (key == "number of steps") {
            const int steps = small_integer(words.front());
            case_.time_sets[id_].steps = std::min(static_cast<std::size_t>(std::max(steps, 0)), kMostSteps);
        } else if (key == "filename start number") {
            first_[id_].first = small_integer(words.front());
        } else if (key == "filename increment") {
            first_[id_].second = small_integer(words.front());
        } else if (key == "filename numbers" || key == "time values") {
            list_ = key == "time values" ? &read_times : &read_numbers;
            list_(case_.time_sets[id_], words);
        }
    }

    /// Lists go on in the lines below.
    void read_more(std::string_view line) {
        if (list_ != nullptr) list_(case_.time_sets[id_], words_of(line));
    }

    static void read_times(EnsightCase::TimeSet& set, const Words& words) {
        for (const std::string_view word : words) {
            const auto time = parse_double(word);
            if (time && set.times.size() < kMostSteps) set.times.push_back(*time);
        }
    }
    static void read_numbers(EnsightCase::TimeSet& set, const Words& words) {
        for (const std::string_view word : words) {
            const int number = small_integer(word);
            if (number >= 0 && set.numbers.size() < kMostSteps) set.numbers.push_back(number);
        }
    }

    void complete(int id, EnsightCase::TimeSet& set) {
        const auto [first, by] = first_.contains(id) ? first_[id] : std::pair(0, 1);
        for (std::size_t i = set.numbers.size(); i < set.steps && first >= 0 && by >= 0; ++i)
            set.numbers.push_back(static_cast<int>((first + static_cast<long>(i) * by) % 1'000'000'000));
    }

    EnsightCase case_;
    int id_ = 1;
    std::map<int, std::pair<int, int>> first_;  ///< Start and increment of numbers in names.
    void (*list_)(EnsightCase::TimeSet&, const Words&) = nullptr;
};

std::string numbered(const std::string& pattern, int number) {
    const std::size_t first = pattern.find('*');
    if (first == std::string::npos) return pattern;
    const std::size_t end = std::min(pattern.find_first_not_of('*', first), pattern.size());
    return pattern.substr(0, first) + fmt::format("{:0{}}", number, end - first) + pattern.substr(end);
}

const EnsightCase::TimeSet* set_of(const EnsightCase& all, const EnsightCase::File& file) {
    if (all.time_sets.empty()) return nullptr;
    const auto named = all.time_sets.find(file.time_set);
    return named != all.time_sets.end() ? &named->second : &all.time_sets.begin()->second;
}

bool begins_word(std::string_view line) {
    return std::isalpha(static_cast<unsigned char>(line.front())) != 0 && !line.starts_with("nan") &&
           !line.starts_with("inf") && !line.starts_with("NaN") && !line.starts_with("Inf");
}

}  // namespace

EnsightCase read_ensight_case(std::string_view text) {
    return CaseReader().read(text);
}

std::vector<std::string> files_of(const EnsightCase& all) {
    constexpr std::size_t kMostFiles = 100'000, kMostBytes = std::size_t{16} << 20;
    std::vector<std::string> names;
    std::set<std::string, std::less<>> known;
    std::size_t bytes = 0, asked = 0;
    const auto add = [&](const EnsightCase::File& file) {
        const EnsightCase::TimeSet* const set = set_of(all, file);
        const bool series = file.pattern.find('*') != std::string::npos && set != nullptr;
        for (std::size_t i = 0; i < (series ? set->numbers.size() : 1U); ++i) {
            bytes += file.pattern.size();
            if (++asked > kMostFiles || bytes > kMostBytes)
                throw Error(
                    Code::TooLarge, "", "the case names more files than any real one: 100,000 are read"
                );
            std::string name = series ? numbered(file.pattern, set->numbers[i]) : file.pattern;
            if (!name.empty() && known.insert(name).second) names.push_back(std::move(name));
        }
    };
    add(all.geometry);
    for (const EnsightCase::Variable& variable : all.variables) add(variable.file);
    return names;
}

std::string file_at(const EnsightCase& all, const EnsightCase::File& file, double time) {
    const EnsightCase::TimeSet* const set = set_of(all, file);
    if (set == nullptr || set->numbers.empty()) return file.pattern;
    std::size_t at = 0;
    while (at + 1 < set->numbers.size() && at + 1 < set->times.size() && set->times[at + 1] <= time) ++at;
    return numbered(file.pattern, set->numbers[at]);
}

bool is_ensight_text(std::string_view bytes) {
    const std::string_view head = bytes.substr(0, 400);
    return head.find('\0') == std::string_view::npos && head.find('\n') != std::string_view::npos;
}

std::string trouble_of_ensight_end(std::string_view text) {
    return text.empty() || text.back() == '\n' ? "" : "its last line does not end: it was cut";
}

namespace {

/// Goes through a geometry file line by line.
class GeometryWalk {
public:
    explicit GeometryWalk(std::string_view text) : text_(text) {}

    std::string trouble() {
        next_line(text_);
        next_line(text_);
        has_node_ids_ = lists_ids(next_line(text_));
        has_element_ids_ = lists_ids(next_line(text_));
        while (!text_.empty() && trouble_.empty()) {
            const std::string_view line = next_line(text_);
            if (line.empty()) continue;
            if (line.starts_with("BEGIN") || line.starts_with("block")) return {};
            if (line.starts_with("extents")) {
                skip(3);
            } else if (line.starts_with("part")) {
                skip(1);
                next_line(text_);
            } else if (line.starts_with("coordinates")) {
                const std::size_t nodes = number();
                skip((has_node_ids_ ? 4 : 3) * nodes);
            } else {
                walk_elements(line);
            }
        }
        return trouble_;
    }

private:
    static bool lists_ids(std::string_view line) {
        return line.ends_with("given") || line.ends_with("ignore");
    }

    void walk_elements(std::string_view type) {
        const std::size_t elements = number();
        if (has_element_ids_) skip(elements);
        if (type.find("nsided") != std::string_view::npos) {
            skip(elements);
        } else if (type.find("nfaced") != std::string_view::npos) {
            std::size_t faces = 0;
            for (std::size_t i = 0; i < elements && trouble_.empty(); ++i) faces += number();
            skip(faces);
            skip(faces);
            return;
        }
        skip(elements);
    }

    std::size_t number() {
        if (text_.empty()) trouble_ = "it ends too early: it was cut";
        const std::string_view line = next_line(text_);
        const int value = small_integer(line);
        if (value < 0 && trouble_.empty())
            trouble_ = fmt::format("\"{}\" stands where a number should be", line.substr(0, 40));
        return static_cast<std::size_t>(std::max(value, 0));
    }

    void skip(std::size_t lines) {
        for (std::size_t i = 0; i < lines && trouble_.empty(); ++i) {
            if (text_.empty()) trouble_ = "it ends too early: it was cut";
            const std::string_view line = next_line(text_);
            if (!line.empty() && begins_word(line))
                trouble_ = fmt::format("\"{}\" stands where a number should be", line.substr(0, 40));
        }
    }

    std::string_view text_;
    std::string trouble_;
    bool has_node_ids_ = false, has_element_ids_ = false;
};

}  // namespace

std::string trouble_of_ensight_geometry(std::string_view text) {
    return GeometryWalk(text).trouble();
}

std::ptrdiff_t count_ensight_values(std::string_view text) {
    next_line(text);
    std::ptrdiff_t count = 0;
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        if (line.empty()) continue;
        if (!begins_word(line)) {
            count += static_cast<std::ptrdiff_t>(words_of(line).size());
            continue;
        }
        if (line.starts_with("BEGIN") || line.find("partial") != std::string_view::npos) return -1;
        // The number of the part, the value that means none.
        if (line.starts_with("part") || line.ends_with("undef")) next_line(text);
    }
    return count;
}

}  // namespace feelem::exchange
