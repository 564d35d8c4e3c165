// SPDX-License-Identifier: Apache-2.0
// Commands that make one node or one element: N, E, EN, EMORE, as people and CDWRITE,,,,,,UNBLOCKED write
// them.
#pragma once

#include "read/ansys/cdb_commands.hpp"
#include "read/ansys/cdb_deck.hpp"

#include <functional>
#include <string>

namespace feelem::ansys::cdb {

/// What earlier commands set for those that follow.
struct Settings {
    Parameters parameters;
    bool has_type = false;       ///< TYPE was given,
    std::int64_t type = 1;       ///< with this number.
    std::int64_t last_type = 1;  ///< Of the last ET.
    std::int64_t material = 1;
    std::int64_t system = 0;  ///< Of CSYS.
    std::string body;
    int loops = 0;  ///< *DO around this place.
};

/// Into the table; KEYOPT(1) tells the shape of MESH200. False for a number that is none.
bool define_type(std::int64_t number, std::string_view name, std::int64_t keyopt1, TypeTable& types);
/// ET,number,name,KEYOPT(1). False when the number cannot be had.
bool take_type(const Command& command, Settings& settings, TypeTable& types);
/// KEYOPT,number,option,value
void take_key_option(const Command& command, const Parameters& parameters, TypeTable& types);

class SingleCommands {
public:
    SingleCommands(Deck& deck, const Settings& settings, Diagnostics& diagnostics)
        : deck_(deck), settings_(settings), diagnostics_(diagnostics) {}

    /// False when the command is another one.
    bool take(const Command& command, std::size_t input, std::size_t offset);

private:
    void take_node(const Command& command);
    void take_numbered_element(const Command& command);
    void add_element(std::int64_t id, std::int64_t type, std::int64_t material);
    void add_nodes(const Command& command, std::size_t first);
    void left_out(const Command& command);
    void note_system();

    Deck& deck_;
    const Settings& settings_;
    Diagnostics& diagnostics_;
    std::size_t input_ = 0;
    std::size_t offset_ = 0;
    bool open_element_ = false;  ///< Further nodes may follow.
};

}  // namespace feelem::ansys::cdb
