// SPDX-License-Identifier: Apache-2.0
// load_scene: parts and fields back from the arrays.
#include "scene/scene_read.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
namespace {

[[noreturn]] void bad(const SceneFile& file, const std::string& text) {
    throw Error(Code::BadScene, file.path(), text);
}

void read_part(const SceneFile& file, std::size_t index, ScenePart& part) {
    const gltf::Primitive& primitive = file.document().parts[index];
    const std::vector<float> positions = file.floats(attribute_of(file, primitive, "POSITION"), 3);
    for (std::size_t i = 0; i < positions.size(); i += 3)
        part.positions.push_back({positions[i], positions[i + 1], positions[i + 2]});
    if (primitive.mode != gltf::kTriangles || primitive.indices < 0)
        bad(file, fmt::format("part {} is not a list of triangles", index));
    const std::vector<std::uint32_t> corners = file.integers(primitive.indices);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        part.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    const bool fits =
        std::ranges::all_of(corners, [&](std::uint32_t c) { return c < part.positions.size(); });
    if (!fits || corners.size() % 3 != 0)
        bad(file, fmt::format("part {} has a triangle without vertices", index));
    part.node_ids = read_node_ids(file, primitive, part.positions.size());
    for (const std::uint32_t id : file.integers(file.find(file.document().elements[index])))
        part.element_ids.push_back(id);
    if (part.element_ids.size() != part.triangles.size())
        bad(file,
            fmt::format(
                "part {} has {} triangles, but {} element ids",
                index,
                part.triangles.size(),
                part.element_ids.size()
            ));
}

/// Components of the accessors of one field, in the order of SceneResult::components.
void read_components(
    const SceneFile& file, const std::vector<std::string>& names, std::size_t width, SceneField& out
) {
    std::size_t first = 0;
    for (const std::string& name : names) {
        const int accessor = file.find(name);
        const unsigned count =
            file.document().accessors[static_cast<std::size_t>(accessor)].accessor.components;
        const std::vector<float> values = file.floats(accessor, count);
        const std::size_t rows = out.values.size() / width;
        if (values.size() != rows * count || first + count > width)
            bad(file, fmt::format("accessor '{}' does not fit its result", name));
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t c = 0; c < count; ++c)
                out.values[row * width + first + c] = values[row * count + c];
        }
        first += count;
    }
    if (first != width) bad(file, "a result lacks components");
}

}  // namespace

std::vector<std::int64_t> read_node_ids(
    const SceneFile& file, const gltf::Primitive& primitive, std::size_t count
) {
    const std::vector<float> low = file.floats(attribute_of(file, primitive, "_NODE_ID"), 1);
    std::vector<float> high(low.size(), 0.0F);
    const auto is_high = [](const auto& attribute) { return attribute.first == "_NODE_ID_HIGH"; };
    const auto found = std::ranges::find_if(primitive.attributes, is_high);
    if (found != primitive.attributes.end()) high = file.floats(found->second, 1);
    if (low.size() != count || high.size() != count) bad(file, "node ids do not match the vertices");
    std::vector<std::int64_t> ids;
    ids.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        constexpr float kModulus = 16777216.0F;
        const auto is_id = [](float part) {
            return part >= 0 && part < kModulus && part == std::floor(part);
        };
        if (!is_id(low[i]) || !is_id(high[i])) bad(file, fmt::format("vertex {} has no whole node id", i));
        ids.push_back(static_cast<std::int64_t>(low[i]) + static_cast<std::int64_t>(high[i]) * (1 << 24));
    }
    return ids;
}

Presentation read_presentation(const SceneFile& file) {
    try {
        return parse_presentation(file.document().presentation_json, "presentation");
    } catch (const Error& error) {
        throw Error(
            Code::BadScene, file.path(), std::string("its presentation cannot be read: ") + error.what()
        );
    }
}

int attribute_of(const SceneFile& file, const gltf::Primitive& primitive, std::string_view semantic) {
    for (const auto& [name, accessor] : primitive.attributes) {
        if (name == semantic) return accessor;
    }
    bad(file, fmt::format("a part has no attribute {}", semantic));
}

std::vector<ScenePart> read_parts(const SceneFile& file) {
    std::vector<ScenePart> parts = file.document().scene.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) read_part(file, i, parts[i]);
    return parts;
}

std::optional<SceneField> read_field(
    const SceneFile& file, std::span<const ScenePart> parts, const FieldAddress& address
) {
    const SceneDocument& document = file.document();
    const SceneResult& result = document.scene.results[address.result];
    const FieldPlace& place = document.fields[address.result][address.values];
    if (place.accessors[address.part].empty()) return std::nullopt;
    const std::size_t width = result.components.size();
    const std::vector<std::int64_t>& ids = parts[address.part].node_ids;
    if (width > document.accessors.size())
        bad(file, "a result has more components than the scene has arrays");
    SceneField field{address.result, result.values[address.values].step, address.part, {}, {}};
    field.values.resize(ids.size() * width);
    read_components(file, place.accessors[address.part], width, field);
    field.validity.resize(ids.size());
    for (std::size_t row = 0; row < ids.size(); ++row)
        field.validity[row] = ids[row] == 0 ? Validity::Interpolated : Validity::Solver;
    const std::string& mask = place.masks[address.part];
    if (mask.empty()) return field;
    const std::vector<float> valid = file.floats(file.find(mask), 1);
    if (valid.size() != ids.size()) bad(file, fmt::format("accessor '{}' does not fit its part", mask));
    for (std::size_t row = 0; row < ids.size(); ++row) {
        if (valid[row] != 0 && valid[row] != 1 && valid[row] != 2)
            bad(file, fmt::format("accessor '{}' has {} in row {}", mask, valid[row], row));
        field.validity[row] = static_cast<Validity>(valid[row]);
        if (field.validity[row] != Validity::Missing) continue;
        for (std::size_t c = 0; c < width; ++c)
            field.values[row * width + c] = std::numeric_limits<float>::quiet_NaN();
    }
    return field;
}

Scene load_scene(const std::string& path) {
    const SceneFile file(path);
    Scene scene = file.document().scene;
    scene.presentation = read_presentation(file);
    scene.parts = read_parts(file);
    for (std::size_t r = 0; r < scene.results.size(); ++r) {
        for (std::size_t v = 0; v < scene.results[r].values.size(); ++v) {
            for (std::size_t p = 0; p < scene.parts.size(); ++p) {
                std::optional<SceneField> field = read_field(file, scene.parts, {r, v, p});
                if (field) scene.fields.push_back(std::move(*field));
            }
        }
    }
    return scene;
}

}  // namespace feelem
