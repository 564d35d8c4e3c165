// SPDX-License-Identifier: Apache-2.0
// Must: keep every maximum and minimum that rises out of its surroundings by more than twice the bound, bit
// by bit. Assumes: fields are linear on triangles. Algorithm: every vertex points to its highest neighbour,
// which cuts the surface into basins; edges between basins are taken by falling height of their pass; of two
// basins that meet, the one with the lower summit ends (elder rule; Edelsbrunner, Letscher & Zomorodian
// 2002). Equal values are ordered by index, so that plateaus have one summit. Data: 8 bytes a vertex and 12 a
// pass.
#include "base/parallel.hpp"
#include "lod/lod_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

/// One field, turned upside down for its minima.
class Heights {
public:
    Heights(std::span<const float> values, float sign) : values_(values), sign_(sign) {}

    float of(std::uint32_t v) const { return sign_ * values_[v]; }
    bool is_missing(std::uint32_t v) const { return !std::isfinite(values_[v]); }
    /// Total: of equal values the smaller index is higher.
    bool is_higher(std::uint32_t a, std::uint32_t b) const {
        const float fa = of(a), fb = of(b);
        return fa > fb || (fa == fb && a < b);
    }

private:
    std::span<const float> values_;
    float sign_;
};

struct Pass {
    float height;
    std::uint32_t a, b;  ///< Summits on both sides.
};

/// Vertices of one place with one value are one: the smallest index stands for them.
class Joint {
public:
    Joint(const Model& model, std::span<const float> values) : model_(model), values_(values) {
        if (model.place_count >= model.place.size()) return;
        first_.assign(model.place_count, kNone);
        for (auto v = static_cast<std::uint32_t>(model.place.size()); v-- > 0;) first_[model.place[v]] = v;
    }
    std::uint32_t operator()(std::uint32_t v) const {
        if (first_.empty()) return v;
        const std::uint32_t first = first_[model_.place[v]];
        return values_[first] == values_[v] ? first : v;
    }

private:
    const Model& model_;
    std::span<const float> values_;
    std::vector<std::uint32_t> first_;
};

std::vector<std::uint32_t> summits(const Model& model, const Heights& heights, const Joint& joint) {
    std::vector<std::uint32_t> up(model.place.size(), kNone);
    for (const Face& face : model.faces) {
        const std::array<std::uint32_t, 3> v{
            joint(face.vertex[0]), joint(face.vertex[1]), joint(face.vertex[2])};
        std::uint32_t highest = kNone;
        for (const std::uint32_t w : v) {
            if (heights.is_missing(w)) continue;
            if (highest == kNone || heights.is_higher(w, highest)) highest = w;
        }
        for (const std::uint32_t w : v) {
            if (heights.is_missing(w)) continue;
            if (up[w] == kNone || heights.is_higher(highest, up[w])) up[w] = highest;
        }
    }
    for (std::uint32_t v = 0; v < up.size(); ++v) {
        if (up[v] == kNone) continue;
        std::uint32_t top = v;
        while (up[top] != top) top = up[top];
        for (std::uint32_t w = v; up[w] != top;) {
            const std::uint32_t next = up[w];
            up[w] = top;
            w = next;
        }
    }
    return up;
}

std::vector<Pass> passes(
    const Model& model, const Heights& heights, const Joint& joint, std::span<const std::uint32_t> top
) {
    std::vector<Pass> found;
    for (const Face& face : model.faces) {
        const std::array<std::uint32_t, 3> v{
            joint(face.vertex[0]), joint(face.vertex[1]), joint(face.vertex[2])};
        const std::array<std::uint32_t, 3> at{top[v[0]], top[v[1]], top[v[2]]};
        if (at[0] == at[1] && at[1] == at[2]) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = at[k], b = at[kNext[k]];
            if (a == b || a == kNone || b == kNone) continue;
            found.push_back(
                {std::min(heights.of(v[k]), heights.of(v[kNext[k]])), std::min(a, b), std::max(a, b)}
            );
        }
    }
    std::ranges::sort(found, [](const Pass& p, const Pass& q) {
        if (p.height != q.height) return p.height > q.height;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    return found;
}

/// Summits of one field and sign that must stay.
std::vector<std::uint32_t> lasting_summits(const Model& model, const LodField& field, float sign) {
    const Heights heights(field.values, sign);
    const Joint joint(model, field.values);
    std::vector<std::uint32_t> top = summits(model, heights, joint);
    const std::vector<Pass> met = passes(model, heights, joint, top);
    std::vector<std::uint32_t> lasting;
    // From here on, top[summit] leads to the summit that outlived it.
    const auto root = [&](std::uint32_t s) {
        while (top[s] != s) {
            top[s] = top[top[s]];
            s = top[s];
        }
        return s;
    };
    std::vector<std::uint32_t> all;
    for (std::uint32_t v = 0; v < top.size(); ++v) {
        if (top[v] == v) all.push_back(v);
    }
    for (const Pass& pass : met) {
        std::uint32_t a = root(pass.a), b = root(pass.b);
        if (a == b) continue;
        if (heights.is_higher(b, a)) std::swap(a, b);
        top[b] = a;
        const double rise = static_cast<double>(heights.of(b)) - static_cast<double>(pass.height);
        if (rise > 2 * field.bound) lasting.push_back(b);
    }
    for (const std::uint32_t s : all) {
        if (top[s] == s) lasting.push_back(s);
    }
    return lasting;
}

}  // namespace

void lock_extremes(std::span<const LodField> fields, Model& model) {
    std::vector<std::vector<std::uint32_t>> found(2 * fields.size());
    parallel_chunks(found.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            found[i] = lasting_summits(model, fields[i / 2], i % 2 == 0 ? 1.0F : -1.0F);
    });
    std::vector<bool> is_extreme(model.place_count, false);
    for (const auto& vertices : found) {
        for (const std::uint32_t v : vertices) {
            const std::uint32_t place = model.place[v];
            if (!is_extreme[place]) ++model.report.extremes;
            is_extreme[place] = true;
            if (model.role[place] != Role::Pinned) model.role[place] = Role::Locked;
        }
    }
}

}  // namespace feelem::lod

namespace feelem {

std::vector<VertexIndex> lasting_extremes(const LodSurface& surface, std::span<const LodField> fields) {
    lod::Model model;
    lod::make_faces(surface, model);
    std::vector<std::vector<std::uint32_t>> found(2 * fields.size());
    parallel_chunks(found.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            found[i] = lod::lasting_summits(model, fields[i / 2], i % 2 == 0 ? 1.0F : -1.0F);
    });
    std::vector<VertexIndex> vertices;
    for (const auto& some : found) {
        for (const std::uint32_t v : some) vertices.push_back(VertexIndex{v});
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

}  // namespace feelem
