// SPDX-License-Identifier: Apache-2.0
// A model's results as Feelem shows them: each in the ways of averaging and the systems that were asked for,
// and envelopes over steps as results of a step of their own.
#pragma once

#include "feelem/convert.hpp"
#include "feelem/derive.hpp"
#include "feelem/model.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

enum class Envelope : std::uint8_t {
    Max,
    Min,
    AbsMax  ///< The value of largest magnitude, with its sign.
};
std::string_view word(Envelope envelope);

/// A cylindrical system and its name, "cylindrical:0,0,0,0,0,1".
struct ResultSystem {
    std::string name;
    CylindricalSystem system;
};

struct Preparing {
    std::vector<Averaging> averages{Averaging::Part};
    std::vector<ResultSystem> systems;
    std::vector<Envelope> envelopes;
};
/// Of the options. Throws Error(BadOption).
Preparing preparing_of(const Job& job);
ResultSystem parse_result_system(std::string_view text);
std::vector<Envelope> parse_envelopes(std::string_view text);

/// An envelope has a step of its own, number 0 of its input.
bool is_envelope(const Step& step);

class PreparedSource : public ModelSource {
public:
    /// The results of `source` at those indexes; an envelope is over the steps that they stand at, modes
    /// apart. Throws Error(BadOption) when there are no two steps to envelop. `source` must outlive this.
    PreparedSource(ModelSource& source, std::span<const std::size_t> results, const Preparing& preparing);

    const Mesh& mesh() const override { return source_.mesh(); }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    Result load(std::size_t index) override;
    std::span<const InputRecord> inputs() const override { return source_.inputs(); }
    SolverInfo solver() const override { return source_.solver(); }
    std::string title() const override { return source_.title(); }

    /// The chosen steps, then those of envelopes.
    std::vector<std::size_t> used_steps() const;
    std::vector<std::size_t> all_results() const;

private:
    struct Prepared {
        std::size_t source_result = 0;
        Averaging averaging = Averaging::NotApplicable;
        const ResultSystem* system = nullptr;
        // Envelopes: of these prepared results, in the order of their steps.
        std::vector<std::size_t> members{};
        Envelope envelope = Envelope::Max;
        bool gives_step = false;  ///< Which step it is, not the value.
    };

    void add(std::size_t source_result, Averaging averaging, const ResultSystem* system);
    void add_envelopes(Envelope envelope);
    void add_envelope(Envelope envelope, std::vector<std::size_t> members);
    Result load_envelope(std::size_t index);

    ModelSource& source_;
    Preparing preparing_;
    std::vector<Step> steps_;
    std::vector<Prepared> prepared_;
    std::vector<ResultInfo> infos_;
};

}  // namespace feelem
