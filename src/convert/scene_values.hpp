// SPDX-License-Identifier: Apache-2.0
// Values of a planned scene on the skin: each result of the model is read once and gives all that is made of
// it; fields wait in memory up to a limit, what is beyond is read again when it is asked for.
#pragma once

#include "convert/model_values.hpp"
#include "convert/scene_plan.hpp"

#include "feelem/skin.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem {

class SceneValueStore {
public:
    /// All must outlive the store.
    SceneValueStore(ModelSource& source, const Surface& surface, const ScenePlan& plan);

    /// Reads every result once: extremes over the whole model, and fields as memory allows.
    void read_all(const Progress& progress);

    /// One for each component of the planned result.
    const std::vector<ComponentRange>& ranges(std::size_t result, std::size_t values) const;
    SurfaceField field(std::size_t result, std::size_t values);
    /// The same, given away: it is not asked for again.
    SurfaceField take_field(std::size_t result, std::size_t values);
    /// Mid-side vertices filled from their corners, over all results of the model that were read.
    std::uint64_t interpolated() const noexcept { return interpolated_; }

private:
    using Key = std::pair<std::size_t, std::size_t>;  // scene result, values
    /// Exactly the components that the planned result has, stored or derived.
    Result made_of(const Result& result, const PlannedResult& planned, DerivedComponents& derived) const;
    std::vector<std::string_view> single_components(std::span<const Key> keys) const;
    void keep(const Key& key, SurfaceField field);

    ModelSource& source_;
    const Surface& surface_;
    const ScenePlan& plan_;
    std::map<Key, std::vector<ComponentRange>> ranges_;
    std::map<Key, SurfaceField> fields_;
    std::size_t kept_bytes_ = 0;
    std::size_t byte_limit_ = 0;
    std::uint64_t interpolated_ = 0;
};

}  // namespace feelem
