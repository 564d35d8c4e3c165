// SPDX-License-Identifier: Apache-2.0
// A .msh file as a ModelSource: heads are listed on opening, values read on demand.
#include "read/gmsh/gmsh_format.hpp"

#include "read/gmsh/gmsh_mesh.hpp"
#include "read/gmsh/gmsh_results.hpp"
#include "read/gmsh/gmsh_sections.hpp"
#include "read/listed_source.hpp"

#include <utility>

namespace feelem {
namespace gmsh {
namespace {

Likelihood recognise_msh(const Input& input) {
    const std::string_view head = head_of(input);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || head[first] != '$') return Likelihood::No;
    if (head.substr(first).starts_with("$MeshFormat")) return Likelihood::Sure;
    const bool other_first =
        head.substr(first).starts_with("$Comments") || head.substr(first).starts_with("$PhysicalNames");
    return other_first && head.find("\n$MeshFormat") != std::string_view::npos ? Likelihood::Sure
                                                                               : Likelihood::No;
}

class MshSource : public ListedSource {
public:
    MshSource(Input file, const ReadContext& context, Diagnostics& diagnostics)
        : ListedSource(std::move(file), diagnostics), layout_(find_sections(input(), diagnostics)) {
        set_mesh(
            read_mesh(input(), layout_, diagnostics),
            context,
            "the .msh file defines no nodes. Is it a view alone? Then name the mesh before it."
        );
        Contents contents = list_contents(input(), layout_);
        listed_ = std::move(contents.results);
        std::vector<ResultInfo> infos;
        for (const Listed& listed : listed_) infos.push_back(listed.info);
        set_contents(std::move(contents.steps), std::move(infos));
    }

private:
    LoadedResult read(std::size_t index) override {
        return read_values(input(), layout_.coding, listed_[index], mesh());
    }

    Layout layout_;
    std::vector<Listed> listed_;
};

std::unique_ptr<ModelSource> open_msh(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<MshSource>(inputs.front(), context, diagnostics);
}

}  // namespace
}  // namespace gmsh

ReadFormat gmsh_msh_format() {
    return {
        {"gmsh-msh", "gmsh meshes and views, versions 2 and 4, text and binary", ".msh", true, true},
        false,
        gmsh::recognise_msh,
        gmsh::open_msh};
}

}  // namespace feelem
