// SPDX-License-Identifier: Apache-2.0
// Lines of APDL: commands with comma-separated fields, and the parameters that Workbench puts into them.
#pragma once

#include "base/letter_case.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::ansys::cdb {

/// One command; views into its line.
class Command {
public:
    /// `text`: without comment, one command only.
    explicit Command(std::string_view text);

    /// Whether it is this one. As in the solver, four letters tell (five with / or *): KEYOP is KEYOPT.
    bool is(std::string_view name) const;
    /// Fields behind the name, from 1, trimmed; empty where there is none.
    std::string_view operator[](std::size_t field) const;
    /// Everything behind the first comma or blank.
    std::string_view rest() const { return rest_; }
    /// In capitals, at most eight letters.
    std::string_view name() const { return {name_.data(), name_length_}; }
    std::size_t field_count() const { return count_; }

private:
    static constexpr std::size_t kMostFields = 24;
    std::array<char, 8> name_{};
    std::size_t name_length_ = 0;
    std::string_view rest_;
    std::array<std::string_view, kMostFields> fields_{};
    std::size_t count_ = 0;
};

/// Without the comment behind an exclamation mark that stands in no quotes.
std::string_view without_comment(std::string_view line);

/// Calls with each command of a line that $ joins.
template <class Take>
void for_each_command(std::string_view line, const Take& take) {
    while (!line.empty()) {
        const std::size_t end = line.find('$');
        take(line.substr(0, end));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end + 1);
    }
}

/// Scalar parameters with a number: *SET,CID,3 and CID=3.
class Parameters {
public:
    /// CID=3. False when the text is no assignment.
    bool take_assignment(std::string_view text);
    void set(std::string_view name, std::string_view value);
    void forget(std::string_view name);
    /// A number, or the value of a parameter. Empty field: 0. Empty result: neither.
    std::optional<double> real(std::string_view field) const;
    std::optional<std::int64_t> integer(std::string_view field) const;

private:
    std::map<std::string, double, std::less<>> values_;
};

}  // namespace feelem::ansys::cdb
