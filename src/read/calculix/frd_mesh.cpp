// SPDX-License-Identifier: Apache-2.0
#include "read/calculix/frd_mesh.hpp"

#include "base/byte_reader.hpp"
#include "base/number.hpp"
#include "model/mesh_builder.hpp"
#include "read/calculix/frd_fields.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace feelem::frd {
namespace {

/// Feelem's node i is the file's node kOrder[i]: mid-sides bottom, vertical, top in the file.
constexpr std::array<std::uint8_t, 20> kHex20Order{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                                   10, 11, 16, 17, 18, 19, 12, 13, 14, 15};
constexpr std::array<std::uint8_t, 15> kWedge15Order{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11};

struct FrdType {
    ElementType type;
    std::span<const std::uint8_t> order;  ///< Empty: the same.
};
/// By the file's type number less one: he8 pe6 te4 he20 pe15 te10 tr3 tr6 qu4 qu8 be2 be3.
constexpr std::array<FrdType, 12> kTypes{{
    {ElementType::Hex8, {}},
    {ElementType::Wedge6, {}},
    {ElementType::Tet4, {}},
    {ElementType::Hex20, kHex20Order},
    {ElementType::Wedge15, kWedge15Order},
    {ElementType::Tet10, {}},
    {ElementType::Tri3, {}},
    {ElementType::Tri6, {}},
    {ElementType::Quad4, {}},
    {ElementType::Quad8, {}},
    {ElementType::Line2, {}},
    {ElementType::Line3, {}},
}};

constexpr std::size_t kMark = 3;  ///< " -1" or " -2" before each line.
constexpr std::size_t kRealWidth = 12;
constexpr std::size_t kAttributes = 15;    ///< Columns of type, group and material.
constexpr std::size_t kWindow = 4u << 20;  ///< Bytes read before the pages behind are let go.

/// Lets go of what was read, a window at a time.
class Trail {
public:
    Trail(const Input& input, std::size_t first) : input_(input), released_(first) {}
    void at(std::size_t offset) {
        if (offset - released_ < kWindow) return;
        input_.release(released_, offset);
        released_ = offset;
    }
    void end(std::size_t offset) const { input_.release(released_, offset); }

private:
    const Input& input_;
    std::size_t released_;
};

/// Lines of a text body.
struct Lines {
    std::string_view text;
    std::size_t at = 0;
    std::size_t last = 0;

    bool done() const { return at >= last; }
    std::string_view take() {
        const std::size_t end = std::min(text.find('\n', at), last);
        std::string_view line = text.substr(at, end - at);
        at = std::min(end + 1, last);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
};

std::int64_t integer_field(std::string_view line, std::size_t first, std::size_t width, bool& ok) {
    std::int64_t value = 0;
    if (first + width <= line.size() && fast_integer(line.data() + first, width, value)) return value;
    const auto general = parse_integer(first < line.size() ? line.substr(first, width) : std::string_view{});
    if (!general) ok = false;
    return general.value_or(0);
}

double real_field(std::string_view line, std::size_t first, bool& ok) {
    double value = 0;
    if (first + 12 <= line.size() && fast_real12(line.data() + first, value)) return value;
    const auto general = parse_double(first < line.size() ? line.substr(first, 12) : std::string_view{});
    if (!general) ok = false;
    return general.value_or(0);
}

class MeshReader {
public:
    MeshReader(const Input& input, const Layout& layout, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics), builder_(diagnostics) {
        where_ = [this] { return place(record_); };
    }

    Mesh read() {
        read_nodes(layout_.nodes);
        builder_.seal_nodes();
        if (layout_.has_elements) {
            constexpr std::size_t kShortestElement = 24;
            const Body& body = layout_.elements;
            builder_.expect_elements(
                std::min<std::size_t>(body.count, (body.last - body.first) / kShortestElement)
            );
            is_text(layout_.elements.coding) ? read_text_elements(layout_.elements)
                                             : read_binary_elements(layout_.elements);
        }
        return builder_.finish();
    }

private:
    std::string place(std::size_t offset) const {
        return is_text(layout_.nodes.coding) ? input_.where_line(offset) : input_.where_byte(offset);
    }

    [[noreturn]] void bad_record(std::string_view what, std::string_view line) const {
        throw Error(
            Code::BadNumber,
            place(record_),
            fmt::format("this is no record of {}: \"{}\"", what, line.substr(0, 80))
        );
    }

    void read_nodes(const Body& body) {
        constexpr std::size_t kShortestNode = 16;
        builder_.reserve_nodes(std::min<std::size_t>(body.count, (body.last - body.first) / kShortestNode));
        is_text(body.coding) ? read_text_nodes(body) : read_binary_nodes(body);
    }

    void add_node(std::int64_t id, Point3 point) {
        for (double& x : point) {
            if (std::isfinite(x)) continue;
            diagnostics_.add(
                Code::NonFiniteValue, where_, "nodes have a coordinate that is no finite number"
            );
            x = std::nan("");
        }
        builder_.add_node(NodeId{id}, point);
    }

    void read_text_nodes(const Body& body) {
        const std::size_t id_columns = id_width(body.coding);
        Lines lines{input_.text(), body.first, body.last};
        Trail trail(input_, body.first);
        for (;;) {
            take_plain_nodes(lines, trail, id_columns);
            if (lines.done()) break;
            record_ = lines.at;
            const std::string_view line = lines.take();
            bool ok = line.starts_with(" -1");
            const std::int64_t id = integer_field(line, 3, id_columns, ok);
            const std::size_t first = 3 + id_columns;
            const Point3 point{
                real_field(line, first, ok),
                real_field(line, first + 12, ok),
                real_field(line, first + 24, ok)};
            if (!ok) bad_record("a node", line);
            add_node(id, point);
            trail.at(lines.at);
        }
        trail.end(body.last);
    }

    /// Records as CalculiX writes them, as long as they follow each other: all equally long, so that no line
    /// end is looked for.
    void take_plain_nodes(Lines& lines, Trail& trail, std::size_t id_columns) {
        const char* const text = lines.text.data();
        const char* const last = text + lines.last;
        const char* at = text + lines.at;
        const std::size_t used = kMark + id_columns + 3 * kRealWidth;
        if (static_cast<std::size_t>(last - at) < used + 2) return;
        const std::size_t length = used + (at[used] == '\r' ? 2 : 1);
        while (static_cast<std::size_t>(last - at) >= length) {
            std::uint64_t odd = 0;
            std::int64_t id = 0;
            const char* field = at + kMark + id_columns;
            Point3 point;
            for (double& x : point) {
                x = real12<double>(field, odd);
                field += kRealWidth;
            }
            if (odd != 0 || !starts_with(at, " -1") || !fast_integer(at + kMark, id_columns, id)) break;
            if (at[length - 1] != '\n' || (length == used + 2 && *field != '\r')) break;
            builder_.add_node(NodeId{id}, point);
            at += length;
            trail.at(static_cast<std::size_t>(at - text));
        }
        lines.at = static_cast<std::size_t>(at - text);
    }

    static bool starts_with(const char* at, const char* mark) {
        return at[0] == mark[0] && at[1] == mark[1] && at[2] == mark[2];
    }

    void read_binary_nodes(const Body& body) {
        ByteReader reader(input_, body.first, layout_.swap);
        Trail trail(input_, body.first);
        const auto coordinate = [&]() -> double {
            return body.coding == Coding::Float ? static_cast<double>(reader.read<float>())
                                                : reader.read<double>();
        };
        for (std::uint64_t i = 0; i < body.count; ++i) {
            record_ = reader.offset();
            const auto id = reader.read<std::int32_t>();
            const double x = coordinate();
            const double y = coordinate();
            add_node(id, {x, y, coordinate()});
            trail.at(reader.offset());
        }
        trail.end(body.last);
    }

    void add_element(std::int64_t id, const FrdType& type, std::span<const NodeId> nodes, PartIndex part) {
        std::array<NodeId, kMaxElementNodes> ordered{};
        if (!type.order.empty()) {
            for (std::size_t i = 0; i < nodes.size(); ++i) ordered[i] = nodes[type.order[i]];
            nodes = std::span<const NodeId>(ordered).first(nodes.size());
        }
        builder_.add_element(ElementId{id}, type.type, nodes, part, where_);
    }

    /// Materials are numbers, in fluid results names.
    PartIndex part_of(std::string_view material) {
        if (!has_part_ || material != last_material_) {
            last_material_ = material;
            last_part_ = builder_.part(fmt::format("material {}", material));
            has_part_ = true;
        }
        return last_part_;
    }

    void read_text_elements(const Body& body) {
        const std::size_t id_columns = id_width(body.coding);
        Lines lines{input_.text(), body.first, body.last};
        Trail trail(input_, body.first);
        for (;;) {
            take_plain_elements(lines, trail, id_columns);
            if (lines.done()) break;
            record_ = lines.at;
            const std::string_view line = lines.take();
            bool ok = line.starts_with(" -1");
            const std::int64_t id = integer_field(line, 3, id_columns, ok);
            const std::int64_t type = integer_field(line, 3 + id_columns, 5, ok);
            if (!ok) bad_record("an element", line);
            const std::size_t material = std::min(13 + id_columns, line.size());
            read_element_nodes(lines, id, type, trim(line.substr(material, 5)), id_columns);
            remember(lines, line, type, id_columns);
            trail.at(lines.at);
        }
        trail.end(body.last);
    }

    /// What the element just read is like, for take_plain_elements().
    void remember(const Lines& lines, std::string_view head, std::int64_t type, std::size_t id_columns) {
        like_ = {};
        const std::size_t head_length = kMark + id_columns + kAttributes;
        if (type < 1 || type > std::ssize(kTypes) || head.size() != head_length) return;
        like_.type = static_cast<std::size_t>(type) - 1;
        like_.attributes = head.substr(kMark + id_columns);
        like_.line_end = lines.text[record_ + head_length] == '\r' ? 2 : 1;
        const std::size_t nodes = element_row(kTypes[like_.type].type).node_count;
        like_.per_line = id_columns == 10 ? 10 : 15;
        const std::size_t node_lines = (nodes + like_.per_line - 1) / like_.per_line;
        like_.length =
            head_length + like_.line_end + node_lines * (kMark + like_.line_end) + nodes * id_columns;
        if (lines.at - record_ != like_.length) like_ = {};
    }

    /// Elements like the one before, as long as they follow each other: their lines are as long as its.
    void take_plain_elements(Lines& lines, Trail& trail, std::size_t id_columns) {
        if (like_.length == 0) return;
        const char* const text = lines.text.data();
        const char* const last = text + lines.last;
        const char* at = text + lines.at;
        std::array<NodeId, 20> nodes{};
        const FrdType& type = kTypes[like_.type];
        const auto wanted = std::span(nodes).first(element_row(type.type).node_count);
        // Another line of nodes may follow the last one.
        while (static_cast<std::size_t>(last - at) >= like_.length + kMark) {
            std::int64_t id = 0;
            if (!take_plain_element(at, id_columns, id, wanted) || starts_with(at + like_.length, " -2"))
                break;
            record_ = static_cast<std::size_t>(at - text);
            add_element(id, type, wanted, last_part_);
            at += like_.length;
            trail.at(static_cast<std::size_t>(at - text));
        }
        lines.at = static_cast<std::size_t>(at - text);
    }

    bool take_plain_element(
        const char* at, std::size_t id_columns, std::int64_t& id, std::span<NodeId> nodes
    ) {
        const auto line_ends = [&](const char* end) {
            return end[like_.line_end - 1] == '\n' && (like_.line_end == 1 || *end == '\r');
        };
        const char* p = at + kMark + id_columns;
        if (!starts_with(at, " -1") || !fast_integer(at + kMark, id_columns, id)) return false;
        if (std::memcmp(p, like_.attributes.data(), kAttributes) != 0 || !line_ends(p + kAttributes))
            return false;
        p += kAttributes + like_.line_end;
        for (std::size_t i = 0; i < nodes.size(); i += like_.per_line) {
            if (!starts_with(p, " -2")) return false;
            p += kMark;
            for (NodeId& node : nodes.subspan(i, std::min(like_.per_line, nodes.size() - i))) {
                std::int64_t value = 0;
                if (!fast_integer(p, id_columns, value)) return false;
                node = NodeId{value};
                p += id_columns;
            }
            if (!line_ends(p)) return false;
            p += like_.line_end;
        }
        return true;
    }

    void read_element_nodes(
        Lines& lines, std::int64_t id, std::int64_t type, std::string_view material, std::size_t id_columns
    ) {
        std::array<NodeId, 20> nodes{};
        const bool known = type >= 1 && type <= std::ssize(kTypes);
        const std::size_t wanted =
            known ? element_row(kTypes[static_cast<std::size_t>(type) - 1].type).node_count : 0;
        std::size_t count = 0;
        while (!lines.done() && lines.text.substr(lines.at, 3) == " -2") {
            const std::string_view line = lines.take();
            for (std::size_t at = 3; at + id_columns <= line.size() && count < wanted; at += id_columns) {
                bool ok = true;
                nodes[count++] = NodeId{integer_field(line, at, id_columns, ok)};
                if (!ok) bad_record("an element's nodes", line);
            }
        }
        if (!known) {
            skip_type(type);
        } else if (count < wanted) {
            throw Error(
                Code::BadStructure,
                place(record_),
                fmt::format("element {} has {} nodes; its type {} needs {}", id, count, type, wanted)
            );
        } else {
            add_element(
                id,
                kTypes[static_cast<std::size_t>(type) - 1],
                std::span(nodes).first(wanted),
                part_of(material)
            );
        }
    }

    void skip_type(std::int64_t type) {
        const std::string name = fmt::format("type {}", type);
        diagnostics_.add(
            Code::UnknownElementType,
            where_,
            fmt::format("elements of {} are left out: the .frd format has types 1 to 12", name)
        );
        builder_.skip_element(name);
    }

    void read_binary_elements(const Body& body) {
        ByteReader reader(input_, body.first, layout_.swap);
        Trail trail(input_, body.first);
        std::array<NodeId, 20> nodes{};
        for (std::uint64_t i = 0; i < body.count; ++i) {
            record_ = reader.offset();
            const auto id = reader.read<std::int32_t>();
            const auto type = static_cast<std::size_t>(reader.read<std::int32_t>());  // 1 to 12: find_blocks
            reader.read<std::int32_t>();
            const auto material = reader.read<std::int32_t>();
            const std::size_t wanted = element_row(kTypes[type - 1].type).node_count;
            for (std::size_t n = 0; n < wanted; ++n) nodes[n] = NodeId{reader.read<std::int32_t>()};
            add_element(
                id, kTypes[type - 1], std::span(nodes).first(wanted), part_of(std::to_string(material))
            );
            trail.at(reader.offset());
        }
        trail.end(body.last);
    }

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    MeshBuilder::Where where_;
    std::size_t record_ = 0;  ///< Where the record being read starts.
    /// The element before, when it is written as CalculiX does.
    struct Like {
        std::size_t length = 0;  ///< With all its lines; 0: there is none.
        std::size_t type = 0;    ///< Into kTypes.
        std::size_t line_end = 1;
        std::size_t per_line = 10;    ///< Nodes.
        std::string_view attributes;  ///< Type, group and material as they stand.
    };
    Like like_;
    bool has_part_ = false;
    std::string last_material_;
    PartIndex last_part_{};
};

}  // namespace

Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics) {
    return MeshReader(input, layout, diagnostics).read();
}

}  // namespace feelem::frd
