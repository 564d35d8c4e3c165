// SPDX-License-Identifier: Apache-2.0
// Must: never show a value at a place that is not its own.
// Algorithm: equal meshes are one candidate; each candidate is scored by how many results find their nodes
// in it.
#include "read/choose_mesh.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace feelem {
namespace {

/// Sources that hold one and the same mesh.
struct Candidate {
    std::size_t source = 0;   ///< The first of them.
    std::size_t results = 0;  ///< Of all of them.
    std::size_t elements = 0;
    bool is_drawn = false;  ///< Has elements, and most nodes have a place.
};

bool can_be_drawn(const Mesh& mesh) {
    const auto placed =
        std::ranges::count_if(mesh.coordinates, [](const Point3& p) { return std::isfinite(p[0]); });
    return mesh.element_count() > 0 && 2 * static_cast<std::size_t>(placed) > mesh.node_count();
}

const Mesh& mesh_of(const OpenedSource& opened) {
    return opened.source->mesh();
}

struct Candidates {
    std::vector<Candidate> list;
    std::vector<std::size_t> of_source;
};

Candidates find_candidates(std::span<const OpenedSource> sources) {
    Candidates found;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Mesh& mesh = mesh_of(sources[i]);
        std::size_t at = 0;
        for (; at < found.list.size(); ++at) {
            const Mesh& its = mesh_of(sources[found.list[at].source]);
            if (&its == &mesh || is_same_mesh(its, mesh)) break;
        }
        if (at == found.list.size()) found.list.push_back({i, 0, mesh.element_count(), can_be_drawn(mesh)});
        found.list[at].results += sources[i].source->results().size();
        found.of_source.push_back(at);
    }
    return found;
}

/// How many results find their nodes in the candidate's mesh.
double score_of(const Candidate& candidate, const Candidates& all, std::span<const OpenedSource> sources) {
    const Mesh& shown = mesh_of(sources[candidate.source]);
    double score = 0;
    for (const Candidate& other : all.list) {
        const Mesh& mesh = mesh_of(sources[other.source]);
        double share = 1;
        if (other.source != candidate.source && other.results > 0 && mesh.node_count() > 0) {
            share = static_cast<double>(map_mesh(mesh, shown).same_nodes) /
                    static_cast<double>(mesh.node_count());
        }
        score += share * static_cast<double>(other.results);
    }
    return score;
}

std::size_t best_candidate(const Candidates& all, std::span<const OpenedSource> sources) {
    constexpr std::size_t kMostScored = 8;  // Each costs a comparison with all others.
    if (all.list.size() == 1) return 0;
    using Score = std::tuple<bool, double, std::size_t, std::size_t>;
    std::size_t best = 0;
    Score most{};
    for (std::size_t i = 0; i < std::min(all.list.size(), kMostScored); ++i) {
        const Candidate& candidate = all.list[i];
        const double fitting = candidate.is_drawn ? score_of(candidate, all, sources) : 0;
        const Score score{candidate.is_drawn, fitting, candidate.results, candidate.elements};
        if (i > 0 && score <= most) continue;
        best = i;
        most = score;
    }
    return best;
}

/// The one factor between all coordinates, or 0.
double scale_between(const Mesh& other, const Mesh& shown) {
    double scale = 0;
    for (std::size_t i = 0; i < other.node_count(); ++i) {
        const NodeIndex pair = find_node(shown, other.node_ids[i]);
        if (pair == kNoNode) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double mine = other.coordinates[i][axis], its = shown.coordinates[raw(pair)][axis];
            if (mine == 0 && its == 0) continue;
            const double ratio = mine / its;
            if (scale == 0) scale = ratio;
            if (!(std::abs(ratio - scale) <= 1e-3 * std::abs(scale))) return 0;
        }
    }
    return scale;
}

/// Shells and beams without any solid.
bool is_thin_mesh(const Mesh& mesh) {
    return std::ranges::all_of(mesh.blocks, [](const ElementBlock& block) {
        return element_row(block.type).dimension < 3;
    });
}

[[noreturn]] void refuse(
    const Mesh& other,
    const Mesh& shown,
    const MeshMap& map,
    const std::string& name,
    const std::string& shown_name
) {
    std::string text = fmt::format(
        "has {} nodes, {} has {}; {} agree in number and place",
        other.node_count(),
        shown_name,
        shown.node_count(),
        map.same_nodes
    );
    if (map.nodes_moved.count > 0) {
        text += fmt::format(
            ", {} stand elsewhere (node {} is {:g} away)",
            map.nodes_moved.count,
            map.farthest_id,
            map.farthest
        );
    }
    const double scale = scale_between(other, shown);
    text += scale != 0 && scale != 1
                ? fmt::format(". Its coordinates are {:g} times the others: are both in one unit?", scale)
                : ". Are the files of one model?";
    if (map.same_nodes == 0 && is_thin_mesh(other) != is_thin_mesh(shown)) {
        text +=
            " CalculiX makes solids of shells and beams, with nodes of their own, and numbers the layers of "
            "composites anew: open its .frd without the deck";
    }
    throw Error(Code::MeshesDiffer, name, text);
}

/// Tells in which things two meshes do not agree.
class Teller {
public:
    Teller(const std::string& name, std::string shown, bool has_results, Diagnostics& diagnostics)
        : name_(name), shown_(std::move(shown)), has_results_(has_results), diagnostics_(diagnostics) {}

    void tell(const MeshMap& map) {
        const char* left_out = has_results_ ? "; their values are left out" : "";
        const char* without = has_results_ ? "; they have no values of its results" : "";
        say(map.nodes_only_other, "nodes are not in", left_out);
        say(map.nodes_only_shown, "lacks nodes of", without);
        say(map.nodes_moved,
            fmt::format(
                "nodes stand elsewhere, by up to {:g} (node {}), than in", map.farthest, map.farthest_id
            ),
            left_out);
        say(map.elements_only_other, "elements are not in", "");
        say(map.elements_only_shown, "lacks elements of", "");
        say(map.elements_of_other_type,
            fmt::format("elements are of another type ({}) than in", map.types),
            "");
        say(map.elements_on_other_nodes, "elements have other nodes, or in another order, than in", "");
    }

private:
    void say(const Disagreement& what, std::string_view verb, std::string_view then) {
        if (what.count == 0) return;
        diagnostics_.add(
            Code::SourcesDisagree,
            name_,
            fmt::format(
                "{} the mesh shown, that of {}: {}{}{}",
                verb,
                shown_,
                fmt::join(what.first, ", "),
                what.count > what.first.size() ? " ..." : "",
                then
            ),
            what.count
        );
    }

    const std::string& name_;
    std::string shown_;
    bool has_results_;
    Diagnostics& diagnostics_;
};

std::string file_name_of(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

bool same_angles(const Mesh& a, const Mesh& b) {
    return a.node_angles == b.node_angles;
}

}  // namespace

void check_same_mesh(const Mesh& first, const Mesh& second, const std::string& second_name) {
    if (is_same_mesh(first, second)) return;
    const MeshMap map = map_mesh(second, first);
    if (map.same_nodes < second.node_count() || first.node_count() != second.node_count()) {
        refuse(second, first, map, second_name, "the input before it");
    }
    throw Error(
        Code::MeshesDiffer,
        second_name,
        fmt::format(
            "has {} elements, the input before it has {}; {} agree in number and corners. Are the files of "
            "one "
            "model?",
            second.element_count(),
            first.element_count(),
            map.same_elements
        )
    );
}

MeshChoice choose_mesh(
    std::span<const OpenedSource> sources, std::span<const std::string> names, Diagnostics& diagnostics
) {
    const Candidates all = find_candidates(sources);
    const std::size_t best = best_candidate(all, sources);
    MeshChoice choice;
    choice.shown = all.list[best].source;
    choice.maps.resize(sources.size());
    const Mesh& shown = mesh_of(sources[choice.shown]);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Mesh& mesh = mesh_of(sources[i]);
        if (&mesh == &shown) continue;
        MeshMap map = map_mesh(mesh, shown);
        const std::string shown_name = file_name_of(names[choice.shown]);
        if (all.of_source[i] != best) {
            if (!is_one_model(map, mesh, shown)) refuse(mesh, shown, map, names[i], shown_name);
            const bool has_results = !sources[i].source->results().empty();
            Teller(names[i], shown_name, has_results, diagnostics).tell(map);
        } else if (map.is_part_for_part && same_angles(mesh, shown)) {
            continue;  // Not even parts are counted otherwise.
        }
        choice.maps[i] = std::move(map);
    }
    return choice;
}

}  // namespace feelem
