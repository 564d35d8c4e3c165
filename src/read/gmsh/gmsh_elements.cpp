// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_elements.hpp"

#include "base/huge_pages.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace feelem::gmsh {
namespace {

/// Numbers of version 2 start with a count in text, whatever the coding of what follows.
struct Counted {
    std::size_t count;
    Numbers numbers;
};
Counted start_2(const Input& input, const Coding& coding, const Section& section) {
    Coding text = coding;
    text.binary = false;
    Numbers head(input, text, section.first, section.last);
    const std::int64_t count = head.integer();
    TextLines lines(input, section.first, section.last);
    while (lines.offset() < head.offset()) lines.next();
    Numbers numbers(input, coding, coding.binary ? lines.offset() : head.offset(), section.last);
    return {numbers.count(count, 2), numbers};
}

/// What is known of the row that is read.
struct RowHead {
    std::int64_t id = 0;
    const TypeRow* type = nullptr;
    std::int64_t physical = 0, entity = 0;
    std::size_t offset = 0;
};

class ElementWalk {
public:
    ElementWalk(Numbers numbers, ElementRows& rows) : numbers_(numbers), rows_(rows) {}

    void version_2(std::size_t count, bool binary) {
        std::size_t done = 0;
        while (done < count) {
            element_.offset = numbers_.offset();
            if (!binary) element_.id = numbers_.integer();
            set_type(numbers_.integer());
            if (done == 0) make_room(count);
            const std::size_t follow = binary ? numbers_.count(numbers_.integer(), 4) : 1;
            const std::int64_t tags = numbers_.integer();
            if (follow == 0 || tags < 0 || tags > 1000) numbers_.bad("a count of tags");
            for (std::size_t i = 0; i < follow; ++i) {
                if (binary) element_.id = numbers_.integer();
                element_.physical = element_.entity = 0;
                for (std::int64_t t = 0; t < tags; ++t) {
                    const std::int64_t tag = numbers_.integer();
                    if (t == 0) element_.physical = tag;
                    if (t == 1) element_.entity = tag;
                }
                row([&] { return numbers_.integer(); });
            }
            done += follow;
        }
    }

    void version_40() {
        const std::size_t blocks = numbers_.count(numbers_.size(), 4);
        numbers_.size();
        for (std::size_t b = 0; b < blocks; ++b) {
            element_.entity = numbers_.integer();
            numbers_.integer();
            set_type(numbers_.integer());
            const std::size_t count = numbers_.count(numbers_.size(), 2);
            make_room(count);
            for (std::size_t i = 0; i < count; ++i) {
                element_.offset = numbers_.offset();
                element_.id = numbers_.integer();
                row([&] { return numbers_.integer(); });
            }
        }
    }

    void version_41() {
        const std::size_t blocks = numbers_.count(numbers_.size(), 4);
        for (int i = 0; i < 3; ++i) numbers_.size();
        for (std::size_t b = 0; b < blocks; ++b) {
            numbers_.integer();
            element_.entity = numbers_.integer();
            set_type(numbers_.integer());
            const std::size_t count = numbers_.count(numbers_.size(), 2);
            make_room(count);
            for (std::size_t i = 0; i < count; ++i) {
                element_.offset = numbers_.offset();
                element_.id = numbers_.size();
                row([&] { return numbers_.size(); });
            }
        }
    }

private:
    void set_type(std::int64_t number) {
        if (element_.type != nullptr && element_.type->number == number) return;
        element_.type = find_type(number);
        if (element_.type == nullptr) {
            throw Error(
                Code::BadStructure,
                numbers_.where(),
                fmt::format("element type {} is none that Feelem knows the length of", number)
            );
        }
    }

    /// The run that a row belongs to.
    ElementRows::Run& run_of_row(bool is_wide) {
        std::vector<ElementRows::Run>& runs = rows_.runs;
        const bool goes_on = !runs.empty() && runs.back().type == element_.type &&
                             runs.back().physical == element_.physical &&
                             runs.back().entity == element_.entity && runs.back().is_wide == is_wide;
        if (!goes_on) {
            const std::size_t first_node = is_wide ? rows_.wide_nodes.size() : rows_.nodes.size();
            runs.push_back(
                {element_.type, element_.physical, element_.entity, is_wide, rows_.ids.size(), first_node}
            );
        }
        return runs.back();
    }

    template <class Next>
    void row(const Next& next) {
        const TypeRow& type = *element_.type;
        std::uint64_t high = 0;
        for (std::size_t i = 0; i < type.nodes; ++i) {
            const std::int64_t node = next();
            if (i >= file_.size()) continue;
            file_[i] = node;
            high |= static_cast<std::uint64_t>(node) >> 32U;
        }
        const std::size_t width = run_of_row(high != 0 && type.known).width();
        rows_.ids.push_back(ElementId{element_.id});
        rows_.offsets.push_back(element_.offset);
        const auto from = [&](std::size_t i) { return file_[type.order.empty() ? i : type.order[i]]; };
        if (high != 0) {
            for (std::size_t i = 0; i < width; ++i) rows_.wide_nodes.push_back(NodeId{from(i)});
            return;
        }
        const std::size_t first = rows_.nodes.size();
        rows_.nodes.resize(first + width);
        for (std::size_t i = 0; i < width; ++i) rows_.nodes[first + i] = static_cast<std::uint32_t>(from(i));
    }

    /// For as many rows as are announced, or as the bytes that are left can hold.
    void make_room(std::size_t count) {
        const std::size_t least = 2 * (std::size_t{1} + element_.type->nodes);
        const std::size_t rows = std::min(count, numbers_.left() / least + 1);
        reserve_big(rows_.ids, rows_.ids.size() + rows);
        reserve_big(rows_.offsets, rows_.offsets.size() + rows);
        const std::size_t width = element_.type->known ? element_row(element_.type->type).node_count : 0;
        reserve_big(rows_.nodes, rows_.nodes.size() + rows * width);
    }

    Numbers numbers_;
    ElementRows& rows_;
    RowHead element_;
    std::array<std::int64_t, kMaxElementNodes> file_{};
};

Point3 place_of(Numbers& numbers) {
    Point3 place{};
    for (double& x : place) x = numbers.real();
    return place;
}

/// Room for as many nodes as are announced, or as the bytes that are left can hold.
void make_room_for_nodes(NodeRows& rows, std::size_t count, const Numbers& numbers) {
    constexpr std::size_t kLeastBytes = 8;
    const std::size_t more = std::min(count, numbers.left() / kLeastBytes + 1);
    reserve_big(rows.ids, rows.ids.size() + more);
    reserve_big(rows.places, rows.places.size() + more);
}

void read_nodes_4(Numbers numbers, bool is_40, NodeRows& rows) {
    const std::size_t blocks = numbers.count(numbers.size(), 4);
    const std::int64_t all = numbers.size();
    make_room_for_nodes(rows, all > 0 ? static_cast<std::size_t>(all) : 0, numbers);
    for (int i = 0; i < (is_40 ? 0 : 2); ++i) numbers.size();
    for (std::size_t b = 0; b < blocks; ++b) {
        std::int64_t dimension = numbers.integer();
        const std::int64_t second = numbers.integer();
        if (is_40) dimension = second;
        const bool parametric = numbers.integer() != 0;
        const std::int64_t extra = parametric ? std::clamp<std::int64_t>(dimension, 0, 3) : 0;
        const std::size_t count = numbers.count(numbers.size(), 4);
        for (std::size_t i = 0; i < count && !is_40; ++i) rows.ids.push_back(NodeId{numbers.size()});
        for (std::size_t i = 0; i < count; ++i) {
            if (is_40) rows.ids.push_back(NodeId{numbers.integer()});
            rows.places.push_back(place_of(numbers));
            for (std::int64_t e = 0; e < extra; ++e) numbers.real();
        }
    }
}

}  // namespace

std::span<const NodeId> ElementRows::row(
    const Run& run, std::size_t i, std::array<NodeId, kMaxElementNodes>& room
) const {
    const std::size_t width = run.width();
    if (run.is_wide) return std::span(wide_nodes).subspan(run.first_node + (i - run.first) * width, width);
    const auto narrow = nodes_of(run, i, 1);
    for (std::size_t k = 0; k < width; ++k) room[k] = NodeId{narrow[k]};
    return std::span(room).first(width);
}

void read_element_rows(const Input& input, const Coding& coding, const Section& section, ElementRows& rows) {
    if (coding.version < 40) {
        const Counted start = start_2(input, coding, section);
        ElementWalk(start.numbers, rows).version_2(start.count, coding.binary);
        return;
    }
    ElementWalk walk(Numbers(input, coding, section.first, section.last), rows);
    if (coding.version == 40) {
        walk.version_40();
    } else {
        walk.version_41();
    }
}

void read_node_rows(const Input& input, const Coding& coding, const Section& section, NodeRows& rows) {
    if (coding.version >= 40) {
        read_nodes_4(Numbers(input, coding, section.first, section.last), coding.version == 40, rows);
        return;
    }
    Counted start = start_2(input, coding, section);
    make_room_for_nodes(rows, start.count, start.numbers);
    for (std::size_t i = 0; i < start.count; ++i) {
        rows.ids.push_back(NodeId{start.numbers.integer()});
        rows.places.push_back(place_of(start.numbers));
    }
}

}  // namespace feelem::gmsh
