// SPDX-License-Identifier: Apache-2.0
// Values of a scene against id -> value tables of the inputs.
#include "convert/check_inputs.hpp"
#include "convert/model_values.hpp"
#include "convert/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace feelem {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

bool same_bits(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// The same bits, or within what the scene says that it lost.
bool is_within(float a, float b, double bound) {
    return same_bits(a, b) ||
           (bound > 0 && std::abs(static_cast<double>(a) - static_cast<double>(b)) <= bound);
}

/// Rows of a result by what they belong to.
class RowTable {
public:
    explicit RowTable(const Result& result) : result_(result) {
        if (result.row_node.empty()) return;
        order_.resize(result.row_count());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::ranges::sort(order_, {}, [&](std::size_t row) { return key(row); });
    }
    /// The row of a node (of a part or an element), or of an element; nothing when there is none.
    std::optional<std::size_t> find(NodeIndex node, std::uint32_t part, ElementIndex element) const {
        const auto plain = [&](std::uint32_t row) {
            return row < result_.row_count() ? std::optional<std::size_t>(row) : std::nullopt;
        };
        switch (result_.info.location) {
        case Location::Nodal: return plain(raw(node));
        case Location::Elemental: return plain(raw(element));
        case Location::PartNodal: return search({part, node});
        case Location::ElementNodal: return search({raw(element), node});
        }
        return std::nullopt;
    }

private:
    using Key = std::pair<std::uint32_t, NodeIndex>;
    Key key(std::size_t row) const { return {result_.row_owner[row], result_.row_node[row]}; }
    std::optional<std::size_t> search(const Key& wanted) const {
        const auto found =
            std::ranges::lower_bound(order_, wanted, {}, [&](std::size_t row) { return key(row); });
        return found == order_.end() || key(*found) != wanted ? std::nullopt : std::optional(*found);
    }
    const Result& result_;
    std::vector<std::size_t> order_;
};

/// Mid-side node -> the corners that it lies between, once for each different pair.
using MiddleTable = std::multimap<NodeIndex, std::pair<NodeIndex, NodeIndex>>;

MiddleTable middles_of(const Mesh& mesh) {
    MiddleTable table;
    for (std::uint32_t e = 0; e < mesh.element_count(); ++e) {
        const ElementRef element = element_at(mesh, ElementIndex{e});
        const auto nodes = element.nodes();
        for (const EdgeRow& edge : edges_of(element.block->type)) {
            if (edge.middle == kNoLocalNode || nodes[edge.middle] == kNoNode) continue;
            const std::pair ends = std::minmax({nodes[edge.first], nodes[edge.second]});
            const auto [first, last] = table.equal_range(nodes[edge.middle]);
            const bool known =
                std::any_of(first, last, [&](const auto& entry) { return entry.second == ends; });
            if (!known) table.emplace(nodes[edge.middle], ends);
        }
    }
    return table;
}

/// One field of the scene and what it is compared with.
struct Comparison {
    const Mesh& mesh;
    const Result& result;  ///< The components of the scene's result, in its order.
    const RowTable& rows;
    const MiddleTable& middles;  ///< Empty but for corner-only results.
    const ScenePart& part;
    const SceneField& field;
    const std::vector<ElementIndex>& vertex_element;
    double bound = 0;  ///< What the scene says that a value may be off.

    std::size_t width() const { return result.component_count(); }
    float value(std::optional<std::size_t> row, std::size_t component) const {
        return row ? result.values[*row * width() + component] : kMissing;
    }
    bool has_value(std::optional<std::size_t> row) const {
        for (std::size_t c = 0; c < width(); ++c) {
            if (!std::isfinite(value(row, c))) return false;
        }
        return row.has_value();
    }
    float found(std::size_t vertex, std::size_t component) const {
        return field.values[vertex * width() + component];
    }
    std::optional<std::size_t> row(NodeIndex node, std::size_t vertex) const {
        return rows.find(node, part.model_part, vertex_element[vertex]);
    }
    bool is_mean_of_corners(NodeIndex node, std::size_t vertex) const {
        const auto [first, last] = middles.equal_range(node);
        return std::any_of(first, last, [&](const auto& entry) {
            const auto a = row(entry.second.first, vertex), b = row(entry.second.second, vertex);
            for (std::size_t c = 0; c < width(); ++c) {
                const double sum = static_cast<double>(value(a, c)) + static_cast<double>(value(b, c));
                if (!is_within(static_cast<float>(0.5 * sum), found(vertex, c), bound)) return false;
            }
            return true;
        });
    }
    bool agrees(std::size_t vertex) const {
        const NodeIndex node = find_node(mesh, NodeId{part.node_ids[vertex]});
        if (node == kNoNode) return false;
        const auto at = row(node, vertex);
        if (field.validity[vertex] == Validity::Interpolated)
            return result.info.corner_only && !has_value(at) && is_mean_of_corners(node, vertex);
        if (field.validity[vertex] == Validity::Missing)
            return !has_value(at) && !is_mean_of_corners(node, vertex);
        if (!has_value(at)) return false;
        for (std::size_t c = 0; c < width(); ++c) {
            if (!is_within(value(at, c), found(vertex, c), bound)) return false;
        }
        return true;
    }
};

std::vector<ElementIndex> elements_of_vertices(const ScenePart& part, const ElementTable& elements) {
    std::vector<ElementIndex> out(part.positions.size(), kNoElement);
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        for (const std::uint32_t corner : part.triangles[t]) {
            if (out[corner] == kNoElement) out[corner] = elements(part.element_ids[t]);
        }
    }
    return out;
}

/// The result's components by name, stored or derived. Empty when it does not have them.
std::optional<Result> with_components(const Result& result, const std::vector<std::string>& names) {
    Result out;
    out.info = result.info;
    out.info.components = names;
    out.row_owner = result.row_owner;
    out.row_node = result.row_node;
    out.values.resize(result.row_count() * names.size());
    for (std::size_t c = 0; c < names.size(); ++c) {
        const auto known = all_components(result.info);
        if (std::ranges::find(known, names[c]) == known.end()) return std::nullopt;
        const Result one = component_of(result, names[c]);
        for (std::size_t row = 0; row < out.row_count(); ++row)
            out.values[row * names.size() + c] = one.values[row];
    }
    return out;
}

bool may_be(const ModelSource& source, const ResultInfo& info, const SceneResult& wanted, const Step& step) {
    const Step& its = source.steps()[info.step];
    return info.name == wanted.quantity && info.solver_name == wanted.source &&
           info.complex == wanted.complex && info.layer == wanted.layer && info.system == wanted.system &&
           its.step == step.step && its.substep == step.substep && its.kind == step.kind &&
           its.value == step.value;
}

/// A sum of at most eight floats in double, rounded once. Terms of very different size, such as 9.5 and
/// 1e-12, make it inexact: then the order in which they are added decides how a tie is rounded, and any is
/// right.
class RoundedSum {
public:
    RoundedSum(double sum, double size_of_terms, double bound)
        : sum_(sum), slack_(8 * std::numeric_limits<double>::epsilon() * size_of_terms + bound) {}
    float value() const { return static_cast<float>(sum_); }
    bool may_be(float found) const {
        if (std::isnan(sum_)) return std::isnan(found);
        return static_cast<float>(sum_ - slack_) <= found && found <= static_cast<float>(sum_ + slack_);
    }

private:
    double sum_, slack_;
};

/// Centres of quads and left-out middles, from the scene's own vertices around them (checked themselves).
struct CentreCheck {
    const Mesh& mesh;
    const ElementTable& elements;
    const ScenePart& part;
    double bound = 0;                                              ///< Of the field at hand.
    std::map<std::uint32_t, std::vector<std::uint32_t>> around{};  ///< Vertices that share a triangle.
    std::map<std::uint32_t, std::int64_t> element{};

    void gather() {
        for (std::size_t t = 0; t < part.triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = part.triangles[t][i];
                if (part.node_ids[vertex] != 0) continue;
                element.emplace(vertex, part.element_ids[t]);
                for (const std::size_t other : {(i + 1) % 3, (i + 2) % 3}) {
                    std::vector<std::uint32_t>& list = around[vertex];
                    const std::uint32_t neighbour = part.triangles[t][other];
                    if (std::ranges::find(list, neighbour) == list.end()) list.push_back(neighbour);
                }
            }
        }
    }
    bool is_corner(std::uint32_t vertex, std::int64_t element_id) const {
        const ElementRef at = element_at(mesh, elements(element_id));
        const auto corners = at.nodes().first(element_row(at.block->type).corner_count);
        const NodeIndex node = find_node(mesh, NodeId{part.node_ids[vertex]});
        return part.node_ids[vertex] != 0 && std::ranges::find(corners, node) != corners.end();
    }
    /// The value at a vertex that has no node; nothing where this check does not know the rule.
    std::optional<RoundedSum> expected(
        std::uint32_t vertex, const SceneField& field, std::size_t width, std::size_t component
    ) const {
        const std::vector<std::uint32_t>& neighbours = around.at(vertex);
        const std::int64_t id = element.at(vertex);
        if (elements(id) == kNoElement) return std::nullopt;
        double corners = 0, middles = 0, size = 0;
        std::size_t corner_count = 0, middle_count = 0;
        for (const std::uint32_t neighbour : neighbours) {
            if (part.node_ids[neighbour] == 0) return std::nullopt;
            const double value = static_cast<double>(field.values[neighbour * width + component]);
            const bool corner = is_corner(neighbour, id);
            (corner ? corners : middles) += value;
            ++(corner ? corner_count : middle_count);
            size += std::abs(value);
        }
        // Each of the values may be off, and the weights' sizes add up to 1 and to 3.
        if (corner_count == 4 && middle_count == 0) return RoundedSum(0.25 * corners, size, 2 * bound);
        if (corner_count == 4 && middle_count == 4)
            return RoundedSum(0.5 * middles - 0.25 * corners, size, 4 * bound);
        return std::nullopt;
    }
};

void check_centres(const CentreCheck& centres, const SceneField& field, std::size_t width, Tally& tally) {
    for (const auto& [vertex, neighbours] : centres.around) {
        for (std::size_t c = 0; c < width; ++c) {
            const std::optional<RoundedSum> wanted = centres.expected(vertex, field, width, c);
            if (!wanted) continue;
            const float found = field.values[vertex * width + c];
            tally.count(wanted->may_be(found), [&, id = centres.element.at(vertex)] {
                return fmt::format("on a facet of element {}: {} instead of {}", id, found, wanted->value());
            });
        }
    }
}

struct ValueCheck {
    ModelSource& source;
    const Scene& scene;
    ElementTable elements;
    std::vector<std::vector<ElementIndex>> vertex_elements{};
    std::vector<CentreCheck> centres{};
    std::optional<MiddleTable> middles{};

    Tally compare(
        const Result& result, std::size_t scene_result, std::size_t values, const std::string& name
    ) {
        if (result.info.corner_only && !middles) middles = middles_of(source.mesh());
        static const MiddleTable kNone;
        const RowTable rows(result);
        Tally tally{name};
        const SceneResult& said = scene.results[scene_result];
        const std::size_t step = said.values[values].step;
        for (std::size_t p = 0; p < scene.parts.size(); ++p) {
            const auto field = std::ranges::find_if(scene.fields, [&](const SceneField& one) {
                return one.result == scene_result && one.step == step && one.part == p;
            });
            const ScenePart& part = scene.parts[p];
            if (field == scene.fields.end()) {
                count_absent(part, rows, result, p, tally);
                continue;
            }
            const MiddleTable& between = result.info.corner_only ? *middles : kNone;
            const Comparison comparison{
                source.mesh(), result, rows, between, part, *field, vertex_elements[p], said.bound};
            for (std::size_t v = 0; v < part.positions.size(); ++v) {
                if (part.node_ids[v] == 0) continue;
                tally.count(comparison.agrees(v), [&] {
                    const NodeIndex node = find_node(source.mesh(), NodeId{part.node_ids[v]});
                    const float wanted =
                        node == kNoNode ? kMissing : comparison.value(comparison.row(node, v), 0);
                    return fmt::format(
                        "node {}: {} in the inputs, {} in the scene",
                        part.node_ids[v],
                        wanted,
                        comparison.found(v, 0)
                    );
                });
            }
            centres[p].bound = said.bound;
            check_centres(centres[p], *field, result.component_count(), tally);
        }
        count_statements(source.mesh(), result, said, said.values[values], tally);
        return tally;
    }
    /// A part without accessor has no value of that result in the inputs either.
    void count_absent(
        const ScenePart& part, const RowTable& rows, const Result& result, std::size_t p, Tally& tally
    ) const {
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            if (part.node_ids[v] == 0) continue;
            const NodeIndex node = find_node(source.mesh(), NodeId{part.node_ids[v]});
            const auto row =
                node == kNoNode ? std::nullopt : rows.find(node, part.model_part, vertex_elements[p][v]);
            const bool none = !row || std::isnan(result.values[*row * result.component_count()]);
            tally.count(none, [&] {
                return fmt::format("node {} has a value in the inputs", part.node_ids[v]);
            });
        }
    }
    /// The same name may come from several inputs: the one that agrees counts, else the first.
    Claim check(std::size_t scene_result, std::size_t values) {
        const SceneResult& wanted = scene.results[scene_result];
        const std::size_t step = wanted.values[values].step;
        const std::string name = fmt::format("values of {} at step {}", wanted.id, step + 1);
        std::optional<Tally> best;
        for (std::size_t i = 0; i < source.results().size(); ++i) {
            if (!may_be(source, source.results()[i], wanted, scene.steps[step])) continue;
            const auto picked =
                with_components(load_prepared(source, i, wanted.averaging), wanted.components);
            if (!picked) continue;
            const Tally tally = compare(*picked, scene_result, values, name);
            if (!best || tally.wrong == 0) best = tally;
            if (tally.wrong == 0) break;
        }
        if (!best) return {name, "in the inputs", "no such result in the inputs", false};
        return best->claim();
    }
};

}  // namespace

std::vector<Claim> check_values(ModelSource& source, const Scene& scene, const Progress& progress) {
    ValueCheck check{source, scene, ElementTable(source.mesh())};
    for (const ScenePart& part : scene.parts) {
        check.vertex_elements.push_back(elements_of_vertices(part, check.elements));
        CentreCheck centres{source.mesh(), check.elements, part};
        if (part.kind == "solid" || part.kind == "shell") centres.gather();
        check.centres.push_back(std::move(centres));
    }
    std::vector<Claim> claims;
    for (std::size_t r = 0; r < scene.results.size(); ++r) {
        report_progress(progress, "values", fraction_of(r, scene.results.size()));
        for (std::size_t v = 0; v < scene.results[r].values.size(); ++v) claims.push_back(check.check(r, v));
    }
    return claims;
}

}  // namespace feelem
