// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_sections.hpp"

#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

namespace feelem::gmsh {
namespace {

/// The line after $MeshFormat: version, 0 or 1 for binary, bytes of a real; then, in binary files, the number
/// one, which shows the byte order.
Coding read_coding(const Input& input, TextLines& lines) {
    auto line = lines.next().value_or(std::string_view{});
    const auto version = parse_double(take_word(line));
    const auto binary = take_integer(line);
    const auto size = take_integer(line);
    if (!version || !binary || !size) {
        throw Error(
            Code::BadStructure, lines.where(), "$MeshFormat needs a version, 0 or 1, and the size of a real"
        );
    }
    Coding coding;
    coding.version = static_cast<int>(std::lround(std::clamp(*version, 0.0, 99.0) * 10));
    coding.binary = *binary == 1;
    const bool known =
        (coding.version >= 20 && coding.version <= 22) || coding.version == 40 || coding.version == 41;
    if (!known || *size != 8) {
        throw Error(
            Code::BadStructure,
            lines.where(),
            fmt::format(
                "a .msh file of version {:g} with reals of {} bytes; versions 2.0 to 2.2, 4.0 and 4.1 with 8 "
                "are "
                "read. gmsh FILE -save -format msh41 -o NEW.msh converts it.",
                *version,
                *size
            )
        );
    }
    if (!coding.binary) return coding;
    ByteReader reader(input, lines.offset());
    const auto one = reader.read<std::uint32_t>();
    if (one != 1 && one != 0x01000000U)
        throw Error(
            Code::BadStructure, input.where_byte(lines.offset()), "no number one to show the byte order"
        );
    coding.swap = one != 1;
    return coding;
}

}  // namespace

Layout find_sections(const Input& input, Diagnostics& diagnostics) {
    const std::string_view text = input.text();
    Layout layout;
    bool has_format = false;
    std::size_t at = 0;
    while (at < text.size()) {
        TextLines lines(input, at, text.size());
        const std::string_view line = trim(lines.next().value_or(std::string_view{}));
        at = lines.offset();
        if (!line.starts_with('$') || line.starts_with("$End")) continue;
        const std::string name(line.substr(1));
        const std::size_t first = at;
        if (name == "MeshFormat") {
            layout.coding = read_coding(input, lines);
            has_format = true;
        }
        // Bytes of a binary section may look like anything, but not by chance like its own end.
        const std::size_t end = text.find("$End" + name, first);
        if (end == std::string_view::npos) {
            diagnostics.add(
                Code::TruncatedInput,
                [&] { return input.where_line(first); },
                fmt::format(
                    "section ${} has no end: the file was not written or copied whole", name.substr(0, 40)
                )
            );
            break;
        }
        if (name != "MeshFormat") layout.sections.push_back({name, first, end});
        at = end;
    }
    if (!has_format)
        throw Error(Code::BadStructure, input.name(), "no whole $MeshFormat section in the file");
    return layout;
}

std::size_t Numbers::count(std::int64_t value, std::size_t least) const {
    if (value < 0 || static_cast<std::uint64_t>(value) > (last_ - at_) / least + 1) {
        throw Error(
            Code::Truncated, where(), fmt::format("a count of {} is more than the section can hold", value)
        );
    }
    return static_cast<std::size_t>(value);
}

void Numbers::bad(std::string_view expected) const {
    const std::string_view text = input_->text();
    if (at_ >= last_)
        throw Error(Code::Truncated, where(), fmt::format("the section ends where {} should be", expected));
    throw Error(
        Code::BadNumber,
        where(),
        fmt::format(
            "no {} before \"{}\"", expected, trim(text.substr(at_, std::min<std::size_t>(last_ - at_, 30)))
        )
    );
}

std::string_view Numbers::word() {
    const std::string_view text = input_->text();
    const auto is_blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    while (at_ < last_ && is_blank(text[at_])) ++at_;
    const std::size_t first = at_;
    while (at_ < last_ && !is_blank(text[at_])) ++at_;
    return text.substr(first, at_ - first);
}

std::int64_t Numbers::any_integer() {
    const auto value = parse_integer(word());
    if (!value) bad("a whole number");
    return *value;
}

}  // namespace feelem::gmsh
