// SPDX-License-Identifier: Apache-2.0
// The .case file of EnSight: which files it names, at which step.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::exchange {

struct EnsightCase {
    struct File {
        std::string pattern;  ///< A run of * stands for the number of the step.
        int time_set = 0;     ///< 0: the case names none.
    };
    struct Variable {
        std::string name;
        bool nodal = true;
        bool measured = false;
        File file;
    };
    struct TimeSet {
        std::size_t steps = 0;
        std::vector<int> numbers;   ///< In names of files.
        std::vector<double> times;  ///< One a step.
    };

    bool is_gold = false;
    File geometry;
    std::vector<Variable> variables;
    std::map<int, TimeSet> time_sets;
};

/// Knows no errors: what it does not understand is left to VTK.
EnsightCase read_ensight_case(std::string_view text);

/// Names of all files of all steps, each once, in order. Throws Error(TooLarge) beyond 100,000 files or 16
/// MiB.
std::vector<std::string> files_of(const EnsightCase& all);

/// The name at a time: that of the last step which is not later.
std::string file_at(const EnsightCase& all, const EnsightCase::File& file, double time);

/// Whether a file is text, by its beginning.
bool is_ensight_text(std::string_view bytes);

/// What is wrong with a text file's end or its numbers of lines, which VTK does not notice: it takes 0 for
/// lines that are not there. Empty: nothing.
std::string trouble_of_ensight_end(std::string_view text);
std::string trouble_of_ensight_geometry(std::string_view text);

/// How many values a text file of a variable holds. -1: they cannot be counted (several steps, partial
/// parts).
std::ptrdiff_t count_ensight_values(std::string_view text);

}  // namespace feelem::exchange
