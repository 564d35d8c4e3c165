// SPDX-License-Identifier: Apache-2.0
// check_scene: every claim of the certificate made again from the arrays alone.
#include "base/sha256.hpp"
#include "scene/scene_check_shown.hpp"
#include "scene/scene_measure.hpp"
#include "scene/scene_read.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace feelem {
namespace {

struct Check {
    const SceneFile& file;
    std::vector<ScenePart> parts{};
    std::vector<Claim> claims{};

    const CertificateClaims& certificate() const { return file.document().certificate; }
    void compare(std::string name, const std::string& claimed, const std::string& found) {
        claims.push_back({std::move(name), claimed, found, claimed == found});
    }
    template <class T>
    requires std::is_arithmetic_v<T>
    void compare(std::string name, T claimed, T found) {
        compare(std::move(name), fmt::format("{}", claimed), fmt::format("{}", found));
    }
    void compare_close(std::string name, double claimed, double found, double tolerance) {
        const bool holds = std::abs(claimed - found) <= tolerance;
        claims.push_back({std::move(name), fmt::format("{}", claimed), fmt::format("{}", found), holds});
    }
};

void check_digests(Check& check) {
    const SceneDocument& document = check.file.document();
    for (const auto& [name, digest] : check.certificate().digests) {
        const auto found = document.by_name.find(name);
        const std::string there =
            found == document.by_name.end() ? "no such array" : sha256_hex(check.file.packed(found->second));
        check.compare("digest " + name, digest, there);
    }
    std::size_t without = 0;
    for (const ReadAccessor& read : document.accessors)
        without += check.certificate().digests.contains(read.accessor.name) ? 0u : 1u;
    check.compare<std::size_t>("arrays without digest", 0, without);
}

bool is_drawn_kind(const ScenePart& part) {
    return part.kind == "solid" || part.kind == "shell";
}

void check_counts(Check& check) {
    const SceneDocument& document = check.file.document();
    std::uint64_t vertices = 0, triangles = 0, edges = 0, drawn = 0;
    std::set<std::pair<std::uint64_t, std::int64_t>> nodes;
    for (std::size_t i = 0; i < check.parts.size(); ++i) {
        const ScenePart& part = check.parts[i];
        check.compare<std::uint64_t>(
            fmt::format("vertices of part {}", i), document.vertices[i], part.positions.size()
        );
        check.compare<std::uint64_t>(
            fmt::format("triangles of part {}", i), document.triangles[i], part.triangles.size()
        );
        vertices += part.positions.size();
        triangles += part.triangles.size();
        if (!is_drawn_kind(part)) continue;
        drawn += part.triangles.size();
        for (const auto& triangle : part.triangles) {
            for (const std::uint32_t corner : triangle) {
                if (part.node_ids[corner] != 0) nodes.emplace(document.model_parts[i], part.node_ids[corner]);
            }
        }
    }
    for (const gltf::Primitive& primitive : document.edges) {
        if (primitive.indices >= 0)
            edges += document.accessors[static_cast<std::size_t>(primitive.indices)].accessor.count / 2;
    }
    const CertificateClaims& claimed = check.certificate();
    check.compare("vertices", claimed.scene_vertices, vertices);
    check.compare("triangles", claimed.scene_triangles, triangles);
    check.compare("edges", claimed.scene_edges, edges);
    check.compare("triangles of the skin", claimed.skin_triangles, drawn);
    check.compare<std::uint64_t>("vertices of the skin", claimed.skin_vertices, nodes.size());
    check.compare("facets kept and dropped", claimed.facets_in, claimed.facets_kept + claimed.facets_dropped);
}

/// What stands at a vertex, whichever of its copies: the node, or the place where there is none.
using PlaceKey = std::array<std::int64_t, 4>;

PlaceKey key_of(const ScenePart& part, std::uint32_t vertex) {
    if (part.node_ids[vertex] != 0) return {part.node_ids[vertex], 0, 0, 0};
    const std::array<float, 3>& at = part.positions[vertex];
    return {
        0,
        std::bit_cast<std::int32_t>(at[0]),
        std::bit_cast<std::int32_t>(at[1]),
        std::bit_cast<std::int32_t>(at[2])};
}

bool is_closed(std::span<const ScenePart> parts) {
    struct Side {
        PlaceKey from, to;
        int way;
        bool operator<(const Side& other) const {
            return std::tie(from, to) < std::tie(other.from, other.to);
        }
    };
    std::vector<Side> sides;
    for (const ScenePart& part : parts) {
        if (part.kind != "solid") continue;
        for (const auto& triangle : part.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const PlaceKey a = key_of(part, triangle[i]), b = key_of(part, triangle[(i + 1) % 3]);
                sides.push_back(a < b ? Side{a, b, 1} : Side{b, a, -1});
            }
        }
    }
    std::ranges::sort(sides, std::less<>{});
    for (std::size_t i = 0; i < sides.size();) {
        int balance = 0;
        const std::size_t first = i;
        for (; i < sides.size() && !(sides[first] < sides[i]); ++i) balance += sides[i].way;
        if (balance != 0) return false;
    }
    return true;
}

/// A grid of 65,536 pieces moves corners of a fine mesh by a good part of its thinnest triangles.
constexpr double kGridOnWhole = 1e-3;

void check_shape(Check& check) {
    double area = 0, volume = 0, largest = 0;
    bool has_solids = false;
    for (const ScenePart& part : check.parts) {
        for (const auto& position : part.positions) {
            for (const float coordinate : position)
                largest = std::max(largest, std::abs(static_cast<double>(coordinate)));
        }
        if (!is_drawn_kind(part)) continue;
        has_solids = has_solids || part.kind == "solid";
        for (const auto& triangle : part.triangles) {
            const Corners corners{
                part.positions[triangle[0]], part.positions[triangle[1]], part.positions[triangle[2]]};
            area += triangle_area(corners);
            if (part.kind == "solid") volume += triangle_volume(corners);
        }
    }
    const CertificateClaims& claimed = check.certificate();
    check.compare("area of the scene", claimed.scene_area, area);
    check.compare("volume of the scene", claimed.scene_volume, volume);
    // What rounding positions to float32, or to the grid of a compressed scene, can do to the whole.
    const double rounding = check.file.document().scene.position_bound > 0 ? kGridOnWhole : 1e-5;
    check.compare_close("area", claimed.area, area, rounding * std::abs(claimed.area));
    const std::string closed = claimed.closed ? *claimed.closed ? "yes" : "no" : "no solids";
    const bool is_closed_here = has_solids && is_closed(check.parts);
    // Facets with unequal mid-side nodes meet at their corners only: their triangles say nothing of the
    // solid.
    if (claimed.facets_unmatched == 0)
        check.compare("closed", closed, has_solids ? is_closed_here ? "yes" : "no" : "no solids");
    if (is_closed_here)
        check.compare_close(
            "volume",
            claimed.volume,
            volume,
            rounding * std::max(std::abs(claimed.volume), area * largest * 0.01)
        );
}

/// A node is at one place, whatever part or crease splits its vertices.
void check_nodes(Check& check) {
    std::vector<std::pair<std::int64_t, std::array<float, 3>>> places;
    for (const ScenePart& part : check.parts) {
        if (!is_drawn_kind(part)) continue;
        for (std::size_t v = 0; v < part.positions.size(); ++v) {
            if (part.node_ids[v] != 0) places.emplace_back(part.node_ids[v], part.positions[v]);
        }
    }
    std::ranges::sort(places);
    std::size_t wrong = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        wrong += places[i].first == places[i - 1].first && places[i].second != places[i - 1].second ? 1u : 0u;
    check.compare<std::size_t>("nodes at more than one place", 0, wrong);
}

struct FoundExtremes {
    std::optional<Extreme> min, max;
    std::uint64_t missing = 0, interpolated = 0;

    void take(float value, std::int64_t id) {
        const auto is_first = [&](const std::optional<Extreme>& best) {
            return !best || (value == best->value && id < best->id);
        };
        if (is_first(min) || value < min->value) min = Extreme{value, id};
        if (is_first(max) || value > max->value) max = Extreme{value, id};
    }
};

/// Element of each vertex, from the triangles: right where elements do not share vertices.
std::vector<std::int64_t> element_of_vertices(const ScenePart& part) {
    std::vector<std::int64_t> ids(part.positions.size(), 0);
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        for (const std::uint32_t corner : part.triangles[t]) ids[corner] = part.element_ids[t];
    }
    return ids;
}

void take_part(const Check& check, const FieldAddress& address, FoundExtremes& found) {
    const ScenePart& part = check.parts[address.part];
    const SceneResult& result = check.file.document().scene.results[address.result];
    const std::optional<SceneField> field = read_field(check.file, check.parts, address);
    const bool by_element = result.location == Location::Elemental && part.domain == "element-node";
    const std::vector<std::int64_t> elements =
        by_element ? element_of_vertices(part) : std::vector<std::int64_t>();
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        if (part.node_ids[v] == 0) continue;
        const Validity validity = field ? field->validity[v] : Validity::Missing;
        found.missing += validity == Validity::Missing ? 1u : 0u;
        found.interpolated += validity == Validity::Interpolated ? 1u : 0u;
        if (validity == Validity::Solver && result.components.size() == 1)
            found.take(field->values[v], by_element ? elements[v] : part.node_ids[v]);
    }
}

std::string text_of(const std::optional<Extreme>& extreme) {
    // + 0: JSON has no -0; the digests compare the bits.
    return extreme ? fmt::format("{} at {}", extreme->value + 0.0F, extreme->id) : "none";
}

void check_extremes(Check& check) {
    const Scene& scene = check.file.document().scene;
    std::size_t claimed = 0;
    for (std::size_t r = 0; r < scene.results.size(); ++r) {
        const SceneResult& result = scene.results[r];
        for (std::size_t v = 0; v < result.values.size(); ++v, ++claimed) {
            FoundExtremes found;
            for (std::size_t p = 0; p < check.parts.size(); ++p) take_part(check, {r, v, p}, found);
            const std::string name = fmt::format("{} at step {}", result.id, result.values[v].step + 1);
            const auto& all = check.certificate().results;
            const auto claim = std::ranges::find_if(all, [&](const CertificateResult& one) {
                return one.result == result.id && one.step == result.values[v].step + 1;
            });
            if (claim == all.end()) {
                check.compare("extremes of " + name, "nothing", "a result");
                continue;
            }
            check.compare("minimum of " + name, text_of(claim->skin.min), text_of(found.min));
            check.compare("maximum of " + name, text_of(claim->skin.max), text_of(found.max));
            check.compare("missing values of " + name, claim->skin.missing, found.missing);
            check.compare("interpolated values of " + name, claim->skin.interpolated, found.interpolated);
        }
    }
    check.compare("results with a claim", check.certificate().results.size(), claimed);
}

/// The certificate's range over the model is the one that the scene lists, and holds all that the skin shows.
void check_ranges(Check& check) {
    const Scene& scene = check.file.document().scene;
    const auto text = [](const auto& min, const auto& max, std::uint64_t missing) {
        return fmt::format("{} to {}, {} missing", text_of(min), text_of(max), missing);
    };
    for (const CertificateResult& claim : check.certificate().results) {
        const auto result = std::ranges::find(scene.results, claim.result, &SceneResult::id);
        if (result == scene.results.end()) continue;
        const auto values = std::ranges::find(result->values, claim.step - 1, &SceneValues::step);
        if (values == result->values.end()) continue;
        check.compare(
            fmt::format("range over the model of {} at step {}", claim.result, claim.step),
            text(claim.model_min, claim.model_max, claim.model_missing),
            text(values->min, values->max, values->missing_in_model)
        );
        if (!claim.skin.min || !claim.skin.max || !values->min || !values->max) continue;
        const bool holds = static_cast<double>(values->min->value) - result->bound <=
                               static_cast<double>(claim.skin.min->value) &&
                           static_cast<double>(values->max->value) + result->bound >=
                               static_cast<double>(claim.skin.max->value);
        check.claims.push_back(
            {fmt::format("range of {} at step {}", claim.result, claim.step),
             fmt::format("{} to {}", values->min->value, values->max->value),
             fmt::format("{} to {}", claim.skin.min->value, claim.skin.max->value),
             holds}
        );
    }
}

}  // namespace

std::vector<Claim> check_scene(const std::string& path) {
    const SceneFile file(path);
    Check check{file};
    // Made while results were still being read, and kept by somebody.
    if (const auto& notes = file.document().scene.notes; notes.contains("preview"))
        check.claims.push_back({"finished scene", "yes", notes.at("preview"), false});
    check_digests(check);
    try {
        check.parts = read_parts(file);
        check_counts(check);
        check_shape(check);
        check_nodes(check);
        check_extremes(check);
        check_ranges(check);
        std::ranges::move(check_shown(file, check.parts), std::back_inserter(check.claims));
    } catch (const Error& error) {
        // Arrays that contradict each other: the digests above say which of them changed.
        check.claims.push_back({"arrays fit together", "yes", error.what(), false});
    }
    return check.claims;
}

}  // namespace feelem
