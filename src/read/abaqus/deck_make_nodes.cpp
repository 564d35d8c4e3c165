// SPDX-License-Identifier: Apache-2.0
// *NGEN and *NFILL: nodes along lines, and between two sets of nodes.
#include "model/vector.hpp"
#include "read/abaqus/deck_generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace feelem::abaqus {
namespace {

Point3 between(const Point3& a, const Point3& b, double t) {
    return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

/// Through `middle` halfway: quadratic in t.
Point3 on_parabola(const Point3& a, const Point3& middle, const Point3& b, double t) {
    const double first = (1 - t) * (1 - 2 * t), second = 4 * t * (1 - t), third = t * (2 * t - 1);
    Point3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = first * a[i] + second * middle[i] + third * b[i];
    return out;
}

/// From `a` by the right hand about `axis`, through `degrees`, to `b`. Where the ends are not quite as far
/// from the centre, the radius goes from one to the other.
struct Arc {
    Point3 centre, axis, outward, sideward;
    double first_radius = 0, last_radius = 0, first_height = 0, last_height = 0, degrees = 0;

    Point3 at(double t) const {
        const auto [sine, cosine] = sine_and_cosine(t * degrees);
        const double radius = (1 - t) * first_radius + t * last_radius;
        const double height = (1 - t) * first_height + t * last_height;
        Point3 out;
        for (std::size_t i = 0; i < 3; ++i)
            out[i] = centre[i] + height * axis[i] + radius * (cosine * outward[i] + sine * sideward[i]);
        return out;
    }
};

/// Without a normal the way is the shorter one. Empty where these points define no arc.
std::optional<Arc> arc_of(
    const Point3& a, const Point3& b, const Point3& centre, const std::optional<Point3>& normal
) {
    const Point3 from = minus(a, centre), to = minus(b, centre);
    const double scale = std::max(length(from), length(to));
    const auto axis =
        normal ? direction(*normal, 0) : direction(cross(from, to), length(from) * length(to) * 1e3);
    if (!axis) return {};
    Arc arc;
    arc.centre = centre;
    arc.axis = *axis;
    arc.first_height = dot(from, *axis);
    arc.last_height = dot(to, *axis);
    Point3 flat = from;
    for (std::size_t i = 0; i < 3; ++i) flat[i] -= arc.first_height * (*axis)[i];
    const auto outward = direction(flat, scale);
    if (!outward) return {};
    arc.outward = *outward;
    arc.sideward = cross(*axis, *outward);
    arc.first_radius = length(flat);
    const double along = dot(to, arc.outward), aside = dot(to, arc.sideward);
    arc.last_radius = std::hypot(along, aside);
    arc.degrees = std::atan2(aside, along) * (180 / std::numbers::pi);
    if (arc.degrees < 1e-9) arc.degrees += 360;
    const double off =
        std::abs(arc.first_radius - arc.last_radius) + std::abs(arc.first_height - arc.last_height);
    if (!(off <= 0.01 * scale)) return {};
    return arc;
}

enum class LineKind : char {
    Straight,
    Parabola,
    Arc,
};

/// A line of *NGEN.
struct LineOfNodes {
    std::int64_t first = 0, last = 0, step = 1;
    std::optional<Point3> extra;  ///< Empty: it is a node that is not defined.
    std::optional<Point3> normal;
};

LineOfNodes read_line_of_nodes(Generation& job, std::string_view line, const DataLines& lines) {
    LineOfNodes out;
    out.first = take_whole(line, 0, job, lines);
    out.last = take_whole(line, 0, job, lines);
    out.step = take_whole(line, 1, job, lines);
    const std::int64_t node = take_whole(line, 0, job, lines);
    Point3 extra{}, normal{};
    for (double& x : extra) x = take_number(line, 0, job.deck, lines);
    for (double& x : normal) x = take_number(line, 0, job.deck, lines);
    if (normal != Point3{}) out.normal = to_global(job.system.axes, normal);
    if (node == 0) {
        const SystemKind kind = system_kind(job.keyword.value("SYSTEM"));
        out.extra = placed(job.system, cartesian(kind, extra));
    } else if (const auto at = find_place(job.scope, generated_label(job, node))) {
        out.extra = job.scope.places[*at];
    }
    return out;
}

/// The number of intervals; 0 where the increment does not lead from one end to the other.
std::int64_t intervals_of(const LineOfNodes& line) {
    const std::int64_t way = line.last - line.first;
    if (line.step == 0 || way % line.step != 0) return 0;
    return std::max<std::int64_t>(way / line.step, 0);
}

class NodeLines {
public:
    explicit NodeLines(Generation& job) : job_(job), lines_(job.deck, job.keyword) {
        const std::string kind = folded(job.keyword.value("LINE"));
        if (kind.starts_with('P')) kind_ = LineKind::Parabola;
        if (kind.starts_with('C')) kind_ = LineKind::Arc;
        if (kind_ == LineKind::Parabola) {
            report_left_out(
                job,
                job.deck.where(job.keyword),
                "LINE=P spaces nodes evenly in the parameter of the parabola, as an element of three nodes "
                "does: the manual does not say how"
            );
        }
        if (job.keyword.has("NSET")) {
            set_ = &job.scope.node_sets.get(job.keyword.value("NSET"));
            set_->unsorted = false;
        }
    }

    void make() {
        while (const auto line = lines_.next()) make(read_line_of_nodes(job_, *line, lines_));
        lines_.release();
    }

private:
    void make(const LineOfNodes& line) {
        const auto first = find_place(job_.scope, generated_label(job_, line.first));
        const auto last = find_place(job_.scope, generated_label(job_, line.last));
        const std::int64_t count = intervals_of(line);
        if (!first || !last || count == 0 || !line.extra) {
            leave_out(
                line,
                !first || !last ? "an end is not defined before"
                : count == 0    ? "the increment does not lead from the first to the last"
                                : "the third node is not defined before"
            );
            return;
        }
        const Point3 a = job_.scope.places[*first], b = job_.scope.places[*last];
        std::optional<Arc> arc;
        if (kind_ == LineKind::Arc && !(arc = arc_of(a, b, *line.extra, line.normal))) {
            leave_out(
                line,
                "the ends, the centre and the normal define no arc (180 degrees and more need a normal; the "
                "ends must be equally far from the centre)"
            );
            return;
        }
        spend_visits(job_, static_cast<std::uint64_t>(count));
        add(line.first);
        for (std::int64_t k = 1; k < count; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(count);
            const Point3 place = arc                           ? arc->at(t)
                                 : kind_ == LineKind::Parabola ? on_parabola(a, *line.extra, b, t)
                                                               : between(a, b, t);
            put_node(job_, generated_label(job_, line.first + k * line.step), place);
            add(line.first + k * line.step);
        }
        add(line.last);
    }

    void leave_out(const LineOfNodes& line, const char* why) {
        report_left_out(
            job_,
            lines_.where(),
            fmt::format("from {} to {} in steps of {} is left out: {}", line.first, line.last, line.step, why)
        );
    }

    void add(std::int64_t label) {
        if (set_ != nullptr) add_label(*set_, generated_label(job_, label));
    }

    Generation& job_;
    DataLines lines_;
    LineKind kind_ = LineKind::Straight;
    DeckSet* set_ = nullptr;
};

/// A line of *NFILL.
struct Fill {
    std::string first, second;
    std::int64_t count = 0, step = 1;
    SetContents from, to;

    std::size_t pairs() const { return std::min(from.labels.size(), to.labels.size()); }
};

Fill read_fill(Generation& job, std::string_view line, const DataLines& lines) {
    Fill fill;
    fill.first = std::string(take_field(line));
    fill.second = std::string(take_field(line));
    fill.count = take_whole(line, 0, job, lines);
    fill.step = take_whole(line, 1, job, lines);
    fill.from = nodes_of_set(job, fill.first);
    fill.to = nodes_of_set(job, fill.second);
    return fill;
}

/// Why it cannot be carried out; empty when it can.
std::string fault_of(const Fill& fill) {
    const std::uint64_t undefined = fill.from.undefined + fill.to.undefined;
    if (undefined > 0) return fmt::format("the sets name {} nodes that are not defined before", undefined);
    if (fill.pairs() == 0)
        return fmt::format(
            "the sets hold {} and {} nodes so far", fill.from.labels.size(), fill.to.labels.size()
        );
    if (fill.count < 1 || fill.step == 0) return "it needs a number of intervals and an increment";
    for (std::size_t i = 0; i < fill.pairs(); ++i) {
        const std::int64_t way = std::int64_t{fill.to.labels[i]} - fill.from.labels[i];
        if (way % fill.step != 0)
            return fmt::format(
                "nodes {} and {} are no whole number of increments apart",
                fill.from.labels[i],
                fill.to.labels[i]
            );
    }
    return {};
}

/// In the set are the nodes between and those of both bounds.
void fill_in(Generation& job, const Fill& fill) {
    for (std::size_t i = 0; i < fill.pairs(); ++i) {
        const Label first = fill.from.labels[i], last = fill.to.labels[i];
        const Point3 a = job.scope.places[*find_place(job.scope, first)];
        const Point3 b = job.scope.places[*find_place(job.scope, last)];
        spend_visits(job, static_cast<std::uint64_t>(fill.count));
        for (std::int64_t k = 1; k < fill.count; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(fill.count);
            put_node(job, generated_label(job, first + k * fill.step), between(a, b, t));
        }
        if (!job.keyword.has("NSET")) continue;
        DeckSet& set = job.scope.node_sets.get(job.keyword.value("NSET"));
        for (std::int64_t k = 0; k < fill.count; ++k)
            add_label(set, generated_label(job, first + k * fill.step));
        add_label(set, last);
    }
}

}  // namespace

void generate_nodes(Generation& job) {
    NodeLines(job).make();
}

void fill_nodes(Generation& job) {
    for (const char* option : {"BIAS", "SINGULAR"}) {
        if (!job.keyword.has(option)) continue;
        report_left_out(
            job,
            job.deck.where(job.keyword),
            fmt::format("with {} is not carried out: the nodes between are missing", option)
        );
        return;
    }
    DataLines lines(job.deck, job.keyword);
    while (const auto line = lines.next()) {
        const Fill fill = read_fill(job, *line, lines);
        const std::string fault = fault_of(fill);
        if (!fault.empty()) {
            report_left_out(
                job,
                lines.where(),
                fmt::format("from \"{}\" to \"{}\" is left out: {}", fill.first, fill.second, fault)
            );
            continue;
        }
        if (fill.from.labels.size() != fill.to.labels.size()) {
            report_left_out(
                job,
                lines.where(),
                fmt::format(
                    "pairs {} nodes of \"{}\" with {} of \"{}\": the rest of the longer set is not used",
                    fill.from.labels.size(),
                    fill.first,
                    fill.to.labels.size(),
                    fill.second
                )
            );
        }
        fill_in(job, fill);
    }
    lines.release();
}

}  // namespace feelem::abaqus
