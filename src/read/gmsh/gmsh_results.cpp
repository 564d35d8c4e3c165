// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_results.hpp"

#include "model/node_lookup.hpp"
#include "read/element_lookup.hpp"
#include "read/gmsh/gmsh_types.hpp"
#include "read/result_names.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace feelem::gmsh {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t kMostTags = 100;

struct Head {
    std::string name;
    double time = 0;
    std::int64_t step = 0, components = 0, count = 0;
    std::size_t first = 0;
};

/// Heads are lines of text in either coding: a count, then as many tags, one a line.
Head read_head(const Input& input, const Section& section) {
    Head head;
    TextLines lines(input, section.first, section.last);
    const auto line = [&] { return lines.next().value_or(std::string_view{}); };
    const auto count = [&] {
        const auto value = parse_integer(line());
        if (!value || *value < 0 || *value > kMostTags) {
            throw Error(
                Code::BadStructure,
                lines.where(),
                fmt::format("no count of tags in the head of ${}", section.name)
            );
        }
        return *value;
    };
    const std::int64_t strings = count();
    for (std::int64_t i = 0; i < strings; ++i) {
        std::string_view text = trim(line());
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
            text = text.substr(1, text.size() - 2);
        if (i == 0) head.name = text;
    }
    const std::int64_t reals = count();
    for (std::int64_t i = 0; i < reals; ++i) {
        const auto value = parse_double(line());
        if (i == 0 && value) head.time = *value;
    }
    std::int64_t* const tags[]{&head.step, &head.components, &head.count};
    const std::int64_t integers = count();
    for (std::int64_t i = 0; i < integers; ++i) {
        const auto value = parse_integer(line());
        if (i < 3 && value) *tags[i] = *value;
    }
    head.first = lines.offset();
    if (integers < 3 || head.components < 1 || head.components > kMostTags || head.count < 0) {
        throw Error(
            Code::BadStructure,
            lines.where(),
            fmt::format("${} needs a step, a number of components and a count in its head", section.name)
        );
    }
    return head;
}

std::optional<Location> location_of(std::string_view name) {
    if (name == "NodeData") return Location::Nodal;
    if (name == "ElementData") return Location::Elemental;
    if (name == "ElementNodeData") return Location::ElementNodal;
    return {};
}

}  // namespace

Contents list_contents(const Input& input, const Layout& layout) {
    Contents contents;
    std::map<std::pair<std::int64_t, double>, std::uint32_t> steps;
    std::map<std::tuple<std::uint32_t, Location, std::string, std::int64_t>, std::size_t> known;
    std::map<std::int64_t, std::int32_t> substeps;
    ResultNames names;
    for (const Section& section : layout.sections) {
        const auto location = location_of(section.name);
        if (!location) continue;
        const Head head = read_head(input, section);
        const auto [step, is_new] =
            steps.try_emplace({head.step, head.time}, static_cast<std::uint32_t>(contents.steps.size()));
        if (is_new) {
            const auto number = static_cast<std::int32_t>(std::clamp<std::int64_t>(head.step, 0, INT32_MAX));
            contents.steps.push_back({0, number, ++substeps[number], StepKind::Other, head.time, ""});
        }
        const Rows rows{head.first, section.last, static_cast<std::size_t>(head.count)};
        const auto [at, first] =
            known.try_emplace({step->second, *location, head.name, head.components}, contents.results.size());
        if (!first) {
            contents.results[at->second].rows.push_back(rows);
            continue;
        }
        Listed listed;
        listed.rows.push_back(rows);
        const auto components = static_cast<std::size_t>(head.components);
        listed.info.name = common_name(head.name, components);
        listed.info.solver_name = head.name;
        listed.info.step = step->second;
        listed.info.location = *location;
        if (*location == Location::ElementNodal) listed.info.averaging = Averaging::None;
        listed.places = name_components(listed.info, components, TensorOrder::Vtk);
        names.make_unique(listed.info);
        contents.results.push_back(std::move(listed));
    }
    const bool in_time =
        contents.steps.size() > 1 || (contents.steps.size() == 1 && contents.steps.front().value != 0);
    for (Step& step : contents.steps) step.kind = in_time ? StepKind::Time : StepKind::Other;
    return contents;
}

namespace {

class RowReader {
public:
    RowReader(const Listed& listed, const Mesh& mesh)
        : listed_(listed), mesh_(mesh), width_(listed.places.size()) {
        values_.result.info = listed.info;
    }

    LoadedResult read(const Input& input, const Coding& coding) {
        const Location location = listed_.info.location;
        std::vector<float>& out = values_.result.values;
        if (location == Location::Nodal) out.assign(mesh_.node_count() * width_, kMissing);
        if (location == Location::Elemental) out.assign(mesh_.element_count() * width_, kMissing);
        for (const Rows& rows : listed_.rows) {
            Numbers numbers(input, coding, rows.first, rows.last);
            const std::size_t count = numbers.count(static_cast<std::int64_t>(rows.count), 2);
            if (location == Location::Nodal)
                read_nodes(numbers, count);
            else if (location == Location::Elemental)
                read_elements(numbers, count);
            else
                read_element_nodes(numbers, count);
        }
        if (location == Location::ElementNodal) sort_rows_by_owner(values_.result);
        return std::move(values_);
    }

private:
    void read_row(Numbers& numbers, std::size_t nodes = 1) {
        row_.clear();
        for (std::size_t i = 0; i < width_ * nodes; ++i) row_.push_back(numbers.value());
    }

    void store(float* to, std::size_t node = 0) {
        for (std::size_t c = 0; c < width_; ++c) {
            const float value = row_[node * width_ + listed_.places[c]];
            if (!std::isfinite(value)) ++values_.without_number;
            to[c] = std::isfinite(value) ? value : kMissing;
        }
    }

    void read_nodes(Numbers& numbers, std::size_t count) {
        const NodeLookup lookup(mesh_.node_ids);
        for (std::size_t i = 0; i < count; ++i) {
            const NodeIndex node = lookup(NodeId{numbers.integer()});
            read_row(numbers);
            if (node == kNoNode)
                ++values_.without_owner;
            else
                store(&values_.result.values[raw(node) * width_]);
        }
    }

    void read_elements(Numbers& numbers, std::size_t count) {
        const ElementLookup lookup(mesh_);
        for (std::size_t i = 0; i < count; ++i) {
            const ElementIndex element = lookup(ElementId{numbers.integer()});
            read_row(numbers);
            if (element == kNoElement)
                ++values_.without_owner;
            else
                store(&values_.result.values[raw(element) * width_]);
        }
    }

    void read_element_nodes(Numbers& numbers, std::size_t count) {
        const ElementLookup lookup(mesh_);
        for (std::size_t i = 0; i < count; ++i) {
            const ElementIndex element = lookup(ElementId{numbers.integer()});
            const std::size_t nodes = numbers.count(numbers.integer(), 2);
            if (nodes > 1000) numbers.bad("a number of nodes");
            read_row(numbers, nodes);
            if (element == kNoElement || !add_element(element, nodes)) ++values_.without_owner;
        }
    }

    bool add_element(ElementIndex element, std::size_t count) {
        const ElementRef ref = element_at(mesh_, element);
        const ElementRow& row = element_row(ref.block->type);
        if (count != row.node_count && count != row.corner_count) return false;
        const auto order = file_order(ref.block->type);
        const auto nodes = ref.nodes();
        for (std::size_t i = 0; i < count; ++i) {
            if (nodes[i] == kNoNode) continue;
            values_.result.row_owner.push_back(raw(element));
            values_.result.row_node.push_back(nodes[i]);
            values_.result.values.resize(values_.result.values.size() + width_);
            store(&*(values_.result.values.end() - std::ssize(listed_.places)), order.empty() ? i : order[i]);
        }
        return true;
    }

    const Listed& listed_;
    const Mesh& mesh_;
    std::size_t width_;
    std::vector<float> row_;
    LoadedResult values_;
};

}  // namespace

LoadedResult read_values(const Input& input, const Coding& coding, const Listed& listed, const Mesh& mesh) {
    return RowReader(listed, mesh).read(input, coding);
}

}  // namespace feelem::gmsh
