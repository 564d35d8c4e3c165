// SPDX-License-Identifier: Apache-2.0
#include "convert/prepared_source.hpp"

#include "base/number.hpp"
#include "convert/joined_rows.hpp"
#include "convert/model_values.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace feelem {
namespace {

constexpr std::string_view kCylindrical = "cylindrical:";

[[noreturn]] void refuse_system(std::string_view text) {
    throw Error(
        Code::BadOption,
        "--result-system",
        fmt::format(
            "\"{}\": expected cylindrical:OX,OY,OZ,AX,AY,AZ, a point of the axis and its direction, like "
            "cylindrical:0,0,0,0,0,1",
            text
        )
    );
}

/// Results that are one but for their step.
auto kind_of(const ResultInfo& info, std::uint32_t input) {
    return std::tuple(
        input,
        info.name,
        info.solver_name,
        info.components,
        info.unit,
        info.location,
        info.averaging,
        info.complex,
        info.layer,
        info.system
    );
}

bool is_mode(const Step& step) {
    return step.kind == StepKind::Mode || step.kind == StepKind::Buckling;
}

/// The result with all components, stored and derived, side by side.
Result with_all_components(const Result& result) {
    Result out;
    out.info = result.info;
    out.info.components = all_components(result.info);
    out.row_owner = result.row_owner;
    out.row_node = result.row_node;
    const std::size_t width = out.info.components.size();
    out.values.resize(result.row_count() * width);
    DerivedComponents derived(result, derivable_components(result.info));
    for (std::size_t c = 0; c < width; ++c) {
        const Result one = derived.take(out.info.components[c]);
        for (std::size_t row = 0; row < one.values.size(); ++row)
            out.values[row * width + c] = one.values[row];
    }
    return out;
}

bool goes_beyond(Envelope envelope, float value, float than) {
    switch (envelope) {
    case Envelope::Max: return value > than;
    case Envelope::Min: return value < than;
    case Envelope::AbsMax: return std::abs(value) > std::abs(than);
    }
    return false;
}

std::string_view words_of(Envelope envelope) {
    switch (envelope) {
    case Envelope::Max: return "maximum";
    case Envelope::Min: return "minimum";
    case Envelope::AbsMax: return "largest magnitude";
    }
    return "maximum";
}

}  // namespace

std::string_view word(Envelope envelope) {
    switch (envelope) {
    case Envelope::Max: return "max";
    case Envelope::Min: return "min";
    case Envelope::AbsMax: return "absmax";
    }
    return "max";
}

ResultSystem parse_result_system(std::string_view text) {
    if (!text.starts_with(kCylindrical)) refuse_system(text);
    std::array<double, 6> numbers{};
    std::string_view rest = text.substr(kCylindrical.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t comma = rest.find(',');
        const bool is_last = comma == std::string_view::npos;
        const auto number = parse_double(trim(rest.substr(0, comma)));
        if (!number || !std::isfinite(*number) || is_last != (i + 1 == numbers.size())) refuse_system(text);
        numbers[i] = *number;
        rest.remove_prefix(is_last ? rest.size() : comma + 1);
    }
    const auto [ox, oy, oz, ax, ay, az] = numbers;
    const double length = std::hypot(ax, ay, az);
    if (!(length > 0) || !std::isfinite(length)) refuse_system(text);
    // Written anew, so that 1 and 1.0 are one name.
    return {
        fmt::format("{}{}", kCylindrical, fmt::join(numbers, ",")),
        {{ox, oy, oz}, {ax / length, ay / length, az / length}}};
}

std::vector<Envelope> parse_envelopes(std::string_view text) {
    std::vector<Envelope> found;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const std::string_view item = trim(text.substr(0, comma));
        bool known = false;
        for (const Envelope envelope : {Envelope::Max, Envelope::Min, Envelope::AbsMax}) {
            if (word(envelope) != item) continue;
            known = true;
            if (std::ranges::find(found, envelope) == found.end()) found.push_back(envelope);
        }
        if (!known)
            throw Error(
                Code::BadOption, "--envelope", fmt::format("\"{}\" is not one of max, min, absmax", item)
            );
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    return found;
}

Preparing preparing_of(const Job& job) {
    Preparing preparing;
    if (!job.averages.empty()) preparing.averages = job.averages;
    for (const std::string& system : job.result_systems)
        preparing.systems.push_back(parse_result_system(system));
    preparing.envelopes = parse_envelopes(job.envelopes);
    return preparing;
}

bool is_envelope(const Step& step) {
    return step.kind == StepKind::Other && step.step == 0;
}

PreparedSource::PreparedSource(
    ModelSource& source, std::span<const std::size_t> results, const Preparing& preparing
)
    : source_(source), preparing_(preparing) {
    const auto steps = source.steps();
    steps_.assign(steps.begin(), steps.end());
    for (const std::size_t i : results) {
        const ResultInfo& info = source.results()[i];
        const bool is_averaged = info.averaging == Averaging::None;
        for (const Averaging averaging :
             is_averaged ? preparing_.averages : std::vector{Averaging::NotApplicable}) {
            add(i, averaging, nullptr);
            for (const ResultSystem& system : preparing_.systems) {
                if (can_be_cylindrical(info)) add(i, averaging, &system);
            }
        }
    }
    for (const Envelope envelope : preparing_.envelopes) add_envelopes(envelope);
}

void PreparedSource::add(std::size_t source_result, Averaging averaging, const ResultSystem* system) {
    ResultInfo info = prepared_info(source_.results()[source_result], averaging);
    if (system != nullptr) {
        info = cylindrical_info(info);
        info.system = system->name;
    }
    infos_.push_back(std::move(info));
    prepared_.push_back({source_result, averaging, system});
}

void PreparedSource::add_envelopes(Envelope envelope) {
    std::map<decltype(kind_of({}, 0)), std::vector<std::size_t>> groups;
    std::vector<const std::vector<std::size_t>*> in_order;
    for (std::size_t i = 0; i < infos_.size(); ++i) {
        const Step& step = steps_[infos_[i].step];
        if (is_mode(step) || is_envelope(step)) continue;
        std::vector<std::size_t>& group = groups[kind_of(infos_[i], step.input)];
        if (group.empty()) in_order.push_back(&group);
        group.push_back(i);
    }
    bool any = false;
    for (const std::vector<std::size_t>* group : in_order) {
        if (group->size() < 2) continue;
        add_envelope(envelope, *group);
        any = true;
    }
    if (!any) {
        throw Error(
            Code::BadOption,
            "--envelope",
            "no result stands at two of the chosen steps; --steps all takes more"
        );
    }
}

void PreparedSource::add_envelope(Envelope envelope, std::vector<std::size_t> members) {
    const Step& first = steps_[infos_[members.front()].step];
    Step step{
        first.input,
        0,
        1 + static_cast<std::int32_t>(envelope),
        StepKind::Other,
        static_cast<double>(members.size()),
        ""};
    step.label = fmt::format("{} over {} steps", words_of(envelope), members.size());
    const auto known = std::ranges::find_if(steps_, [&](const Step& s) {
        return is_envelope(s) && s.input == step.input && s.substep == step.substep && s.value == step.value;
    });
    const auto index = static_cast<std::uint32_t>(known - steps_.begin());
    if (known == steps_.end()) steps_.push_back(std::move(step));

    ResultInfo info = infos_[members.front()];
    info.components = all_components(info);
    info.shape = Shape::Other;  // No vector or tensor: each component's extreme is at a step of its own.
    info.shear = Shear::NotApplicable;
    info.step = index;
    info.name += "_" + std::string(word(envelope));
    prepared_.push_back({0, Averaging::NotApplicable, nullptr, members, envelope, false});
    infos_.push_back(info);
    info.name += "_step";
    info.unit.clear();
    info.corner_only = false;  // There is no mean of two steps.
    prepared_.push_back({0, Averaging::NotApplicable, nullptr, std::move(members), envelope, true});
    infos_.push_back(std::move(info));
}

Result PreparedSource::load(std::size_t index) {
    const Prepared& prepared = prepared_.at(index);
    if (!prepared.members.empty()) return load_envelope(index);
    Result result = load_prepared(source_, prepared.source_result, prepared.averaging);
    if (prepared.system != nullptr) result = to_cylindrical(mesh(), result, prepared.system->system);
    result.info = infos_[index];
    return result;
}

Result PreparedSource::load_envelope(std::size_t index) {
    const Prepared& prepared = prepared_[index];
    Result extreme;
    std::vector<float> at_step;
    for (std::size_t m = 0; m < prepared.members.size(); ++m) {
        Result one = with_all_components(load(prepared.members[m]));
        if (m == 0) {
            at_step.assign(one.values.size(), std::numeric_limits<float>::quiet_NaN());
            extreme.row_owner = std::move(one.row_owner);
            extreme.row_node = std::move(one.row_node);
            extreme.values.assign(one.values.size(), std::numeric_limits<float>::quiet_NaN());
        } else if (one.row_owner != extreme.row_owner || one.row_node != extreme.row_node) {
            // Elements come and go, or have results at some steps only.
            const std::size_t width = one.component_count();
            extreme.info = one.info;
            JoinedRows joined = join_rows(extreme, one);
            extreme.values = spread_rows(extreme.values, joined.from_a, width);
            at_step = spread_rows(at_step, joined.from_a, width);
            one.values = spread_rows(one.values, joined.from_b, width);
            extreme.row_owner = std::move(joined.owner);
            extreme.row_node = std::move(joined.node);
        }
        for (std::size_t i = 0; i < std::min(one.values.size(), extreme.values.size()); ++i) {
            const float value = one.values[i];
            if (std::isnan(value)) continue;
            if (!std::isnan(extreme.values[i]) && !goes_beyond(prepared.envelope, value, extreme.values[i]))
                continue;
            extreme.values[i] = value;
            at_step[i] = static_cast<float>(m + 1);
        }
    }
    if (prepared.gives_step) extreme.values = std::move(at_step);
    extreme.info = infos_[index];
    return extreme;
}

std::vector<std::size_t> PreparedSource::used_steps() const {
    std::set<std::size_t> used;
    for (const ResultInfo& info : infos_) used.insert(info.step);
    return {used.begin(), used.end()};
}

std::vector<std::size_t> PreparedSource::all_results() const {
    std::vector<std::size_t> all(infos_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

}  // namespace feelem
