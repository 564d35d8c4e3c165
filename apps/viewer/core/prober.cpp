// SPDX-License-Identifier: Apache-2.0
// Rays against the drawn skin, also while it moves: one hierarchy a part.
#include "viewer/core/cuts.hpp"
#include "viewer/core/moving_tree.hpp"
#include "viewer/core/probe.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <atomic>
#include <cmath>
#include <limits>

namespace feelem::viewer {
namespace {

pick::Double3 plain(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
glm::dvec3 vec(const pick::Double3& v) {
    return {v[0], v[1], v[2]};
}
bool is_finite_vec(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Not of unit length; zero for a triangle without area.
glm::dvec3 square_to(const pick::Corners3& corners) {
    const glm::dvec3 a = vec(corners[0]);
    return glm::cross(vec(corners[1]) - a, vec(corners[2]) - a);
}

struct Found {
    std::size_t part = 0;
    Hit hit;
};

}  // namespace

struct Prober::State {
    explicit State(const ViewedModel& viewed) : model(viewed) {}

    const ViewedModel& model;
    std::vector<MovingTree> trees;  ///< One a part; complete once `ready` is true.
    std::atomic<bool> ready{false};
    DrawnShape shape;
    std::vector<PartLook> looks;
    std::vector<CutPlane> cuts;
    glm::dmat4 to_world{1}, to_model{1};
    double scale = 1;  ///< Metres a model unit.

    PartLook look_of(std::size_t part) const { return part < looks.size() ? looks[part] : PartLook::Shown; }
    glm::dvec3 to(const glm::dmat4& matrix, const glm::dvec3& place) const {
        return glm::dvec3(matrix * glm::dvec4(place, 1));
    }
    glm::dvec3 place_of(const Found& found) const;
    SkinHit hit_of(const Found& found, const glm::dvec3& from, const glm::vec3& from_world) const;
    std::optional<Found> first_hit(
        PartLook look, const glm::dvec3& origin, const glm::dvec3& direction, double reach
    ) const;
    std::optional<Found> closest(PartLook look, const glm::dvec3& from, double reach) const;
    Swing swing_of(const FieldChoice& field, float factor) const;
};

glm::dvec3 Prober::State::place_of(const Found& found) const {
    const pick::Corners3 corners = trees[found.part].corners(found.hit.triangle);
    glm::dvec3 place(0);
    for (std::size_t k = 0; k < 3; ++k) place += found.hit.weights[k] * vec(corners[k]);
    return place;
}

/// `from`: where it was looked at from, model units; the normal is on that side.
SkinHit Prober::State::hit_of(const Found& found, const glm::dvec3& from, const glm::vec3& from_world) const {
    const glm::dvec3 place = place_of(found);
    const glm::dvec3 square = square_to(trees[found.part].corners(found.hit.triangle));
    glm::dvec3 normal = glm::length(square) > 0 ? square : from - place;
    if (glm::dot(normal, from - place) < 0) normal = -normal;
    glm::dvec3 turned = glm::dmat3(to_world) * normal;
    turned = glm::length(turned) > 0 ? glm::normalize(turned) : glm::dvec3(0, 1, 0);
    const glm::dvec3 world = to(to_world, place);
    SkinHit hit;
    hit.part = found.part;
    hit.triangle = found.hit.triangle;
    hit.weights = found.hit.weights;
    hit.distance = glm::distance(world, glm::dvec3(from_world));
    hit.world = glm::vec3(world);
    hit.normal = glm::vec3(turned);
    return hit;
}

std::optional<Found> Prober::State::first_hit(
    PartLook look, const glm::dvec3& origin, const glm::dvec3& direction, double reach
) const {
    std::optional<Found> best;
    for (std::size_t p = 0; p < trees.size(); ++p) {
        if (look_of(p) != look) continue;
        const double limit = best ? best->hit.distance : reach;
        const auto hit = trees[p].ray(plain(origin), plain(direction), limit);
        if (hit && !(best && best->hit.distance <= hit->distance)) best = {p, *hit};
    }
    return best;
}

std::optional<Found> Prober::State::closest(PartLook look, const glm::dvec3& from, double reach) const {
    std::optional<Found> best;
    const auto is_kept = [&](const pick::Double3& place) { return !is_cut_away(cuts, vec(place)); };
    for (std::size_t p = 0; p < trees.size(); ++p) {
        if (look_of(p) != look) continue;
        const double limit = best ? best->hit.distance : reach;
        const auto hit = trees[p].nearest(plain(from), limit, is_kept);
        if (hit && !(best && best->hit.distance <= hit->distance)) best = {p, *hit};
    }
    return best;
}

Swing Prober::State::swing_of(const FieldChoice& field, float factor) const {
    const FieldSpan span = model.values({field.result, field.values, 0});
    if (span.components != 3) return {};
    return {span.values, static_cast<double>(factor)};
}

Prober::Prober(const ViewedModel& model) : state_(std::make_unique<State>(model)) {}
Prober::~Prober() = default;
Prober::Prober(Prober&&) noexcept = default;
Prober& Prober::operator=(Prober&&) noexcept = default;

void Prober::grow() {
    if (state_->ready) return;
    const ModelArrays& arrays = state_->model.arrays();
    for (const PartSpan& part : arrays.parts) {
        state_->trees.emplace_back(
            arrays.positions, arrays.triangles.subspan(part.first_triangle, part.triangles)
        );
    }
    state_->ready = true;
}

bool Prober::is_ready() const noexcept {
    return state_->ready;
}

void Prober::set_look(const Look& look) {
    State& state = *state_;
    state.shape = {};
    if (look.shape) {
        state.shape[0] = state.swing_of(look.shape->field, look.shape->factor);
        if (look.shape->imaginary) {
            state.shape[1] = state.swing_of(*look.shape->imaginary, look.shape->imaginary_factor);
        }
    }
    state.looks = look.parts;
    state.cuts = look.cuts;
    state.to_world = glm::dmat4(look.model_to_world);
    state.to_model = glm::inverse(state.to_world);
    state.scale = glm::length(glm::dvec3(state.to_world[0]));
    if (!state.ready) return;
    for (MovingTree& tree : state.trees) tree.set_shape(state.shape);
}

Cast Prober::cast(const Ray& ray) const {
    const State& state = *state_;
    if (!state.ready || !is_finite_vec(ray.origin) || !is_finite_vec(ray.direction)) return {};
    const glm::dvec3 along = glm::dmat3(state.to_model) * glm::dvec3(ray.direction);
    const double length = glm::length(along);
    if (!(length > 0) || !std::isfinite(length)) return {};
    const glm::dvec3 direction = along / length;
    const glm::dvec3 eye = state.to(state.to_model, glm::dvec3(ray.origin));
    const auto range = kept_range(state.cuts, eye, direction);
    if (!range) return {};
    const glm::dvec3 origin = eye + range->enters * direction;
    const double reach = range->leaves - range->enters;
    auto found = state.first_hit(PartLook::Shown, origin, direction, reach);
    if (!found) found = state.first_hit(PartLook::Clear, origin, direction, reach);
    if (!found) return {};
    const bool from_behind =
        glm::dot(square_to(state.trees[found->part].corners(found->hit.triangle)), direction) > 0;
    const bool is_solid = state.model.about().parts[found->part].kind == "solid";
    if (range->enters > 0 && is_solid && from_behind) {
        return {std::nullopt, glm::vec3(state.to(state.to_world, origin))};
    }
    return {state.hit_of(*found, eye, ray.origin), std::nullopt};
}

std::optional<SkinHit> Prober::near(const glm::vec3& point, float reach) const {
    const State& state = *state_;
    if (!state.ready || !is_finite_vec(point) || !(state.scale > 0)) return std::nullopt;
    const glm::dvec3 from = state.to(state.to_model, glm::dvec3(point));
    const double within = static_cast<double>(reach) / state.scale;
    auto found = state.closest(PartLook::Shown, from, within);
    if (!found) found = state.closest(PartLook::Clear, from, within);
    if (!found) return std::nullopt;
    return state.hit_of(*found, from, point);
}

SkinHit Prober::at_corner(std::size_t corner) const {
    const ModelArrays& arrays = state_->model.arrays();
    const std::size_t triangle = corner / 3;
    SkinHit hit;
    hit.part = state_->model.part_of_triangle(triangle);
    hit.triangle = static_cast<std::uint32_t>(triangle - arrays.parts[hit.part].first_triangle);
    hit.weights[corner % 3] = 1;
    hit.world = world_of(hit);
    const auto& t = arrays.triangles[triangle];
    const glm::vec3 a = drawn_at(t[0]);
    const glm::vec3 square = glm::cross(drawn_at(t[1]) - a, drawn_at(t[2]) - a);
    if (glm::length(square) > 0) hit.normal = glm::normalize(square);
    return hit;
}

glm::vec3 Prober::drawn_at(std::uint32_t vertex) const {
    const glm::dvec3 place = vec(viewer::drawn_at(state_->model.arrays().positions, state_->shape, vertex));
    return glm::vec3(state_->to(state_->to_world, place));
}

glm::vec3 Prober::world_of(const SkinHit& hit) const {
    const ModelArrays& arrays = state_->model.arrays();
    const auto& corners = arrays.triangles[arrays.parts[hit.part].first_triangle + hit.triangle];
    glm::dvec3 place(0);
    for (std::size_t k = 0; k < 3; ++k) {
        place += hit.weights[k] * vec(viewer::drawn_at(arrays.positions, state_->shape, corners[k]));
    }
    return glm::vec3(state_->to(state_->to_world, place));
}

bool Prober::is_there(std::size_t part, std::uint32_t vertex) const {
    if (state_->look_of(part) == PartLook::Hidden) return false;
    const auto place = viewer::drawn_at(state_->model.arrays().positions, state_->shape, vertex);
    return !is_cut_away(state_->cuts, vec(place));
}

}  // namespace feelem::viewer
