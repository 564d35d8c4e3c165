// SPDX-License-Identifier: Apache-2.0
#include "scene/sample_scenes.hpp"

#include "support/meshes.hpp"
#include "support/paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace feelem::test {
namespace {

std::vector<NodeIndex> facet_key(const FacetRow& facet, std::span<const NodeIndex> nodes) {
    std::vector<NodeIndex> key;
    for (const std::uint8_t local : facet_corners(facet)) key.push_back(nodes[local]);
    std::ranges::sort(key);
    return key;
}

std::array<float, 3> facet_normal(const Mesh& mesh, const std::array<NodeIndex, 4>& quad) {
    const auto at = [&](int i) { return mesh.coordinates[raw(quad[static_cast<std::size_t>(i)])]; };
    Point3 a{}, b{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        a[axis] = at(1)[axis] - at(0)[axis];
        b[axis] = at(3)[axis] - at(0)[axis];
    }
    const Point3 n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return {
        static_cast<float>(n[0] / length),
        static_cast<float>(n[1] / length),
        static_cast<float>(n[2] / length)};
}

/// Makes the vertices: one for each (node, side of the box), so that corners are split at the creases.
struct Builder {
    const Mesh& mesh;
    Domain domain;
    Surface surface{};
    std::map<std::tuple<NodeIndex, std::array<float, 3>, ElementIndex>, VertexIndex> known{};

    VertexIndex add(
        NodeIndex node, const Point3& at, const std::array<float, 3>& normal, ElementIndex element
    ) {
        const auto index = VertexIndex{static_cast<std::uint32_t>(surface.positions.size())};
        surface.positions.push_back(at);
        surface.normals.push_back(normal);
        surface.vertex_node.push_back(node);
        if (domain == Domain::ElementNode) surface.vertex_element.push_back(element);
        return index;
    }
    void add_quad(const std::array<NodeIndex, 4>& quad, ElementIndex element) {
        const std::array<float, 3> normal = facet_normal(mesh, quad);
        std::array<VertexIndex, 4> corners{};
        Point3 centre{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Point3& at = mesh.coordinates[raw(quad[i])];
            for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += 0.25 * at[axis];
            const auto key = std::tuple(quad[i], normal, domain == Domain::Node ? kNoElement : element);
            auto [place, is_new] = known.try_emplace(key);
            if (is_new) place->second = add(quad[i], at, normal, element);
            corners[i] = place->second;
        }
        const VertexIndex middle = add(kNoNode, centre, normal, element);
        surface.blends.push_back({middle, static_cast<std::uint32_t>(surface.blend_sources.size()), 4});
        for (std::size_t i = 0; i < 4; ++i) {
            surface.blend_sources.push_back(corners[i]);
            surface.blend_weights.push_back(0.25);
            surface.triangles.push_back({corners[i], corners[(i + 1) % 4], middle});
            surface.triangle_element.push_back(element);
            surface.edges.push_back({corners[i], corners[(i + 1) % 4]});
        }
    }
};

void blend(const Surface& surface, SurfaceField& field) {
    for (const Blend& blend : surface.blends) {
        for (std::size_t c = 0; c < field.component_count; ++c) {
            double sum = 0;
            for (std::size_t i = blend.first; i < blend.first + blend.count; ++i)
                sum += surface.blend_weights[i] *
                       static_cast<double>(
                           field.values[raw(surface.blend_sources[i]) * field.component_count + c]
                       );
            field.values[raw(blend.vertex) * field.component_count + c] = static_cast<float>(sum);
        }
        const bool known = std::isfinite(field.values[raw(blend.vertex) * field.component_count]);
        field.validity[raw(blend.vertex)] = known ? Validity::Interpolated : Validity::Missing;
    }
}

}  // namespace

Surface outer_facets(const Mesh& mesh, Domain domain) {
    std::map<std::vector<NodeIndex>, int> owners;
    const auto for_each_facet = [&](const auto& visit) {
        for (std::uint32_t e = 0; e < mesh.element_count(); ++e) {
            const ElementRef element = element_at(mesh, ElementIndex{e});
            for (const FacetRow& facet : facets_of(element.block->type))
                visit(facet, element.nodes(), ElementIndex{e});
        }
    };
    for_each_facet([&](const FacetRow& facet, std::span<const NodeIndex> nodes, ElementIndex) {
        ++owners[facet_key(facet, nodes)];
    });
    Builder builder{mesh, domain};
    SkinReport& report = builder.surface.report;
    for_each_facet([&](const FacetRow& facet, std::span<const NodeIndex> nodes, ElementIndex element) {
        ++report.solid_facets_in;
        if (owners[facet_key(facet, nodes)] > 1) {
            ++report.facets_inner;
            return;
        }
        ++report.solid_facets_kept;
        ++report.solid_quad_kept;
        report.area += 1;  // unit squares
        const auto corners = facet_corners(facet);
        builder.add_quad(
            {nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[3]]}, element
        );
    });
    Surface surface = std::move(builder.surface);
    std::set<NodeIndex> nodes(surface.vertex_node.begin(), surface.vertex_node.end());
    nodes.erase(kNoNode);
    surface.report.vertices = nodes.size();
    surface.report.triangles = surface.triangles.size();
    surface.report.has_solids = surface.report.closed = true;
    surface.report.volume = static_cast<double>(mesh.element_count());
    surface.domain = domain;
    surface.parts.push_back(
        {PartIndex{0},
         PartKind::Solid,
         0,
         static_cast<std::uint32_t>(surface.positions.size()),
         0,
         static_cast<std::uint32_t>(surface.triangles.size()),
         0,
         static_cast<std::uint32_t>(surface.edges.size())}
    );
    return surface;
}

void add_result(
    Sample& sample,
    const SampleResult& result,
    const std::function<float(std::int64_t, std::size_t, std::size_t)>& make
) {
    SceneResult out;
    out.id = out.quantity = out.title = result.id;
    out.source = "TEST";
    out.shape = result.shape;
    out.components = result.components;
    out.unit = result.unit;
    const std::size_t width = result.components.size();
    std::vector<SurfaceField>& fields = sample.fields.emplace_back();
    for (std::size_t step = 0; step < sample.contents.steps.size(); ++step) {
        SceneValues values;
        values.step = step;
        for (const NodeId node : sample.mesh.node_ids) {
            const float value = make(raw(node), step, 0);
            values.missing_in_model += std::isnan(value) ? 1u : 0u;
            if (std::isnan(value) || width > 1) continue;
            if (!values.min || value < values.min->value) values.min = Extreme{value, raw(node)};
            if (!values.max || value > values.max->value) values.max = Extreme{value, raw(node)};
        }
        SurfaceField& field = fields.emplace_back();
        field.component_count = static_cast<std::uint32_t>(width);
        for (const NodeIndex node : sample.surface.vertex_node) {
            for (std::size_t c = 0; c < width; ++c)
                field.values.push_back(
                    node == kNoNode ? 0 : make(raw(sample.mesh.node_ids[raw(node)]), step, c)
                );
            const bool known = !std::isnan(field.values.back());
            field.validity.push_back(known ? Validity::Solver : Validity::Missing);
        }
        blend(sample.surface, field);
        out.values.push_back(values);
    }
    sample.contents.results.push_back(std::move(out));
}

std::unique_ptr<Sample> brick_sample(int nx, int ny, int nz) {
    auto sample = std::make_unique<Sample>();
    sample->mesh = brick_grid(nx, ny, nz);
    sample->mesh.length_unit = LengthUnit{"mm", 0.001};
    sample->surface = outer_facets(sample->mesh, Domain::Node);
    SceneContents& contents = sample->contents;
    contents.title = "Bricks";
    contents.solver = {"CalculiX", "2.20"};
    contents.inputs.push_back({"/somewhere/bricks.frd", "calculix-frd", 1234, std::string(64, 'a')});
    contents.mesh = &sample->mesh;
    contents.surface = &sample->surface;
    contents.steps.push_back({0, 1, 1, StepKind::Static, 1.0, ""});
    contents.load = [all = sample.get()](std::size_t result, std::size_t values) {
        all->asked.push_back(result);
        return all->fields[result][values];
    };
    const auto number = [](std::int64_t id, std::size_t step, std::size_t component) {
        const double value = 20.1 * static_cast<double>(id) + 0.3 * static_cast<double>(component);
        return static_cast<float>(value + 7.7 * static_cast<double>(step));
    };
    add_result(*sample, {"temperature", Shape::Scalar, {"value"}, "degC"}, number);
    add_result(
        *sample,
        {"displacement", Shape::Vector, {"x", "y", "z"}, "mm"},
        [&](std::int64_t id, std::size_t step, std::size_t c) { return 1e-4F * number(id, step, c); }
    );
    add_result(
        *sample, {"stress", Shape::SymmetricTensor, {"xx", "yy", "zz", "xy", "yz", "zx"}, "MPa"}, number
    );
    contents.presentation = sample_presentation();
    return sample;
}

Presentation sample_presentation() {
    Presentation presentation;
    presentation.title = "T seen, u heard, stress felt";
    PresentedResult t, u, s;
    t.key = "T";
    t.name = "temperature";
    t.unit = "degC";
    t.lo = 60.3;
    t.hi = 290.7;
    u.key = "U";
    u.name = "displacement";
    u.component = "magnitude";
    u.unit = "mm";
    u.lo = 0.002;
    u.hi = 0.06;
    s.key = "S";
    s.name = "stress";
    s.component = "xx";
    s.unit = "MPa";
    s.lo = 20;
    s.hi = 360;
    presentation.results = {t, u, s};
    PresentedEffect seen, heard, felt;
    seen.result = "T";
    seen.colour.bands = 10;
    heard.result = "U";
    heard.sense = Sense::Pitch;
    felt.result = "S";
    felt.sense = Sense::Pulses;
    presentation.effects = {seen, heard, felt};
    presentation.deformation_result = "U";
    presentation.deformation_factor = 50;
    return presentation;
}

std::string write_sample(
    const Sample& sample, const std::string& name, const SceneOptions& options, const std::string& file
) {
    const std::string path = scratch_folder(name) + "/" + file;
    Diagnostics diagnostics;
    write_scene(sample.contents, path, options, diagnostics);
    return path;
}

}  // namespace feelem::test
