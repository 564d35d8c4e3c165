// SPDX-License-Identifier: Apache-2.0
#include "read/merged_model.hpp"

#include "base/sha256.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <span>
#include <utility>

namespace feelem {
namespace {

constexpr const char* kOneModelHint = " Are the files of one model?";

double largest_coordinate(const Mesh& mesh) {
    double largest = 0;
    for (const Point3& point : mesh.coordinates) {
        for (const double x : point) {
            if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        }
    }
    return largest;
}

bool same_place(const Point3& a, const Point3& b, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool gaps = std::isnan(a[i]) && std::isnan(b[i]);
        if (!gaps && !(a[i] == b[i] || std::abs(a[i] - b[i]) <= tolerance)) return false;
    }
    return true;
}

void check_same_nodes(const Mesh& first, const Mesh& second, const std::string& name) {
    if (first.node_count() != second.node_count()) {
        throw Error(
            Code::MeshesDiffer,
            name,
            fmt::format(
                "has {} nodes, the inputs before it {}.{}",
                second.node_count(),
                first.node_count(),
                kOneModelHint
            )
        );
    }
    const double tolerance = 1e-5 * largest_coordinate(first);
    for (std::size_t i = 0; i < first.node_count(); ++i) {
        if (first.node_ids[i] != second.node_ids[i]) {
            throw Error(
                Code::MeshesDiffer,
                name,
                fmt::format(
                    "has node {} where the inputs before it have node {}.{}",
                    raw(second.node_ids[i]),
                    raw(first.node_ids[i]),
                    kOneModelHint
                )
            );
        }
        const Point3& a = first.coordinates[i];
        const Point3& b = second.coordinates[i];
        if (!same_place(a, b, tolerance)) {
            throw Error(
                Code::MeshesDiffer,
                name,
                fmt::format(
                    "node {} is at ({:g}, {:g}, {:g}), in the inputs before it at ({:g}, {:g}, {:g}).{}",
                    raw(first.node_ids[i]),
                    b[0],
                    b[1],
                    b[2],
                    a[0],
                    a[1],
                    a[2],
                    kOneModelHint
                )
            );
        }
    }
}

void check_same_block(const ElementBlock& a, const ElementBlock& b, const std::string& name) {
    if (a.type != b.type || a.ids.size() != b.ids.size()) {
        throw Error(
            Code::MeshesDiffer,
            name,
            fmt::format(
                "has {} {} elements, the inputs before it {} {}.{}",
                b.ids.size(),
                element_row(b.type).name,
                a.ids.size(),
                element_row(a.type).name,
                kOneModelHint
            )
        );
    }
    const auto [mine, other] = std::ranges::mismatch(a.ids, b.ids);
    if (mine != a.ids.end()) {
        throw Error(
            Code::MeshesDiffer,
            name,
            fmt::format(
                "has element {} where the inputs before it have element {}.{}",
                raw(*other),
                raw(*mine),
                kOneModelHint
            )
        );
    }
    const auto node = std::ranges::mismatch(a.nodes, b.nodes).in1;
    if (node != a.nodes.end()) {
        const auto row = static_cast<std::size_t>(node - a.nodes.begin()) / element_row(a.type).node_count;
        throw Error(
            Code::MeshesDiffer,
            name,
            fmt::format(
                "element {} has other nodes than in the inputs before it.{}", raw(a.ids[row]), kOneModelHint
            )
        );
    }
}

/// One model made of several sources; input records are hashed when they are first asked for.
class MergedModel : public ModelSource {
public:
    MergedModel(std::vector<OpenedSource> sources, std::vector<UsedInput> inputs)
        : sources_(std::move(sources)), inputs_(std::move(inputs)) {
        assert(!sources_.empty());
        for (const OpenedSource& opened : sources_) append(opened);
    }

    const Mesh& mesh() const override { return sources_.front().source->mesh(); }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return results_; }

    Result load(std::size_t index) override {
        const auto [source, local] = origin_.at(index);
        Result result = sources_[source].source->load(local);
        result.info = results_[index];
        return result;
    }

    std::span<const InputRecord> inputs() const override {
        std::call_once(hashed_, [this] {
            for (const UsedInput& used : inputs_) {
                records_.push_back({used.input.name(), used.format, used.input.size(), sha256_hex(used.input)}
                );
            }
        });
        return records_;
    }

    SolverInfo solver() const override {
        for (const OpenedSource& opened : sources_) {
            if (SolverInfo info = opened.source->solver(); !info.name.empty()) return info;
        }
        return {};
    }

    std::string title() const override {
        for (const OpenedSource& opened : sources_) {
            if (std::string title = opened.source->title(); !title.empty()) return title;
        }
        return {};
    }

private:
    struct Origin {
        std::size_t source = 0;
        std::size_t index = 0;
    };

    void append(const OpenedSource& opened) {
        const auto first_step = static_cast<std::uint32_t>(steps_.size());
        for (Step step : opened.source->steps()) {
            step.input = opened.inputs.at(step.input);
            steps_.push_back(std::move(step));
        }
        const auto source = static_cast<std::size_t>(&opened - sources_.data());
        const std::span<const ResultInfo> results = opened.source->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            results_.push_back(results[i]);
            results_.back().step += first_step;
            origin_.push_back({source, i});
        }
    }

    std::vector<OpenedSource> sources_;
    std::vector<UsedInput> inputs_;
    std::vector<Step> steps_;
    std::vector<ResultInfo> results_;
    std::vector<Origin> origin_;
    mutable std::once_flag hashed_;
    mutable std::vector<InputRecord> records_;
};

}  // namespace

void check_same_mesh(const Mesh& first, const Mesh& second, const std::string& second_name) {
    check_same_nodes(first, second, second_name);
    if (first.blocks.size() != second.blocks.size()) {
        throw Error(
            Code::MeshesDiffer,
            second_name,
            fmt::format(
                "has {} types of elements, the inputs before it {}.{}",
                second.blocks.size(),
                first.blocks.size(),
                kOneModelHint
            )
        );
    }
    for (std::size_t i = 0; i < first.blocks.size(); ++i) {
        check_same_block(first.blocks[i], second.blocks[i], second_name);
    }
}

std::unique_ptr<ModelSource> merge_sources(std::vector<OpenedSource> sources, std::vector<UsedInput> inputs) {
    const Mesh& first = sources.front().source->mesh();
    for (const OpenedSource& opened : std::span(sources).subspan(1)) {
        const Mesh& mesh = opened.source->mesh();
        if (&mesh != &first) check_same_mesh(first, mesh, inputs[opened.inputs.front()].input.name());
    }
    return std::make_unique<MergedModel>(std::move(sources), std::move(inputs));
}

}  // namespace feelem
