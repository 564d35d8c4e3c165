// SPDX-License-Identifier: Apache-2.0
// Must: show no value that is not the solution's. Cyclic symmetry says that sector s moves as
// turn(s) * (A cos(s k alpha) - B sin(s k alpha)), A and B being two solutions of the sector in the file, k
// the harmonic index, alpha the angle of a sector. Which solution is B, and its sign, is known by one thing
// only: the sides of neighbours must move together. So it is tried, and what does not fit is left out.
// Assumes: nothing of the order of modes in the file.
// Algorithm: for each step, solutions of the same frequency and harmonic index (and the second sector, where
// the file has one) are tried as B with both signs; the best must fit. Data: the mesh of all sectors; one
// result at a time.
#include "read/ansys/rst_cyclic.hpp"

#include "model/mesh_builder.hpp"
#include "model/node_lookup.hpp"
#include "read/ansys/rst_copy.hpp"
#include "read/ansys/rst_sectors.hpp"
#include "read/element_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace feelem::rst {
namespace {

/// Of the largest value: neighbours' sides in single precision.
constexpr double kFits = 1e-5;
constexpr double kSameFrequency = 1e-6;

/// How a step runs round the axis.
struct StepPlan {
    bool fits = false;
    std::int64_t harmonic = 0;
    std::uint32_t partner = 0;  ///< The step of B.
    double sign = 0;            ///< 0: there is no B.
    bool own_copies = false;    ///< B is the same step at the nodes of the second sector.
};

bool is_tensor(const ResultInfo& info) {
    return info.shape == Shape::SymmetricTensor && info.components.size() == 6;
}
bool is_vector(const ResultInfo& info) {
    return info.shape == Shape::Vector && info.components.size() == 3;
}

/// A row along other axes.
void turn_row(const ResultInfo& info, const Matrix3& turn, double* row) {
    if (is_vector(info)) {
        const auto turned = to_global(turn, std::array<double, 3>{row[0], row[1], row[2]});
        std::ranges::copy(turned, row);
    } else if (is_tensor(info)) {
        const double shear = info.shear == Shear::Engineering ? 2 : 1;
        Tensor6 tensor{};
        for (std::size_t i = 0; i < 6; ++i) tensor[i] = row[i] / (i < 3 ? 1 : shear);
        tensor = to_global(turn, tensor);
        for (std::size_t i = 0; i < 6; ++i) row[i] = tensor[i] * (i < 3 ? 1 : shear);
    }
}

/// Rows of the sector in the file, in the global system.
struct SectorValues {
    Result result;
    std::vector<double> rows;
};

class CyclicSource : public ModelSource {
public:
    CyclicSource(std::unique_ptr<RstSource> sector, Sectors sectors, Diagnostics& diagnostics)
        : sector_(std::move(sector)), sectors_(std::move(sectors)), diagnostics_(diagnostics) {
        build_mesh();
        find_nodes();
        plan_steps();
        list_results();
    }

    const Mesh& mesh() const override { return mesh_; }
    std::span<const Step> steps() const override { return sector_->steps(); }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return sector_->solver(); }
    std::string title() const override { return sector_->title(); }

    Result load(std::size_t index) override {
        const std::size_t at = sources_.at(index);
        const StepPlan& plan = plans_[infos_[index].step];
        const SectorValues a = values_of(at);
        std::optional<SectorValues> b;
        if (plan.sign != 0) b = partner_values(a, plan);
        Result result;
        result.info = infos_[index];
        if (result.info.location == Location::Nodal) {
            spread_nodal(a, b, plan, result);
        } else {
            spread_rows(a, b, plan, result);
        }
        return result;
    }

private:
    const Mesh& base() const { return sector_->mesh(); }

    static std::int64_t offset_above(std::int64_t largest) {
        std::int64_t offset = 10;
        while (offset <= largest && offset < 1'000'000'000'000) offset *= 10;
        return offset;
    }

    NodeId id_of(std::size_t s, NodeIndex node) const {
        const auto [stands, own] = sectors_.standing_for(s, node);
        return NodeId{static_cast<std::int64_t>(stands) * node_offset_ + raw(base().node_ids[raw(own)])};
    }

    bool is_own(ElementId id) const {
        const std::int32_t last = sector_->header().sector_elements;
        return last <= 0 || raw(id) <= last;
    }

    void build_mesh() {
        std::int64_t largest_node = 0, largest_element = 0;
        for (std::size_t i = 0; i < base().node_count(); ++i) {
            if (sectors_.is_own(NodeIndex{static_cast<std::uint32_t>(i)}))
                largest_node = std::max(largest_node, raw(base().node_ids[i]));
        }
        for (const ElementBlock& block : base().blocks) {
            for (const ElementId id : block.ids) {
                if (is_own(id)) largest_element = std::max(largest_element, raw(id));
            }
        }
        node_offset_ = offset_above(largest_node);
        element_offset_ = offset_above(largest_element);

        Diagnostics heard_already;
        MeshBuilder builder(heard_already);
        for (std::size_t s = 0; s < sectors_.count(); ++s) {
            for (std::uint32_t i = 0; i < base().node_count(); ++i) {
                const NodeIndex node{i};
                if (sectors_.is_own(node) && sectors_.standing_for(s, node) == std::pair{s, node})
                    builder.add_node(id_of(s, node), sectors_.place(s, base().coordinates[i]));
            }
        }
        builder.seal_nodes();
        for (std::size_t s = 0; s < sectors_.count(); ++s) {
            const auto node = [&](NodeIndex index) { return id_of(s, index); };
            const auto wanted = [&](ElementId id) { return is_own(id); };
            copy_elements(base(), {node, wanted, static_cast<std::int64_t>(s) * element_offset_}, builder);
        }
        for (const auto& [type, count] : base().skipped_elements) builder.skip_element(type, count);
        if (base().length_unit) builder.set_length_unit(*base().length_unit);
        mesh_ = builder.finish();
    }

    void find_nodes() {
        const NodeLookup lookup(mesh_.node_ids);
        const ElementLookup element(mesh_);
        for (std::size_t s = 0; s < sectors_.count(); ++s) {
            for (std::uint32_t i = 0; i < base().node_count(); ++i) {
                const NodeIndex node{i};
                places_.push_back(sectors_.is_own(node) ? lookup(id_of(s, node)) : kNoNode);
            }
            for (const ElementBlock& block : base().blocks) {
                for (const ElementId id : block.ids) {
                    const ElementId copy{raw(id) + static_cast<std::int64_t>(s) * element_offset_};
                    element_places_.push_back(is_own(id) ? element(copy) : kNoElement);
                }
            }
        }
        copies_.assign(base().node_count(), kNoNode);
        const NodeLookup own(base().node_ids);
        const std::int64_t last = sector_->header().sector_nodes;
        for (std::size_t i = 0; last > 0 && i < base().node_count(); ++i)
            copies_[i] = own(NodeId{raw(base().node_ids[i]) + last});
    }

    SectorValues values_of(std::size_t index) const {
        SectorValues out;
        out.result = sector_->load(index);
        const ResultInfo& info = out.result.info;
        out.rows.assign(out.result.values.begin(), out.result.values.end());
        if (!info.nodal_system || base().node_angles.empty()) return out;
        const std::size_t width = out.result.component_count();
        for (std::size_t row = 0; row < base().node_count(); ++row) {
            if (base().node_angles[row] != NodalAngles{})
                turn_row(info, nodal_axes(base().node_angles[row]), out.rows.data() + row * width);
        }
        return out;
    }

    /// B of a result: the same result of the partner's step, or its values at the second sector.
    SectorValues partner_values(const SectorValues& a, const StepPlan& plan) const {
        if (plan.own_copies) return copied(a);
        const auto results = sector_->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            const ResultInfo& info = results[i];
            if (info.step != plan.partner || info.name != a.result.info.name ||
                info.layer != a.result.info.layer)
                continue;
            SectorValues b = values_of(i);
            if (b.result.row_owner == a.result.row_owner && b.result.row_node == a.result.row_node &&
                b.rows.size() == a.rows.size())
                return b;
        }
        throw Error(
            Code::BadStructure,
            sector_->records().input().name(),
            fmt::format(
                "{} of the other mode of the same frequency is not in the file, or has other elements: it "
                "cannot be shown in all sectors",
                a.result.info.solver_name
            )
        );
    }

    SectorValues copied(const SectorValues& a) const {
        SectorValues b = a;
        const std::size_t width = a.result.component_count();
        for (std::size_t row = 0; row < base().node_count(); ++row) {
            for (std::size_t c = 0; c < width; ++c) {
                b.rows[row * width + c] = copies_[row] == kNoNode ? std::numeric_limits<double>::quiet_NaN()
                                                                  : a.rows[raw(copies_[row]) * width + c];
            }
        }
        return b;
    }

    /// A row in sector s.
    void combine(
        const SectorValues& a,
        const SectorValues* b,
        std::size_t row,
        std::pair<double, double> phase,
        double* out
    ) const {
        const std::size_t width = a.result.component_count();
        for (std::size_t c = 0; c < width; ++c) {
            out[c] = a.rows[row * width + c] * phase.first;
            if (b == nullptr || phase.second == 0) continue;
            // The partner's step of a damaged file may hold fewer components.
            const std::size_t at = row * width + c;
            out[c] -= at < b->rows.size() ? b->rows[at] * phase.second : std::nan("");
        }
    }

    std::pair<double, double> phase(std::size_t s, const StepPlan& plan) const {
        auto [cosine, sine] = phase_of(s, plan.harmonic, sectors_.count());
        return {cosine, sine * plan.sign};
    }

    void spread_nodal(
        const SectorValues& a, const std::optional<SectorValues>& b, const StepPlan& plan, Result& result
    ) const {
        const std::size_t width = a.result.component_count();
        result.values.assign(mesh_.node_count() * width, std::numeric_limits<float>::quiet_NaN());
        std::vector<double> row(width);
        for (std::size_t s = 0; s < sectors_.count(); ++s) {
            const auto now = phase(s, plan);
            for (std::uint32_t i = 0; i < base().node_count(); ++i) {
                const NodeIndex node{i};
                if (!sectors_.is_own(node) || sectors_.standing_for(s, node) != std::pair{s, node}) continue;
                combine(a, b ? &*b : nullptr, i, now, row.data());
                if (s > 0) turn_row(result.info, sectors_.turn(s), row.data());
                float* to = result.values.data() + raw(places_[s * base().node_count() + i]) * width;
                for (std::size_t c = 0; c < width; ++c) to[c] = static_cast<float>(row[c]);
            }
        }
    }

    void spread_rows(
        const SectorValues& a, const std::optional<SectorValues>& b, const StepPlan& plan, Result& result
    ) const {
        const std::size_t width = a.result.component_count();
        const std::size_t elements = base().element_count();
        struct Place {
            std::uint32_t owner;
            std::size_t sector, row;
        };
        std::vector<Place> places;
        for (std::size_t s = 0; s < sectors_.count(); ++s) {
            for (std::size_t row = 0; row < a.result.row_count(); ++row) {
                const ElementIndex owner = element_places_[s * elements + a.result.row_owner[row]];
                if (owner != kNoElement) places.push_back({raw(owner), s, row});
            }
        }
        std::ranges::stable_sort(places, {}, &Place::owner);
        std::vector<double> row(width);
        for (const Place& place : places) {
            combine(a, b ? &*b : nullptr, place.row, phase(place.sector, plan), row.data());
            if (place.sector > 0) turn_row(result.info, sectors_.turn(place.sector), row.data());
            result.row_owner.push_back(place.owner);
            result.row_node.push_back(
                places_[place.sector * base().node_count() + raw(a.result.row_node[place.row])]
            );
            for (const double value : row) result.values.push_back(static_cast<float>(value));
        }
    }

    /// The first result at nodes that tells whether sectors fit: all of a step run round alike.
    std::optional<std::size_t> witness(std::uint32_t step) const {
        const auto results = sector_->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            const ResultInfo& info = results[i];
            const bool fits = is_vector(info) || info.shape == Shape::Scalar;
            if (info.step == step && info.location == Location::Nodal && fits && is_shown(info)) return i;
        }
        return std::nullopt;
    }

    static bool is_shown(const ResultInfo& info) {
        // Reactions on the sides of a sector are those of its neighbours.
        return info.complex == Complex::No && !info.name.starts_with("reaction") &&
               info.location != Location::Elemental &&
               (info.components.size() == 1 || is_vector(info) || is_tensor(info));
    }

    std::int64_t harmonic_of(std::uint32_t step) const {
        for (const ResultSet& set : sector_->sets().sets) {
            if (set.step == step) return set.harmonic_index;
        }
        return 0;
    }

    /// Largest jump between the sides of neighbours, in parts of the largest value.
    double jump(const SectorValues& a, const SectorValues* b, const StepPlan& plan) const {
        const std::size_t width = a.result.component_count();
        double most = 0, largest = 0;
        std::vector<double> row(width);
        for (std::uint32_t i = 0; i < base().node_count(); ++i) {
            if (!sectors_.is_own(NodeIndex{i})) continue;
            for (std::size_t c = 0; c < width; ++c) {
                const double value = std::abs(a.rows[i * width + c]);
                if (value > largest) largest = value;
            }
            const NodeIndex low = sectors_.low_of(NodeIndex{i});
            if (low == kNoNode) continue;
            combine(a, b, raw(low), phase(1, plan), row.data());
            turn_row(a.result.info, sectors_.turn(1), row.data());
            for (std::size_t c = 0; c < width; ++c) {
                const double apart = std::abs(row[c] - a.rows[i * width + c]);
                // A node without the unknown has it on neither side.
                const bool both_missing = std::isnan(row[c]) && std::isnan(a.rows[i * width + c]);
                if (!both_missing && !(apart <= most)) most = std::isnan(apart) ? 1e30 : apart;
            }
        }
        return largest == 0 ? most : most / largest;
    }

    StepPlan plan_of(std::uint32_t step) const {
        StepPlan plan;
        const std::int64_t harmonic = harmonic_of(step);
        plan.harmonic = std::abs(harmonic);
        const auto index = witness(step);
        if (!index) return plan;
        const StepKind kind = steps()[step].kind;
        const bool modes = kind == StepKind::Mode || kind == StepKind::Buckling;
        // Loads of other harmonic indexes are parts of a sum that is not in the file.
        if (!modes && plan.harmonic != 0) return plan;
        const SectorValues a = values_of(*index);
        const auto n = static_cast<std::int64_t>(sectors_.count());
        if (plan.harmonic == 0 || 2 * plan.harmonic == n) {
            plan.fits = jump(a, nullptr, plan) <= kFits;
            return plan;
        }
        double best = kFits;
        const auto attempt = [&](const SectorValues& b, StepPlan tried) {
            for (const double sign : {1.0, -1.0}) {
                tried.sign = sign;
                const double found = jump(a, &b, tried);
                if (found > best) continue;
                best = found;
                tried.fits = true;
                plan = tried;
            }
        };
        for (const std::uint32_t other : {step - 1, step + 1}) {
            if (!is_pair(step, other)) continue;
            const auto at = witness(other);
            if (!at) continue;
            StepPlan tried = plan;
            tried.partner = other;
            tried.own_copies = false;
            attempt(values_of(*at), tried);
        }
        if (std::ranges::any_of(copies_, [](NodeIndex copy) { return copy != kNoNode; })) {
            StepPlan tried = plan;
            tried.own_copies = true;
            attempt(copied(a), tried);
        }
        return plan;
    }

    bool is_pair(std::uint32_t step, std::uint32_t other) const {
        if (other >= steps().size()) return false;
        const Step& a = steps()[step];
        const Step& b = steps()[other];
        return a.step == b.step && std::abs(harmonic_of(step)) == std::abs(harmonic_of(other)) &&
               std::abs(a.value - b.value) <= kSameFrequency * std::abs(a.value);
    }

    void plan_steps() {
        std::uint64_t left_out = 0;
        for (std::uint32_t step = 0; step < steps().size(); ++step) {
            plans_.push_back(plan_of(step));
            if (!plans_.back().fits) ++left_out;
        }
        if (left_out == 0) return;
        diagnostics_.add(
            Code::StepsLeftOut,
            sector_->records().input().name(),
            "results of steps are left out: it is not known how they run on from sector to sector. Without "
            "--expand-cyclic the sector in the file is shown with all of them",
            left_out
        );
    }

    void list_results() {
        std::uint64_t left_out = 0;
        const auto results = sector_->results();
        for (std::size_t i = 0; i < results.size(); ++i) {
            const ResultInfo& info = results[i];
            const StepPlan& plan = plans_[info.step];
            if (!plan.fits) continue;
            // The second sector's elements are not tried.
            const bool known = info.location == Location::Nodal || !plan.own_copies;
            if (!is_shown(info) || !known) {
                ++left_out;
                continue;
            }
            infos_.push_back(info);
            infos_.back().nodal_system = false;
            sources_.push_back(i);
        }
        if (left_out == 0) return;
        diagnostics_.add(
            Code::ResultForPartOfModel,
            sector_->records().input().name(),
            "results are left out in the expanded model: reactions, parts of complex responses, vectors with "
            "components missing, values of whole elements and of beams",
            left_out
        );
    }

    std::unique_ptr<RstSource> sector_;
    Sectors sectors_;
    Diagnostics& diagnostics_;
    Mesh mesh_;
    std::int64_t node_offset_ = 0, element_offset_ = 0;
    std::vector<NodeIndex> places_;             ///< By sector, then node of the file.
    std::vector<ElementIndex> element_places_;  ///< By sector, then element of the file.
    std::vector<NodeIndex> copies_;             ///< Of nodes in the second sector of the file.
    std::vector<StepPlan> plans_;
    std::vector<ResultInfo> infos_;
    std::vector<std::size_t> sources_;  ///< Into the sector's results.
};

}  // namespace

std::unique_ptr<ModelSource> expand_sectors(std::unique_ptr<RstSource> sector, Diagnostics& diagnostics) {
    std::string reason;
    auto sectors = Sectors::find(sector->records(), sector->header(), sector->mesh(), reason);
    if (sectors) return std::make_unique<CyclicSource>(std::move(sector), std::move(*sectors), diagnostics);
    diagnostics.add(
        Code::ResultForPartOfModel,
        sector->records().input().name(),
        fmt::format("only the sector in the file is shown, for {}", reason)
    );
    return sector;
}

}  // namespace feelem::rst
