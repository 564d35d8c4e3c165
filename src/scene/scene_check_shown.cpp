// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_check_shown.hpp"

#include "scene/scene_read.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace feelem {
namespace {

struct Shown {
    const SceneFile& file;
    std::span<const ScenePart> parts;
    std::vector<Claim> claims{};

    const SceneDocument& document() const { return file.document(); }
    const SceneResult& result(std::size_t index) const { return document().scene.results[index]; }

    /// Positions and all that is drawn stand on grids: gltf::kNormalGrid, gltf::kTexcoordGrid, and their own.
    bool is_rounded() const { return document().scene.position_bound > 0; }

    void count(const std::string& name, std::size_t vertices, std::size_t wrong, const std::string& first) {
        const std::string all = fmt::format("{} of {} agree", vertices, vertices);
        claims.push_back(
            {name,
             all,
             wrong == 0 ? all : fmt::format("{} of {} agree; {}", vertices - wrong, vertices, first),
             wrong == 0}
        );
    }
    void compare(const std::string& name, double claimed, double found) {
        claims.push_back({name, fmt::format("{}", claimed), fmt::format("{}", found), claimed == found});
    }
    /// Position of a step among the values of a result.
    std::optional<std::size_t> values_at(std::size_t index, std::size_t step) const {
        const auto& values = result(index).values;
        const auto found = std::ranges::find(values, step, &SceneValues::step);
        if (found == values.end()) return std::nullopt;
        return static_cast<std::size_t>(found - values.begin());
    }
    std::vector<float> floats(std::size_t part, int accessor, unsigned width) const {
        std::vector<float> values = file.floats(accessor, width);
        if (values.size() != parts[part].positions.size() * width)
            throw Error(Code::BadScene, file.path(), fmt::format("an array does not fit part {}", part));
        return values;
    }
};

/// Vertices compared and those that are wrong.
struct Count {
    std::size_t vertices = 0, wrong = 0;
    std::string first{};

    void take(bool right, const ScenePart& part, std::size_t vertex) {
        ++vertices;
        if (!right && wrong++ == 0) first = fmt::format("node {}", part.node_ids[vertex]);
    }
};

double component_at(const SceneField& field, const SceneResult& result, std::size_t vertex, int component) {
    const float* row = field.values.data() + vertex * result.components.size();
    if (component >= 0) return static_cast<double>(row[component]);
    const double x = row[0], y = row[1], z = row[2];
    return std::sqrt(x * x + y * y + z * z);
}

/// The palette runs from 1/16 to 15/16 of the texture; a value at an end may stand 2^-15 inside it.
bool is_place_of(double value, const ValueRange& range, const float* place, double grid) {
    if (!std::isfinite(value)) return place[0] == 0.5F && place[1] == 1.0F;
    const double u = place[0];
    const Normalised where = normalise(value, range);
    if (place[1] != 0.0F || where.missing) return false;
    if (where.below) return u < 1.0 / 16;
    if (where.above) return u > 15.0 / 16;
    return std::abs(u - (1.0 / 16 + 14.0 / 16 * where.position)) <= 1.0 / 32768 + 1e-6 + grid;
}

/// The range that the presentation and the results give for a coloured result.
std::pair<double, double> range_of_presentation(const Shown& shown, const TexcoordClaim& claim) {
    const SceneResult& result = shown.result(claim.result);
    const Presentation presentation = parse_presentation(shown.document().presentation_json, "presentation");
    const auto values = shown.values_at(claim.result, claim.step);
    const SceneValues none;
    const SceneValues& at_step = values ? result.values[*values] : none;
    for (const PresentedResult& wanted : presentation.results) {
        if (wanted.name != result.quantity && wanted.name != result.id) continue;
        if (wanted.component != claim.component) continue;
        const double lo = wanted.lo ? *wanted.lo : at_step.min ? static_cast<double>(at_step.min->value) : 0;
        const double hi = wanted.hi     ? *wanted.hi
                          : at_step.max ? static_cast<double>(at_step.max->value)
                                        : lo + 1;
        return {lo, hi};
    }
    const double none_found = std::numeric_limits<double>::quiet_NaN();
    return {none_found, none_found};
}

void check_texcoord(Shown& shown, const TexcoordClaim& claim) {
    const SceneResult& result = shown.result(claim.result);
    const std::string name = fmt::format("colours of {}", result.id);
    const auto [lo, hi] = range_of_presentation(shown, claim);
    shown.compare("lower end of " + name, claim.range.lo, lo);
    shown.compare("upper end of " + name, claim.range.hi, hi);
    const auto values = shown.values_at(claim.result, claim.step);
    if (!values) throw Error(Code::BadScene, shown.file.path(), name + " are of a step without values");
    const auto found = std::ranges::find(result.components, claim.component);
    const int component =
        found == result.components.end() ? -1 : static_cast<int>(found - result.components.begin());
    if (component < 0 && result.components.size() != 3)
        throw Error(Code::BadScene, shown.file.path(), name + " are of a component that is not there");
    Count count;
    const double grid = shown.is_rounded() ? static_cast<double>(gltf::kTexcoordGrid) : 0;
    for (std::size_t p = 0; p < shown.parts.size(); ++p) {
        const auto field = read_field(shown.file, shown.parts, {claim.result, *values, p});
        const std::string semantic = fmt::format("TEXCOORD_{}", claim.set);
        const int accessor = attribute_of(shown.file, shown.document().parts[p], semantic);
        const std::vector<float> places = shown.floats(p, accessor, 2);
        for (std::size_t v = 0; v < shown.parts[p].positions.size(); ++v) {
            const double value = field ? component_at(*field, result, v, component) : NAN;
            count.take(is_place_of(value, claim.range, places.data() + 2 * v, grid), shown.parts[p], v);
        }
    }
    shown.count(name, count.vertices, count.wrong, count.first);
}

/// The displacement and, of a complex mode, its imaginary part.
std::vector<std::size_t> shapes_of(const Shown& shown, const DeformationClaim& claim) {
    const SceneResult& real = shown.result(claim.result);
    std::vector<std::size_t> shapes{claim.result};
    if (real.complex != Complex::Real) return shapes;
    const auto& results = shown.document().scene.results;
    for (std::size_t r = 0; r < results.size(); ++r) {
        if (results[r].quantity == real.quantity && results[r].complex == Complex::Imaginary &&
            results[r].components == real.components && shown.values_at(r, claim.step)) {
            shapes.push_back(r);
            break;
        }
    }
    return shapes;
}

/// One target of one part against its displacement.
void check_target(const Shown& shown, const FieldAddress& address, int target, double factor, Count& count) {
    const ScenePart& part = shown.parts[address.part];
    const auto field = read_field(shown.file, shown.parts, address);
    const std::vector<float> moves = shown.floats(address.part, target, 3);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        const float* at = field ? field->values.data() + 3 * v : nullptr;
        const bool known = at && std::isfinite(at[0]) && std::isfinite(at[1]) && std::isfinite(at[2]);
        bool right = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double move = known ? factor * static_cast<double>(at[axis]) : 0;
            right = right && std::abs(static_cast<double>(moves[3 * v + axis] - static_cast<float>(move))) <=
                                 shown.document().scene.position_bound;
        }
        count.take(right, part, v);
    }
}

void check_targets(Shown& shown) {
    const std::vector<gltf::Primitive>& parts = shown.document().parts;
    if (!shown.document().deformation) {
        const bool none =
            std::ranges::all_of(parts, [](const gltf::Primitive& part) { return part.targets.empty(); });
        shown.claims.push_back({"deformed shape", "none", none ? "none" : "one", none});
        return;
    }
    const DeformationClaim& claim = *shown.document().deformation;
    const Presentation presentation = parse_presentation(shown.document().presentation_json, "presentation");
    if (presentation.deformation_factor)
        shown.compare("deformation factor", claim.factor, *presentation.deformation_factor);
    Count count;
    const std::vector<std::size_t> shapes = shapes_of(shown, claim);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].targets.size() != shapes.size())
            throw Error(Code::BadScene, shown.file.path(), fmt::format("part {} lacks shapes", p));
        for (std::size_t s = 0; s < shapes.size(); ++s) {
            const auto values = shown.values_at(shapes[s], claim.step);
            if (!values || shown.result(shapes[s]).components.size() != 3)
                throw Error(Code::BadScene, shown.file.path(), "the deformed shape is of no vector");
            check_target(shown, {shapes[s], *values, p}, parts[p].targets[s], claim.factor, count);
        }
    }
    shown.count("deformed shape", count.vertices, count.wrong, count.first);
}

std::array<double, 3> normal_of(const ScenePart& part, const std::array<std::uint32_t, 3>& triangle) {
    std::array<double, 3> a{}, b{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double origin = part.positions[triangle[0]][axis];
        a[axis] = static_cast<double>(part.positions[triangle[1]][axis]) - origin;
        b[axis] = static_cast<double>(part.positions[triangle[2]][axis]) - origin;
    }
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A normal has length 1 and looks away from the side that the sum of its triangles looks away from.
void check_normals(Shown& shown) {
    Count count;
    for (std::size_t p = 0; p < shown.parts.size(); ++p) {
        const ScenePart& part = shown.parts[p];
        if (part.kind != "solid" && part.kind != "shell") continue;
        const int accessor = attribute_of(shown.file, shown.document().parts[p], "NORMAL");
        const std::vector<float> normals = shown.floats(p, accessor, 3);
        std::vector<double> best(part.positions.size(), -1);
        for (const auto& triangle : part.triangles) {
            const std::array<double, 3> face = normal_of(part, triangle);
            for (const std::uint32_t v : triangle) {
                const float* normal = normals.data() + 3 * std::size_t{v};
                best[v] = std::max(best[v], face[0] * normal[0] + face[1] * normal[1] + face[2] * normal[2]);
            }
        }
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            const double length = std::hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
            const bool unit = std::abs(length - 1) <
                              (shown.is_rounded() ? 2 * static_cast<double>(gltf::kNormalGrid) : 1e-5);
            count.take(unit && (best[v] >= 0 || shown.is_rounded()), part, v);
        }
    }
    shown.count("normals", count.vertices, count.wrong, count.first);
}

}  // namespace

std::vector<Claim> check_shown(const SceneFile& file, std::span<const ScenePart> parts) {
    Shown shown{file, parts};
    for (const TexcoordClaim& claim : shown.document().texcoords) check_texcoord(shown, claim);
    check_targets(shown);
    check_normals(shown);
    return std::move(shown.claims);
}

}  // namespace feelem
