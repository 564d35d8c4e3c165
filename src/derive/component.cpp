// SPDX-License-Identifier: Apache-2.0
// One component of a result, stored or derived.
#include "base/parallel.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

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

}  // namespace

Result component_of(const Result& result, std::string_view component) {
    const std::size_t width = result.component_count();
    const int stored = component_index(result.info, component);
    if (stored >= 0) {
        Result out = scalar_like(result, component);
        for (std::size_t row = 0; row < out.values.size(); ++row)
            out.values[row] = result.values[row * width + static_cast<std::size_t>(stored)];
        return out;
    }
    const Derivation& derivation = find_derivation(result.info, component);
    Result out = scalar_like(result, component);
    // Invariants do not depend on the system, nor on how shear is written.
    out.info.nodal_system = false;
    out.info.shear = Shear::NotApplicable;
    parallel_chunks(out.values.size(), kRowsAtOnce, [&](std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row) {
            const auto values = std::span(result.values).subspan(row * width, width);
            out.values[row] = static_cast<float>(derivation.make(result.info, values));
        }
    });
    return out;
}

}  // namespace feelem
