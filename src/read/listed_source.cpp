// SPDX-License-Identifier: Apache-2.0
#include "read/listed_source.hpp"

#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

namespace feelem {

Result ListedSource::load(std::size_t index) {
    const ResultInfo& info = infos_.at(index);
    LoadedResult loaded = read(index);
    if (!reported_[index]) report(info, loaded);
    reported_[index] = true;
    return std::move(loaded.result);
}

void ListedSource::set_mesh(Mesh own, const ReadContext& context, const std::string& hint) {
    const bool has_elements = own.element_count() > 0 || !own.skipped_elements.empty();
    if (context.mesh != nullptr && !has_elements) {
        // Results alone are matched by id.
        mesh_ = context.mesh;
        return;
    }
    if (own.node_count() == 0) throw Error(Code::NoNodes, input_.name(), hint);
    own_mesh_ = std::move(own);
    mesh_ = own_or_shared(own_mesh_, context.mesh);
}

void ListedSource::set_contents(std::vector<Step> steps, std::vector<ResultInfo> infos) {
    steps_ = std::move(steps);
    infos_ = std::move(infos);
    reported_.assign(infos_.size(), false);
}

void ListedSource::report(const ResultInfo& info, const LoadedResult& loaded) {
    const auto add = [&](Code code, std::uint64_t count, std::string_view text) {
        if (count > 0)
            diagnostics_.add(code, input_.name(), fmt::format("{} {}", info.solver_name, text), count);
    };
    add(Code::ResultWithoutNode, loaded.without_owner, "lists nodes or elements that the mesh does not have");
    add(Code::NonFiniteValue,
        loaded.without_number,
        "has values that are no finite numbers; they count as missing");
    add(Code::SeveralValuesAtNode,
        loaded.left_over,
        "lists more values a place than its head says (shell layers); only the first are read");
}

void sort_rows_by_owner(Result& result) {
    if (std::ranges::is_sorted(result.row_owner)) return;
    std::vector<std::uint32_t> order(result.row_owner.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return result.row_owner[i]; });
    Result sorted;
    sorted.info = result.info;
    const std::size_t width = result.component_count();
    for (const std::uint32_t i : order) {
        sorted.row_owner.push_back(result.row_owner[i]);
        sorted.row_node.push_back(result.row_node[i]);
        const auto from = result.values.begin() + static_cast<std::ptrdiff_t>(i * width);
        sorted.values.insert(sorted.values.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
    result = std::move(sorted);
}

}  // namespace feelem
