// SPDX-License-Identifier: Apache-2.0
// Models out of result files in memory or of the corpus, and values out of them by name and number.
#pragma once

#include "read_ansys_rst/rst_writer.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::test {

struct OpenedRst {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;
};
OpenedRst open_bytes(const std::string& bytes);
OpenedRst open_written(const WrittenModel& model, const ReadOptions& options = {});
/// As files of one model.
OpenedRst open_written(const std::vector<WrittenModel>& models);
/// By path from the corpus; without a model when it is not there.
OpenedRst open_corpus(const std::vector<std::string>& paths, const ReadOptions& options = {});

/// Of the first result of that name, at a step (from 0), part and layer.
struct Wanted {
    std::string_view name;
    std::uint32_t step = 0;
    Complex complex = Complex::No;
    Layer layer = Layer::No;
};
/// A result without values when there is none, and a failure.
Result load_wanted(const OpenedRst& opened, const Wanted& wanted);
bool has_wanted(const OpenedRst& opened, const Wanted& wanted);
/// Value of a nodal result at a node.
float value_at(const OpenedRst& opened, const Result& result, std::int64_t node, std::string_view component);

}  // namespace feelem::test
