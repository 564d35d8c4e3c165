// SPDX-License-Identifier: Apache-2.0
// Must: read the table in any user-interface language: columns are told apart by place and shape, not by
// words; only the names of results are matched in English. Assumes: the first column is a node or element
// number; places are three columns of one unit that differ in X, Y, Z; a node that is listed once a body
// stands in blocks of ascending numbers, one block a body.
#include "read/ansys/mechanical_export.hpp"

#include "base/letter_case.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem::ansys {
namespace {

constexpr std::size_t kMostColumns = 64;
constexpr std::size_t kMostBodies = 1000;

/// The fields of a line; quotes around a field are dropped.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    line = line.substr(0, std::min(line.find('\0'), line.size()));
    while (fields.size() < kMostColumns) {
        const std::size_t end = std::min(line.find(separator), line.size());
        std::string_view field = trim(line.substr(0, end));
        if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
            field = field.substr(1, field.size() - 2);
        fields.push_back(field);
        if (end == line.size()) break;
        line.remove_prefix(end + 1);
    }
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    return fields;
}

/// Bytes of Latin-1 as UTF-8 when the text is not UTF-8 already.
std::string utf8_of(std::string_view text) {
    std::size_t follow = 0;
    bool valid = true;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (follow > 0) {
            valid = valid && (byte & 0xC0U) == 0x80U;
            --follow;
        } else if (byte >= 0x80U) {
            follow = byte >= 0xF0U ? 3 : byte >= 0xE0U ? 2 : 1;
            valid = valid && byte >= 0xC2U && byte <= 0xF4U;
        }
    }
    if (valid && follow == 0) return std::string(text);
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80U) {
            out += c;
        } else {
            out += static_cast<char>(0xC0U | (byte >> 6U));
            out += static_cast<char>(0x80U | (byte & 0x3FU));
        }
    }
    return out;
}

struct Heading {
    std::string name;
    std::string unit;
};

/// "Equivalent (von-Mises) Stress (MPa)": the unit is in the last brackets, when they end the text.
Heading heading_of(std::string_view text) {
    Heading heading{utf8_of(text), ""};
    const std::size_t open = heading.name.rfind('(');
    if (!heading.name.ends_with(')') || open == std::string::npos || open == 0) return heading;
    heading.unit = trim(std::string_view(heading.name).substr(open + 1, heading.name.size() - open - 2));
    heading.name = std::string(trim(std::string_view(heading.name).substr(0, open)));
    return heading;
}

/// "X Location" "Y Location" "Z Location" in any language: equal but for the axis, with one unit.
bool are_places(const Heading& x, const Heading& y, const Heading& z) {
    if (x.unit != y.unit || x.unit != z.unit || x.name.size() != y.name.size() ||
        x.name.size() != z.name.size())
        return false;
    int axes = 0;
    for (std::size_t i = 0; i < x.name.size(); ++i) {
        const std::array<char, 3> here{x.name[i], y.name[i], z.name[i]};
        if (here == std::array{'X', 'Y', 'Z'} || here == std::array{'x', 'y', 'z'})
            ++axes;
        else if (here[0] != here[1] || here[0] != here[2])
            return false;
    }
    // Components of a deformation have an axis and a length unit too.
    return axes == 1 && x.name.find("eform") == std::string::npos &&
           x.name.find("erform") == std::string::npos;
}

bool has_places(std::span<const std::string_view> headings) {
    return headings.size() > 4 &&
           are_places(heading_of(headings[1]), heading_of(headings[2]), heading_of(headings[3]));
}

template <std::size_t N>
bool has_word(std::string_view heading, const std::array<std::string_view, N>& words) {
    const std::string lower = lower_case(utf8_of(heading));
    return std::ranges::any_of(words, [&](std::string_view word) {
        return lower.find(word) != std::string::npos;
    });
}

/// In the languages of Mechanical; the last ones are Chinese and Japanese.
bool names_elements(std::string_view heading) {
    return has_word(
        heading,
        std::array<std::string_view, 5>{
            "elem", "\u00E9l\u00E9m", "\u5355\u5143", "\u55AE\u5143", "\u8981\u7D20"}
    );
}
bool names_nodes(std::string_view heading) {
    return has_word(
        heading,
        std::array<std::string_view, 8>{
            "node", "knoten", "noeud", "n\u0153ud", "nodo", "\u8282\u70B9", "\u7BC0\u9EDE", "\u7BC0\u70B9"}
    );
}

struct KnownName {
    std::string_view label;
    std::string_view name;
    std::string_view component;
    bool averaged;
};
/// A direction is not in the label of Normal Stress or Directional Deformation: these keep their own names.
constexpr std::array kKnownNames{
    KnownName{"total deformation", "displacement", "magnitude", false},
    KnownName{"directional deformation", "directional_deformation", "value", false},
    KnownName{"total velocity", "velocity", "magnitude", false},
    KnownName{"total acceleration", "acceleration", "magnitude", false},
    KnownName{"temperature", "temperature", "value", false},
    KnownName{"electric voltage", "electric_potential", "value", false},
    KnownName{"equivalent (von-mises) stress", "stress", "von_mises", true},
    KnownName{"equivalent stress", "stress", "von_mises", true},
    KnownName{"maximum principal stress", "stress", "principal_1", true},
    KnownName{"middle principal stress", "stress", "principal_2", true},
    KnownName{"minimum principal stress", "stress", "principal_3", true},
    KnownName{"stress intensity", "stress", "tresca", true},
    KnownName{"equivalent elastic strain", "elastic_strain", "equivalent", true},
    KnownName{"equivalent plastic strain", "plastic_strain", "equivalent", true},
    KnownName{"total heat flux", "heat_flux", "magnitude", true},
};

/// Letters and digits in lower case, the rest as single underscores.
std::string plain_name(std::string_view label) {
    std::string name;
    for (const char c : lower_case(label)) {
        const bool word =
            (c >= 'a' && c <= 'z') || is_digit(c) || (static_cast<unsigned char>(c) & 0x80U) != 0;
        if (word)
            name += c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    while (name.ends_with('_')) name.pop_back();
    return name.empty() ? "values" : name;
}

ResultInfo column_info(const Heading& heading, bool of_elements) {
    ResultInfo info;
    info.solver_name = heading.name;
    info.unit = heading.unit;
    info.shape = Shape::Scalar;
    const std::string lower = lower_case(heading.name);
    const auto* known = std::ranges::find(kKnownNames, lower, &KnownName::label);
    const bool found = known != kKnownNames.end();
    info.name = found ? std::string(known->name) : plain_name(heading.name);
    info.components = {found ? std::string(known->component) : "value"};
    const bool averaged = found ? known->averaged : true;
    info.averaging = averaged && !of_elements ? Averaging::Solver : Averaging::NotApplicable;
    if (info.name == "elastic_strain" || info.name == "plastic_strain") info.shear = Shear::Engineering;
    return info;
}

std::optional<double> number_of(std::string_view field, bool decimal_comma) {
    if (!decimal_comma) return parse_double(field);
    std::array<char, 40> buffer{};
    if (field.size() > buffer.size()) return std::nullopt;
    std::ranges::replace_copy(field, buffer.begin(), ',', '.');
    return parse_double({buffer.data(), field.size()});
}

/// How a table is written, from its head line and first row.
struct Form {
    char separator = '\0';
    bool decimal_comma = false;
    std::vector<std::string_view> headings;
};

bool fits(std::span<const std::string_view> row, std::size_t columns, bool decimal_comma) {
    if (row.size() != columns || row.size() < 2) return false;
    const auto id = parse_integer(row[0]);
    return id && *id > 0 && std::all_of(row.begin() + 1, row.end(), [&](std::string_view field) {
               return field.empty() || number_of(field, decimal_comma);
           });
}

std::optional<Form> form_of(std::string_view head) {
    Lines lines(head, 0, head.size(), line_end_of(head));
    std::string_view first;
    while (first.empty() && lines.next()) first = trim(lines.line());
    std::string_view second;
    while (second.empty() && lines.next()) second = trim(lines.line());
    // Column heads have words; a row has none.
    if (first.empty() || is_digit(first.front()) || second.empty()) return std::nullopt;
    for (const char separator : {'\t', ';', ','}) {
        Form form{separator, false, fields_of(first, separator)};
        const auto row = fields_of(second, separator);
        if (form.headings.size() < 2) continue;
        // Tables of other things (Steps, Time) have whole numbers in front too.
        const std::string_view number = form.headings[0];
        if (!names_nodes(number) && !names_elements(number) && !has_places(form.headings)) continue;
        if (fits(row, form.headings.size(), false)) return form;
        form.decimal_comma = true;
        if (separator != ',' && fits(row, form.headings.size(), true)) return form;
    }
    return std::nullopt;
}

[[noreturn]] void throw_bad_export_row(const ExportFile& file, const Lines& lines) {
    constexpr std::size_t kShown = 60;
    throw Error(
        Code::BadNumber,
        file.input.where_line(lines.begin()),
        fmt::format(
            "expected a number and {} values, found \"{}\". Was the export edited, or was the file damaged?",
            file.columns.size() + (file.has_places ? 3 : 0),
            trim(lines.line().substr(0, kShown))
        )
    );
}

/// Finds the runs of ascending numbers and whether a number comes again.
void find_bodies(ExportFile& file, std::size_t begin) {
    const std::string_view text = file.input.text();
    Lines lines(text, begin, text.size(), file.line_end);
    std::vector<std::int64_t> ids;
    std::int64_t previous = 0;
    while (lines.next()) {
        Cursor cursor(lines.line());
        std::int64_t id = 0;
        if (!scan_unsigned(cursor, id)) continue;
        if (file.bodies.empty() || (id <= previous && file.bodies.size() < kMostBodies)) {
            file.bodies.push_back({lines.begin(), lines.end()});
        }
        file.bodies.back().end = lines.end();
        previous = id;
        ids.push_back(id);
        ++file.rows;
    }
    if (file.bodies.size() < 2) return;
    std::ranges::sort(ids);
    file.repeats_numbers = std::ranges::adjacent_find(ids) != ids.end();
}

}  // namespace

bool is_export(std::string_view head) {
    return form_of(head).has_value();
}

std::optional<ExportFile> scan_export(const Input& input, Diagnostics& diagnostics) {
    const std::string_view text = input.text();
    constexpr std::size_t kHead = 64U << 10U;
    const auto form = form_of(text.substr(0, kHead));
    if (!form) {
        diagnostics.add(
            Code::UnknownBlock,
            input.name(),
            "the table has no column of node or element numbers: switch on Include Node Numbers in "
            "Mechanical's "
            "export options"
        );
        return std::nullopt;
    }
    ExportFile file{
        input, line_end_of(text), form->separator, form->decimal_comma, false, false, "", {}, {}, 0, false};
    file.of_elements = names_elements(form->headings[0]);
    std::vector<Heading> headings;
    for (const std::string_view field : form->headings) headings.push_back(heading_of(field));
    file.has_places = has_places(form->headings);
    if (file.has_places) {
        file.length_unit =
            headings[1].unit == "\u00B5m" || headings[1].unit == "\u03BCm" ? "um" : headings[1].unit;
    }
    for (std::size_t i = file.has_places ? 4 : 1; i < headings.size(); ++i) {
        file.columns.push_back(column_info(headings[i], file.of_elements));
    }
    const auto head_end =
        static_cast<std::size_t>(form->headings.back().data() + form->headings.back().size() - text.data());
    find_bodies(file, head_end);
    return file;
}

void for_each_export_row(
    const ExportFile& file,
    TextRange range,
    Diagnostics* diagnostics,
    const std::function<void(const ExportRow&)>& use
) {
    std::vector<float> values(file.columns.size());
    ExportRow row;
    Lines lines(file.input.text(), range.begin, range.end, file.line_end);
    while (lines.next()) {
        const auto fields = fields_of(lines.line(), file.separator);
        if (fields.empty()) continue;
        if (!lines.ended()) {
            if (diagnostics != nullptr) {
                diagnostics->add(
                    Code::TruncatedInput,
                    [&] { return file.input.where_line(lines.begin()); },
                    "the last row has no line end: its last number may have been cut, and it is left out. "
                    "Add a line "
                    "end if it is whole."
                );
            }
            continue;
        }
        const auto id = parse_integer(fields[0]);
        const std::size_t first = file.has_places ? 4 : 1;
        if (!id || *id <= 0 || fields.size() > first + values.size()) throw_bad_export_row(file, lines);
        row.values.id = *id;
        row.values.offset = lines.begin();
        row.values.has_bad_value = false;
        for (std::size_t i = 0; i + 1 < first; ++i) {
            const auto x =
                i + 1 < fields.size() ? number_of(fields[i + 1], file.decimal_comma) : std::nullopt;
            if (!x) throw_bad_export_row(file, lines);
            row.place[i] = *x;
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string_view field = first + i < fields.size() ? fields[first + i] : std::string_view();
            values[i] = std::numeric_limits<float>::quiet_NaN();
            if (field.empty()) continue;
            std::optional<float> value;
            if (!file.decimal_comma) {
                value = parse_float(field);
            } else {
                std::string dotted(field.substr(0, 40));
                std::ranges::replace(dotted, ',', '.');
                value = parse_float(dotted);
            }
            if (!value) throw_bad_export_row(file, lines);
            if (std::isfinite(*value))
                values[i] = *value;
            else
                row.values.has_bad_value = true;
        }
        row.values.values = values;
        use(row);
    }
}

}  // namespace feelem::ansys
