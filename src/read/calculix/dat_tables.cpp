// SPDX-License-Identifier: Apache-2.0
#include "read/calculix/dat_tables.hpp"

#include "read/result_names.hpp"
#include "read/text_lines.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace feelem::dat {
namespace {

constexpr std::size_t kMostColumns = 256;
constexpr std::string_view kSet = " for set ", kTime = " and time ";

std::vector<std::string> split_commas(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        words.emplace_back(trim(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// The head of a table that holds a row a node or element.
std::optional<Table> parse_head(std::string_view line) {
    const std::size_t set = line.find(kSet);
    const std::size_t time = line.find(kTime, std::min(set, line.size()));
    if (set == std::string_view::npos || time == std::string_view::npos) return {};
    const auto value = parse_double(line.substr(time + kTime.size()));
    std::string_view title = trim(line.substr(0, set));
    if (!value || title.starts_with("total") || title.starts_with("statistics")) return {};
    Table table;
    table.time = *value;
    const std::size_t open = title.find('(');
    if (open != std::string_view::npos && title.ends_with(')')) {
        table.components = split_commas(title.substr(open + 1, title.size() - open - 2));
        title = trim(title.substr(0, open));
    }
    table.label = std::string(title);
    const auto take_front = [&](const auto& is) {
        if (table.components.empty() || !is(table.components.front())) return false;
        table.components.erase(table.components.begin());
        return true;
    };
    table.of_elements =
        take_front([](const std::string& word) { return word == "elem" || word == "element"; });
    table.has_points = take_front([](const std::string& word) { return word.starts_with("integ"); });
    return table;
}

bool starts_with_number(std::string_view line) {
    return parse_integer(take_word(line)).has_value();
}

/// "S T E P       3" -> 3.
std::optional<std::int32_t> number_behind(std::string_view line, std::string_view words) {
    line = trim(line);
    if (!line.starts_with(words)) return {};
    line.remove_prefix(words.size());
    const auto number = take_integer(line);
    if (!number || *number < 0 || *number > INT32_MAX) return {};
    return static_cast<std::int32_t>(*number);
}

void look_at_row(Table& table, std::string_view row) {
    if (table.rows++ > 0) return;
    take_word(row);
    if (table.has_points) take_word(row);
    for (std::string_view word = take_word(row); !word.empty(); word = take_word(row)) {
        const bool is_name = !parse_double(word).has_value();
        table.is_local = table.is_local || is_name;
        if (is_name || table.columns >= kMostColumns) break;
        ++table.columns;
    }
}

struct Known {
    std::string_view label, ours;
    Shear shear = Shear::NotApplicable;
};
constexpr Known kKnown[]{
    {"displacements", "displacement"},
    {"velocities", "velocity"},
    {"accelerations", "acceleration"},
    {"forces", "reaction_force"},
    {"temperatures", "temperature"},
    {"stresses", "stress"},
    {"strains", "strain", Shear::Tensor},
    {"mechanical strains", "mechanical_strain", Shear::Tensor},
    {"heat flux", "heat_flux"},
    {"equivalent plastic strain", "plastic_strain"},
};

class Lister {
public:
    explicit Lister(const std::vector<Table>& tables) : tables_(tables) {}

    Contents list() {
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            const Table& table = tables_[i];
            const std::uint32_t step = step_of(table);
            // Nodes with six degrees of freedom: a displacement and a rotation.
            const bool both = table.label == "displacements" && table.columns == 6;
            add(i, step, both ? "displacements" : table.label, 0, both ? 3 : table.columns);
            if (both) add(i, step, "rotations", 3, 3);
        }
        ResultNames names;
        for (Listed& listed : contents_.results) names.make_unique(listed.info);
        return std::move(contents_);
    }

private:
    std::uint32_t step_of(const Table& table) {
        const auto [found, is_new] = steps_.try_emplace(
            {table.step, table.increment, table.time}, static_cast<std::uint32_t>(contents_.steps.size())
        );
        if (is_new)
            contents_.steps.push_back({0, table.step, table.increment, StepKind::Other, table.time, ""});
        return found->second;
    }

    void add(
        std::size_t index, std::uint32_t step, const std::string& label, std::size_t first, std::size_t count
    ) {
        const Table& table = tables_[index];
        // Tables of one quantity for several sets are one result.
        const auto [found, is_new] =
            by_label_.try_emplace({step, label, table.of_elements, count}, contents_.results.size());
        if (!is_new) {
            contents_.results[found->second].tables.push_back(index);
            return;
        }
        Listed listed;
        listed.tables.push_back(index);
        ResultInfo& info = listed.info;
        info.step = step;
        const auto* known = std::ranges::find(kKnown, label, &Known::label);
        info.name = known != std::end(kKnown) ? std::string(known->ours) : plain_name(label);
        if (known != std::end(kKnown)) info.shear = known->shear;
        info.solver_name = table.has_points ? label + " (mean of integration points)" : label;
        info.location = table.of_elements ? Location::Elemental : Location::Nodal;
        name_columns(listed, table, first, count);
        contents_.results.push_back(std::move(listed));
    }

    static std::string plain_name(const std::string& label) {
        std::string name = lower_name(label);
        std::ranges::replace(name, ' ', '_');
        return name == "rotations" ? "rotation" : name;
    }

    static void name_columns(Listed& listed, const Table& table, std::size_t first, std::size_t count) {
        ResultInfo& info = listed.info;
        for (std::size_t i = 0; i < count; ++i)
            listed.columns.push_back(static_cast<std::uint32_t>(first + i));
        if (count == 1) {
            info.components = {"value"};
        } else if (count == 3) {
            info.shape = Shape::Vector;
            info.components = {"x", "y", "z"};
        } else if (count == 6) {
            // Printed as xx yy zz xy xz yz.
            info.shape = Shape::SymmetricTensor;
            info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
            std::swap(listed.columns[4], listed.columns[5]);
        } else {
            info.shape = Shape::Other;
            for (std::size_t i = 0; i < count; ++i) {
                const bool named = table.components.size() == count;
                info.components.push_back(
                    named ? lower_name(table.components[i]) : "v" + std::to_string(i + 1)
                );
            }
        }
    }

    const std::vector<Table>& tables_;
    Contents contents_;
    std::map<std::tuple<std::int32_t, std::int32_t, double>, std::uint32_t> steps_;
    std::map<std::tuple<std::uint32_t, std::string, bool, std::size_t>, std::size_t> by_label_;
};

}  // namespace

std::vector<Table> find_tables(const Input& input) {
    std::vector<Table> tables;
    std::int32_t step = 1, increment = 1;
    bool inside = false;
    TextLines lines(input, 0, input.size());
    while (const auto line = lines.next()) {
        if (trim(*line).empty()) continue;
        if (inside && starts_with_number(*line)) {
            look_at_row(tables.back(), *line);
            tables.back().end = lines.offset();
            continue;
        }
        inside = false;
        if (const auto number = number_behind(*line, "S T E P")) step = *number;
        if (const auto number = number_behind(*line, "INCREMENT")) increment = *number;
        if (auto table = parse_head(*line)) {
            table->step = step;
            table->increment = increment;
            table->begin = table->end = lines.offset();
            tables.push_back(std::move(*table));
            inside = true;
        }
    }
    std::erase_if(tables, [](const Table& table) { return table.rows == 0 || table.columns == 0; });
    return tables;
}

bool starts_like_tables(std::string_view head) {
    const Input input = Input::from_memory("", std::string(head.substr(0, 4096)));
    TextLines lines(input, 0, input.size());
    while (const auto line = lines.next()) {
        const std::string_view text = trim(*line);
        if (text.empty()) continue;
        // Abaqus' own tables say more behind the number: "S T E P  1  S T A T I C".
        const bool step = number_behind(text, "S T E P ") && parse_integer(trim(text.substr(8)));
        return step || text.starts_with("E I G E N V A L U E ") ||
               (text.find(kSet) != std::string_view::npos && text.find(kTime) != std::string_view::npos);
    }
    return false;
}

Contents list_tables(const std::vector<Table>& tables) {
    return Lister(tables).list();
}

}  // namespace feelem::dat
