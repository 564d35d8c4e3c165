// SPDX-License-Identifier: Apache-2.0
#include "med/med_model.hpp"

#include "med/hdf5_file.hpp"
#include "med/med_elements.hpp"
#include "med/med_mesh.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace feelem::exchange {
namespace {

constexpr std::size_t kComponentName = 16;
constexpr std::int64_t kMostComponents = 100;

using StepKey = std::tuple<std::int64_t, std::int64_t, double>;

/// A field at a calculation step, and the step's key.
struct FieldStep {
    std::string group;  ///< "/CHA/DEPL/0000...1"
    StepKey key;
};

std::vector<FieldStep> steps_of(const Hdf5File& file, const std::string& field) {
    std::vector<FieldStep> steps;
    for (const std::string& name : file.names_in("/CHA/" + field)) {
        const std::string group = "/CHA/" + field + "/" + name;
        const auto time = file.real(group, "PDT").value_or(0);
        steps.push_back(
            {group, {file.integer(group, "NDT").value_or(-1), file.integer(group, "NOR").value_or(-1), time}}
        );
    }
    return steps;
}

/// Names of 16 characters each, one after the other.
std::vector<std::string> component_names(const Hdf5File& file, const std::string& field, std::size_t count) {
    const std::string all = file.text("/CHA/" + field, "NOM");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        std::string name =
            i * kComponentName < all.size() ? all.substr(i * kComponentName, kComponentName) : "";
        while (!name.empty() && name.back() == ' ') name.pop_back();
        if (name.empty()) return {};
        names.push_back(std::move(name));
    }
    return names;
}

/// Whether a group of a field's step holds values of that place: "NOE", "MAI.HE8".
bool has_elements(const std::vector<std::string>& places) {
    return std::ranges::any_of(places, [](const std::string& place) { return place.starts_with("MAI."); });
}

bool has_nodes(const std::vector<std::string>& places) {
    return std::ranges::find(places, "NOE") != places.end();
}

/// Values of one place into rows [first, first + count) of `out`; a profile says which of them.
void fill(
    const Hdf5File& file,
    const std::string& place,
    std::size_t first,
    std::size_t count,
    std::size_t width,
    std::vector<float>& out
) {
    for (const std::string& profile : file.names_in(place)) {
        const std::string path = place + "/" + profile;
        if (!file.exists(path + "/CO")) continue;
        // Several values an element (Gauss points) are no value of the element.
        if (file.integer(path, "NGA").value_or(1) > 1) continue;
        const std::vector<double> values = file.reals(path + "/CO");
        std::vector<std::int64_t> rows;
        const std::string named = "/PROFILS/" + profile + "/PFL";
        if (file.exists(named)) rows = file.integers(named);
        const std::size_t given = values.size() / width;
        if (rows.empty() ? given != count : rows.size() != given) continue;
        // All first components, then all second ones.
        for (std::size_t i = 0; i < given; ++i) {
            const std::int64_t row = rows.empty() ? static_cast<std::int64_t>(i) : rows[i] - 1;
            if (row < 0 || row >= static_cast<std::int64_t>(count)) continue;
            for (std::size_t c = 0; c < width; ++c)
                out[(first + static_cast<std::size_t>(row)) * width + c] =
                    static_cast<float>(values[c * given + i]);
        }
    }
}

std::set<StepKey> all_steps(const Hdf5File& file) {
    std::set<StepKey> keys;
    for (const std::string& field : file.names_in("/CHA")) {
        for (const FieldStep& step : steps_of(file, field)) keys.insert(step.key);
    }
    return keys;
}

std::vector<float> values_of(
    const Hdf5File& file, const MedMesh& mesh, const std::set<StepKey>& keys, const NeutralResult& result
) {
    if (result.step >= keys.size() || result.components < 1 || result.components > kMostComponents)
        throw std::runtime_error("there is no such step");
    const StepKey key = *std::next(keys.begin(), result.step);
    const bool nodal = result.location == Location::Nodal;
    const std::size_t width = result.components;
    std::vector<float> values(
        (nodal ? mesh.nodes : mesh.elements) * width, std::numeric_limits<float>::quiet_NaN()
    );
    for (const FieldStep& step : steps_of(file, result.name)) {
        if (step.key != key) continue;
        if (nodal) fill(file, step.group + "/NOE", 0, mesh.nodes, width, values);
        for (const MedType& type : med_types()) {
            const auto block = mesh.blocks.find(type.name);
            const std::string place = step.group + "/MAI." + std::string(type.name);
            if (!nodal && block != mesh.blocks.end() && file.exists(place))
                fill(file, place, block->second.first, block->second.count, width, values);
        }
    }
    return values;
}

}  // namespace

std::string list_med(const std::string& path) {
    const Hdf5File file(path);
    NeutralModel model;
    const MedMesh mesh = read_med_mesh(file, model);
    const std::set<StepKey> keys = all_steps(file);
    const std::vector<std::string> fields = file.names_in("/CHA");
    std::map<StepKey, std::uint32_t> index;
    std::map<std::int64_t, std::int32_t> substeps;
    for (const auto& key : keys) {
        index[key] = static_cast<std::uint32_t>(model.steps.size());
        const auto number =
            static_cast<std::int32_t>(std::clamp<std::int64_t>(std::get<0>(key), 1, INT32_MAX));
        Step step;
        step.step = number;
        step.substep = ++substeps[number];
        step.kind = keys.size() > 1 ? StepKind::Time : StepKind::Other;
        step.value = std::get<2>(key);
        model.steps.push_back(std::move(step));
    }
    for (const std::string& field : fields) {
        const auto components = file.integer("/CHA/" + field, "NCO").value_or(0);
        if (components < 1 || components > kMostComponents) continue;
        const auto width = static_cast<std::size_t>(components);
        for (const FieldStep& step : steps_of(file, field)) {
            const auto places = file.names_in(step.group);
            for (const Location location : {Location::Nodal, Location::Elemental}) {
                if (location == Location::Nodal ? !has_nodes(places) : !has_elements(places)) continue;
                model.results.push_back(
                    {field,
                     static_cast<std::uint32_t>(width),
                     location,
                     index[step.key],
                     component_names(file, field, width)}
                );
            }
        }
    }
    return write_model(model);
}

std::string load_med(const std::string& path, const std::vector<NeutralResult>& results) {
    const Hdf5File file(path);
    NeutralModel model;
    const MedMesh mesh = read_med_mesh(file, model);
    const std::set<StepKey> keys = all_steps(file);
    NeutralWriter to(Answer::Values);
    for (const NeutralResult& result : results)
        write_values(to, mesh_digest(model), values_of(file, mesh, keys, result));
    return to.take();
}

}  // namespace feelem::exchange
