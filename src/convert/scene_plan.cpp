// SPDX-License-Identifier: Apache-2.0
#include "convert/scene_plan.hpp"

#include "base/letter_case.hpp"
#include "convert/model_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace feelem {
namespace {

/// A scene result that a model's result gives: all leading components, or one scalar.
struct Piece {
    std::string suffix;  ///< Of the id: "", "von_mises".
    std::vector<std::string> components;
    Shape shape = Shape::Scalar;
    bool derived = false;
};

bool leads_with(const ResultInfo& info, std::span<const std::string_view> names) {
    return info.components.size() >= names.size() &&
           std::equal(names.begin(), names.end(), info.components.begin());
}

/// Vectors and tensors stay whole when they are complete; every other component is a scalar of its own.
std::vector<Piece> pieces_of(const ResultInfo& info) {
    static constexpr std::array<std::string_view, 3> kVector{"x", "y", "z"};
    static constexpr std::array<std::string_view, 6> kTensor{"xx", "yy", "zz", "xy", "yz", "zx"};
    std::vector<Piece> pieces;
    std::size_t leading = 0;
    if (info.shape == Shape::Vector && leads_with(info, kVector)) leading = kVector.size();
    if (info.shape == Shape::SymmetricTensor && leads_with(info, kTensor)) leading = kTensor.size();
    if (leading > 0) {
        const auto end = info.components.begin() + static_cast<std::ptrdiff_t>(leading);
        pieces.push_back({"", {info.components.begin(), end}, info.shape, false});
    }
    for (std::size_t i = leading; i < info.components.size(); ++i) {
        const std::string& name = info.components[i];
        pieces.push_back({name == "value" ? "" : name, {name}, Shape::Scalar, false});
    }
    for (const std::string_view name : derivable_components(info)) {
        pieces.push_back({std::string(name), {std::string(name)}, Shape::Scalar, true});
    }
    return pieces;
}

/// Which averagings of one element result the plan has: more than one needs to be told apart.
class Averagings {
public:
    Averagings(const ModelSource& source, std::span<const std::size_t> results) {
        for (const std::size_t i : results) {
            const Averaging averaging = source.results()[i].averaging;
            const bool is_ours = averaging != Averaging::NotApplicable && averaging != Averaging::Solver;
            if (is_ours && std::ranges::find(found_, averaging) == found_.end()) found_.push_back(averaging);
        }
    }
    /// Nothing for the first one, which is the usual one.
    bool needs_word(Averaging averaging) const {
        return found_.size() > 1 && averaging != found_.front() &&
               std::ranges::find(found_, averaging) != found_.end();
    }
    bool are_several() const { return found_.size() > 1; }

private:
    std::vector<Averaging> found_;
};

std::string_view id_word(Averaging averaging) {
    switch (averaging) {
    case Averaging::Part: return "in_parts";
    case Averaging::All: return "across_parts";
    case Averaging::None: return "unaveraged";
    default: return "";
    }
}

std::string id_of(const ResultInfo& info, const Piece& piece, const Averagings& averagings) {
    static const std::map<Complex, std::string_view> parts{
        {Complex::No, ""},
        {Complex::Real, "re"},
        {Complex::Imaginary, "im"},
        {Complex::Amplitude, "amplitude"},
        {Complex::Phase, "phase"}};
    std::string id;
    for (const std::string_view word :
         {std::string_view(info.name),
          std::string_view(piece.suffix),
          word(info.layer),
          parts.at(info.complex),
          info.system.empty() || !piece.suffix.empty() ? std::string_view() : std::string_view("cylindrical"),
          averagings.needs_word(info.averaging) ? id_word(info.averaging) : std::string_view()}) {
        if (!word.empty()) id += (id.empty() ? "" : "_") + std::string(word);
    }
    for (char& c : id) {
        c = to_small(c);
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (!is_plain) c = '_';
    }
    return id.empty() ? "result" : id;
}

SceneResult scene_result(
    const ResultInfo& info, const Piece& piece, std::string id, const Averagings& averagings
) {
    SceneResult result;
    result.id = std::move(id);
    result.quantity = info.name;
    result.title = title_of(info.name, piece.suffix);
    for (const std::string_view note : {word(info.layer), word(info.complex)}) {
        if (!note.empty()) result.title += ", " + std::string(note);
    }
    if (averagings.are_several()) {
        std::string averaged(id_word(info.averaging));
        std::ranges::replace(averaged, '_', ' ');
        if (!averaged.empty()) result.title += ", " + averaged;
    }
    result.source = info.solver_name;
    result.components = piece.components;
    result.shape = piece.shape;
    result.unit = info.unit;
    result.location = info.location;
    result.averaging = info.averaging;
    result.complex = info.complex;
    result.layer = info.layer;
    result.shear = piece.shape == Shape::SymmetricTensor ? info.shear : Shear::NotApplicable;
    result.system = info.system;
    result.derived = piece.derived;
    return result;
}

bool is_same_kind(const SceneResult& a, const SceneResult& b) {
    return a.quantity == b.quantity && a.components == b.components && a.shape == b.shape &&
           a.unit == b.unit && a.location == b.location && a.averaging == b.averaging &&
           a.complex == b.complex && a.layer == b.layer && a.shear == b.shear && a.system == b.system &&
           a.derived == b.derived;
}

/// Steps of the model gathered to steps of the scene.
struct StepGroups {
    std::vector<Step> steps;
    std::vector<std::vector<std::size_t>> members;  ///< Indices into source.steps().
    std::map<std::size_t, std::size_t> group_of;
};

StepGroups group_steps(
    const ModelSource& source,
    std::span<const std::size_t> steps,
    std::span<const std::size_t> results,
    const Averagings& averagings
) {
    std::map<std::size_t, std::set<std::string>> names;  // by step of the model
    for (const std::size_t i : results) {
        const ResultInfo& info = source.results()[i];
        names[info.step].insert(id_of(info, {}, averagings));
    }
    StepGroups groups;
    const auto may_join = [&](std::size_t step, std::size_t group) {
        const Step& mine = source.steps()[step];
        return std::ranges::all_of(groups.members[group], [&](std::size_t other) {
            const Step& its = source.steps()[other];
            const bool same = mine.input != its.input && mine.step == its.step &&
                              mine.substep == its.substep && mine.kind == its.kind && mine.value == its.value;
            return same && std::ranges::none_of(names[step], [&](const std::string& name) {
                       return names[other].contains(name);
                   });
        });
    };
    for (const std::size_t step : steps) {
        if (!names.contains(step)) continue;  // Nothing to show.
        std::size_t group = 0;
        while (group < groups.steps.size() && !may_join(step, group)) ++group;
        if (group == groups.steps.size()) {
            groups.steps.push_back(source.steps()[step]);
            groups.members.emplace_back();
        }
        groups.members[group].push_back(step);
        groups.group_of[step] = group;
    }
    return groups;
}

/// The planned result of that kind with nothing at that step yet; made when there is none.
PlannedResult& place_for(
    ScenePlan& plan,
    const ResultInfo& info,
    const Piece& piece,
    std::size_t step,
    std::set<std::string>& ids,
    const Averagings& averagings
) {
    const SceneResult wanted = scene_result(info, piece, "", averagings);
    for (PlannedResult& planned : plan.results) {
        const bool taken =
            std::ranges::any_of(planned.values, [&](const PlannedValues& v) { return v.step == step; });
        if (!taken && is_same_kind(planned.scene, wanted)) return planned;
    }
    const std::string id = id_of(info, piece, averagings);
    std::string unique = id;
    for (int n = 2; !ids.insert(unique).second; ++n) unique = fmt::format("{}_{}", id, n);
    plan.results.push_back({scene_result(info, piece, unique, averagings), piece.components, {}});
    return plan.results.back();
}

}  // namespace

std::string title_of(std::string_view quantity, std::string_view component) {
    static const std::map<std::string_view, std::string_view> invariants{
        {"von_mises", "von Mises {}"},
        {"tresca", "Tresca {}"},
        {"principal_1", "Largest principal {}"},
        {"principal_2", "Middle principal {}"},
        {"principal_3", "Smallest principal {}"},
        {"radial", "Radial {}"},
        {"hoop", "Hoop {}"},
        {"axial", "Axial {}"},
        {"radial_hoop", "Radial-hoop {}"},
        {"hoop_axial", "Hoop-axial {}"},
        {"axial_radial", "Axial-radial {}"}};
    std::string name(quantity);
    std::ranges::replace(name, '_', ' ');
    const auto invariant = invariants.find(component);
    std::string title = invariant == invariants.end()
                            ? name + (component.empty() ? "" : " " + std::string(component))
                            : fmt::format(fmt::runtime(invariant->second), name);
    if (!title.empty() && component != "von_mises") {
        title.front() = to_capital(title.front());
    }
    return title;
}

ScenePlan plan_scene(
    const ModelSource& source, std::span<const std::size_t> steps, std::span<const std::size_t> results
) {
    ScenePlan plan;
    const Averagings averagings(source, results);
    StepGroups groups = group_steps(source, steps, results, averagings);
    plan.steps = std::move(groups.steps);
    std::set<std::string> ids;
    for (const std::size_t i : results) {
        const ResultInfo& info = source.results()[i];
        const std::size_t step = groups.group_of.at(info.step);
        const bool by_element =
            info.location == Location::Elemental || info.location == Location::ElementNodal;
        if (by_element) plan.domain = Domain::ElementNode;
        for (const Piece& piece : pieces_of(info)) {
            PlannedResult& planned = place_for(plan, info, piece, step, ids, averagings);
            planned.values.push_back({i, step});
        }
    }
    for (PlannedResult& planned : plan.results) {
        std::ranges::sort(planned.values, {}, &PlannedValues::step);
        for (const PlannedValues& values : planned.values) {
            planned.scene.values.push_back({});
            planned.scene.values.back().step = values.step;
        }
    }
    return plan;
}

}  // namespace feelem
