// SPDX-License-Identifier: Apache-2.0
// Written once for numbers and for numbers with slopes. Sources: Zienkiewicz & Taylor, The Finite Element
// Method, chapter 8 (Lagrange, serendipity, simplex, prism); Bedrosian, Int. J. Numer. Meth. Eng. 35 (1992)
// for pyramids.
#include "model/shape_functions.hpp"

#include "model/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace feelem {
namespace {

using enum ElementType;

/// A number and its slopes by the three reference coordinates.
struct Sloped {
    double value = 0;
    Point3 slope{};

    Sloped() = default;
    Sloped(double number) : value(number) {}  // NOLINT(google-explicit-constructor): numbers mix with it
    static Sloped variable(double number, std::size_t axis) {
        Sloped made(number);
        made.slope[axis] = 1;
        return made;
    }
};
Sloped combined(double value, const Sloped& a, double by_a, const Sloped& b, double by_b) {
    Sloped out(value);
    for (std::size_t i = 0; i < 3; ++i) out.slope[i] = by_a * a.slope[i] + by_b * b.slope[i];
    return out;
}
Sloped operator+(const Sloped& a, const Sloped& b) {
    return combined(a.value + b.value, a, 1, b, 1);
}
Sloped operator-(const Sloped& a, const Sloped& b) {
    return combined(a.value - b.value, a, 1, b, -1);
}
Sloped operator*(const Sloped& a, const Sloped& b) {
    return combined(a.value * b.value, a, b.value, b, a.value);
}
Sloped operator/(const Sloped& a, const Sloped& b) {
    return combined(a.value / b.value, a, 1 / b.value, b, -a.value / (b.value * b.value));
}
double value_of(double number) {
    return number;
}
double value_of(const Sloped& number) {
    return number.value;
}

template <class T>
using Place = std::array<T, 3>;
template <class T>
using Weights = std::array<T, kMaxElementNodes>;

template <class T>
T point_shape(const ElementRow& /*row*/, std::size_t /*node*/, const Place<T>& /*at*/) {
    return T(1);
}

/// Lines, quads and bricks of two nodes an edge.
template <class T>
T linear_product(const ElementRow& row, std::size_t node, const Place<T>& at) {
    T out(1);
    for (std::size_t d = 0; d < row.dimension; ++d)
        out = out * (row.reference[node][d] == 1 ? at[d] : T(1) - at[d]);
    return out;
}

/// Lagrange's three functions on 0, 1/2, 1.
template <class T>
T lagrange3(float own, const T& x) {
    if (own == 0) return (T(1) - x) * (T(1) - T(2) * x);
    if (own == 1) return x * (T(2) * x - T(1));
    return T(4) * x * (T(1) - x);
}

template <class T>
T quadratic_product(const ElementRow& row, std::size_t node, const Place<T>& at) {
    T out(1);
    for (std::size_t d = 0; d < row.dimension; ++d) out = out * lagrange3(row.reference[node][d], at[d]);
    return out;
}

/// Quads and bricks with nodes on their edges alone.
template <class T>
T serendipity(const ElementRow& row, std::size_t node, const Place<T>& at) {
    T out(1);
    T sum(1 - static_cast<double>(row.dimension));
    bool is_corner = true;
    for (std::size_t d = 0; d < row.dimension; ++d) {
        const double own = 2 * static_cast<double>(row.reference[node][d]) - 1;
        const T r = T(2) * at[d] - T(1);
        is_corner = is_corner && own != 0;
        sum = sum + T(own) * r;
        out = out * (own == 0 ? T(1) - r * r : T(0.5) * (T(1) + T(own) * r));
    }
    return is_corner ? out * sum : out;
}

/// Barycentric coordinate `i` of a triangle or tetrahedron of that dimension.
template <class T>
T barycentric(std::size_t dimension, std::size_t i, const Place<T>& at) {
    if (i > 0) return at[i - 1];
    T out(1);
    for (std::size_t d = 0; d < dimension; ++d) out = out - at[d];
    return out;
}

template <class T>
T linear_simplex(const ElementRow& row, std::size_t node, const Place<T>& at) {
    return barycentric(row.dimension, node, at);
}

const EdgeRow& edge_through(const ElementRow& row, std::size_t middle) {
    return *std::ranges::find_if(row.edges, [&](const EdgeRow& edge) { return edge.middle == middle; });
}

template <class T>
T quadratic_simplex(const ElementRow& row, std::size_t node, const Place<T>& at) {
    if (node < row.corner_count) {
        const T l = barycentric(row.dimension, node, at);
        return l * (T(2) * l - T(1));
    }
    const EdgeRow& edge = edge_through(row, node);
    return T(4) * barycentric(row.dimension, edge.first, at) * barycentric(row.dimension, edge.second, at);
}

template <class T>
T wedge6(const ElementRow& row, std::size_t node, const Place<T>& at) {
    return barycentric(2, node % 3, at) * (row.reference[node][2] == 1 ? at[2] : T(1) - at[2]);
}

template <class T>
T wedge15(const ElementRow& row, std::size_t node, const Place<T>& at) {
    const T bulge = at[2] * (T(1) - at[2]);
    const T side = row.reference[node][2] == 1 ? at[2] : T(1) - at[2];
    if (node < 6) {
        const T l = barycentric(2, node % 3, at);
        return l * ((T(2) * l - T(1)) * side - T(2) * bulge);
    }
    const EdgeRow& edge = edge_through(row, node);
    const T first = barycentric(2, edge.first % 3, at);
    if (edge.first % 3 == edge.second % 3) return T(4) * first * bulge;
    return T(4) * first * barycentric(2, edge.second % 3, at) * side;
}

template <class T>
T wedge18(const ElementRow& row, std::size_t node, const Place<T>& at) {
    const auto& own = row.reference[node];
    const std::array<float, 3> corner{1 - own[0] - own[1], own[0], own[1]};
    T out = lagrange3(own[2], at[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const T l = barycentric(2, i, at);
        if (corner[i] == 1) out = out * l * (T(2) * l - T(1));
        if (corner[i] == 0.5F) out = out * T(2) * l;
    }
    return out;
}

/// 1 - z, the half width of a pyramid there; not quite 0 at the apex, by which it is divided.
template <class T>
T width_at(const T& z) {
    constexpr double kLeast = 1e-14;
    const T width = T(1) - z;
    return std::abs(value_of(width)) < kLeast ? width + T(kLeast) : width;
}

template <class T>
T pyramid5(const ElementRow& row, std::size_t node, const Place<T>& at) {
    if (node == 4) return at[2];
    const T width = width_at(at[2]);
    T out = T(1) / (T(4) * width);
    for (std::size_t d = 0; d < 2; ++d)
        out = out * (width + T(2 * static_cast<double>(row.reference[node][d]) - 1) * (T(2) * at[d] - T(1)));
    return out;
}

template <class T>
T pyramid13(const ElementRow& row, std::size_t node, const Place<T>& at) {
    const T z = at[2];
    const T width = width_at(z);
    if (node == 4) return z * (T(2) * z - T(1));
    const EdgeRow* edge = node < 5 ? nullptr : &edge_through(row, node);
    const auto& own = row.reference[edge != nullptr && edge->second == 4 ? edge->first : node];
    const std::array<double, 2> side{
        2.0 * static_cast<double>(own[0]) - 1, 2.0 * static_cast<double>(own[1]) - 1};
    const std::array<T, 2> r{T(2) * at[0] - T(1), T(2) * at[1] - T(1)};
    if (edge == nullptr) {
        const T a = T(side[0]) * r[0], b = T(side[1]) * r[1];
        return T(0.25) * (a + b - T(1)) * ((T(1) + a) * (T(1) + b) - z + a * b * z / width);
    }
    T out = edge->second == 4 ? z / width : T(0.5) / width;
    for (std::size_t d = 0; d < 2; ++d)
        out = out * (side[d] == 0 ? (width + r[d]) * (width - r[d]) : width + T(side[d]) * r[d]);
    return out;
}

template <class T>
using ShapeFunction = T (*)(const ElementRow&, std::size_t, const Place<T>&);
struct ShapeRow {
    ElementType type;
    ElementType without_inner;  ///< The kind that has no nodes but those of corners and edges.
    ShapeFunction<double> weight;
    ShapeFunction<Sloped> sloped;
};
#define FEELEM_SHAPE(function) function<double>, function<Sloped>
constexpr std::array<ShapeRow, kElementTypeCount> kShapes{
    ShapeRow{Point1, Point1, FEELEM_SHAPE(point_shape)},
    ShapeRow{Line2, Line2, FEELEM_SHAPE(linear_product)},
    ShapeRow{Line3, Line3, FEELEM_SHAPE(quadratic_product)},
    ShapeRow{Tri3, Tri3, FEELEM_SHAPE(linear_simplex)},
    ShapeRow{Tri6, Tri6, FEELEM_SHAPE(quadratic_simplex)},
    ShapeRow{Quad4, Quad4, FEELEM_SHAPE(linear_product)},
    ShapeRow{Quad8, Quad8, FEELEM_SHAPE(serendipity)},
    ShapeRow{Quad9, Quad8, FEELEM_SHAPE(quadratic_product)},
    ShapeRow{Tet4, Tet4, FEELEM_SHAPE(linear_simplex)},
    ShapeRow{Tet10, Tet10, FEELEM_SHAPE(quadratic_simplex)},
    ShapeRow{Pyramid5, Pyramid5, FEELEM_SHAPE(pyramid5)},
    ShapeRow{Pyramid13, Pyramid13, FEELEM_SHAPE(pyramid13)},
    ShapeRow{Wedge6, Wedge6, FEELEM_SHAPE(wedge6)},
    ShapeRow{Wedge15, Wedge15, FEELEM_SHAPE(wedge15)},
    ShapeRow{Wedge18, Wedge15, FEELEM_SHAPE(wedge18)},
    ShapeRow{Hex8, Hex8, FEELEM_SHAPE(linear_product)},
    ShapeRow{Hex20, Hex20, FEELEM_SHAPE(serendipity)},
    ShapeRow{Hex27, Hex20, FEELEM_SHAPE(quadratic_product)},
};
#undef FEELEM_SHAPE

constexpr bool shapes_are_in_order() {
    for (std::size_t i = 0; i < kShapes.size(); ++i) {
        if (static_cast<std::size_t>(kShapes[i].type) != i) return false;
    }
    return true;
}
static_assert(shapes_are_in_order(), "a row for each ElementType, in the order of the enum");

const ShapeRow& shape_row(ElementType type) {
    return kShapes[static_cast<std::size_t>(type)];
}

/// The type to take the functions of when inner nodes may be missing.
ElementType present_type(ElementType type, std::span<const NodeIndex> nodes) {
    const ElementType without = shape_row(type).without_inner;
    const auto inner = nodes.subspan(std::min<std::size_t>(element_row(without).node_count, nodes.size()));
    return std::ranges::find(inner, kNoNode) == inner.end() ? type : without;
}

template <class Add>
void hand_on_missing(ElementType type, std::span<const NodeIndex> nodes, Add hand_on) {
    for (const EdgeRow& edge : edges_of(type)) {
        if (edge.middle == kNoLocalNode || nodes[edge.middle] != kNoNode) continue;
        hand_on(edge.middle, edge.first);
        hand_on(edge.middle, edge.second);
    }
}

struct ReferencePlane {
    Point3 normal{};
    double offset = 0;  ///< Inside: normal * at <= offset.
};

std::vector<ReferencePlane> planes_of(ElementType type) {
    std::vector<ReferencePlane> planes;
    const ElementRow& row = element_row(type);
    const auto place = [&](std::uint8_t node) {
        const auto& at = row.reference[node];
        return Point3{at[0], at[1], at[2]};
    };
    for (const FacetRow& facet : facets_of(type)) {
        const auto c = facet_corners(facet);
        const Point3 normal = cross(minus(place(c[1]), place(c[0])), minus(place(c[2]), place(c[0])));
        const Point3 n = direction(normal).value_or(Point3{});
        planes.push_back({n, dot(n, place(c[0]))});
    }
    return planes;
}

/// Solution of the 3 x 3 system with the columns a b c; empty when they lie in a plane.
std::optional<Point3> solved(const Point3& a, const Point3& b, const Point3& c, const Point3& right) {
    const double whole = dot(a, cross(b, c));
    if (!(std::abs(whole) > 0) || !std::isfinite(whole)) return {};
    return Point3{
        dot(right, cross(b, c)) / whole, dot(right, cross(c, a)) / whole, dot(right, cross(a, b)) / whole};
}

}  // namespace

ShapeWeights shape_at(ElementType type, const Point3& at) noexcept {
    const ElementRow& row = element_row(type);
    ShapeWeights out{};
    for (std::size_t i = 0; i < row.node_count; ++i) out[i] = shape_row(type).weight(row, i, at);
    return out;
}

ShapeSlopes shape_slopes_at(ElementType type, const Point3& at) noexcept {
    const ElementRow& row = element_row(type);
    const Place<Sloped> place{
        Sloped::variable(at[0], 0), Sloped::variable(at[1], 1), Sloped::variable(at[2], 2)};
    ShapeSlopes out;
    for (std::size_t i = 0; i < row.node_count; ++i) {
        const Sloped shape = shape_row(type).sloped(row, i, place);
        out.weights[i] = shape.value;
        out.slopes[i] = shape.slope;
    }
    return out;
}

ShapeWeights shape_at(ElementType type, std::span<const NodeIndex> nodes, const Point3& at) noexcept {
    const ElementType present = present_type(type, nodes);
    ShapeWeights out = shape_at(present, at);
    hand_on_missing(present, nodes, [&](std::size_t middle, std::size_t corner) {
        out[corner] += out[middle] / 2;
    });
    hand_on_missing(present, nodes, [&](std::size_t middle, std::size_t) { out[middle] = 0; });
    return out;
}

ShapeSlopes shape_slopes_at(ElementType type, std::span<const NodeIndex> nodes, const Point3& at) noexcept {
    const ElementType present = present_type(type, nodes);
    ShapeSlopes out = shape_slopes_at(present, at);
    hand_on_missing(present, nodes, [&](std::size_t middle, std::size_t corner) {
        out.weights[corner] += out.weights[middle] / 2;
        for (std::size_t d = 0; d < 3; ++d) out.slopes[corner][d] += out.slopes[middle][d] / 2;
    });
    hand_on_missing(present, nodes, [&](std::size_t middle, std::size_t) {
        out.weights[middle] = 0;
        out.slopes[middle] = {};
    });
    return out;
}

Point3 reference_centre(ElementType type) noexcept {
    const ElementRow& row = element_row(type);
    Point3 sum{};
    for (std::size_t i = 0; i < row.corner_count; ++i) {
        for (std::size_t d = 0; d < 3; ++d) sum[d] += static_cast<double>(row.reference[i][d]);
    }
    for (double& v : sum) v /= row.corner_count;
    return sum;
}

double depth_inside(ElementType type, const Point3& at) noexcept {
    static const auto planes = [] {
        std::array<std::vector<ReferencePlane>, kElementTypeCount> made;
        for (std::size_t i = 0; i < made.size(); ++i) made[i] = planes_of(static_cast<ElementType>(i));
        return made;
    }();
    double depth = std::numeric_limits<double>::infinity();
    for (const ReferencePlane& plane : planes[static_cast<std::size_t>(type)])
        depth = std::min(depth, plane.offset - dot(plane.normal, at));
    return depth;
}

std::optional<Point3> find_natural(
    ElementType type, std::span<const NodeIndex> nodes, std::span<const Point3> places, const Point3& target
) noexcept {
    constexpr int kMostSteps = 40;
    constexpr double kExact = 1e-10, kFarthest = 2;
    // Places are taken from a corner, not from the model's origin, which may be far away.
    const Point3& origin = places[raw(nodes.front())];
    Point3 at = reference_centre(type);
    for (int step = 0; step < kMostSteps; ++step) {
        const ShapeSlopes shape = shape_slopes_at(type, nodes, at);
        Point3 left = minus(target, origin);
        std::array<Point3, 3> columns{};
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i] == kNoNode) continue;
            const Point3 place = minus(places[raw(nodes[i])], origin);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                left[axis] -= shape.weights[i] * place[axis];
                for (std::size_t d = 0; d < 3; ++d) columns[d][axis] += shape.slopes[i][d] * place[axis];
            }
        }
        const auto move = solved(columns[0], columns[1], columns[2], left);
        if (!move || !std::isfinite(length(*move))) return {};
        for (std::size_t d = 0; d < 3; ++d) at[d] = std::clamp(at[d] + (*move)[d], -kFarthest, 1 + kFarthest);
        if (length(*move) < kExact) return at;
    }
    return {};
}

}  // namespace feelem
