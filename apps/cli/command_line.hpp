// SPDX-License-Identifier: Apache-2.0
// The command line as options: the only user of CLI11.
#pragma once

#include "command.hpp"

#include <optional>
#include <string>
#include <vector>

namespace feelem::cli {

/// A command and its options, or a text to print instead (--help, --version).
struct ParsedLine {
    const Command* command = nullptr;
    Options options;
    std::optional<std::string> text;
};

/// `arguments` without the program's name. Throws UsageError.
ParsedLine parse_command_line(std::vector<std::string> arguments);

}  // namespace feelem::cli
