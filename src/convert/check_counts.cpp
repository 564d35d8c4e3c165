// SPDX-License-Identifier: Apache-2.0
// The certificate's numbers of the model and its facets: the skin is made again from the inputs, and must
// count and measure the same.
#include "convert/check_inputs.hpp"
#include "convert/skin_options.hpp"

#include "feelem/skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace feelem {
namespace {

using Numbers = std::map<std::string, double>;

/// Skinned as the scene's notes say it was.
SkinOptions options_of(const Scene& scene, Job job) {
    const auto note = [&](const char* name) {
        const auto found = scene.notes.find(name);
        return found == scene.notes.end() ? std::string() : found->second;
    };
    job.skin.method = note("skin") == "all"         ? SkinMethod::All
                      : note("skin") == "node-list" ? SkinMethod::NodeList
                                                    : SkinMethod::Exact;
    const std::string subdivide = note("subdivide");
    if (subdivide.size() == 1 && subdivide[0] >= '0' && subdivide[0] <= '6') {
        job.skin.subdivide = static_cast<unsigned>(subdivide[0] - '0');
    }
    const bool unshared =
        std::ranges::any_of(scene.parts, [](const ScenePart& part) { return part.domain == "element-node"; });
    job.skin.domain = unshared ? Domain::ElementNode : Domain::Node;
    return skin_options(job);
}

Numbers numbers_of(const Mesh& mesh, const SkinReport& skin) {
    const auto real = [](std::uint64_t count) { return static_cast<double>(count); };
    Numbers numbers{
        {"model.nodes", real(mesh.node_count())},
        {"model.elements", real(mesh.element_count())},
        {"skin.elements", real(mesh.element_count())},
        {"skin.facets.in", real(skin.solid_facets_in)},
        {"skin.facets.kept", real(skin.solid_facets_kept)},
        {"skin.facets.keptTriangles", real(skin.solid_tri_kept)},
        {"skin.facets.keptQuads", real(skin.solid_quad_kept)},
        {"skin.facets.dropped.inner", real(skin.facets_inner)},
        {"skin.facets.dropped.manyOwners", real(skin.facets_many_owners)},
        {"skin.facets.dropped.collapsed", real(skin.facets_collapsed)},
        {"skin.facets.dropped.ofDuplicates", real(skin.facets_of_duplicates)},
        {"skin.facets.unmatched", real(skin.unmatched_facets)},
        {"skin.facets.shellTriangles", real(skin.shell_tri)},
        {"skin.facets.shellQuads", real(skin.shell_quad)},
        {"skin.duplicateElements", real(skin.duplicate_elements)},
        {"skin.invertedElements", real(skin.inverted_elements)},
        {"skin.vertices", real(skin.vertices)},
        {"skin.triangles", real(skin.triangles)},
        {"skin.area", skin.area},
        {"skin.volume", skin.volume},
    };
    for (const auto& [type, count] : mesh.skipped_elements) {
        numbers.emplace("model.skippedElements." + type, real(count));
    }
    return numbers;
}

}  // namespace

Claim check_counts(const Mesh& mesh, const Scene& scene, const Job& job) {
    Tally tally{"numbers of the certificate"};
    const auto skin = scene.notes.find("skin");
    if (skin != scene.notes.end() && skin->second == "node-list" && job.surface_nodes_file.empty()) {
        tally.name += " (not made again: --surface-nodes was not given)";
        return tally.claim();
    }
    Diagnostics told_when_converted;
    const Surface surface = make_skin(mesh, options_of(scene, job), told_when_converted);
    const Numbers wanted = numbers_of(mesh, surface.report);
    for (const auto& [name, number] : wanted) {
        const auto claimed = scene.certificate_numbers.find(name);
        const bool stands = claimed != scene.certificate_numbers.end();
        tally.count(stands && claimed->second == number, [&, name = name, number = number] {
            return fmt::format(
                "{} is {} by the inputs, not {}",
                name,
                number,
                stands ? fmt::format("{}", claimed->second) : "left out"
            );
        });
    }
    for (const auto& [name, number] : scene.certificate_numbers) {
        tally.count(wanted.contains(name), [&, name = name] {
            return fmt::format("the inputs have no {}", name);
        });
    }
    return tally.claim();
}

}  // namespace feelem
