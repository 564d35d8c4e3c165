// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_singles.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>

namespace feelem::ansys::cdb {
namespace {

constexpr std::size_t kMostNodes = 64;

/// N,R5.3,LOC,... (N,UNBL,LOC,... since 2020) instead of N,1,...
bool is_of_solver(const Command& command) {
    const std::string first = upper_case(command[1]);
    return first.starts_with("R5") || first == "UNBL";
}

constexpr std::int64_t kMostNumber = std::numeric_limits<std::int32_t>::max();

}  // namespace

bool define_type(std::int64_t number, std::string_view name, std::int64_t keyopt1, TypeTable& types) {
    if (number < 1 || number > kMostNumber || name.empty()) return false;
    TypeShape& type = types[static_cast<int>(number)];
    type.element = find_element(name);
    type.name = type.element ? std::string(type.element->name) : upper_case(name);
    type.keyopt1 = keyopt1 >= 0 && keyopt1 <= kMostNumber ? static_cast<int>(keyopt1) : 0;
    return true;
}

bool take_type(const Command& command, Settings& settings, TypeTable& types) {
    const auto number =
        command[1].empty() ? std::optional(settings.last_type + 1) : settings.parameters.integer(command[1]);
    const auto keyopt1 = settings.parameters.integer(command[3]);
    if (!number || !define_type(*number, command[2], keyopt1.value_or(0), types)) return false;
    settings.last_type = *number;
    return true;
}

void take_key_option(const Command& command, const Parameters& parameters, TypeTable& types) {
    const auto number = parameters.integer(command[1]).value_or(0);
    const auto option = parameters.integer(command[2]).value_or(0);
    const auto value = parameters.integer(command[3]).value_or(0);
    if (option != 1 || number < 1 || number > kMostNumber || value < 0 || value > kMostNumber) return;
    const auto type = types.find(static_cast<int>(number));
    if (type != types.end()) type->second.keyopt1 = static_cast<int>(value);
}

bool SingleCommands::take(const Command& command, std::size_t input, std::size_t offset) {
    input_ = input;
    offset_ = offset;
    if (command.is("N")) {
        take_node(command);
    } else if (command.is("E")) {
        add_element(0, settings_.type, settings_.material);
        add_nodes(command, 1);
    } else if (command.is("EN")) {
        take_numbered_element(command);
    } else if (command.is("EMORE")) {
        add_nodes(command, 1);
    } else {
        return false;
    }
    return true;
}

void SingleCommands::left_out(const Command& command) {
    diagnostics_.add(
        Code::UnknownBlock,
        [&] { return deck_.inputs[input_].where_line(offset_); },
        fmt::format(
            "{} commands stand in loops or use parameters whose values Feelem does not know: they are left "
            "out",
            command.name()
        )
    );
}

void SingleCommands::note_system() {
    diagnostics_.add(
        Code::CoordinateSystem,
        [&] { return deck_.inputs[input_].where_line(offset_); },
        fmt::format(
            "nodes are given in coordinate system {} (CSYS): taken as they stand, the shape is wrong. "
            "CDWRITE writes "
            "them in the global one.",
            settings_.system
        )
    );
}

/// N,number,x,y,z,THXY,THYZ,THZX; by the solver N,R5.3,LOC,number,entity,line,x,y,z and N,R5.3,ANG,number,...
void SingleCommands::take_node(const Command& command) {
    const bool of_solver = is_of_solver(command);
    const std::size_t number_at = of_solver ? 3 : 1;
    std::size_t real_at = number_at + 1;
    // Entity and line have no point.
    while (of_solver && real_at < 6 && !command[real_at].empty() &&
           command[real_at].find('.') == std::string_view::npos)
        ++real_at;
    // Without a number it is the next after the highest: 0 until that is known.
    const auto number = settings_.parameters.integer(command[number_at]).value_or(-1);
    if (of_solver && number < 0) return;  // The end of a block.
    std::array<double, 6> reals{};
    for (std::size_t i = 0; i < reals.size(); ++i) {
        const auto real = settings_.parameters.real(command[real_at + i]);
        if (!real || number < 0 || settings_.loops > 0) return left_out(command);
        reals[i] = *real;
    }
    if (of_solver && upper_case(command[2]) == "ANG") {
        if (!deck_.nodes.empty() && deck_.nodes.back().id == number)
            deck_.nodes.back().angles = {reals[0], reals[1], reals[2]};
        return;
    }
    if (settings_.system != 0 && !of_solver) note_system();
    deck_.nodes.push_back({number, {reals[0], reals[1], reals[2]}, {reals[3], reals[4], reals[5]}});
}

/// EN,number,i,j,...; by the solver EN,R5.5,ATTR,nodes,material,type,real,section,system,number and
/// EN,R5.5,NODE,i,j,... once or more.
void SingleCommands::take_numbered_element(const Command& command) {
    const Parameters& parameters = settings_.parameters;
    if (!is_of_solver(command)) {
        const auto number = parameters.integer(command[1]).value_or(0);
        if (number < 1) return left_out(command);
        add_element(number, settings_.type, settings_.material);
        return add_nodes(command, 2);
    }
    if (upper_case(command[2]) == "NODE") return add_nodes(command, 3);
    open_element_ = false;
    if (parameters.integer(command[3]).value_or(0) < 0) return;  // The end of a block.
    const auto number = parameters.integer(command[9]).value_or(0);
    if (number < 1) return left_out(command);
    add_element(
        number, parameters.integer(command[5]).value_or(0), parameters.integer(command[4]).value_or(0)
    );
}

void SingleCommands::add_element(std::int64_t id, std::int64_t type, std::int64_t material) {
    deck_.elements.push_back({id, type, material, deck_.element_nodes.size(), 0, input_, offset_});
    open_element_ = true;
}

/// To the last element; without them it is none.
void SingleCommands::add_nodes(const Command& command, std::size_t first) {
    if (!open_element_) return;
    CommandElement& element = deck_.elements.back();
    bool known = settings_.loops == 0;
    for (std::size_t i = first; i <= command.field_count() && element.count < kMostNodes; ++i) {
        const auto node = settings_.parameters.integer(command[i]);
        known = known && node;
        deck_.element_nodes.push_back(node.value_or(0));
        ++element.count;
    }
    if (known) return;
    deck_.element_nodes.resize(element.first);
    deck_.elements.pop_back();
    open_element_ = false;
    left_out(command);
}

}  // namespace feelem::ansys::cdb
