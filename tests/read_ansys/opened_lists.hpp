// SPDX-License-Identifier: Apache-2.0
// Lists opened for tests, and short questions about what was read.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::test {

struct OpenedLists {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;
};

OpenedLists open_files(const std::vector<std::string>& paths, const std::string& types = "");
/// From text: one file a string, called a.lis, b.lis ...
OpenedLists open_texts(const std::vector<std::string>& texts, const std::string& types = "");

/// The result of that name (and component, and layer), loaded. Fails the test when there is not exactly one.
Result load_only(
    OpenedLists& opened, std::string_view name, std::string_view component = "", Layer layer = Layer::No
);

/// Smallest and largest value of a component with the ids of their nodes (elements), as `info` prints them.
struct ValueExtremes {
    float min = 0;
    std::int64_t min_id = 0;
    float max = 0;
    std::int64_t max_id = 0;
    std::uint64_t valid = 0;
};
ValueExtremes extremes(const Mesh& mesh, const Result& result, std::string_view component);

/// Value of a component at a node of a nodal result, NaN when missing.
float value_at(const Mesh& mesh, const Result& result, std::string_view component, std::int64_t node);

/// The text of the first diagnostic of a code; empty when there is none.
std::string text_of(const Diagnostics& diagnostics, Code code);

/// Words of all diagnostics, for messages.
std::string all_texts(const Diagnostics& diagnostics);

}  // namespace feelem::test
