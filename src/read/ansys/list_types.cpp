// SPDX-License-Identifier: Apache-2.0
// Must: name the shape behind a type number; conclude one only when nobody names it, and say so.
// Assumes: all rows of a type are of one family (a brick written with four nodes does not occur).
// Algorithm: the longest row of a type tells the family; eight, four, three and six nodes are ambiguous:
// there the first rows vote by geometry (is a node in the middle of an edge? are four nodes in one plane?).
#include "read/ansys/list_types.hpp"

#include "base/eight_digits.hpp"
#include "base/number.hpp"
#include "model/vector.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace feelem::ansys {
namespace {

/// Mid-side nodes of curved edges are off the middle, but less than this share of the edge; the node above a
/// brick's corner is at least half an edge away.
constexpr double kNearMiddle = 0.3;
/// Six times a tetrahedron's volume over the cube of its longest edge: a warped shell facet has less.
constexpr double kFlat = 0.05;

/// Whether node `middle` is in the middle between two others. Empty when the edge has no length.
std::optional<bool> is_middle(
    std::span<const Point3> points, std::size_t a, std::size_t b, std::size_t middle
) {
    const Point3 edge = minus(points[b], points[a]);
    const double length = std::sqrt(dot(edge, edge));
    if (!(length > 0)) return std::nullopt;
    Point3 centre{};
    for (std::size_t i = 0; i < 3; ++i) centre[i] = (points[a][i] + points[b][i]) / 2;
    const Point3 off = minus(points[middle], centre);
    return std::sqrt(dot(off, off)) < kNearMiddle * length;
}

bool has_middles(std::span<const Point3> points, std::size_t corners) {
    for (std::size_t i = 0; i < corners; ++i) {
        const auto middle = is_middle(points, i, (i + 1) % corners, corners + i);
        if (middle && !*middle) return false;
    }
    return true;
}

bool is_flat(std::span<const Point3> points) {
    const Point3 a = minus(points[1], points[0]);
    const Point3 b = minus(points[2], points[0]);
    const Point3 c = minus(points[3], points[0]);
    const double longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
    return std::abs(dot(cross(a, b), c)) < kFlat * std::pow(longest, 1.5) || longest == 0;
}

/// What the rows of one type look like.
struct Votes {
    std::size_t most_nodes = 0;
    std::size_t rows = 0;
    int flat = 0;   ///< Rows that look like the flatter shape of that number of nodes,
    int solid = 0;  ///< and like the other.
    std::size_t first_offset = 0;
    const ListFile* file = nullptr;
};

void vote(Votes& votes, std::span<const Point3> points, std::span<const std::int64_t> ids) {
    bool flat = false;
    switch (points.size()) {
    case 3: flat = !is_middle(points, 0, 1, 2).value_or(false); break;
    case 4: flat = ids[2] == ids[3] || is_flat(points); break;
    case 6: flat = has_middles(points, 3); break;
    case 8: flat = has_middles(points, 4); break;
    default: return;
    }
    ++(flat ? votes.flat : votes.solid);
}

std::optional<ElementType> conclude(const Votes& votes) {
    const bool flat = votes.flat >= votes.solid;
    switch (votes.most_nodes) {
    case 2: return ElementType::Line2;
    case 3: return flat ? ElementType::Line2 : ElementType::Line3;  // The third is an orientation node.
    case 4: return flat ? ElementType::Quad4 : ElementType::Tet4;
    case 6: return flat ? ElementType::Tri6 : ElementType::Tet10;
    case 8: return flat ? ElementType::Quad8 : ElementType::Hex8;
    case 7:
    case 9:
    case 10: return ElementType::Tet10;
    default: break;
    }
    return votes.most_nodes > 10 && votes.most_nodes <= 20 ? std::optional(ElementType::Hex20) : std::nullopt;
}

bool has_name(const TypeTable& types, std::int64_t type) {
    const auto known = types.find(static_cast<int>(type));
    return type <= std::numeric_limits<std::int32_t>::max() && known != types.end() &&
           !known->second.name.empty();
}

/// Whether the rows of a list are surely of types that have names: by the third column alone, which is far
/// less work than reading the rows. False when in doubt.
bool has_names_for_all(const ListFile& file, const List& list, const TypeTable& types) {
    constexpr std::size_t kFurtherRow = 20, kTypeEnd = 16;
    std::int64_t named = -1;  // The last one that was looked up.
    bool open = false;
    for (const RowRun& run : list.runs) {
        if (run.taken > 0) {
            if (!has_name(types, run.type)) return false;
            continue;
        }
        for (Lines lines(file.input.text(), run.begin, run.end, file.line_end); lines.next();) {
            const std::string_view line = lines.line();
            if (!is_digit(first_mark(line))) continue;
            if (open && line.find_first_not_of(' ') >= kFurtherRow) continue;
            std::int64_t id = 0, material = 0, type = 0;
            const bool in_columns = line.size() > kTypeEnd && line[kTypeEnd] == ' ' &&
                                    fast_integer(line.data(), 8, id) && line[8] == ' ' &&
                                    fast_integer(line.data() + 8, 4, material) && line[12] == ' ' &&
                                    fast_integer(line.data() + 12, 4, type);
            if (!in_columns) return false;
            open = true;
            if (type == named) continue;
            if (!has_name(types, type)) return false;
            named = type;
        }
    }
    return true;
}

std::map<int, Votes> count_votes(
    std::span<const ListFile> files, const FindPosition& position, const TypeTable& types
) {
    constexpr int kVoters = 64;
    std::map<int, Votes> all;
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind != ListKind::Elements || !list.has_nodes) continue;
            if (has_names_for_all(file, list, types)) continue;
            for_each_element(file, list, nullptr, [&](const ElementRowIds& row) {
                if (row.type > std::numeric_limits<std::int32_t>::max()) return;
                const int type = static_cast<int>(row.type);
                const auto known = types.find(type);
                if (known != types.end() && !known->second.name.empty()) return;
                Votes& votes = all[type];
                if (votes.rows++ == 0) {
                    votes.first_offset = row.offset;
                    votes.file = &file;
                }
                if (row.nodes.size() > votes.most_nodes) {
                    votes.most_nodes = row.nodes.size();
                    votes.flat = votes.solid = 0;
                }
                if (row.nodes.size() < votes.most_nodes || votes.flat + votes.solid >= kVoters) return;
                std::array<Point3, 8> points{};
                if (row.nodes.size() > points.size()) return;
                for (std::size_t i = 0; i < row.nodes.size(); ++i) {
                    const auto point = position(row.nodes[i]);
                    if (!point || std::isnan((*point)[0])) return;
                    points[i] = *point;
                }
                vote(votes, std::span(points).first(row.nodes.size()), row.nodes);
            });
        }
    }
    return all;
}

void add_type(TypeTable& types, int number, std::string_view name, int keyopt1) {
    TypeShape& type = types[number];
    type.name = name;
    type.element = find_element(name);
    type.keyopt1 = keyopt1;
}

void add_option(TypeTable& types, std::string_view option) {
    while (!option.empty()) {
        const std::size_t end = std::min(option.find(','), option.size());
        const std::string_view pair = option.substr(0, end);
        option.remove_prefix(std::min(end + 1, option.size()));
        const std::size_t sign = pair.find('=');
        const auto number = parse_integer(pair.substr(0, std::min(sign, pair.size())));
        const std::string_view name = sign == std::string_view::npos ? "" : trim(pair.substr(sign + 1));
        if (!number || *number < 1 || *number > std::numeric_limits<std::int32_t>::max() || name.empty()) {
            throw Error(
                Code::BadOption,
                "",
                fmt::format("--types: \"{}\" is not NUMBER=NAME, as in 1=SOLID92,2=SHELL63", pair)
            );
        }
        const auto element = find_element(name);
        if (!element) {
            throw Error(
                Code::BadOption, "", fmt::format("--types: no element type of Ansys is called \"{}\"", name)
            );
        }
        add_type(types, static_cast<int>(*number), element->name, 0);
    }
}

}  // namespace

TypeTable read_types(std::span<const ListFile> files, const std::string& option, Diagnostics& diagnostics) {
    TypeTable types;
    for (const ListFile& file : files) {
        for (const auto& [number, listed] : file.types) {
            if (!listed.name.empty()) add_type(types, number, listed.name, listed.keyopt1);
        }
    }
    if (option.find('=') != std::string::npos) {
        add_option(types, option);
    } else if (!option.empty()) {
        const ListFile listing = scan_lists(Input::from_file(option), diagnostics);
        if (listing.types.empty()) {
            throw Error(
                Code::BadOption, option, "--types: the file has no line like ELEMENT TYPE 1 IS SOLID185"
            );
        }
        for (const auto& [number, listed] : listing.types)
            add_type(types, number, listed.name, listed.keyopt1);
    }
    return types;
}

void guess_types(
    std::span<const ListFile> files, const FindPosition& position, TypeTable& types, Diagnostics& diagnostics
) {
    for (const auto& [number, votes] : count_votes(files, position, types)) {
        const auto type = conclude(votes);
        if (!type) continue;  // Left out later, as a type that is not known.
        types[number].guessed = type;
        diagnostics.add(
            Code::GuessedElementType,
            [&votes = votes] { return votes.file->input.where_line(votes.first_offset); },
            fmt::format(
                "element type {} has no name in the inputs: its elements have {} nodes and are taken as {}. "
                "Add an "
                "ETLIST listing, or --types {}=NAME.",
                number,
                votes.most_nodes,
                element_row(*type).name,
                number
            ),
            votes.rows
        );
    }
}

std::optional<RowShape> shape_of(const TypeShape& type, std::size_t count) {
    if (type.element) return shape_of_row(*type.element, count, type.keyopt1);
    if (!type.guessed) return std::nullopt;
    const ElementRow& row = element_row(*type.guessed);
    if (count < row.corner_count) return std::nullopt;
    return RowShape{*type.guessed, std::min<std::size_t>(count, row.node_count)};
}

}  // namespace feelem::ansys
