// SPDX-License-Identifier: Apache-2.0
// A command of the program: one row of the list in commands.cpp.
#pragma once

#include "feelem/convert.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::cli {

/// Everything a command line can say. Each command uses its part.
struct Options {
    Job job;
    bool json = false;
    bool verbose = false;
    unsigned threads = 0;             ///< 0: all.
    std::vector<std::string> making;  ///< Names of given options that say how a scene is made.
    // probe
    std::optional<std::int64_t> node;
    std::optional<Point3> point;
    std::optional<std::array<double, 6>> ray;
    // view
    int port = 8322;
    bool port_given = false;
    bool lan = false;
    std::string certificate_file, key_file;
    bool open_browser = true;
};

/// Groups of options that a command takes.
enum class Takes : std::uint16_t {
    Nothing = 0,
    Inputs = 1,
    Output = 2,
    Model = 4,     ///< Units, skin, steps, results ...
    Reading = 64,  ///< How inputs are read.
    Json = 8,
    Place = 16,
    Serving = 32,
    Brief = 128,
    Levels = 256,
};
constexpr Takes operator|(Takes a, Takes b) {
    return static_cast<Takes>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(Takes set, Takes one) {
    return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

struct Command {
    std::string_view name;
    std::string_view summary;
    std::string_view usage;  ///< What follows the name, without options.
    Takes takes;
    /// Returns the exit code: 0 done, 1 the data cannot be used.
    int (*run)(const Options& options);
};
std::span<const Command> commands();

int run_convert(const Options& options);
int run_info(const Options& options);
int run_view(const Options& options);
int run_probe(const Options& options);
int run_check(const Options& options);
int run_formats(const Options& options);
int run_doctor(const Options& options);

/// The command line is wrong: exit code 2. The text ends with a hint.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace feelem::cli
