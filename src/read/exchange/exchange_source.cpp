// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/exchange_source.hpp"

#include "model/mesh_builder.hpp"
#include "model/node_lookup.hpp"
#include "read/element_lookup.hpp"
#include "read/exchange/asked_values.hpp"
#include "read/exchange/helper_process.hpp"
#include "read/exchange/input_files.hpp"
#include "read/exchange/neutral_form.hpp"
#include "read/listed_source.hpp"
#include "read/result_names.hpp"
#include "read/side_markers.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace feelem::exchange {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

class ExchangeSource : public ListedSource {
public:
    ExchangeSource(
        std::string format,
        const Input& main,
        const std::vector<std::string>& others,
        const ReadContext& context,
        Diagnostics& diagnostics
    )
        : ListedSource(main, diagnostics), format_(std::move(format)), files_(main, others, context.includes),
          values_([this](const std::vector<std::string>& requests) { return ask(requests); }, main.name()) {
        NeutralModel model = read_model(ask({"list"}), input().name());
        set_mesh(make_mesh(model, diagnostics), context, "the file defines no nodes");
        mesh_digest_ = mesh_digest(model);
        node_ids_ = std::move(model.node_ids);
        element_ids_ = std::move(model.element_ids);
        list(std::move(model));
    }

private:
    std::string ask(const std::vector<std::string>& what) const {
        std::vector<std::string> words{format_, files_.path()};
        words.insert(words.end(), what.begin(), what.end());
        return ask_helper(words, input().name(), files_.bytes());
    }

    /// Meshers' own formats name boundaries by elements on the sides of others.
    bool has_side_markers() const { return format_ == "med"; }

    Mesh make_mesh(const NeutralModel& model, Diagnostics& diagnostics) const {
        MeshBuilder builder(diagnostics);
        builder.reserve_nodes(model.node_ids.size());
        for (std::size_t i = 0; i < model.node_ids.size(); ++i) {
            const double* const at = &model.coordinates[3 * i];
            builder.add_node(NodeId{model.node_ids[i]}, {at[0], at[1], at[2]});
        }
        builder.seal_nodes();
        SideMarkers sides;
        if (has_side_markers()) {
            each_element(model, [&](std::size_t e, std::span<const NodeId> nodes) {
                sides.add_candidate(model.types[e], nodes);
            });
            each_element(model, [&](std::size_t e, std::span<const NodeId> nodes) {
                sides.add_owner(model.types[e], nodes);
            });
        }
        std::map<std::string, std::vector<NodeId>> side_nodes;
        each_element(model, [&](std::size_t e, std::span<const NodeId> nodes) {
            const ElementType type = model.types[e];
            if (sides.is_side(type, nodes)) {
                builder.skip_element(fmt::format("{} on the side of another element", element_row(type).name)
                );
                auto& set = side_nodes[model.parts[model.element_parts[e]]];
                set.insert(set.end(), nodes.begin(), nodes.end());
                return;
            }
            const PartIndex part = builder.part(model.parts[model.element_parts[e]]);
            builder.add_element(ElementId{model.element_ids[e]}, type, nodes, part, [&] {
                return input().name();
            });
        });
        for (auto& [name, nodes] : side_nodes) {
            std::ranges::sort(nodes);
            nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
            builder.add_node_set(name, nodes);
        }
        for (const auto& [name, count] : model.skipped) {
            diagnostics.add(
                Code::UnknownElementType,
                input().name(),
                fmt::format(
                    "elements of type {} are left out: Feelem does not know their shape. ParaView's filters "
                    "Tetrahedralize and Triangulate make shapes that it knows",
                    name
                ),
                count
            );
        }
        for (const auto& [name, nodes] : model.node_sets) {
            std::vector<NodeId> ids;
            for (const std::uint32_t node : nodes) {
                if (node < model.node_ids.size()) ids.push_back(NodeId{model.node_ids[node]});
            }
            builder.add_node_set(name, ids);
        }
        constexpr std::pair<const char*, double> kUnits[]{
            {"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}};
        for (const auto& [name, metres] : kUnits) {
            if (model.length_unit == name) builder.set_length_unit({name, metres});
        }
        Mesh mesh = builder.finish();
        if (!model.element_sets.empty()) add_element_sets(mesh, model);
        return mesh;
    }

    static void add_element_sets(Mesh& mesh, const NeutralModel& model) {
        const ElementLookup lookup(mesh);
        for (const auto& [name, elements] : model.element_sets) {
            std::vector<ElementId> ids;
            for (const std::uint32_t element : elements) {
                if (element < model.element_ids.size()) ids.push_back(ElementId{model.element_ids[element]});
            }
            add_element_set(mesh, lookup, name, ids);
        }
    }

    template <class Use>
    static void each_element(const NeutralModel& model, const Use& use) {
        std::vector<NodeId> nodes;
        std::size_t at = 0;
        for (std::size_t e = 0; e < model.types.size(); ++e) {
            nodes.clear();
            for (std::size_t i = element_row(model.types[e]).node_count; i > 0; --i)
                nodes.push_back(NodeId{model.node_ids[model.element_nodes[at++]]});
            use(e, nodes);
        }
    }

    void list(NeutralModel model) {
        std::vector<ResultInfo> infos;
        ResultNames names;
        for (const NeutralResult& result : model.results) {
            ResultInfo info;
            info.solver_name = result.name;
            info.step = result.step;
            info.location = result.location;
            places_.push_back(name_result(info, result));
            names.make_unique(info);
            infos.push_back(std::move(info));
        }
        set_contents(std::move(model.steps), std::move(infos));
        values_.list(std::move(model.results), node_ids_.size(), element_ids_.size());
    }

    /// code_aster puts the name of its result, filled up to eight characters with _, before that of the
    /// field: RESU____DEPL.
    static std::string name_of(const std::string& label, std::size_t components) {
        constexpr std::size_t kAsterResult = 8;
        std::string name = common_name(label, components);
        if (name != lower_name(label) || label.size() <= kAsterResult || label[kAsterResult - 1] != '_')
            return name;
        std::string field = common_name(label.substr(kAsterResult), components);
        return field != lower_name(label.substr(kAsterResult)) ? field : name;
    }

    static std::vector<std::uint32_t> name_result(ResultInfo& info, const NeutralResult& result) {
        info.name = name_of(result.name, result.components);
        const std::vector<std::string>& names = result.component_names;
        const bool tensor = names.size() == 6 && names[0].ends_with("XX") && names[4].ends_with("XZ");
        auto places = name_components(info, result.components, tensor ? TensorOrder::Med : TensorOrder::Vtk);
        if (tensor || names.size() != result.components || names.size() == 1) return places;
        const bool vector = names.size() >= 3 && names[0].ends_with('X') && names[1].ends_with('Y') &&
                            names[2].ends_with('Z') && names[0].size() == 2;
        if (vector) info.name = name_of(result.name, 3);
        info.shape = vector ? Shape::Vector : Shape::Other;
        info.components.clear();
        std::iota(places.begin(), places.end(), 0U);
        for (std::size_t c = 0; c < names.size(); ++c) {
            constexpr const char* kAxes[]{"x", "y", "z"};
            std::string name = vector && c < 3 ? kAxes[c] : lower_name(names[c]);
            if (std::ranges::find(info.components, name) != info.components.end())
                name += fmt::format("_{}", c + 1);
            info.components.push_back(std::move(name));
        }
        return places;
    }

    /// Where the helper's rows stand in the mesh.
    std::vector<std::uint32_t> rows_of_mesh(bool nodal) const {
        std::vector<std::uint32_t> rows;
        if (nodal) {
            const NodeLookup node_of(mesh().node_ids);
            for (const std::int64_t id : node_ids_) rows.push_back(raw(node_of(NodeId{id})));
        } else {
            const ElementLookup element_of(mesh());
            for (const std::int64_t id : element_ids_) rows.push_back(raw(element_of(ElementId{id})));
        }
        return rows;
    }

    LoadedResult read(std::size_t index) override {
        LoadedResult loaded;
        const ResultInfo& info = results()[index];
        loaded.result.info = info;
        const bool nodal = info.location == Location::Nodal;
        const std::size_t width = info.components.size();
        const std::size_t rows = nodal ? node_ids_.size() : element_ids_.size();
        const NeutralValues values = values_.get(index);
        if (values.mesh_digest != mesh_digest_ || values.bytes.size() != rows * width * sizeof(float)) {
            throw Error(
                Code::MeshesDiffer,
                input().name(),
                fmt::format(
                    "{} at step {} is of other nodes or elements than those of the first step. Convert such "
                    "steps one by one",
                    info.solver_name,
                    steps()[info.step].step
                )
            );
        }
        loaded.result.values.assign((nodal ? mesh().node_count() : mesh().element_count()) * width, kMissing);
        const std::vector<std::uint32_t> places = rows_of_mesh(nodal);
        std::vector<float> row(width);
        for (std::size_t i = 0; i < rows; ++i) {
            std::memcpy(row.data(), values.bytes.data() + i * width * sizeof(float), width * sizeof(float));
            const std::size_t to = places[i];
            if (to >= (nodal ? mesh().node_count() : mesh().element_count())) continue;
            for (std::size_t c = 0; c < width; ++c) {
                const float value = row[places_[index][c]];
                if (std::isinf(value)) ++loaded.without_number;
                loaded.result.values[to * width + c] = std::isfinite(value) ? value : kMissing;
            }
        }
        return loaded;
    }

    std::string format_;
    InputFiles files_;
    std::uint64_t mesh_digest_ = 0;
    std::vector<std::int64_t> node_ids_, element_ids_;  ///< In the order of the helper's values.
    AskedValues values_;
    std::vector<std::vector<std::uint32_t>> places_;
};

}  // namespace

std::unique_ptr<ModelSource> open_exchange(
    const std::string& format,
    const Input& input,
    const std::vector<std::string>& others,
    const ReadContext& context,
    Diagnostics& diagnostics
) {
    return std::make_unique<ExchangeSource>(format, input, others, context, diagnostics);
}

}  // namespace feelem::exchange
