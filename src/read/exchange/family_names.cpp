// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/family_names.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace feelem::exchange {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// The text of the next tag <name ...> from `at` on, without its brackets; `at` moves behind it.
std::optional<std::string_view> next_tag(std::string_view text, std::string_view name, std::size_t& at) {
    while ((at = text.find('<', at)) != std::string_view::npos) {
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) break;
        const std::string_view tag = text.substr(at + 1, end - at - 1);
        at = end + 1;
        const bool same = tag.starts_with(name) && (tag.size() == name.size() || is_space(tag[name.size()]) ||
                                                    tag[name.size()] == '/');
        if (same) return tag;
    }
    at = text.size();
    return {};
}

std::string decoded(std::string_view text) {
    constexpr std::pair<std::string_view, char> kEntities[]{
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    std::string out;
    while (!text.empty()) {
        const auto entity =
            std::ranges::find_if(kEntities, [&](const auto& one) { return text.starts_with(one.first); });
        if (entity != std::end(kEntities)) {
            out += entity->second;
            text.remove_prefix(entity->first.size());
        } else {
            out += text.front();
            text.remove_prefix(1);
        }
    }
    return out;
}

std::optional<std::string> attribute_of(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
        if (at == 0 || !is_space(tag[at - 1])) continue;
        std::size_t value = at + name.size();
        while (value < tag.size() && is_space(tag[value])) ++value;
        if (value >= tag.size() || tag[value] != '=') continue;
        ++value;
        while (value < tag.size() && is_space(tag[value])) ++value;
        if (value >= tag.size() || (tag[value] != '"' && tag[value] != '\'')) continue;
        const std::size_t end = tag.find(tag[value], value + 1);
        if (end == std::string_view::npos) return {};
        return decoded(tag.substr(value + 1, end - value - 1));
    }
    return {};
}

}  // namespace

std::vector<PvdEntry> read_pvd(std::string_view text, const std::string& name) {
    std::vector<PvdEntry> entries;
    std::size_t at = 0;
    while (const auto tag = next_tag(text, "DataSet", at)) {
        const auto file = attribute_of(*tag, "file");
        if (!file || file->empty()) continue;
        const auto time = parse_double(attribute_of(*tag, "timestep").value_or("0"));
        entries.push_back({time.value_or(0), *file, attribute_of(*tag, "name").value_or("")});
    }
    if (text.find("</VTKFile") == std::string_view::npos)
        throw Error(Code::Truncated, name, "the collection has no </VTKFile> at its end: it was cut");
    if (entries.empty())
        throw Error(Code::BadStructure, name, "the collection names no file (<DataSet timestep= file=/>)");
    return entries;
}

std::vector<std::string> attribute_values(
    std::string_view text, std::string_view tag, std::string_view attribute
) {
    std::vector<std::string> values;
    std::size_t at = 0;
    while (const auto found = next_tag(text, tag, at)) {
        if (auto value = attribute_of(*found, attribute); value && !value->empty())
            values.push_back(std::move(*value));
    }
    return values;
}

}  // namespace feelem::exchange
