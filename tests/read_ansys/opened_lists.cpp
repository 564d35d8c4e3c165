// SPDX-License-Identifier: Apache-2.0
#include "read_ansys/opened_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace feelem::test {

OpenedLists open_files(const std::vector<std::string>& paths, const std::string& types) {
    OpenedLists opened;
    opened.model = open_model(paths, ReadOptions{"", types}, *opened.diagnostics);
    return opened;
}

OpenedLists open_texts(const std::vector<std::string>& texts, const std::string& types) {
    OpenedLists opened;
    std::vector<NamedBytes> files;
    for (const std::string& text : texts) {
        files.push_back({std::string(1, static_cast<char>('a' + files.size())) + ".lis", text});
    }
    opened.model = open_model(std::move(files), ReadOptions{"", types}, *opened.diagnostics);
    return opened;
}

Result load_only(OpenedLists& opened, std::string_view name, std::string_view component, Layer layer) {
    const auto results = opened.model->results();
    std::optional<std::size_t> found;
    int count = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const bool has_component = component.empty() || component_index(results[i], component) >= 0;
        if (results[i].name != name || results[i].layer != layer || !has_component) continue;
        found = i;
        ++count;
    }
    EXPECT_EQ(count, 1) << name << " " << component << "; " << all_texts(*opened.diagnostics);
    return found ? opened.model->load(*found) : Result{};
}

ValueExtremes extremes(const Mesh& mesh, const Result& result, std::string_view component) {
    const int index = component_index(result.info, component);
    EXPECT_GE(index, 0) << component;
    if (index < 0) return {};
    const Range range = range_of(result, static_cast<std::size_t>(index));
    const auto id_of = [&](std::size_t row) {
        switch (result.info.location) {
        case Location::Nodal: return raw(mesh.node_ids.at(row));
        case Location::Elemental:
            return raw(element_at(mesh, ElementIndex{static_cast<std::uint32_t>(row)}).id());
        default: return raw(mesh.node_ids.at(raw(result.row_node.at(row))));
        }
    };
    if (range.valid == 0) return {};
    // Rows by part or element are not in the order of nodes: the smallest id counts on a tie.
    ValueExtremes out{range.min, id_of(range.min_row), range.max, id_of(range.max_row), range.valid};
    const std::size_t width = result.component_count();
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const float value = result.values[row * width + static_cast<std::size_t>(index)];
        if (value == range.min) out.min_id = std::min(out.min_id, id_of(row));
        if (value == range.max) out.max_id = std::min(out.max_id, id_of(row));
    }
    return out;
}

float value_at(const Mesh& mesh, const Result& result, std::string_view component, std::int64_t node) {
    const int index = component_index(result.info, component);
    const NodeIndex at = find_node(mesh, NodeId{node});
    if (index < 0 || at == kNoNode) return std::numeric_limits<float>::quiet_NaN();
    return result.values.at(raw(at) * result.component_count() + static_cast<std::size_t>(index));
}

std::string text_of(const Diagnostics& diagnostics, Code code) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.code == code) return entry.text;
    }
    return {};
}

std::string all_texts(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& entry : diagnostics.entries()) {
        text += std::string(code_info(entry.code).word) + " x" + std::to_string(entry.count) + " at " +
                entry.where + ": " + entry.text + "\n";
    }
    return text;
}

}  // namespace feelem::test
