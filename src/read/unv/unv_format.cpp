// SPDX-License-Identifier: Apache-2.0
// A universal file as a ModelSource: heads are listed on opening, values read on demand.
#include "read/unv/unv_format.hpp"

#include "read/listed_source.hpp"
#include "read/unv/unv_datasets.hpp"
#include "read/unv/unv_mesh.hpp"
#include "read/unv/unv_results.hpp"

#include <utility>

namespace feelem {
namespace unv {
namespace {

Likelihood recognise_unv(const Input& input) {
    return starts_like_unv(input) ? Likelihood::Sure : Likelihood::No;
}

class UnvSource : public ListedSource {
public:
    UnvSource(Input file, const ReadContext& context, Diagnostics& diagnostics)
        : ListedSource(std::move(file), diagnostics) {
        const std::vector<Dataset> datasets = find_datasets(input(), diagnostics);
        set_mesh(
            read_mesh(input(), datasets, diagnostics),
            context,
            "the universal file defines no nodes (datasets 2411, 781, 15). Were results exported alone? Then "
            "name the file with the mesh before this one."
        );
        Contents contents = list_contents(input(), datasets, diagnostics);
        listed_ = std::move(contents.results);
        std::vector<ResultInfo> infos;
        for (const Listed& listed : listed_) infos.push_back(listed.info);
        set_contents(std::move(contents.steps), std::move(infos));
    }

private:
    LoadedResult read(std::size_t index) override { return read_values(input(), listed_[index], mesh()); }

    std::vector<Listed> listed_;
};

std::unique_ptr<ModelSource> open_unv(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<UnvSource>(inputs.front(), context, diagnostics);
}

}  // namespace
}  // namespace unv

ReadFormat unv_format() {
    return {
        {"unv", "Universal files of I-deas, NX, Salome, gmsh", ".unv .uff", true, true},
        false,
        unv::recognise_unv,
        unv::open_unv};
}

}  // namespace feelem
