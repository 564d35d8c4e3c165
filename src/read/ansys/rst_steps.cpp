// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_steps.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace feelem::rst {
namespace {

constexpr std::size_t kMostDofs = 30;

StepKind kind_of(const ResultHeader& header) {
    switch (static_cast<Analysis>(header.analysis)) {
    case Analysis::Static: return StepKind::Static;
    case Analysis::Buckling: return StepKind::Buckling;
    case Analysis::Modal: return StepKind::Mode;
    case Analysis::Harmonic:
    case Analysis::HarmonicByModes: return StepKind::Frequency;
    case Analysis::Transient:
    case Analysis::TransientByModes: return StepKind::Time;
    }
    return StepKind::Other;
}

class SetReader {
public:
    SetReader(const Records& records, const ResultHeader& header, Diagnostics& diagnostics)
        : records_(records), header_(header), diagnostics_(diagnostics) {}

    ResultSets read() {
        if (header_.sets == 0) return {};
        const std::vector<std::int32_t> places = table(header_.set_pointers, 2 * header_.set_table);
        load_steps_ = table(header_.load_steps, 3 * header_.set_table);
        if (header_.times != 0) times_ = records_.reals(header_.times, header_.set_table);
        if (header_.sectors > 1 && header_.cyclic != 0)
            harmonic_indexes_ = table(header_.cyclic, std::max(header_.set_table, kSmallRecord));
        for (std::size_t i = 0; i < header_.sets; ++i) {
            const Word base = wide(
                i < places.size() ? places[i] : 0,
                header_.set_table + i < places.size() ? places[header_.set_table + i] : 0
            );
            try {
                read_set(i, base);
            } catch (const Error& error) {
                diagnostics_.add(
                    Code::TruncatedInput,
                    error.where(),
                    fmt::format(
                        "sets of results are left out, for their heads cannot be read: {}", error.what()
                    )
                );
            }
        }
        return std::move(out_);
    }

private:
    std::vector<std::int32_t> table(Word at, std::size_t most) const {
        return at == 0 ? std::vector<std::int32_t>{} : records_.integers(at, most);
    }

    void read_set(std::size_t i, Word base) {
        const std::vector<std::int32_t> head = records_.integers(base);
        const Word geometry = pointer(head, 149, 150);
        if (geometry != 0 && geometry != header_.geometry) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return records_.where(base); },
                "sets of results on another mesh (remeshed during the solution) are left out"
            );
            return;
        }
        ResultSet set;
        set.base = base;
        set.nodes = count_of(head, 3, base);
        const auto dofs = std::clamp<std::int32_t>(item(head, 20), 0, kMostDofs);
        for (std::int32_t k = 0; k < dofs; ++k)
            set.dofs.push_back(item(head, 21 + static_cast<std::size_t>(k)));
        set.columns = set.dofs.size() + static_cast<std::size_t>(std::clamp(item(head, 98), 0, 1000));
        set.reactions = count_of(head, 8, base);
        set.available = static_cast<std::uint32_t>(item(head, 147));
        const auto place = [&](std::size_t low, std::size_t old) {
            const Word found = pointer(head, low, low + 1);
            const Word offset = found != 0 || old == 0 ? found : wide(item(head, old), 0);
            return offset == 0 ? 0 : base + offset;
        };
        set.nodal = place(105, 11);
        set.reaction = set.reactions == 0 ? 0 : place(107, 13);
        set.elements = place(119, 12);
        set.nodal_averages = place(129, 0);
        set.velocity = place(131, 0);
        set.acceleration = place(133, 0);
        if (i < harmonic_indexes_.size()) set.harmonic_index = harmonic_indexes_[i];
        const bool imaginary = header_.is_complex && item(head, 19) == 1;
        if (header_.is_complex) set.complex = imaginary ? Complex::Imaginary : Complex::Real;
        set.step = step_of(i, head, imaginary);
        out_.sets.push_back(std::move(set));
    }

    std::size_t count_of(const std::vector<std::int32_t>& head, std::size_t number, Word base) const {
        const std::int32_t count = item(head, number);
        if (count >= 0 && static_cast<std::size_t>(count) <= records_.words())
            return static_cast<std::size_t>(count);
        throw Error(
            Code::BadStructure,
            records_.where(base),
            fmt::format("item {} of the head of a set is {}: the file is damaged", number, count)
        );
    }

    /// The real and the imaginary part of a response are one step.
    std::uint32_t step_of(std::size_t i, const std::vector<std::int32_t>& head, bool imaginary) {
        Step step;
        step.step = 3 * i < load_steps_.size() ? load_steps_[3 * i] : item(head, 5);
        step.substep = 3 * i + 1 < load_steps_.size() ? load_steps_[3 * i + 1] : item(head, 6);
        step.kind = kind_of(header_);
        step.value = i < times_.size() && std::isfinite(times_[i]) ? times_[i] : 0;
        if (imaginary && !out_.steps.empty()) {
            const Step& last = out_.steps.back();
            if (last.step == step.step && last.substep == step.substep)
                return static_cast<std::uint32_t>(out_.steps.size() - 1);
        }
        if (step.kind == StepKind::Mode || step.kind == StepKind::Buckling) {
            step.label = fmt::format("mode {}", step.substep);
            if (i < harmonic_indexes_.size())
                step.label +=
                    fmt::format(", harmonic index {}", std::abs(std::int64_t{harmonic_indexes_[i]}));
        }
        out_.steps.push_back(std::move(step));
        return static_cast<std::uint32_t>(out_.steps.size() - 1);
    }

    const Records& records_;
    const ResultHeader& header_;
    Diagnostics& diagnostics_;
    ResultSets out_;
    std::vector<std::int32_t> load_steps_;
    std::vector<double> times_;
    std::vector<std::int32_t> harmonic_indexes_;
};

}  // namespace

ResultSets read_sets(const Records& records, const ResultHeader& header, Diagnostics& diagnostics) {
    return SetReader(records, header, diagnostics).read();
}

}  // namespace feelem::rst
