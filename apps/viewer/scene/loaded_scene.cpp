// SPDX-License-Identifier: Apache-2.0
// Parts of a scene joined into one set of arrays; results and levels when they are asked for.
#include "viewer/scene/loaded_scene.hpp"

#include "base/input.hpp"
#include "convert/scene_target.hpp"
#include "scene/scene_read.hpp"
#include "viewer/scene/join_parts.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace feelem::viewer {

struct LoadedScene::State {
    explicit State(const std::string& path) : file(path) {}

    SceneFile file;
    Scene about;
    Geometry geometry;
    glm::mat4 to_metres{1};
    std::vector<ScenePart> parts;  ///< With node ids alone: what read_field asks for.
    std::map<std::pair<std::size_t, std::size_t>, FieldValues> values;
    std::map<std::size_t, std::vector<std::array<std::uint32_t, 3>>> levels;
};

LoadedScene::LoadedScene(const std::string& path, const std::string& presentation_file)
    : state_(std::make_unique<State>(path)) {
    State& state = *state_;
    const SceneDocument& document = state.file.document();
    state.about = document.scene;
    if (presentation_file.empty()) {
        state.about.presentation = read_presentation(state.file);
    } else {
        const Input input = Input::from_file(presentation_file);
        state.about.presentation = parse_presentation(input.text(), input.name());
    }
    state.parts = read_parts(state.file);
    state.geometry = join_parts(state.file, state.parts);
    for (ScenePart& part : state.parts)
        part = {part.name, part.kind, part.domain, part.model_part, {}, {}, std::move(part.node_ids), {}};
    const std::array<double, 16>& matrix = document.model_matrix;
    for (int i = 0; i < 16; ++i)
        glm::value_ptr(state.to_metres)[i] = static_cast<float>(matrix[static_cast<std::size_t>(i)]);
}

LoadedScene::~LoadedScene() = default;

const Scene& LoadedScene::about() const noexcept {
    return state_->about;
}
const Geometry& LoadedScene::geometry() const noexcept {
    return state_->geometry;
}
const glm::mat4& LoadedScene::to_metres() const noexcept {
    return state_->to_metres;
}

const FieldValues& LoadedScene::values(std::size_t result, std::size_t values) {
    State& state = *state_;
    const std::pair key{result, values};
    if (const auto kept = state.values.find(key); kept != state.values.end()) return kept->second;
    FieldValues out;
    out.components = state.about.results.at(result).components.size();
    const std::size_t rows = state.geometry.positions.size();
    out.values.assign(rows * out.components, std::numeric_limits<float>::quiet_NaN());
    out.validity.assign(rows, Validity::Missing);
    for (std::size_t part = 0; part < state.parts.size(); ++part) {
        const auto field = read_field(state.file, state.parts, {result, values, part});
        if (!field) continue;
        const auto first = static_cast<std::ptrdiff_t>(state.geometry.parts[part].first_vertex);
        const auto width = static_cast<std::ptrdiff_t>(out.components);
        std::ranges::copy(field->values, out.values.begin() + first * width);
        std::ranges::copy(field->validity, out.validity.begin() + first);
    }
    return state.values.emplace(key, std::move(out)).first->second;
}

const std::vector<std::array<std::uint32_t, 3>>& LoadedScene::level(std::size_t level) {
    State& state = *state_;
    if (const auto kept = state.levels.find(level); kept != state.levels.end()) return kept->second;
    return state.levels.emplace(level, join_level(state.file, state.geometry, level)).first->second;
}

std::optional<FieldChoice> LoadedScene::find(const PresentedResult& wanted, std::size_t step) const {
    std::vector<const SceneResult*> results;
    std::vector<FieldChoice> choices;
    for (std::size_t r = 0; r < state_->about.results.size(); ++r) {
        const SceneResult& result = state_->about.results[r];
        for (std::size_t v = 0; v < result.values.size(); ++v) {
            if (result.values[v].step != step) continue;
            results.push_back(&result);
            choices.push_back({r, v, 0});
        }
    }
    const auto target = find_presented(results, wanted);
    if (!target) return std::nullopt;
    FieldChoice choice = choices[target->result];
    choice.component = target->component;
    return choice;
}

}  // namespace feelem::viewer
