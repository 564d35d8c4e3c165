// SPDX-License-Identifier: Apache-2.0
// A job's inputs as one model: units as declared, results that two inputs repeat bit for bit listed once.
#include "base/nearest_name.hpp"
#include "base/sha256.hpp"
#include "convert/selection.hpp"
#include "convert/stage.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <utility>

namespace feelem {
namespace {

struct UnitName {
    std::string_view name;
    double metres;
};
constexpr std::array kLengthUnits{
    UnitName{"m", 1.0},
    UnitName{"mm", 1e-3},
    UnitName{"cm", 1e-2},
    UnitName{"in", 0.0254},
    UnitName{"ft", 0.3048},
    UnitName{"um", 1e-6}};

LengthUnit length_unit_called(const std::string& name) {
    for (const UnitName& unit : kLengthUnits) {
        if (unit.name == name) return {name, unit.metres};
    }
    throw Error(
        Code::BadOption, "--length-unit", fmt::format("\"{}\" is not one of m, mm, cm, in, ft, um", name)
    );
}

/// A source seen through a job: units as declared, some results and steps less.
class JobSource : public ModelSource {
public:
    explicit JobSource(std::unique_ptr<ModelSource> source) : source_(std::move(source)) {
        const auto steps = source_->steps();
        const auto results = source_->results();
        steps_.assign(steps.begin(), steps.end());
        results_.assign(results.begin(), results.end());
        for (std::size_t i = 0; i < results_.size(); ++i) origin_.push_back(i);
    }

    const Mesh& mesh() const override { return source_->mesh(); }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return results_; }
    Result load(std::size_t index) override {
        Result result = source_->load(origin_.at(index));
        result.info.unit = results_[index].unit;
        result.info.step = results_[index].step;
        return result;
    }
    std::span<const InputRecord> inputs() const override { return source_->inputs(); }
    SolverInfo solver() const override { return source_->solver(); }
    std::string title() const override { return source_->title(); }

    void declare_length_unit(const LengthUnit& unit) {
        // The source is ours alone and its mesh no constant; a copy would double the memory of a large model.
        const_cast<Mesh&>(source_->mesh()).length_unit = unit;
    }
    void declare_units(const std::map<std::string, std::string>& units);
    /// Results marked are left out, and with them steps that lose their last result.
    void leave_out(const std::vector<bool>& marked);

private:
    std::unique_ptr<ModelSource> source_;
    std::vector<Step> steps_;
    std::vector<ResultInfo> results_;
    std::vector<std::size_t> origin_;  ///< Into source_->results().
};

void JobSource::declare_units(const std::map<std::string, std::string>& units) {
    for (const auto& [name, unit] : units) {
        bool known = false;
        for (ResultInfo& info : results_) {
            if (info.name != name) continue;
            known = true;
            info.unit = unit;
        }
        if (known) continue;
        std::vector<std::string_view> names;
        for (const ResultInfo& info : results_) names.emplace_back(info.name);
        throw Error(
            Code::UnknownName,
            "--unit",
            fmt::format("there is no result \"{}\".{}", name, did_you_mean(name, names))
        );
    }
}

void JobSource::leave_out(const std::vector<bool>& marked) {
    std::vector<bool> had(steps_.size(), false), has(steps_.size(), false);
    for (std::size_t i = 0; i < results_.size(); ++i) {
        had[results_[i].step] = true;
        if (!marked[i]) has[results_[i].step] = true;
    }
    std::vector<std::uint32_t> new_step(steps_.size(), 0);
    std::vector<Step> steps;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        new_step[i] = static_cast<std::uint32_t>(steps.size());
        if (has[i] || !had[i]) steps.push_back(std::move(steps_[i]));
    }
    steps_ = std::move(steps);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < results_.size(); ++i) {
        if (marked[i]) continue;
        if (kept != i) results_[kept] = std::move(results_[i]);
        results_[kept].step = new_step[results_[kept].step];
        origin_[kept] = origin_[i];
        ++kept;
    }
    results_.resize(kept);
    origin_.resize(kept);
}

/// Two inputs may hold the same result: same name, step, value and kind.
bool may_be_twins(const ModelSource& source, const ResultInfo& a, const ResultInfo& b) {
    const Step& s = source.steps()[a.step];
    const Step& t = source.steps()[b.step];
    return s.input != t.input && s.step == t.step && s.substep == t.substep && s.kind == t.kind &&
           s.value == t.value && a.name == b.name && a.components == b.components &&
           a.location == b.location && a.complex == b.complex && a.layer == b.layer;
}

std::string digest(const Result& result) {
    Sha256 hash;
    hash.add(std::as_bytes(std::span(result.values)));
    hash.add(std::as_bytes(std::span(result.row_owner)));
    hash.add(std::as_bytes(std::span(result.row_node)));
    return hash.hex();
}

/// Marks each result that repeats an earlier one of another input bit for bit.
std::vector<bool> find_twins(ModelSource& source, const Progress& progress) {
    const auto results = source.results();
    std::vector<bool> is_twin(results.size(), false);
    std::vector<std::string> digests(results.size());  // made where needed
    const auto digest_of = [&](std::size_t i) -> const std::string& {
        if (digests[i].empty()) digests[i] = digest(source.load(i));
        return digests[i];
    };
    for (std::size_t i = 0; i < results.size(); ++i) {
        for (std::size_t k = 0; k < i && !is_twin[i]; ++k) {
            if (is_twin[k] || !may_be_twins(source, results[k], results[i])) continue;
            report_progress(progress, "compare", fraction_of(i, results.size()));
            is_twin[i] = digest_of(k) == digest_of(i);
        }
    }
    return is_twin;
}

}  // namespace

std::unique_ptr<ModelSource> open_job(const Job& job, Diagnostics& diagnostics, const Progress& progress) {
    try {
        std::optional<LengthUnit> unit;
        if (!job.length_unit.empty()) unit = length_unit_called(job.length_unit);
        report_progress(progress, "read", 0);
        auto source = std::make_unique<JobSource>(open_model(job.inputs, job.read, diagnostics));
        if (unit) source->declare_length_unit(*unit);
        source->declare_units(job.units);
        if (!job.brief) source->leave_out(find_twins(*source, progress));
        for (const ResultInfo& info : source->results()) {
            if (!info.nodal_system || source->mesh().node_angles.empty()) continue;
            diagnostics.add(
                Code::NodalSystemRotated,
                "",
                fmt::format("{} stands in rotated nodal systems; shown in the global one", info.solver_name)
            );
        }
        if (!source->mesh().length_unit) {
            diagnostics.add(
                Code::UnitsUnknown,
                "",
                "the inputs do not say in which unit lengths are; --length-unit mm says it"
            );
        }
        return source;
    } catch (const Cancelled&) {
        return nullptr;
    }
}

}  // namespace feelem
