// SPDX-License-Identifier: Apache-2.0
// A results file as a ModelSource: one pass lists what is there, values are read on demand.
#include "read/abaqus/abaqus_fil.hpp"

#include "read/abaqus/fil_contents.hpp"
#include "read/abaqus/fil_values.hpp"
#include "read/element_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace feelem {
namespace {

using namespace fil;

Likelihood recognise_fil(const Input& input) {
    return coding_of(input) == Coding::None ? Likelihood::No : Likelihood::Sure;
}

/// Where both have a node it must be at one place. Instances have other numbers here than in the deck, and
/// such a pair must not pass for one model.
void check_same_places(const Mesh& deck, const Mesh& own, const std::string& name) {
    double largest = 0;
    for (const Point3& point : deck.coordinates) {
        for (const double x : point) {
            if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        }
    }
    for (std::size_t i = 0; i < own.node_count(); ++i) {
        const NodeIndex node = find_node(deck, own.node_ids[i]);
        bool same = node != kNoNode;
        for (std::size_t axis = 0; same && axis < 3; ++axis) {
            const double difference = own.coordinates[i][axis] - deck.coordinates[raw(node)][axis];
            same = std::abs(difference) <= 1e-5 * largest;
        }
        if (same) continue;
        throw Error(
            Code::MeshesDiffer,
            name,
            fmt::format(
                "node {} is not there, or elsewhere, in the inputs before it. Abaqus numbers the nodes of "
                "several "
                "instances anew in the .fil: open it without the deck.",
                raw(own.node_ids[i])
            )
        );
    }
}

class FilSource : public ModelSource {
public:
    FilSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics), coding_(coding_of(input_)),
          contents_(read_contents(input_, coding_, diagnostics)), mesh_(&contents_.mesh) {
        if (context.mesh != nullptr) {
            check_same_places(*context.mesh, contents_.mesh, input_.name());
            mesh_ = context.mesh;
        }
        if (mesh_->node_count() == 0) {
            throw Error(Code::NoNodes, input_.name(), "the results file defines no nodes");
        }
        elements_ = std::make_unique<ElementLookup>(*mesh_);
        for (Listed& listed : contents_.results) {
            // *NODE FILE writes vectors in the directions of *TRANSFORM, which only the deck tells.
            const bool vector = listed.at == At::Node && listed.info.shape == Shape::Vector;
            listed.info.nodal_system = vector && !mesh_->node_angles.empty();
            infos_.push_back(listed.info);
        }
        reported_.resize(infos_.size());
        note_directions();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return contents_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return contents_.solver; }
    std::string title() const override { return contents_.title; }

    Result load(std::size_t index) override {
        const Listed& listed = contents_.results.at(index);
        LoadedValues loaded = load_values(input_, coding_, listed, *mesh_, *elements_);
        if (!reported_[index]) report(listed, loaded);
        reported_[index] = true;
        return std::move(loaded.result);
    }

private:
    void note_directions() {
        const auto is_tensor = [](const Listed& listed) { return listed.is_tensor; };
        const bool shells = std::ranges::any_of(contents_.results, [](const Listed& listed) {
            return listed.section_point > 0;
        });
        const bool tensors = std::ranges::any_of(contents_.results, is_tensor);
        if (tensors && (shells || contents_.has_local_directions)) {
            diagnostics_.add(
                Code::CoordinateSystem,
                input_.name(),
                "components of shells, and of elements with an *ORIENTATION, are in the elements' own "
                "directions"
            );
        }
        const bool points = std::ranges::any_of(contents_.results, [](const Listed& listed) {
            return listed.at == At::Point;
        });
        if (points) {
            diagnostics_.add(
                Code::UnknownBlock,
                input_.name(),
                "values at integration points: an element shows the mean of its points. *EL FILE, "
                "POSITION=AVERAGED AT NODES or NODES gives values at nodes"
            );
        }
    }

    void report(const Listed& listed, const LoadedValues& loaded) {
        if (loaded.without_place > 0) {
            diagnostics_.add(
                Code::ResultWithoutNode,
                input_.name(),
                fmt::format(
                    "{} lists nodes or elements that the mesh does not have", listed.info.solver_name
                ),
                loaded.without_place
            );
        }
        if (loaded.without_number > 0) {
            diagnostics_.add(
                Code::NonFiniteValue,
                input_.name(),
                fmt::format(
                    "{} has values that are no finite numbers; they count as missing", listed.info.solver_name
                ),
                loaded.without_number
            );
        }
    }

    Input input_;
    Diagnostics& diagnostics_;
    Coding coding_;
    Contents contents_;
    const Mesh* mesh_;
    std::unique_ptr<ElementLookup> elements_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

std::unique_ptr<ModelSource> open_fil(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    if (coding_of(inputs.front()) == Coding::None) {
        throw Error(
            Code::BadStructure,
            inputs.front().name(),
            "this is no results file of Abaqus, neither ASCII nor binary"
        );
    }
    return std::make_unique<FilSource>(inputs.front(), context, diagnostics);
}

}  // namespace

ReadFormat abaqus_fil_format() {
    return {
        {"abaqus-fil", "Abaqus results files, ASCII and binary", ".fil", true, true},
        false,
        recognise_fil,
        open_fil};
}

}  // namespace feelem
