// SPDX-License-Identifier: Apache-2.0
#include "read_ansys_rst/opened_rst.hpp"

#include "support/paths.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace feelem::test {
namespace {

/// -1 when there is none.
int find_wanted(const OpenedRst& opened, const Wanted& wanted) {
    const auto results = opened.model->results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ResultInfo& info = results[i];
        if (info.name == wanted.name && info.step == wanted.step && info.complex == wanted.complex &&
            info.layer == wanted.layer)
            return static_cast<int>(i);
    }
    return -1;
}

}  // namespace

OpenedRst open_bytes(const std::string& bytes) {
    OpenedRst opened;
    opened.model = open_model(std::vector<NamedBytes>{{"made.rst", bytes}}, {}, *opened.diagnostics);
    return opened;
}

OpenedRst open_written(const WrittenModel& model, const ReadOptions& options) {
    OpenedRst opened;
    std::vector<NamedBytes> files{{"made.rst", write_rst(model)}};
    opened.model = open_model(std::move(files), options, *opened.diagnostics);
    return opened;
}

OpenedRst open_written(const std::vector<WrittenModel>& models) {
    OpenedRst opened;
    std::vector<NamedBytes> files;
    for (const WrittenModel& model : models)
        files.push_back({"file" + std::to_string(files.size()) + ".rst", write_rst(model)});
    opened.model = open_model(std::move(files), {}, *opened.diagnostics);
    return opened;
}

OpenedRst open_corpus(const std::vector<std::string>& paths, const ReadOptions& options) {
    OpenedRst opened;
    std::vector<std::string> found;
    for (const std::string& path : paths) {
        if (const auto file = corpus_file("ansys/" + path)) found.push_back(*file);
    }
    if (found.size() == paths.size()) opened.model = open_model(found, options, *opened.diagnostics);
    return opened;
}

bool has_wanted(const OpenedRst& opened, const Wanted& wanted) {
    return find_wanted(opened, wanted) >= 0;
}

Result load_wanted(const OpenedRst& opened, const Wanted& wanted) {
    const int at = find_wanted(opened, wanted);
    if (at >= 0) return opened.model->load(static_cast<std::size_t>(at));
    ADD_FAILURE() << "no result " << wanted.name << " at step " << wanted.step;
    return {};
}

float value_at(const OpenedRst& opened, const Result& result, std::int64_t node, std::string_view component) {
    const NodeIndex index = find_node(opened.model->mesh(), NodeId{node});
    const int c = component_index(result.info, component);
    const std::size_t place = raw(index) * result.component_count() + static_cast<std::size_t>(c);
    if (index == kNoNode || c < 0 || place >= result.values.size()) {
        ADD_FAILURE() << "no " << component << " at node " << node;
        return std::numeric_limits<float>::quiet_NaN();
    }
    return result.values[place];
}

}  // namespace feelem::test
