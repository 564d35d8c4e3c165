// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_groups.hpp"

#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace feelem::unv {
namespace {

[[noreturn]] void throw_bad_number(const TextLines& lines, std::string text) {
    throw Error(Code::BadNumber, lines.where(), std::move(text));
}

}  // namespace

void read_groups(const Input& input, const Dataset& dataset, std::vector<Group>& groups) {
    TextLines lines(input, dataset.first, dataset.last);
    const bool with_leaves = dataset.number > 2432;  // Two more numbers an entity.
    while (auto line = lines.next()) {
        if (trim(*line).empty()) continue;
        const auto number = take_integer(*line);
        std::int64_t count = 0;
        while (const auto value = take_integer(*line)) count = *value;
        if (!number || count < 0)
            throw_bad_number(lines, "a group's head needs its number and, last, its number of entities");
        Group group;
        group.name = trim(lines.next().value_or(std::string_view{}));
        if (group.name.empty()) group.name = fmt::format("group {}", *number);
        std::string_view rest;
        for (std::int64_t i = 0; i < count; ++i) {
            if (trim(rest).empty()) rest = lines.next().value_or(std::string_view{});
            const auto kind = take_integer(rest);
            const auto id = take_integer(rest);
            if (!kind || !id)
                throw_bad_number(
                    lines,

                    fmt::format("group \"{}\" should list {} entities", group.name, count)
                );
            if (with_leaves) {
                take_word(rest);
                take_word(rest);
            }
            if (*kind == 7) group.nodes.push_back(NodeId{*id});
            if (*kind == 8) group.elements.push_back(ElementId{*id});
        }
        groups.push_back(std::move(group));
    }
}

}  // namespace feelem::unv
