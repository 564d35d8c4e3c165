// SPDX-License-Identifier: Apache-2.0
// *NCOPY and *NMAP: nodes as moved, turned, mirrored or mapped others.
#include "model/vector.hpp"
#include "read/abaqus/deck_generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace feelem::abaqus {
namespace {

using Move = std::function<Point3(const Point3&)>;

/// Values of the data lines, an empty line as zeros; how many lines there are.
template <std::size_t Lines, std::size_t Width>
struct DataValues {
    std::array<std::array<double, Width>, Lines> line{};
    std::size_t lines = 0;
    std::size_t filled = 0;  ///< Values of the first line up to the last that is not empty.

    Point3 point(std::size_t at, std::size_t first = 0) const {
        return {line[at][first], line[at][first + 1], line[at][first + 2]};
    }
};

template <std::size_t Lines, std::size_t Width>
DataValues<Lines, Width> read_values(const Generation& job) {
    DataValues<Lines, Width> out;
    DataLines lines(job.deck, job.keyword);
    while (out.lines < Lines) {
        auto line = lines.next_or_empty();
        if (!line) break;
        for (std::size_t i = 0; i < Width; ++i) {
            const std::string_view field = take_field(*line);
            if (field.empty()) continue;
            if (out.lines == 0) out.filled = i + 1;
            std::string_view rest = field;
            out.line[out.lines][i] = take_number(rest, 0, job.deck, lines);
        }
        ++out.lines;
    }
    return out;
}

/// The point as far on the other side of `centre`, of the line, or of the plane.
Point3 mirrored(const Point3& point, const Point3& foot) {
    return {2 * foot[0] - point[0], 2 * foot[1] - point[1], 2 * foot[2] - point[2]};
}

Point3 moved_along(const Point3& from, const Point3& unit, double way) {
    return {from[0] + way * unit[0], from[1] + way * unit[1], from[2] + way * unit[2]};
}

/// Moved once, then turned MULTIPLE times.
std::optional<Move> shift_of(Generation& job) {
    const auto values = read_values<2, 7>(job);
    Placement placement = translation(values.point(0));
    const Placement turn = rotation(values.point(1), values.point(1, 3), values.line[1][6]);
    if (values.line[1][6] != 0 && !turn.moves) return {};
    const std::int64_t times = whole_parameter(job, "MULTIPLE", 1);
    if (times < 1 || times > 1'000'000) return {};
    for (std::int64_t i = 0; turn.moves && i < times; ++i) placement = combined(turn, placement);
    return [placement](const Point3& point) { return placed(placement, point); };
}

std::optional<Move> reflection_of(Generation& job) {
    const std::string kind = folded(job.keyword.value("REFLECT"));
    const auto values = read_values<2, 6>(job);
    const Point3 a = values.point(0), b = values.point(0, 3), c = values.point(1);
    if (kind == "POINT") return [a](const Point3& point) { return mirrored(point, a); };
    if (kind == "LINE") {
        const auto unit = direction(minus(b, a), 0);
        if (!unit) return {};
        return [a, u = *unit](const Point3& point) {
            return mirrored(point, moved_along(a, u, dot(minus(point, a), u)));
        };
    }
    if (kind != "MIRROR") return {};
    const Point3 ab = minus(b, a), ac = minus(c, a);
    const auto normal = direction(cross(ab, ac), length(ab) * length(ac));
    if (!normal) return {};
    return [a, n = *normal](const Point3& point) {
        return mirrored(point, moved_along(point, n, -dot(minus(point, a), n)));
    };
}

/// The old node stands halfway between the pole and the new one.
std::optional<Move> pole_of(Generation& job) {
    const auto values = read_values<1, 4>(job);
    const double number = values.line[0][0];
    if (values.filled != 1 || !(number >= 1 && number <= 2147483647)) return {};
    const auto at = find_place(job.scope, static_cast<Label>(number));
    if (!at) return {};
    return [pole = job.scope.places[*at]](const Point3& point) { return mirrored(pole, point); };
}

void copy_set(Generation& job, const SetContents& old, const Move& move) {
    const std::int64_t change = whole_parameter(job, "CHANGENUMBER", 0);
    const std::string name = job.keyword.value("NEWSET");
    if (!name.empty() && job.scope.node_sets.find(folded(name)) == nullptr)
        job.scope.node_sets.get(name).unsorted = old.unsorted;
    for (const Label label : old.labels) {
        const Point3 place = move(job.scope.places[*find_place(job.scope, label)]);
        const Label copy = generated_label(job, label + change);
        put_node(job, copy, place);
        if (!name.empty()) add_label(job.scope.node_sets.get(name), copy);
    }
}

/// The lines of *NMAP, TYPE=RECTANGULAR and its like; null where they define no system.
class LocalMap {
public:
    explicit LocalMap(Generation& job)
        : kind_(folded(job.keyword.value("TYPE"))), values_(read_values<3, 6>(job)) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (values_.line[2][i] != 0) scale_[i] = values_.line[2][i];
        }
    }

    std::optional<Move> move() const {
        const Point3 a = values_.point(0);
        const bool only_a = values_.filled <= 3 && values_.point(1) == Point3{};
        if (kind_ == "RECTANGULAR" && only_a) return through({translation(a)}, SystemKind::Rectangular);
        const Point3 ab = minus(values_.point(0, 3), a), ac = minus(values_.point(1), a);
        if (kind_ == "DIAMOND") return skewed(a, ab, ac, minus(values_.point(1, 3), a));
        const auto first = direction(ab, 0);
        const auto normal = direction(cross(ab, ac), length(ab) * length(ac));
        if (!first || !normal) return {};
        const Point3 second = cross(*normal, *first);
        // The line a-b is X of a rectangular system, Z of the others; c lies at angle 0.
        if (kind_ == "RECTANGULAR")
            return through({from_columns(*first, second, *normal), a, true}, SystemKind::Rectangular);
        const Placement polar{from_columns(second, cross(*first, second), *first), a, true};
        if (kind_ == "CYLINDRICAL") return through(polar, SystemKind::Cylindrical);
        if (kind_ == "SPHERICAL") return through(polar, SystemKind::Spherical);
        return {};
    }

private:
    Point3 scaled(const Point3& point) const {
        return {scale_[0] * point[0], scale_[1] * point[1], scale_[2] * point[2]};
    }

    Move through(const Placement& placement, SystemKind kind) const {
        return [this, placement, kind](const Point3& point) {
            return placed(placement, cartesian(kind, scaled(point)));
        };
    }

    std::optional<Move> skewed(const Point3& a, const Point3& ab, const Point3& ac, const Point3& ad) const {
        const auto x = direction(ab, 0), y = direction(ac, 0), z = direction(ad, 0);
        if (!x || !y || !z) return {};
        return [this, a, axes = from_columns(*x, *y, *z)](const Point3& point) {
            return placed({axes, a, true}, scaled(point));
        };
    }

    std::string kind_;
    DataValues<3, 6> values_;
    Point3 scale_{1, 1, 1};
};

/// TYPE=ROTATION, TRANSLATION, SCALE.
std::optional<Move> direct_map(Generation& job, const std::string& kind) {
    const auto values = read_values<3, 6>(job);
    const Point3 a = values.point(0), b = values.point(0, 3), second = values.point(1);
    if (kind == "SCALE") {
        // A factor that is left out is 1, as in the types that map.
        Point3 factor = second;
        for (double& f : factor) f = f == 0 ? 1 : f;
        return [a, factor](const Point3& p) {
            Point3 out;
            for (std::size_t i = 0; i < 3; ++i) out[i] = a[i] + factor[i] * (p[i] - a[i]);
            return out;
        };
    }
    const auto axis = direction(minus(b, a), 0);
    if (!axis) return {};
    if (kind == "TRANSLATION") {
        return [u = *axis, way = values.line[1][0]](const Point3& p) { return moved_along(p, u, way); };
    }
    const Placement turn = rotation(second, moved_along(second, *axis, 1), values.line[2][0]);
    return [turn](const Point3& p) { return placed(turn, p); };
}

}  // namespace

void copy_nodes(Generation& job) {
    const std::string where = job.deck.where(job.keyword);
    const SetContents old = nodes_of_set(job, job.keyword.value("OLDSET"));
    if (!job.keyword.has("CHANGENUMBER") || old.labels.empty()) {
        report_left_out(
            job,
            where,
            fmt::format(
                "is left out: it needs CHANGE NUMBER and OLD SET, and the set \"{}\" has no nodes yet",
                job.keyword.value("OLDSET")
            )
        );
        return;
    }
    std::optional<Move> move;
    if (job.keyword.has("SHIFT")) {
        move = shift_of(job);
    } else if (job.keyword.has("REFLECT")) {
        move = reflection_of(job);
    } else if (job.keyword.has("POLE")) {
        move = pole_of(job);
    }
    if (!move) {
        report_left_out(
            job,
            where,
            "is left out: it needs SHIFT, REFLECT=LINE, MIRROR or POINT with points that are not in line, or "
            "POLE with the number of a node"
        );
        return;
    }
    copy_set(job, old, *move);
}

void map_nodes(Generation& job) {
    const std::string where = job.deck.where(job.keyword);
    const std::string kind = folded(job.keyword.value("TYPE"));
    const std::string definition = folded(job.keyword.value("DEFINITION"));
    const SetContents nodes = nodes_of_set(job, job.keyword.value("NSET"));
    const LocalMap local(job);
    std::optional<Move> move;
    if (definition.empty() || definition.starts_with("COORD")) {
        const bool direct = kind == "ROTATION" || kind == "TRANSLATION" || kind == "SCALE";
        move = direct ? direct_map(job, kind) : local.move();
    }
    if (!move || nodes.labels.empty()) {
        report_left_out(
            job,
            where,
            fmt::format(
                "of \"{}\" ({} nodes so far), TYPE={}{} is not carried out: the nodes stay as they were. "
                "Known "
                "are ROTATION, TRANSLATION, SCALE, RECTANGULAR, CYLINDRICAL, SPHERICAL and DIAMOND, by "
                "coordinates of points that are not in line",
                job.keyword.value("NSET"),
                nodes.labels.size(),
                kind,
                definition.empty() ? "" : ", DEFINITION=" + definition
            )
        );
        return;
    }
    for (const Label label : nodes.labels) {
        Point3& place = job.scope.places[*find_place(job.scope, label)];
        place = (*move)(place);
    }
}

}  // namespace feelem::abaqus
