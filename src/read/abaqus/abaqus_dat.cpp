// SPDX-License-Identifier: Apache-2.0
// A .dat of Abaqus as a ModelSource: tables are found on opening, rows read on demand.
#include "read/abaqus/abaqus_dat.hpp"

#include "read/abaqus/print_results.hpp"
#include "read/abaqus/print_tables.hpp"
#include "read/abaqus/print_values.hpp"
#include "read/element_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace feelem {
namespace {

using namespace printed;

Likelihood recognise_printed(const Input& input) {
    return is_printed_by_abaqus(head_of(input)) ? Likelihood::Sure : Likelihood::No;
}

class PrintedSource : public ModelSource {
public:
    PrintedSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics), mesh_(context.mesh) {
        if (mesh_ == nullptr) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                "Abaqus' printed tables hold values without a mesh. Open them together with the .inp of the "
                "same job."
            );
        }
        if (diagnostics.has(Code::IdsOffset)) {
            throw Error(
                Code::MeshesDiffer,
                input_.name(),
                "the deck's instances repeat node or element numbers, and Abaqus numbers them anew in its "
                ".dat: the "
                "rows cannot be told apart. Use tools/abaqus/feelem_export.py on the .odb"
            );
        }
        file_ = scan_printed(input_, diagnostics);
        listed_ = list_printed(file_.tables);
        for (PrintedResult& listed : listed_) {
            // *NODE PRINT writes vectors in the directions of *TRANSFORM, unless GLOBAL=YES.
            const bool vector = listed.place == Place::Node && listed.info.shape == Shape::Vector;
            listed.info.nodal_system = vector && !mesh_->node_angles.empty();
            infos_.push_back(listed.info);
        }
        reported_.resize(infos_.size());
        elements_ = std::make_unique<ElementLookup>(*mesh_);
        note();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return file_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override {
        return file_.solver.name.empty() ? SolverInfo{"Abaqus", ""} : file_.solver;
    }

    Result load(std::size_t index) override {
        const PrintedResult& listed = listed_.at(index);
        PrintedValues loaded = load_printed(input_, listed, file_.tables, *mesh_, *elements_);
        if (!reported_[index]) report(listed, loaded);
        reported_[index] = true;
        return std::move(loaded.result);
    }

private:
    template <class Is>
    bool any(const Is& is) const {
        return std::ranges::any_of(listed_, is);
    }

    void add(Code code, const std::string& text, std::uint64_t count = 1) {
        diagnostics_.add(code, input_.name(), text, count);
    }

    void note() {
        if (listed_.empty())
            add(Code::EmptyResult,
                "the file holds no printed tables of nodes or elements: *NODE PRINT and *EL PRINT make them");
        if (any([](const PrintedResult& listed) { return listed.place == Place::Point; })) {
            add(Code::UnknownBlock,
                "values at integration points: an element shows the mean of its points. *EL PRINT, "
                "POSITION=AVERAGED AT NODES or NODES gives values at nodes");
        }
        const bool tensors =
            any([](const PrintedResult& listed) { return listed.info.shape == Shape::SymmetricTensor; });
        const bool shells = any([](const PrintedResult& listed) { return listed.section > 0; });
        const bool marked = std::ranges::any_of(file_.tables, &PrintedTable::has_marks);
        if (tensors && (shells || marked)) {
            add(Code::CoordinateSystem,
                "components of shells, and of elements with an *ORIENTATION (marked OR), are in the "
                "elements' "
                "own "
                "directions");
        }
        if (any([](const PrintedResult& listed) { return listed.info.nodal_system; })) {
            add(Code::CoordinateSystem,
                "vectors of nodes with *TRANSFORM are taken in its directions, as *NODE PRINT writes them "
                "unless it says GLOBAL=YES");
        }
    }

    void report(const PrintedResult& listed, const PrintedValues& loaded) {
        const std::string& label = listed.info.solver_name;
        for (const std::string& text : loaded.disagreements) add(Code::ValuesDisagree, text);
        if (loaded.without_place > 0) {
            add(Code::ResultWithoutNode,
                fmt::format(
                    "{} lists nodes or elements that the mesh does not have. Abaqus numbers those of several "
                    "instances anew in the .dat: does the deck have any?",
                    label
                ),
                loaded.without_place);
        }
        if (loaded.without_number > 0) {
            add(Code::NonFiniteValue,
                fmt::format("{} has values that are no finite numbers; they count as missing", label),
                loaded.without_number);
        }
        if (listed.info.location == Location::Nodal && loaded.nodes < mesh_->node_count()) {
            add(Code::ResultForPartOfModel,
                fmt::format(
                    "{} has values for {} of {} nodes. Abaqus prints no row whose values are all zero; such "
                    "nodes "
                    "count as missing too",
                    label,
                    loaded.nodes,
                    mesh_->node_count()
                ));
        }
    }

    Input input_;
    Diagnostics& diagnostics_;
    const Mesh* mesh_;
    PrintedFile file_;
    std::vector<PrintedResult> listed_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
    std::unique_ptr<ElementLookup> elements_;
};

std::unique_ptr<ModelSource> open_printed(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<PrintedSource>(inputs.front(), context, diagnostics);
}

}  // namespace

ReadFormat abaqus_dat_format() {
    return {
        {"abaqus-dat", "Abaqus printed tables", ".dat", false, true}, false, recognise_printed, open_printed};
}

}  // namespace feelem
