// SPDX-License-Identifier: Apache-2.0
#include "read/calculix/frd_names.hpp"

#include "base/letter_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace feelem::frd {
namespace {

struct Known {
    std::string_view solver;
    std::string_view ours;
    Layer layer = Layer::No;
    Shear shear = Shear::NotApplicable;
};
/// What has a common name (docs/cli.md). Everything else keeps the solver's, in lower case.
constexpr Known kKnown[]{
    {"DISP", "displacement"},
    {"PDISP", "displacement"},
    {"VELO", "velocity"},
    {"V3DF", "velocity"},
    {"NDTEMP", "temperature"},
    {"PNDTEMP", "temperature"},
    {"TS3DF", "temperature"},
    {"PS3DF", "pressure"},
    {"FLUX", "heat_flux"},
    {"FORC", "reaction_force"},
    {"PFORC", "reaction_force"},
    {"RFL", "reaction_heat_flow"},
    {"ELPOT", "electric_potential"},
    {"STRESS", "stress"},
    {"PSTRESS", "stress"},
    {"STRPOS", "stress", Layer::Top},
    {"STRMID", "stress", Layer::Middle},
    {"STRNEG", "stress", Layer::Bottom},
    {"TOSTRAIN", "strain", Layer::No, Shear::Tensor},
    {"MESTRAIN", "strain", Layer::No, Shear::Tensor},
    {"THSTRAIN", "thermal_strain", Layer::No, Shear::Tensor},
    {"MSTRAIN", "mstrain", Layer::No, Shear::Tensor},
    {"PE", "plastic_strain"},
};

/// Solved for at the nodes, not averaged from the elements.
constexpr std::string_view kAtNodes[]{
    "DISP",   "PDISP",  "VELO",  "V3DF",    "NDTEMP",  "PNDTEMP", "TS3DF",   "PS3DF",   "FORC",
    "PFORC",  "RFL",    "ELPOT", "CONTACT", "PCONTAC", "MDISP",   "TOTEMP",  "MAFLOW",  "TOPRES",
    "STPRES", "STTEMP", "DEPTH", "HCRIT",   "NORM",    "SENFREQ", "SENSTRE", "CT3D-MIS"};

/// Ends in XX, YY ... in the .frd order, which is ours.
bool is_tensor(std::span<const Component> components) {
    constexpr std::array<std::string_view, 6> kEnds{"XX", "YY", "ZZ", "XY", "YZ", "ZX"};
    if (components.size() < kEnds.size()) return false;
    for (std::size_t i = 0; i < kEnds.size(); ++i) {
        const bool tensor = components[i].kind == 4 || components[i].kind == 14;
        if (!tensor || !components[i].name.ends_with(kEnds[i])) return false;
    }
    return true;
}

/// Three directions, numbered 1 2 3 and nothing else.
bool is_vector(std::span<const Component> components) {
    if (components.size() < 3) return false;
    for (int i = 0; i < 3; ++i) {
        const Component& component = components[static_cast<std::size_t>(i)];
        const bool direction = component.kind != 1 && component.second_index == 0;
        if (!direction || component.first_index != i + 1) return false;
    }
    return true;
}

void name_components(ResultInfo& info, std::span<const Component> components) {
    std::vector<std::string> names;
    if (is_tensor(components)) {
        info.shape = Shape::SymmetricTensor;
        names = {"xx", "yy", "zz", "xy", "yz", "zx"};
    } else if (is_vector(components)) {
        info.shape = Shape::Vector;
        names = {"x", "y", "z"};
    } else if (components.size() == 1) {
        info.shape = Shape::Scalar;
        names = {"value"};
    } else {
        info.shape = Shape::Other;
    }
    for (std::size_t i = names.size(); i < components.size(); ++i) {
        std::string name = lower_case(components[i].name);
        if (name.empty() || std::ranges::find(names, name) != names.end())
            name = fmt::format("{}_{}", name.empty() ? "component" : name, i + 1);
        names.push_back(std::move(name));
    }
    info.components = std::move(names);
}

const Known* find_known(std::string_view solver) {
    const auto found = std::ranges::find(kKnown, solver, &Known::solver);
    return found == std::end(kKnown) ? nullptr : found;
}

/// The first half are amplitudes, the second half phases.
bool is_amplitude_and_phase(std::span<const Component> components) {
    const std::size_t half = components.size() / 2;
    if (components.empty() || components.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (!components[i].name.starts_with(i < half ? "MAG" : "PHA")) return false;
    }
    return true;
}

StepKind kind_of(const ResultBlock& block) {
    if (block.mode >= 0 || block.analysis == 2) return StepKind::Mode;
    switch (block.analysis) {
    case 0: return StepKind::Static;
    case 1: return StepKind::Time;
    case 4: return StepKind::Buckling;
    default: return StepKind::Other;
    }
}

std::string label_of(const ResultBlock& block) {
    if (block.mode >= 0) {
        if (block.diameter < 0) return fmt::format("mode {}", block.mode);
        return fmt::format("mode {}, nodal diameter {}", block.mode, block.diameter);
    }
    if (block.load_step < 0 || block.increment < 0) return {};
    return fmt::format("step {}, increment {}", block.load_step, block.increment);
}

class Lister {
public:
    explicit Lister(std::span<const ResultBlock> blocks) : blocks_(blocks) {}

    Contents list() {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const std::size_t first = contents_.results.size();
            const std::uint32_t step = step_of(blocks_[i]);
            add(i, step);
            for (std::size_t r = first; r < contents_.results.size(); ++r)
                make_unique(contents_.results[r].info);
        }
        return std::move(contents_);
    }

private:
    /// A step is a number in column 59. The same number with another value is a further substep.
    std::uint32_t step_of(const ResultBlock& block) {
        const StepKind kind = kind_of(block);
        std::vector<std::uint32_t>& same_number = steps_by_number_[block.step];
        for (const std::uint32_t i : same_number) {
            const Step& step = contents_.steps[i];
            const bool same_kind =
                step.kind == kind || (step.kind == StepKind::Frequency && kind == StepKind::Time);
            if (step.value == block.value && same_kind) return i;
        }
        const auto substep = static_cast<std::int32_t>(same_number.size() + 1);
        same_number.push_back(static_cast<std::uint32_t>(contents_.steps.size()));
        contents_.steps.push_back({0, block.step, substep, kind, block.value, label_of(block)});
        return same_number.back();
    }

    /// The result of the same step that this block is the imaginary part of: "STRESSI" after "STRESS",
    /// "TOSTRAII" after "TOSTRAIN" (eight characters are all a name has).
    Listed* real_part_of(std::string_view name, std::uint32_t step) {
        if (name.size() < 2 || !name.ends_with('I')) return nullptr;
        name.remove_suffix(1);
        const auto found = by_solver_name_.lower_bound({step, std::string(name)});
        if (found == by_solver_name_.end() || found->first.first != step) return nullptr;
        const std::string& real = found->first.second;
        constexpr std::size_t kLongestName = 8;
        const bool cut = real.size() == kLongestName && name.size() == kLongestName - 1;
        return real == name || (cut && real.starts_with(name)) ? &contents_.results[found->second] : nullptr;
    }

    void add(std::size_t index, std::uint32_t step) {
        const ResultBlock& block = blocks_[index];
        const std::span<const Component> components = block.components;
        if (is_amplitude_and_phase(components)) {
            const std::size_t half = components.size() / 2;
            add_part(index, step, {0, half}, Complex::Amplitude, block.name);
            add_part(index, step, {half, half}, Complex::Phase, block.name);
            is_complex(step);
            return;
        }
        Complex complex = Complex::No;
        std::string solver_name = block.name;
        if (Listed* real = real_part_of(block.name, step)) {
            real->info.complex = Complex::Real;
            complex = Complex::Imaginary;
            solver_name = real->info.solver_name;
            is_complex(step);
        }
        add_part(index, step, {0, components.size()}, complex, solver_name);
        by_solver_name_.try_emplace({step, block.name}, contents_.results.size() - 1);
    }

    void add_part(
        std::size_t index, std::uint32_t step, Columns columns, Complex complex, std::string_view name
    ) {
        const ResultBlock& block = blocks_[index];
        Listed listed;
        listed.block = index;
        listed.columns = columns;
        ResultInfo& info = listed.info;
        const Known* known = find_known(name);
        info.name = known != nullptr ? std::string(known->ours) : lower_case(name);
        if (info.name.empty()) info.name = "unnamed";
        info.solver_name = block.name;
        info.step = step;
        info.complex = complex;
        if (known != nullptr) {
            info.layer = known->layer;
            info.shear = known->shear;
        }
        const bool at_nodes = std::ranges::find(kAtNodes, name) != std::end(kAtNodes);
        info.averaging = at_nodes ? Averaging::NotApplicable : Averaging::Solver;
        std::vector<Component> used(
            block.components.begin() + static_cast<std::ptrdiff_t>(columns.first),
            block.components.begin() + static_cast<std::ptrdiff_t>(columns.first + columns.count)
        );
        if (complex == Complex::Phase) {
            for (std::size_t i = 0; i < used.size(); ++i) used[i].first_index = static_cast<int>(i) + 1;
        }
        name_components(info, used);
        contents_.results.push_back(std::move(listed));
    }

    /// Real and imaginary parts at "times" are a response to a harmonic load: the time is a frequency.
    void is_complex(std::uint32_t step) {
        Step& it = contents_.steps[step];
        if (it.kind == StepKind::Time) it.kind = StepKind::Frequency;
    }

    void make_unique(ResultInfo& info) {
        const auto take = [&](const std::string& name) {
            return names_.emplace(info.step, info.layer, info.complex, name).second;
        };
        if (take(info.name)) return;
        const std::string ours = std::exchange(info.name, lower_case(info.solver_name));
        if (take(info.name)) return;
        int& number = repeats_[{info.step, ours}];
        do {
            info.name = fmt::format("{}_{}", ours, ++number + 1);
        } while (!take(info.name));
    }

    std::span<const ResultBlock> blocks_;
    Contents contents_;
    std::map<std::int32_t, std::vector<std::uint32_t>> steps_by_number_;
    std::map<std::pair<std::uint32_t, std::string>, std::size_t> by_solver_name_;
    std::set<std::tuple<std::uint32_t, Layer, Complex, std::string>> names_;
    std::map<std::pair<std::uint32_t, std::string>, int> repeats_;
};

}  // namespace

Contents list_contents(std::span<const ResultBlock> blocks) {
    return Lister(blocks).list();
}

}  // namespace feelem::frd
