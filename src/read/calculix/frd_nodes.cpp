// SPDX-License-Identifier: Apache-2.0
// Must: read every node, each coordinate rounded once.
// Assumes: nothing about the records; the fast way gives up on anything unusual.
// Algorithm: records as CalculiX writes them are equally long, so that sixteen of them are looked at
// together; all others are read line by line.
#include "read/calculix/frd_nodes.hpp"

#include "base/byte_reader.hpp"
#include "base/columns.hpp"
#include "read/calculix/frd_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace feelem::frd {
namespace {

class NodeReader {
public:
    NodeReader(const Input& input, const Layout& layout, MeshBuilder& builder, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics), builder_(builder) {}

    void read() {
        const Body& body = layout_.nodes;
        constexpr std::size_t kShortestNode = 16;
        builder_.reserve_nodes(std::min<std::size_t>(body.count, (body.last - body.first) / kShortestNode));
        is_text(body.coding) ? read_text_nodes(body) : read_binary_nodes(body);
    }

private:
    void add_node(std::int64_t id, Point3 point) {
        for (double& x : point) {
            if (std::isfinite(x)) continue;
            diagnostics_.add(
                Code::NonFiniteValue,
                [&] { return place(); },
                "nodes have a coordinate that is no finite number"
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
            if (!ok) bad_mesh_record(place(), "a node", line);
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
        for (std::size_t i = 0; i < offsets_.size(); ++i)
            offsets_[i] = static_cast<std::uint32_t>(i / 3 * length + i % 3 * kRealWidth);
        const auto is_plain = [&](const char* record, NodeId& id) {
            std::int64_t number = 0;
            if (!has_mark(record, " -1") || !fast_integer(record + kMark, id_columns, number)) return false;
            id = NodeId{number};
            return record[length - 1] == '\n' && (length == used + 1 || record[used] == '\r');
        };
        for (bool goes_on = true; goes_on;) {
            const std::size_t most = std::min(kAtOnce, static_cast<std::size_t>(last - at) / length);
            std::size_t count = 0;
            while (count < most && is_plain(at + count * length, ids_[count])) ++count;
            goes_on = count == kAtOnce;
            const std::size_t read = read_places(at + kMark + id_columns, count, length);
            goes_on = goes_on && read == count;
            builder_.add_nodes(std::span(ids_).first(read), std::span(places_).first(read));
            at += read * length;
            trail.at(static_cast<std::size_t>(at - text));
        }
        lines.at = static_cast<std::size_t>(at - text);
    }

    /// Of so many records, up to the first with an odd number.
    std::size_t read_places(const char* fields, std::size_t count, std::size_t length) {
        if (columns_of_reals(
                fields, std::span(offsets_).first(3 * count), kRealWidth, places_.front().data()
            ))
            return count;
        for (std::size_t i = 0; i < count; ++i) {
            std::uint64_t odd = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                places_[i][axis] = real12<double>(fields + i * length + axis * kRealWidth, odd);
            if (odd != 0) return i;
        }
        return count;
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

    std::string place() const { return place_in_mesh(input_, layout_, record_); }

    static constexpr std::size_t kAtOnce = 16;

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    MeshBuilder& builder_;
    std::size_t record_ = 0;  ///< Where the record being read starts.
    std::array<NodeId, kAtOnce> ids_{};
    std::array<Point3, kAtOnce> places_{};
    std::array<std::uint32_t, 3 * kAtOnce> offsets_{};  ///< Of their coordinates behind the first.
};

}  // namespace

void read_nodes(const Input& input, const Layout& layout, MeshBuilder& builder, Diagnostics& diagnostics) {
    NodeReader(input, layout, builder, diagnostics).read();
}

}  // namespace feelem::frd
