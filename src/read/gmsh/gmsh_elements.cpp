// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_elements.hpp"

#include "read/text_lines.hpp"

#include <fmt/format.h>

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

class ElementWalk {
public:
    ElementWalk(Numbers numbers, const UseElement& use) : numbers_(numbers), use_(use) {}

    void version_2(std::size_t count, bool binary) {
        std::size_t done = 0;
        while (done < count) {
            element_.offset = numbers_.offset();
            if (!binary) element_.id = numbers_.integer();
            set_type(numbers_.integer());
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

    template <class Next>
    void row(const Next& next) {
        const TypeRow& type = *element_.type;
        for (std::size_t i = 0; i < type.nodes; ++i) {
            const NodeId node{next()};
            if (i < file_.size()) file_[i] = node;
        }
        element_.nodes = {};
        if (type.known) {
            const std::size_t count = element_row(type.type).node_count;
            for (std::size_t i = 0; i < count; ++i)
                ours_[i] = type.order.empty() ? file_[i] : file_[type.order[i]];
            element_.nodes = std::span(ours_).first(count);
        }
        use_(element_);
    }

    Numbers numbers_;
    const UseElement& use_;
    ElementIn element_;
    std::array<NodeId, kMaxElementNodes> file_{}, ours_{};
};

Point3 place_of(Numbers& numbers) {
    Point3 place{};
    for (double& x : place) x = numbers.real();
    return place;
}

void each_node_4(Numbers numbers, bool is_40, const UseNode& use) {
    const std::size_t blocks = numbers.count(numbers.size(), 4);
    for (int i = 0; i < (is_40 ? 1 : 3); ++i) numbers.size();
    std::vector<NodeId> tags;
    for (std::size_t b = 0; b < blocks; ++b) {
        std::int64_t dimension = numbers.integer();
        const std::int64_t second = numbers.integer();
        if (is_40) dimension = second;
        const bool parametric = numbers.integer() != 0;
        const std::int64_t extra = parametric ? std::clamp<std::int64_t>(dimension, 0, 3) : 0;
        const std::size_t count = numbers.count(numbers.size(), 4);
        tags.clear();
        if (!is_40) {
            for (std::size_t i = 0; i < count; ++i) tags.push_back(NodeId{numbers.size()});
        }
        for (std::size_t i = 0; i < count; ++i) {
            const NodeId id = is_40 ? NodeId{numbers.integer()} : tags[i];
            const Point3 place = place_of(numbers);
            for (std::int64_t e = 0; e < extra; ++e) numbers.real();
            use(id, place);
        }
    }
}

}  // namespace

void each_element(const Input& input, const Coding& coding, const Section& section, const UseElement& use) {
    if (coding.version < 40) {
        const Counted start = start_2(input, coding, section);
        ElementWalk(start.numbers, use).version_2(start.count, coding.binary);
        return;
    }
    ElementWalk walk(Numbers(input, coding, section.first, section.last), use);
    if (coding.version == 40) {
        walk.version_40();
    } else {
        walk.version_41();
    }
}

void each_node(const Input& input, const Coding& coding, const Section& section, const UseNode& use) {
    if (coding.version >= 40) {
        each_node_4(Numbers(input, coding, section.first, section.last), coding.version == 40, use);
        return;
    }
    Counted start = start_2(input, coding, section);
    for (std::size_t i = 0; i < start.count; ++i) {
        const NodeId id{start.numbers.integer()};
        use(id, place_of(start.numbers));
    }
}

}  // namespace feelem::gmsh
