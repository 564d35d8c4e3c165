// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_fields.hpp"

#include "scene/scene_colour.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <utility>

namespace feelem {
namespace {

std::string upper(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool letter = c >= 'a' && c <= 'z';
        const bool keep = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        out += letter ? static_cast<char>(c - 'a' + 'A') : keep ? c : '_';
    }
    return out;
}

bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> ends) {
    return std::ranges::any_of(ends, [&](std::string_view end) { return text.ends_with(end); });
}

std::string wanted_name(const SceneResult& result) {
    std::string name = "_" + upper(result.id);
    if (result.complex == Complex::Real && !name.ends_with("_RE")) name += "_RE";
    if (result.complex == Complex::Imaginary && !name.ends_with("_IM")) name += "_IM";
    const bool reserved = name == "_BATCHID" || name.starts_with("_FEATURE_ID") ||
                          name.starts_with("_NODE_ID") || ends_with_any(name, {"_VALID"});
    return reserved ? name + "_RESULT" : name;
}

/// The rows of one part, cleaned: what is missing and what stands in its place.
struct PartRows {
    const SurfaceField& field;
    const Surface& surface;
    std::size_t first = 0, count = 0;
    std::vector<float> stand_in;  ///< Per component: the smallest valid value.
    bool any = false, all_solver = true;

    float at(std::size_t row, std::size_t component) const {
        return field.values[(first + row) * field.component_count + component];
    }
    bool is_centre(std::size_t row) const { return surface.vertex_node[first + row] == kNoNode; }
    Validity validity(std::size_t row) const {
        for (std::size_t c = 0; c < field.component_count; ++c) {
            if (!std::isfinite(at(row, c))) return Validity::Missing;
        }
        return field.validity[first + row];
    }
};

PartRows look_at(const SceneBuild& build, const SurfaceField& field, const ScenePartBuild& part) {
    PartRows rows{field, *build.contents.surface, part.range->first_vertex, part.range->vertex_count, {}};
    constexpr float kNone = std::numeric_limits<float>::infinity();
    rows.stand_in.assign(field.component_count, kNone);
    for (std::size_t row = 0; row < rows.count; ++row) {
        const Validity validity = rows.validity(row);
        const Validity usual = rows.is_centre(row) ? Validity::Interpolated : Validity::Solver;
        rows.all_solver = rows.all_solver && validity == usual;
        if (validity == Validity::Missing) continue;
        rows.any = true;
        for (std::size_t c = 0; c < field.component_count; ++c)
            rows.stand_in[c] = std::min(rows.stand_in[c], rows.at(row, c));
    }
    for (float& value : rows.stand_in) value = value == kNone ? 0 : value;
    return rows;
}

/// Id that an extreme of the skin is reported with: the element's for elemental results, else the node's.
std::int64_t id_of(const SceneBuild& build, const SceneResult& result, std::size_t vertex) {
    const Surface& surface = *build.contents.surface;
    if (result.location == Location::Elemental && !surface.vertex_element.empty())
        return raw(element_at(*build.contents.mesh, surface.vertex_element[vertex]).id());
    return raw(build.contents.mesh->node_ids[raw(surface.vertex_node[vertex])]);
}

void take_extremes(
    const SceneBuild& build, const SceneResult& result, const PartRows& rows, WrittenField& out
) {
    const auto better = [](const std::optional<Extreme>& best, float value, std::int64_t id, bool larger) {
        if (!best) return true;
        if (value == best->value) return id < best->id;
        return larger ? value > best->value : value < best->value;
    };
    for (std::size_t row = 0; row < rows.count; ++row) {
        const Validity validity = rows.validity(row);
        if (!rows.is_centre(row)) {
            out.missing += validity == Validity::Missing ? 1 : 0;
            out.interpolated += validity == Validity::Interpolated ? 1 : 0;
        }
        if (validity != Validity::Solver || rows.field.component_count != 1 || rows.is_centre(row)) continue;
        const float value = rows.at(row, 0);
        const std::int64_t id = id_of(build, result, rows.first + row);
        if (better(out.min, value, id, false)) out.min = Extreme{value, id};
        if (better(out.max, value, id, true)) out.max = Extreme{value, id};
    }
}

/// One result at one step on its way into the scene.
struct FieldTask {
    std::size_t result = 0, values = 0;
    bool shown = false;  ///< Its accessors are attributes of the parts.
    std::optional<gltf::Steps> steps{};
    /// Numbers of steps are no values: as attributes they would mislead those who know nothing of them.
    bool as_attribute() const { return shown && !steps; }
};

void write_part_values(
    SceneBuild& build, const FieldTask& task, ScenePartBuild& part, const PartRows& rows, WrittenField& out
) {
    const SceneResult& result = build.contents.results[task.result];
    const std::size_t step = step_id(result.values[task.values]);
    const std::string& attribute = build.attribute_names[task.result];
    const int target = task.as_attribute() ? gltf::kAttributeTarget : 0;
    const auto name_of = [&](const std::string& name) {
        return fmt::format("{}{}/{}", part.prefix, name, step);
    };
    std::vector<std::string> names;
    for (const AttributeSlot& slot : attribute_slots(result, attribute)) {
        ArraySpec spec{name_of(slot.name), slot.count, rows.count, target};
        spec.steps = task.steps;
        const int accessor = build.arrays.floats(spec, [&](std::size_t row, float* values) {
            const bool missing = rows.validity(row) == Validity::Missing;
            for (unsigned c = 0; c < slot.count; ++c)
                values[c] = missing ? rows.stand_in[slot.first + c] : rows.at(row, slot.first + c);
        });
        names.push_back(spec.name);
        if (task.as_attribute()) part.mesh.primitive.attributes.emplace_back(slot.name, accessor);
    }
    out.accessors.back() = std::move(names);
    if (rows.all_solver) return;
    const ArraySpec mask{name_of(attribute + "_VALID"), 1, rows.count, target};
    const int accessor = build.arrays.floats(mask, [&](std::size_t row, float* value) {
        *value = static_cast<float>(rows.validity(row));
    });
    out.masks.back() = mask.name;
    if (task.as_attribute()) part.mesh.primitive.attributes.emplace_back(attribute + "_VALID", accessor);
}

void write_shape(SceneBuild& build, const SurfaceField& field, std::size_t shape, std::size_t step) {
    const double factor = build.deformation->factor;
    for (ScenePartBuild& part : build.parts) {
        const std::string suffix = shape == 0 ? "" : "/im";
        const std::size_t first = part.range->first_vertex;
        ArraySpec spec{
            fmt::format("{}deformation/{}{}", part.prefix, step, suffix),
            3,
            part.range->vertex_count,
            gltf::kAttributeTarget};
        spec.grid = build.grid;
        part.mesh.primitive.targets.push_back(build.arrays.floats(spec, [&](std::size_t row, float* out) {
            const float* value = field.values.data() + (first + row) * 3;
            const bool known = std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]);
            for (int axis = 0; axis < 3; ++axis)
                out[axis] = known ? static_cast<float>(factor * static_cast<double>(value[axis])) : 0.0F;
        }));
    }
}

void write_field(SceneBuild& build, FieldTask task) {
    const SceneResult& result = build.contents.results[task.result];
    SurfaceField field = build.contents.load(task.result, task.values);
    const std::size_t vertices = build.contents.surface->positions.size();
    if (field.component_count != result.components.size() || field.validity.size() != vertices ||
        field.values.size() != vertices * field.component_count) {
        throw Error(Code::BadStructure, "", "the field of " + result.id + " does not fit the skin");
    }
    WrittenField& out = build.written[task.result][task.values];
    const std::optional<gltf::Steps>& steps = build.steps[task.result];
    if (steps && gltf::round_to_steps(*steps, field.values)) task.steps = steps;
    out.exact = !task.steps;
    for (ScenePartBuild& part : build.parts) {
        const PartRows rows = look_at(build, field, part);
        out.accessors.emplace_back();
        out.masks.emplace_back();
        take_extremes(build, result, rows, out);
        if (rows.any) write_part_values(build, task, part, rows, out);
    }
    for (std::size_t set = 0; set < build.coloured.size(); ++set) {
        const ColouredResult& coloured = build.coloured[set];
        if (coloured.result == task.result && coloured.values == task.values)
            write_texcoords(build, field, set);
    }
    if (!build.deformation) return;
    for (std::size_t shape = 0; shape < build.deformation->shapes.size(); ++shape) {
        const ShapeResult& wanted = build.deformation->shapes[shape];
        if (wanted.result == task.result && wanted.values == task.values)
            write_shape(build, field, shape, step_id(result.values[task.values]));
    }
}

bool is_attribute(const SceneBuild& build, std::size_t result, std::size_t values) {
    const auto is_it = [&](const auto& user) { return user.result == result && user.values == values; };
    return std::ranges::any_of(build.coloured, is_it) ||
           (build.deformation && std::ranges::any_of(build.deformation->shapes, is_it));
}

/// Bytes of everything that is not shown first, masks counted as if all had one.
std::uint64_t bytes_aside(const SceneBuild& build) {
    std::uint64_t rows = 0;
    for (const ScenePartBuild& part : build.parts) rows += part.range->vertex_count;
    std::uint64_t bytes = 0;
    for (const SceneResult& result : build.contents.results) {
        for (const SceneValues& values : result.values) {
            if (values.step != build.contents.shown_step) bytes += 4 * rows * (result.components.size() + 1);
        }
    }
    return bytes;
}

void write_side_file(SceneBuild& build, SceneFiles& files, const FieldTask& task) {
    namespace fs = std::filesystem;
    const SceneResult& result = build.contents.results[task.result];
    const std::string name = fmt::format("{}.{}.bin", result.id, step_id(result.values[task.values]));
    fs::create_directories(files.new_folder);
    ScratchFile file((fs::path(files.new_folder) / name).string(), ScratchFile::Kind::Named);
    const int buffer = static_cast<int>(build.document.buffers.size());
    build.document.buffers.push_back({files.folder_name + "/" + name, 0});
    build.arrays.direct_to(buffer, file);
    write_field(build, task);
    file.finish();
    build.document.buffers[static_cast<std::size_t>(buffer)].bytes = file.size();
    build.arrays.direct_to(0, *files.main);
    if (file.size() > 0) return;
    // Nothing valid on the skin: glTF has no empty buffers.
    build.document.buffers.pop_back();
    fs::remove(fs::path(files.new_folder) / name);
}

}  // namespace

std::vector<std::string> name_attributes(const std::vector<SceneResult>& results) {
    std::set<std::string> taken;
    std::vector<std::string> names;
    for (const SceneResult& result : results) {
        const std::string wanted = wanted_name(result);
        const auto is_free = [&](const std::string& name) {
            const auto slots = attribute_slots(result, name);
            return !taken.contains(name) && !taken.contains(name + "_VALID") &&
                   std::ranges::none_of(slots, [&](const AttributeSlot& s) {
                       return taken.contains(s.name);
                   });
        };
        std::string name = wanted;
        for (int number = 2; !is_free(name); ++number) name = fmt::format("{}_{}", wanted, number);
        taken.insert(name);
        taken.insert(name + "_VALID");
        for (const AttributeSlot& slot : attribute_slots(result, name)) taken.insert(slot.name);
        names.push_back(name);
    }
    return names;
}

std::vector<AttributeSlot> attribute_slots(const SceneResult& result, const std::string& attribute) {
    const auto count = static_cast<unsigned>(result.components.size());
    if (count == 1 || count == 3) return {{attribute, 0, count}};
    if (count == 6) return {{attribute + "_NORMAL", 0, 3}, {attribute + "_SHEAR", 3, 3}};
    std::vector<AttributeSlot> slots;
    for (unsigned c = 0; c < count; ++c)
        slots.push_back({fmt::format("{}_{}", attribute, upper(result.components[c])), c, 1});
    return slots;
}

void write_fields(SceneBuild& build, SceneFiles& files) {
    const double bound = build.options.compress ? build.options.bound : 0;
    for (const SceneResult& result : build.contents.results)
        build.steps.push_back(result.range ? gltf::steps_within(*result.range, bound) : std::nullopt);
    const bool embed = files.is_glb && bytes_aside(build) < build.options.embed_limit;
    const std::vector<SceneResult>& results = build.contents.results;
    build.written.resize(results.size());
    for (std::size_t r = 0; r < results.size(); ++r) {
        build.written[r].resize(results[r].values.size());
        for (std::size_t v = 0; v < results[r].values.size(); ++v) {
            const FieldTask task{r, v, is_attribute(build, r, v), {}};
            const bool inside = embed || task.shown || results[r].values[v].step == build.contents.shown_step;
            if (inside)
                write_field(build, task);
            else
                write_side_file(build, files, task);
        }
    }
}

}  // namespace feelem
