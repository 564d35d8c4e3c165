// SPDX-License-Identifier: Apache-2.0
#include "convert/scene_values.hpp"

#include "convert/model_values.hpp"
#include "convert/stage.hpp"

#include <algorithm>

namespace feelem {
namespace {

/// Fields wait in this much memory, or in half of the skin's own size if that is more.
constexpr std::size_t kLeastLimit = 24u << 20;

std::size_t bytes_of(const Surface& surface) {
    const std::size_t per_vertex = sizeof(Point3) + sizeof(surface.normals[0]) + sizeof(NodeIndex);
    const std::size_t per_triangle = sizeof(surface.triangles[0]) + sizeof(ElementIndex);
    return surface.positions.size() * per_vertex + surface.triangles.size() * per_triangle;
}

std::size_t bytes_of(const SurfaceField& field) {
    return field.values.size() * sizeof(float) + field.validity.size() * sizeof(Validity);
}

/// Only these components of a result, in this order.
Result pick_components(const Result& result, const std::vector<std::string>& components) {
    Result picked;
    picked.info = result.info;
    picked.info.components = components;
    picked.row_owner = result.row_owner;
    picked.row_node = result.row_node;
    const std::size_t width = result.component_count();
    picked.values.resize(result.row_count() * components.size());
    for (std::size_t c = 0; c < components.size(); ++c) {
        const auto from = static_cast<std::size_t>(component_index(result.info, components[c]));
        for (std::size_t row = 0; row < result.row_count(); ++row) {
            picked.values[row * components.size() + c] = result.values[row * width + from];
        }
    }
    return picked;
}

}  // namespace

SceneValueStore::SceneValueStore(ModelSource& source, const Surface& surface, const ScenePlan& plan)
    : source_(source), surface_(surface), plan_(plan),
      byte_limit_(std::max(kLeastLimit, bytes_of(surface) / 2)) {}

Result SceneValueStore::made_of(
    const Result& result, const PlannedResult& planned, DerivedComponents& derived
) const {
    if (planned.components.size() > 1) return pick_components(result, planned.components);
    return derived.take(planned.components.front());
}

std::vector<std::string_view> SceneValueStore::single_components(std::span<const Key> keys) const {
    std::vector<std::string_view> names;
    for (const Key& key : keys) {
        const std::vector<std::string>& components = plan_.results[key.first].components;
        if (components.size() == 1) names.push_back(components.front());
    }
    return names;
}

void SceneValueStore::keep(const Key& key, SurfaceField field) {
    const std::size_t bytes = bytes_of(field);
    if (kept_bytes_ + bytes > byte_limit_) return;
    kept_bytes_ += bytes;
    fields_.emplace(key, std::move(field));
}

void SceneValueStore::read_all(const Progress& progress) {
    std::map<std::size_t, std::vector<Key>> users;  // by result of the model
    for (std::size_t i = 0; i < plan_.results.size(); ++i) {
        for (std::size_t k = 0; k < plan_.results[i].values.size(); ++k) {
            users[plan_.results[i].values[k].source_result].push_back({i, k});
        }
    }
    std::size_t done = 0;
    for (const auto& [index, keys] : users) {
        report_progress(progress, "results", fraction_of(done++, users.size()));
        const Result result = source_.load(index);
        DerivedComponents derived(result, single_components(keys));
        std::uint64_t filled = 0;  // The same vertices in each of its components.
        for (const Key& key : keys) {
            const PlannedResult& planned = plan_.results[key.first];
            // Usually the whole result: then it is not copied.
            const bool is_whole = planned.components == result.info.components;
            const Result made = is_whole ? Result{} : made_of(result, planned, derived);
            const Result& values = is_whole ? result : made;
            for (std::size_t c = 0; c < planned.components.size(); ++c) {
                ranges_[key].push_back(range_over_model(source_.mesh(), values, c));
            }
            SurfaceField field = carry(source_.mesh(), surface_, values);
            filled = std::max(filled, field.interpolated);
            keep(key, std::move(field));
        }
        interpolated_ += filled;
    }
}

const std::vector<ComponentRange>& SceneValueStore::ranges(std::size_t result, std::size_t values) const {
    return ranges_.at({result, values});
}

SurfaceField SceneValueStore::field(std::size_t result, std::size_t values) {
    const auto kept = fields_.find({result, values});
    if (kept != fields_.end()) return kept->second;
    const PlannedResult& planned = plan_.results.at(result);
    const Result all = source_.load(planned.values.at(values).source_result);
    if (planned.components == all.info.components) return carry(source_.mesh(), surface_, all);
    DerivedComponents derived(all, {});
    return carry(source_.mesh(), surface_, made_of(all, planned, derived));
}

SurfaceField SceneValueStore::take_field(std::size_t result, std::size_t values) {
    const auto kept = fields_.find({result, values});
    if (kept == fields_.end()) return field(result, values);
    SurfaceField field = std::move(kept->second);
    kept_bytes_ -= bytes_of(field);
    fields_.erase(kept);
    return field;
}

}  // namespace feelem
