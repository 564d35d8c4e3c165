// SPDX-License-Identifier: Apache-2.0
// Must: judge a level without any knowledge of how it was made; shares no code with the simplifier. Assumes:
// indexes in range. Algorithm: for every original vertex the closest place on a triangle of the level that is
// of the same part and faces as an original triangle at the vertex does, found in a tree of boxes; the value
// shown there against the vertex's own. All in double. Data: 140 bytes a triangle of the level and 16 an
// original one.
#include "base/parallel.hpp"

#include "feelem/lod.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace feelem {
namespace {

struct Vec {
    double x = 0, y = 0, z = 0;
};
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator*(double s, Vec a) {
    return {s * a.x, s * a.y, s * a.z};
}
double operator*(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec outer(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit_of(Vec a) {
    const double length = std::sqrt(a * a);
    return length > 0 ? (1 / length) * a : Vec{};
}

constexpr double kAgrees = 0.25;
constexpr std::uint32_t kFewTriangles = 4;
constexpr std::uint32_t kNowhere = 0xffffffffU;
constexpr std::size_t kFieldBits = 64;

struct Found {
    std::uint32_t triangle = kNowhere;
    double square = std::numeric_limits<double>::infinity();
    std::array<double, 3> weights{};
};

/// Place on the segment ab closest to p, as share of b.
double share_of(Vec p, Vec a, Vec b) {
    const Vec d = b - a;
    const double length = d * d;
    return length > 0 ? std::clamp(((p - a) * d) / length, 0.0, 1.0) : 0.0;
}

/// The foot of p when it is inside the triangle, else the best place of its three edges.
Found nearest_on(Vec p, const std::array<Vec, 3>& t) {
    Found found;
    const Vec n = outer(t[1] - t[0], t[2] - t[0]);
    const double area = n * n;
    if (area > 0) {
        const double w1 = (outer(p - t[0], t[2] - t[0]) * n) / area;
        const double w2 = (outer(t[1] - t[0], p - t[0]) * n) / area;
        if (w1 >= 0 && w2 >= 0 && w1 + w2 <= 1) {
            const double height = ((p - t[0]) * n);
            found.square = height * height / area;
            found.weights = {1 - w1 - w2, w1, w2};
            return found;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double s = share_of(p, t[i], t[j]);
        const Vec off = p - (t[i] + s * (t[j] - t[i]));
        if (off * off >= found.square) continue;
        found.square = off * off;
        found.weights = {};
        found.weights[i] = 1 - s;
        found.weights[j] += s;
    }
    return found;
}

struct Box {
    Vec low, high;
    std::uint32_t first = 0, count = 0;  ///< Of triangles in a leaf; else count 0 and first = left child.

    double square_to(Vec p) const {
        const double x = std::max({low.x - p.x, 0.0, p.x - high.x});
        const double y = std::max({low.y - p.y, 0.0, p.y - high.y});
        const double z = std::max({low.z - p.z, 0.0, p.z - high.z});
        return x * x + y * y + z * z;
    }
};

class LevelTree {
public:
    explicit LevelTree(std::vector<std::array<Vec, 3>> triangles) : triangles_(std::move(triangles)) {
        order_.resize(triangles_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        if (order_.empty()) return;
        boxes_.reserve(order_.size());
        boxes_.emplace_back();
        split(0, 0, static_cast<std::uint32_t>(order_.size()));
    }

    /// `near`: a triangle that may be close, to begin with; the answer is the same whatever it is.
    template <class Suits>
    Found nearest(Vec p, const Suits& suits, std::uint32_t near = kNowhere) const {
        Found best;
        if (boxes_.empty()) return best;
        if (near != kNowhere && suits(near)) {
            best = nearest_on(p, triangles_[near]);
            best.triangle = near;
        }
        std::array<std::uint32_t, 128> stack;
        std::size_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Box& box = boxes_[stack[--depth]];
            if (box.square_to(p) > best.square) continue;
            if (box.count == 0) {
                const bool left_last = boxes_[box.first].square_to(p) < boxes_[box.first + 1].square_to(p);
                stack[depth++] = box.first + (left_last ? 1 : 0);
                stack[depth++] = box.first + (left_last ? 0 : 1);
                continue;
            }
            for (std::uint32_t i = box.first; i < box.first + box.count; ++i) {
                Found found = nearest_on(p, triangles_[order_[i]]);
                found.triangle = order_[i];
                const bool is_better = found.square < best.square ||
                                       (found.square == best.square && found.triangle < best.triangle);
                if (is_better && suits(order_[i])) best = found;
            }
        }
        return best;
    }

private:
    void split(std::uint32_t at, std::uint32_t first, std::uint32_t last) {
        const double far = std::numeric_limits<double>::infinity();
        Box box{{far, far, far}, {-far, -far, -far}, first, last - first};
        for (std::uint32_t i = first; i < last; ++i) {
            for (const Vec& v : triangles_[order_[i]]) {
                box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
                box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
            }
        }
        if (box.count > kFewTriangles) {
            const Vec size = box.high - box.low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
            const auto middle = [&](std::uint32_t t) {
                const auto& v = triangles_[t];
                const Vec sum = v[0] + v[1] + v[2];
                return axis == 0 ? sum.x : (axis == 1 ? sum.y : sum.z);
            };
            const std::uint32_t half = first + box.count / 2;
            std::nth_element(
                order_.begin() + first,
                order_.begin() + half,
                order_.begin() + last,
                [&](std::uint32_t a, std::uint32_t b) {
                    const double ma = middle(a), mb = middle(b);
                    return ma < mb || (ma == mb && a < b);
                }
            );
            const auto child = static_cast<std::uint32_t>(boxes_.size());
            boxes_.resize(boxes_.size() + 2);
            box.first = child;
            box.count = 0;
            split(child, first, half);
            split(child + 1, half, last);
        }
        boxes_[at] = box;
    }

    std::vector<std::array<Vec, 3>> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Box> boxes_;
};

using Corners = std::array<VertexIndex, 3>;

/// The triangles of each vertex.
class Incidence {
public:
    Incidence(std::span<const Corners> triangles, std::size_t vertices) : first_(vertices + 1, 0) {
        for (const Corners& t : triangles) {
            for (const VertexIndex v : t) ++first_[raw(v) + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        triangles_.resize(triangles.size() * 3);
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (const VertexIndex v : triangles[t]) triangles_[next[raw(v)]++] = t;
        }
    }
    std::span<const std::uint32_t> of(std::uint32_t v) const {
        return std::span(triangles_).subspan(first_[v], first_[v + 1] - first_[v]);
    }

private:
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> triangles_;
};

class LevelChecker {
public:
    LevelChecker(
        const LodSurface& surface,
        std::span<const LodField> fields,
        std::span<const Corners> level,
        double distance
    )
        : surface_(surface), fields_(fields), level_(level), distance_(distance), tree_(places_of_level()),
          original_(surface.triangles, surface.positions.size()), own_(level, surface.positions.size()) {
        missing_.assign(surface.positions.size(), 0);
        for (std::size_t k = 0; k < fields.size(); ++k) {
            for (std::size_t v = 0; v < missing_.size(); ++v) {
                if (!std::isfinite(fields[k].values[v])) missing_[v] |= std::uint64_t{1} << (k % kFieldBits);
            }
        }
        for (const Corners& t : level) {
            level_normals_.push_back(normal_of(t));
            level_missing_.push_back(missing_in(t));
        }
    }

    LodCheck run() const {
        constexpr std::size_t kChunk = 1U << 12U;
        const std::size_t vertices = surface_.positions.size();
        std::vector<LodCheck> parts((vertices + kChunk - 1) / kChunk);
        parallel_chunks(vertices, kChunk, [&](std::size_t first, std::size_t last) {
            LodCheck& part = parts[first / kChunk];
            part.fields.resize(fields_.size());
            std::uint32_t near = kNowhere;
            for (std::size_t v = first; v < last; ++v) check(static_cast<std::uint32_t>(v), part, near);
        });
        LodCheck sum;
        sum.fields.resize(fields_.size());
        for (const LodCheck& part : parts) {
            sum.vertices += part.vertices;
            sum.without_place += part.without_place;
            sum.invented += part.invented;
            sum.lost += part.lost;
            sum.max_distance = std::max(sum.max_distance, part.max_distance);
            for (std::size_t k = 0; k < fields_.size(); ++k) {
                LodCheck::Field& all = sum.fields[k];
                if (part.fields[k].max > all.max) {
                    all.max = part.fields[k].max;
                    all.worst = part.fields[k].worst;
                }
                all.over += part.fields[k].over;
                all.rms += part.fields[k].rms;
            }
        }
        for (LodCheck::Field& field : sum.fields)
            field.rms = std::sqrt(field.rms / static_cast<double>(std::max<std::uint64_t>(1, sum.vertices)));
        return sum;
    }

private:
    Vec place_of(VertexIndex v) const {
        const Point3& p = surface_.positions[raw(v)];
        return {p[0], p[1], p[2]};
    }
    Vec normal_of(const Corners& t) const {
        return unit_of(outer(place_of(t[1]) - place_of(t[0]), place_of(t[2]) - place_of(t[0])));
    }
    std::vector<std::array<Vec, 3>> places_of_level() const {
        std::vector<std::array<Vec, 3>> out;
        out.reserve(level_.size());
        for (const Corners& t : level_) out.push_back({place_of(t[0]), place_of(t[1]), place_of(t[2])});
        return out;
    }
    std::uint64_t missing_in(const Corners& t) const {
        return missing_[raw(t[0])] | missing_[raw(t[1])] | missing_[raw(t[2])];
    }
    std::uint32_t part_of(VertexIndex v) const { return surface_.parts.empty() ? 0 : surface_.parts[raw(v)]; }

    /// Triangles without area show nothing.
    bool is_drawn(std::uint32_t v) const {
        return std::ranges::any_of(original_.of(v), [&](std::uint32_t t) {
            const Vec n = normal_of(surface_.triangles[t]);
            return n * n > 0;
        });
    }

    /// A vertex of the level is shown by its own triangles.
    template <class Suits>
    Found own_place(std::uint32_t v, const Suits& suits) const {
        for (const std::uint32_t t : own_.of(v)) {
            if (!suits(t)) continue;
            Found found{t, 0, {}};
            for (std::size_t k = 0; k < 3; ++k) {
                if (level_[t][k] == VertexIndex{v}) found.weights[k] = 1;
            }
            return found;
        }
        return {};
    }

    /// `near`: of the vertex before; then of this one.
    void check(std::uint32_t v, LodCheck& out, std::uint32_t& near) const {
        if (!is_drawn(v)) return;
        std::uint64_t missing = ~std::uint64_t{0};
        for (const std::uint32_t t : original_.of(v)) missing &= missing_in(surface_.triangles[t]);
        const auto suits = [&](std::uint32_t t) {
            if (part_of(level_[t][0]) != part_of(VertexIndex{v})) return false;
            return std::ranges::any_of(original_.of(v), [&](std::uint32_t facing) {
                return normal_of(surface_.triangles[facing]) * level_normals_[t] > kAgrees;
            });
        };
        const Vec p = place_of(VertexIndex{v});
        Found found = own_place(v, suits);
        if (found.triangle == kNowhere) found = tree_.nearest(p, suits, near);
        if (found.triangle != kNowhere) near = found.triangle;
        ++out.vertices;
        if (found.triangle == kNowhere) {
            ++out.without_place;
            return;
        }
        if (level_missing_[found.triangle] != missing) {
            // The border of what is missing may have moved a little.
            const Found same =
                tree_.nearest(p, [&](std::uint32_t t) { return level_missing_[t] == missing && suits(t); });
            if (std::sqrt(same.square) <= distance_) found = same;
        }
        out.max_distance = std::max(out.max_distance, std::sqrt(found.square));
        if (level_missing_[found.triangle] == missing) return compare(v, missing, {&found, 1}, out);
        // Fields that are missing at different places may have no place in common: each where it has its
        // state.
        std::array<Found, kFieldBits> own;
        own.fill(found);
        for (std::uint64_t rest = level_missing_[found.triangle] ^ missing; rest != 0; rest &= rest - 1) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
            const auto has_state = [&](std::uint32_t t) {
                return ((level_missing_[t] ^ missing) >> bit & 1U) == 0 && suits(t);
            };
            Found better = own_place(v, has_state);
            if (better.triangle == kNowhere) better = tree_.nearest(p, has_state);
            if (std::sqrt(better.square) <= distance_) own[bit] = better;
        }
        compare(v, missing, own, out);
    }

    void compare(std::uint32_t v, std::uint64_t missing, std::span<const Found> places, LodCheck& out) const {
        bool is_invented = false, is_lost = false;
        for (std::size_t k = 0; k < fields_.size(); ++k) {
            const auto f = fields_[k].values;
            const Found& found = places[k % places.size()];
            const Corners& t = level_[found.triangle];
            double shown = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                if (found.weights[i] != 0) shown += found.weights[i] * static_cast<double>(f[raw(t[i])]);
            }
            const bool is_missing = ((missing >> (k % kFieldBits)) & 1U) != 0;
            const bool is_shown_missing = ((level_missing_[found.triangle] >> (k % kFieldBits)) & 1U) != 0;
            is_invented = is_invented || (is_missing && !is_shown_missing);
            is_lost = is_lost || (!is_missing && is_shown_missing);
            if (is_missing || is_shown_missing) continue;
            const double error = std::abs(shown - static_cast<double>(f[v]));
            LodCheck::Field& field = out.fields[k];
            if (error > field.max) {
                field.max = error;
                field.worst = VertexIndex{v};
            }
            field.rms += error * error;
            if (error > fields_[k].bound) ++field.over;
        }
        if (is_invented) ++out.invented;
        if (is_lost) ++out.lost;
    }

    const LodSurface& surface_;
    std::span<const LodField> fields_;
    std::span<const Corners> level_;
    double distance_;
    LevelTree tree_;
    std::vector<std::uint64_t> missing_;  ///< Per vertex: bit k = field k has no value.
    std::vector<Vec> level_normals_;
    std::vector<std::uint64_t> level_missing_;
    Incidence original_, own_;
};

}  // namespace

LodCheck check_level(
    const LodSurface& surface,
    std::span<const LodField> fields,
    std::span<const std::array<VertexIndex, 3>> level,
    double distance
) {
    return LevelChecker(surface, fields, level, distance).run();
}

}  // namespace feelem
