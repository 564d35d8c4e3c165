// SPDX-License-Identifier: Apache-2.0
// Reading a JSON document whose every error names the path of its key. For presentation_json.cpp alone: the
// JSON library costs seconds wherever it is included.
#pragma once

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem {

using Json = nlohmann::ordered_json;
using Words = std::span<const std::string_view>;

inline constexpr std::size_t kMaxPresentationBytes = 4u << 20;
inline constexpr std::size_t kMaxDepth = 64;
inline constexpr std::size_t kMaxItems = 1000;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
    double lowest = -kInfinity;
    double highest = kInfinity;
};

/// A value of the document and where it stands; reading a wrong one throws.
class Node {
public:
    Node(const Json& value, std::string_view file, std::string path = {})
        : value_(&value), file_(file), path_(std::move(path)) {}

    [[noreturn]] void fail(const std::string& text) const {
        throw Error(
            Code::BadPresentation,
            std::string(file_),
            path_.empty() ? text : fmt::format("{}: {}", path_, text)
        );
    }
    /// Not there at all; `missing` also when it is null.
    bool absent() const { return value_ == &nothing(); }
    bool missing() const { return value_->is_null(); }

    Node operator[](const char* key) const {
        if (!missing() && !value_->is_object()) {
            fail(fmt::format("expected an object, found {}", value_->type_name()));
        }
        const auto found = missing() ? value_->end() : value_->find(key);
        return {
            missing() || found == value_->end() ? nothing() : *found,
            file_,
            path_.empty() ? key : fmt::format("{}.{}", path_, key)};
    }
    std::vector<Node> items() const {
        std::vector<Node> all;
        if (missing()) {
            return all;
        }
        if (!value_->is_array() || value_->size() > kMaxItems) {
            fail(
                fmt::format("expected an array of at most {} items, found {}", kMaxItems, value_->type_name())
            );
        }
        for (std::size_t i = 0; i < value_->size(); ++i) {
            all.emplace_back((*value_)[i], file_, fmt::format("{}[{}]", path_, i));
        }
        return all;
    }

    std::string text(std::string fallback) const {
        if (missing()) {
            return fallback;
        }
        if (!value_->is_string()) {
            fail(fmt::format("expected a text, found {}", value_->type_name()));
        }
        return value_->get<std::string>();
    }
    bool flag(bool fallback) const {
        if (!missing() && !value_->is_boolean()) {
            fail(fmt::format("expected true or false, found {}", value_->type_name()));
        }
        return missing() ? fallback : value_->get<bool>();
    }
    std::optional<double> number(Interval allowed = {}) const {
        if (missing()) {
            return {};
        }
        if (!value_->is_number()) {
            fail(fmt::format("expected a number, found {}", value_->type_name()));
        }
        const double number = value_->get<double>();
        if (!(number >= allowed.lowest && number <= allowed.highest)) {
            fail(fmt::format("{} is not within {} to {}", number, allowed.lowest, allowed.highest));
        }
        return number;
    }
    int integer(int fallback, Interval allowed) const {
        const double number = this->number(allowed).value_or(fallback);
        if (number != std::floor(number)) {
            fail(fmt::format("expected a whole number, found {}", number));
        }
        return static_cast<int>(number);
    }
    std::array<double, 2> pair(std::array<double, 2> fallback, Interval allowed) const {
        if (missing()) {
            return fallback;
        }
        const auto numbers = items();
        if (numbers.size() != 2) {
            fail(fmt::format("expected two numbers, found {}", numbers.size()));
        }
        const std::array<double, 2> ends{
            numbers[0].number(allowed).value_or(fallback[0]),
            numbers[1].number(allowed).value_or(fallback[1])};
        if (!(ends[0] < ends[1])) {
            fail(fmt::format(
                "{} must be less than {}; to turn the direction round use \"invert\"", ends[0], ends[1]
            ));
        }
        return ends;
    }
    /// Position of the word in the list.
    std::size_t word(Words words, std::size_t fallback) const {
        if (missing()) {
            return fallback;
        }
        const std::string found = text({});
        const auto position = std::ranges::find(words, found);
        if (position == words.end()) {
            fail(fmt::format("'{}' is none of: {}", found, fmt::join(words, " ")));
        }
        return static_cast<std::size_t>(position - words.begin());
    }
    Rgb colour(const Rgb& fallback) const {
        const std::string found = text({});
        if (missing()) {
            return fallback;
        }
        if (found.size() != 7 || found[0] != '#' ||
            found.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
            fail(fmt::format("expected a colour like #ff00ff, found '{}'", found));
        }
        const auto byte = [&](std::size_t at) {
            return static_cast<std::uint8_t>(std::stoi(found.substr(at, 2), nullptr, 16));
        };
        return {byte(1), byte(3), byte(5)};
    }

private:
    static const Json& nothing() {
        static const Json null;
        return null;
    }

    const Json* value_;
    std::string_view file_;
    std::string path_;
};

/// Refuses what would make recursion deep, or the ordered objects slow: each key looks at all before it.
inline void check_size(std::string_view text, std::string_view file) {
    const auto refuse = [&](const std::string& what) {
        throw Error(Code::BadPresentation, std::string(file), what);
    };
    if (text.size() > kMaxPresentationBytes) {
        refuse(fmt::format(
            "{} bytes are too many for a presentation (at most {})", text.size(), kMaxPresentationBytes
        ));
    }
    std::array<std::size_t, kMaxDepth + 1> keys{};
    std::size_t depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kMaxDepth) {
                refuse(fmt::format("nested more than {} deep", kMaxDepth));
            }
            keys.at(depth) = 0;
        } else if (c == ']' || c == '}') {
            depth -= depth > 0 ? 1 : 0;
        } else if (c == ':' && ++keys.at(depth) > kMaxItems) {
            refuse(fmt::format("an object has more than {} keys", kMaxItems));
        }
    }
}

inline Json parse_json(std::string_view text, std::string_view file) {
    check_size(text, file);
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        throw Error(
            Code::BadPresentation, std::string(file), fmt::format("this is not JSON: {}", error.what())
        );
    }
}

}  // namespace feelem
