// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_remarks.hpp"

#include "base/number.hpp"
#include "read/ansys/cdb_commands.hpp"

#include <algorithm>

namespace feelem::ansys::cdb {
namespace {

std::optional<std::string_view> behind(std::string_view text, std::string_view words) {
    const std::size_t at = text.find(words);
    if (at == std::string_view::npos) return std::nullopt;
    return text.substr(at + words.size());
}

/// Up to the next label or three blanks.
std::string_view first_entry(std::string_view text) {
    text = text.substr(std::min(text.find_first_not_of(' '), text.size()));
    return trim(text.substr(0, std::min({text.find("BUILD"), text.find("   "), text.size()})));
}

}  // namespace

std::optional<std::string_view> unit_system_in(std::string_view remark) {
    const auto system = behind(remark, "Data in consistent ");
    if (!system) return std::nullopt;
    return system->substr(0, system->find(' '));
}

std::optional<std::string_view> body_in(std::string_view remark) {
    const auto body = behind(remark, "Elements for Body ");
    if (!body) return std::nullopt;
    const std::size_t first = body->find('"');
    const std::size_t last = body->rfind('"');
    if (first == std::string_view::npos || last == first) return std::string_view{};
    return body->substr(first + 1, last - first - 1);
}

std::optional<std::string> release_in(std::string_view remark) {
    if (const auto version = behind(remark, "written by Workbench version "))
        return std::string(trim(*version));
    const auto release = behind(remark, "ANSYS RELEASE");
    if (!release) return std::nullopt;
    // Where no release has a name, the columns up to BUILD are blank.
    const std::string_view label = trim(release->substr(0, release->find("BUILD")));
    std::string_view version = label.empty() ? behind(*release, "BUILD").value_or("") : label;
    if (upper_case(version.substr(0, 8)) == "RELEASE ") version = version.substr(8);
    return std::string(first_entry(version));
}

}  // namespace feelem::ansys::cdb
