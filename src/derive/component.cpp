// SPDX-License-Identifier: Apache-2.0
// One component of a result, stored or derived.
#include "base/parallel.hpp"
#include "derive/tensor.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace feelem {
namespace {

constexpr std::size_t kRowsAtOnce = 1U << 12U;

const Derivation& find_derivation(const ResultInfo& info, std::string_view component) {
    for (const Derivation& derivation : derivations()) {
        if (derivation.name == component && derivation.applies(info)) return derivation;
    }
    throw Error(
        Code::UnknownName,
        "",
        fmt::format(
            "{} has no component '{}'; it has {}{}{}",
            info.name,
            component,
            fmt::join(info.components, " "),
            derivable_components(info).empty() ? "" : " ",
            fmt::join(derivable_components(info), " ")
        )
    );
}

/// The rows of `result` without their values.
Result scalar_like(const Result& result, std::string_view component) {
    Result out;
    out.info = result.info;
    out.info.components = {std::string(component)};
    out.info.shape = Shape::Scalar;
    out.row_owner = result.row_owner;
    out.row_node = result.row_node;
    out.values.resize(result.row_count());
    return out;
}

/// How a row's value of one component is had.
struct ComponentMaker {
    int stored = -1;
    const Derivation* derivation = nullptr;

    float make(const ResultInfo& info, std::span<const float> row, const std::array<double, 3>& principals)
        const {
        if (stored >= 0) return row[static_cast<std::size_t>(stored)];
        return static_cast<float>(
            derivation->of_principals != nullptr ? derivation->of_principals(principals)
                                                 : derivation->make(info, row)
        );
    }
};

ComponentMaker maker_of(const ResultInfo& info, std::string_view component) {
    const int stored = component_index(info, component);
    return {stored, stored >= 0 ? nullptr : &find_derivation(info, component)};
}

}  // namespace

Result component_of(const Result& result, std::string_view component) {
    return std::move(components_of(result, std::span(&component, 1)).front());
}

std::vector<std::string_view> made_of_principals(
    const ResultInfo& info, std::span<const std::string_view> components
) {
    std::vector<std::string_view> found;
    for (const std::string_view name : components) {
        if (component_index(info, name) < 0 && find_derivation(info, name).of_principals != nullptr)
            found.push_back(name);
    }
    return found;
}

std::vector<Result> components_of(const Result& result, std::span<const std::string_view> components) {
    std::vector<Result> made;
    std::vector<ComponentMaker> makers;
    for (const std::string_view component : components) {
        made.push_back(scalar_like(result, component));
        makers.push_back(maker_of(result.info, component));
        if (makers.back().stored >= 0) continue;
        // Invariants do not depend on the system, nor on how shear is written.
        made.back().info.nodal_system = false;
        made.back().info.shear = Shear::NotApplicable;
    }
    const bool shares = std::ranges::any_of(makers, [](const ComponentMaker& maker) {
        return maker.derivation != nullptr && maker.derivation->of_principals != nullptr;
    });
    const std::size_t width = result.component_count();
    parallel_chunks(result.row_count(), kRowsAtOnce, [&](std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row) {
            const auto values = std::span(result.values).subspan(row * width, width);
            const auto principals = shares ? principals_of(result.info, values) : std::array<double, 3>{};
            for (std::size_t i = 0; i < made.size(); ++i)
                made[i].values[row] = makers[i].make(result.info, values, principals);
        }
    });
    return made;
}

}  // namespace feelem
