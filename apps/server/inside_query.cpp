// SPDX-License-Identifier: Apache-2.0
#include "inside_query.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace feelem::server {
namespace {

constexpr std::size_t kLongestName = 200, kMostFields = 16;
constexpr std::int64_t kMostSteps = 1'000'000'000;

[[noreturn]] void bad(const std::string& text) {
    throw Error(Code::BadOption, "", text);
}

/// The keys in brackets may be left out. `client` may always be there.
void check_keys(
    const httplib::Params& params,
    std::initializer_list<const char*> needed,
    std::initializer_list<const char*> optional
) {
    for (const auto& [key, value] : params) {
        const auto is_key = [&key = key](const char* known) { return key == known; };
        const bool is_known =
            std::ranges::any_of(needed, is_key) || std::ranges::any_of(optional, is_key) || key == "client";
        if (!is_known) bad("the question has a key that is not known");
        if (params.count(key) != 1) bad("a key stands there twice");
    }
    for (const char* key : needed) {
        if (params.count(key) == 0) bad(fmt::format("the question needs '{}'", key));
    }
}

const std::string* text_of(const httplib::Params& params, const char* key) {
    const auto found = params.find(key);
    return found == params.end() ? nullptr : &found->second;
}

bool is_name(std::string_view text) {
    const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !text.empty() && text.size() <= kLongestName && std::ranges::all_of(text, is_plain);
}

std::string name_of(std::string_view text, const char* key) {
    if (!is_name(text)) bad(fmt::format("'{}' is not the id of a result", key));
    return std::string(text);
}

double number_of(std::string_view text, const char* key) {
    const auto number = parse_double(text);
    if (!number || !std::isfinite(*number)) bad(fmt::format("'{}' is not a finite number", key));
    return *number;
}

std::size_t count_of(std::string_view text, const char* key) {
    const auto number = parse_integer(text);
    if (!number || *number < 0 || *number > kMostSteps)
        bad(fmt::format("'{}' is not a small whole number", key));
    return static_cast<std::size_t>(*number);
}

std::vector<std::string_view> parts_of(std::string_view text, char between) {
    std::vector<std::string_view> parts;
    while (parts.size() <= kMostFields) {
        const std::size_t end = text.find(between);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return parts;
}

/// "stress", "stress:2": a result and one of its components.
InteriorField field_of(std::string_view text, const char* key, std::size_t step) {
    const auto parts = parts_of(text, ':');
    if (parts.size() > 2) bad(fmt::format("'{}' is not a result and its component", key));
    InteriorField field{name_of(parts[0], key), 0, step};
    if (parts.size() == 2) field.component = count_of(parts[1], key);
    return field;
}

std::size_t step_of(const httplib::Params& params) {
    return count_of(*text_of(params, "step"), "step");
}

/// "displacement,25": the shape that is drawn.
std::optional<InteriorShape> shape_of(const httplib::Params& params) {
    const std::string* text = text_of(params, "shape");
    if (text == nullptr) return std::nullopt;
    const auto parts = parts_of(*text, ',');
    if (parts.size() != 2) bad("'shape' is a result and a factor");
    return InteriorShape{name_of(parts[0], "shape"), step_of(params), number_of(parts[1], "shape")};
}

template <std::size_t N>
std::array<double, N> numbers_of(const httplib::Params& params, const char* key) {
    const auto parts = parts_of(*text_of(params, key), ',');
    if (parts.size() != N) bad(fmt::format("'{}' has {} numbers", key, N));
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) numbers[i] = number_of(parts[i], key);
    return numbers;
}

}  // namespace

PlaneQuestion plane_question(const httplib::Params& params) {
    check_keys(params, {"plane", "result", "step"}, {"shape"});
    const auto plane = numbers_of<4>(params, "plane");
    PlaneQuestion question{
        field_of(*text_of(params, "result"), "result", step_of(params)), {}, shape_of(params)};
    question.plane = {{plane[0], plane[1], plane[2]}, plane[3]};
    const double size = std::hypot(plane[0], plane[1], plane[2]);
    if (!(size > 0) || !std::isfinite(size)) bad("'plane' has no direction");
    return question;
}

LevelQuestion level_question(const httplib::Params& params) {
    check_keys(params, {"result", "step", "value"}, {"colour", "shape"});
    LevelQuestion question{field_of(*text_of(params, "result"), "result", step_of(params))};
    question.level = number_of(*text_of(params, "value"), "value");
    if (const std::string* colour = text_of(params, "colour"))
        question.colour = field_of(*colour, "colour", step_of(params));
    question.shape = shape_of(params);
    return question;
}

PlaceQuestion place_question(const httplib::Params& params) {
    check_keys(params, {"at", "results", "step"}, {"shape"});
    PlaceQuestion question;
    question.place = numbers_of<3>(params, "at");
    const auto fields = parts_of(*text_of(params, "results"), ',');
    if (fields.size() > kMostFields) bad(fmt::format("'results' names more than {}", kMostFields));
    for (const std::string_view field : fields)
        question.fields.push_back(field_of(field, "results", step_of(params)));
    question.shape = shape_of(params);
    return question;
}

std::string client_of(const httplib::Params& params) {
    const std::string* text = text_of(params, "client");
    if (text == nullptr) return {};
    if (!is_name(*text)) bad("'client' is made of small letters, digits and _");
    return *text;
}

}  // namespace feelem::server
