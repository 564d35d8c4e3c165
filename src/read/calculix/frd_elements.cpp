// SPDX-License-Identifier: Apache-2.0
// Must: read every element with its type, material and nodes in Feelem's order.
// Assumes: nothing about the records; the fast way gives up on anything unusual.
// Algorithm: elements that follow one like them have lines as long as its; they are read in numbers, and
// whole ones join the mesh together. All others are read line by line.
#include "read/calculix/frd_elements.hpp"

#include "base/byte_reader.hpp"
#include "base/columns.hpp"
#include "model/collapse.hpp"
#include "model/element_table.hpp"
#include "read/calculix/frd_lines.hpp"

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

constexpr std::size_t kAttributes = 15;  ///< Columns of type, group and material.

class ElementReader {
public:
    ElementReader(const Input& input, const Layout& layout, MeshBuilder& builder, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics), builder_(builder) {
        where_ = [this] { return place(); };
    }

    void read() {
        constexpr std::size_t kShortestElement = 24;
        const Body& body = layout_.elements;
        builder_.expect_elements(
            std::min<std::size_t>(body.count, (body.last - body.first) / kShortestElement)
        );
        is_text(body.coding) ? read_text_elements(body) : read_binary_elements(body);
    }

private:
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
            if (!ok) bad_mesh_record(place(), "an element", line);
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
        const std::size_t width = element_row(kTypes[like_.type].type).node_count;
        for (bool goes_on = true; goes_on;) {
            std::size_t count = 0;
            for (; goes_on && count < kAtOnce; count += goes_on ? 1 : 0) {
                const char* element = at + count * like_.length;
                // Another line of nodes may follow the last one.
                goes_on =
                    static_cast<std::size_t>(last - element) >= like_.length + kMark &&
                    take_plain_element(
                        element, id_columns, ids_[count], std::span(nodes_).subspan(count * width, width)
                    ) &&
                    !has_mark(element + like_.length, " -2");
            }
            add_elements(count, width, static_cast<std::size_t>(at - text));
            at += count * like_.length;
            trail.at(static_cast<std::size_t>(at - text));
        }
        lines.at = static_cast<std::size_t>(at - text);
    }

    bool take_plain_element(
        const char* at, std::size_t id_columns, ElementId& id, std::span<std::uint32_t> nodes
    ) const {
        const auto line_ends = [&](const char* end) {
            return end[like_.line_end - 1] == '\n' && (like_.line_end == 1 || *end == '\r');
        };
        const char* p = at + kMark + id_columns;
        std::int64_t number = 0;
        if (!has_mark(at, " -1") || !fast_integer(at + kMark, id_columns, number)) return false;
        id = ElementId{number};
        if (!same_characters(p, like_.attributes.data(), kAttributes) || !line_ends(p + kAttributes))
            return false;
        p += kAttributes + like_.line_end;
        for (std::size_t i = 0; i < nodes.size(); i += like_.per_line) {
            const std::size_t count = std::min(like_.per_line, nodes.size() - i);
            if (!has_mark(p, " -2") || !take_nodes(p + kMark, id_columns, nodes.subspan(i, count)))
                return false;
            p += kMark + count * id_columns;
            if (!line_ends(p)) return false;
            p += like_.line_end;
        }
        return true;
    }

    static bool take_nodes(const char* at, std::size_t width, std::span<std::uint32_t> nodes) {
        if (width >= 8) return columns_of_integers(at, width, nodes.size(), nodes.data());
        for (std::uint32_t& node : nodes) {
            std::int64_t number = 0;
            if (!fast_integer(at, width, number)) return false;
            node = static_cast<std::uint32_t>(number);
            at += width;
        }
        return true;
    }

    /// The elements just taken, which stand one after the other.
    void add_elements(std::size_t count, std::size_t width, std::size_t first) {
        const FrdType& type = kTypes[like_.type];
        const auto nodes = std::span(nodes_).first(count * width);
        const auto found = std::span(found_).first(count * width);
        ordered_.assign(nodes.begin(), nodes.end());
        for (std::size_t i = 0; i < nodes.size() && !type.order.empty(); ++i)
            ordered_[i] = nodes[i / width * width + type.order[i % width]];
        const ElementRow& row = element_row(type.type);
        // Number 0 stands for a node that is left out.
        const bool are_whole = std::ranges::find(ordered_, 0U) == ordered_.end() &&
                               builder_.nodes().find(ordered_, found.data()) &&
                               (row.dimension < 2 || all_differ_in_rows(found, width, row.corner_count));
        if (are_whole && count > 0)
            builder_.add_whole_elements(type.type, last_part_, std::span(ids_).first(count), found);
        for (std::size_t i = 0; i < count && !are_whole; ++i) {
            std::array<NodeId, kMaxElementNodes> of_one{};
            for (std::size_t n = 0; n < width; ++n) of_one[n] = NodeId{ordered_[i * width + n]};
            record_ = first + i * like_.length;
            builder_.add_element(ids_[i], type.type, std::span(of_one).first(width), last_part_, where_);
        }
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
                if (!ok) bad_mesh_record(place(), "an element's nodes", line);
            }
        }
        if (!known) {
            skip_type(type);
        } else if (count < wanted) {
            throw Error(
                Code::BadStructure,
                place(),
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

    std::string place() const { return place_in_mesh(input_, layout_, record_); }

    static constexpr std::size_t kAtOnce = 64, kMostNodes = 20;

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    MeshBuilder& builder_;
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
    /// Of elements that are read together: ids, nodes as in the file, in Feelem's order, and found.
    std::array<ElementId, kAtOnce> ids_{};
    std::array<std::uint32_t, kAtOnce * kMostNodes> nodes_{};
    std::vector<std::uint32_t> ordered_;
    std::array<NodeIndex, kAtOnce * kMostNodes> found_{};
};

}  // namespace

void read_elements(const Input& input, const Layout& layout, MeshBuilder& builder, Diagnostics& diagnostics) {
    ElementReader(input, layout, builder, diagnostics).read();
}

}  // namespace feelem::frd
