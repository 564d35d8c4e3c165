// SPDX-License-Identifier: Apache-2.0
// Rays and points against the model as it is drawn: deformed, cut, with parts hidden; and the values there.
#pragma once

#include "viewer/core/model_source.hpp"
#include "viewer/core/snapshot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// A place on the drawn skin.
struct SkinHit {
    std::size_t part = 0;
    std::uint32_t triangle = 0;  ///< Of the part's full list.
    std::array<double, 3> weights{};
    double distance = 0;  ///< Metres, along the ray or from the point.
    glm::vec3 world{0}, normal{0, 1, 0};
};

/// What a ray meets: a place of the skin, or the material that a cut has opened, of which a skin knows no
/// values.
struct Cast {
    std::optional<SkinHit> hit;
    std::optional<glm::vec3> inside;  ///< World, metres.
};

class Prober {
public:
    explicit Prober(const ViewedModel& model);
    ~Prober();
    Prober(Prober&&) noexcept;
    Prober& operator=(Prober&&) noexcept;

    /// Makes the hierarchies; may run on a thread of its own while frames are drawn: until it is done, all
    /// rays miss. Once.
    void grow();
    bool is_ready() const noexcept;

    /// What is drawn from now on; cheap when little has changed, whatever the shape does.
    void set_look(const Look& look);
    Cast cast(const Ray& ray) const;
    /// Nearest place within `reach` metres.
    std::optional<SkinHit> near(const glm::vec3& point, float reach) const;
    /// The place of a corner of a triangle (ViewedModel::corner_of_node), whether or not it can be seen.
    SkinHit at_corner(std::size_t corner) const;
    /// Where a vertex is drawn, world.
    glm::vec3 drawn_at(std::uint32_t vertex) const;
    /// The hit's place as the skin is drawn now.
    glm::vec3 world_of(const SkinHit& hit) const;
    /// Whether a place can be seen from somewhere: its part is not hidden, no plane has cut it away.
    bool is_there(std::size_t part, std::uint32_t vertex) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

struct ViewerState;
/// The solver's node nearest to the place.
std::optional<std::int64_t> node_of(const ViewedModel& model, const SkinHit& hit);
/// Everything that is at a place: values of all results of the presentation, as feelem::probe() says them.
Probed read_place(const ViewerState& state, const ViewedModel& model, const SkinHit& hit);

}  // namespace feelem::viewer
