// SPDX-License-Identifier: Apache-2.0
// Must: give each corner of each element its own value of each layer, in the global system.
// Assumes: nothing about lengths; an element whose records have another length than is known is left out.
// Algorithm: an element's table points to its records. Rows of a record are its corner nodes, once a surface:
// of layered elements each layer has a bottom and a top (and a middle). They stand along the axes of the
// layer; the Euler angles of the element, and after them one angle a layer about its normal, turn them. Data:
// the records of one element at a time, and the result.
#include "read/ansys/rst_element.hpp"

#include "model/rotation.hpp"
#include "read/ansys/rst_layers.hpp"
#include "read/ansys/rst_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace feelem::rst {

/// What the flux and the gradient of an element belong to.
enum class Field : std::uint8_t {
    Any,
    Thermal,
    Electric
};

struct ElementQuantity {
    Item item;
    std::size_t entry;   ///< In an element's table, from 1.
    std::size_t stored;  ///< Values a node.
    std::string_view name;
    std::string_view label;
    Shape shape;
    Field field = Field::Any;
};

namespace {

constexpr std::array kQuantities{
    ElementQuantity{Item::Stress, 3, 6, "stress", "S", Shape::SymmetricTensor},
    ElementQuantity{Item::ElasticStrain, 6, 7, "elastic_strain", "EPEL", Shape::SymmetricTensor},
    ElementQuantity{Item::PlasticStrain, 7, 7, "plastic_strain", "EPPL", Shape::SymmetricTensor},
    ElementQuantity{Item::CreepStrain, 8, 7, "creep_strain", "EPCR", Shape::SymmetricTensor},
    ElementQuantity{Item::ThermalStrain, 9, 8, "thermal_strain", "EPTH", Shape::SymmetricTensor},
    ElementQuantity{Item::Flux, 11, 3, "heat_flux", "TF", Shape::Vector, Field::Thermal},
    ElementQuantity{Item::Gradient, 5, 3, "temperature_gradient", "TG", Shape::Vector, Field::Thermal},
    ElementQuantity{Item::Flux, 11, 3, "electric_flux_density", "D", Shape::Vector, Field::Electric},
    ElementQuantity{Item::Gradient, 5, 3, "electric_field", "EF", Shape::Vector, Field::Electric},
};
/// S1 S2 S3 SINT SEQV, which old files store behind the stresses of a corner.
constexpr std::array kInvariants{"principal_1", "principal_2", "principal_3", "tresca", "von_mises"};

bool has_layers(const ElementKindOfFile& kind) {
    return kind.name && kind.name->kind == ansys::ElementKind::Shell;
}

bool has_values(const ElementKindOfFile& kind) {
    using enum ansys::ElementKind;
    if (!kind.name || kind.result_nodes == 0) return false;
    return kind.name->kind == Solid || kind.name->kind == Plane || kind.name->kind == Shell;
}

bool has_dof(const ResultSet& set, std::int32_t code) {
    return std::ranges::find(set.dofs, code) != set.dofs.end();
}

/// Elements of coupled fields hold the fluxes of several: which comes first is not known, so one field it is.
bool is_field(const ResultSet& set, Field field) {
    constexpr std::int32_t kTemperature = 20, kVoltage = 21, kMagnetic = 22, kConcentration = 17,
                           kPressure = 19;
    const bool others = has_dof(set, kMagnetic) || has_dof(set, kConcentration) || has_dof(set, kPressure) ||
                        has_dof(set, 7) || has_dof(set, 8) || has_dof(set, 9);
    const bool thermal = has_dof(set, kTemperature), electric = has_dof(set, kVoltage);
    switch (field) {
    case Field::Any: return true;
    case Field::Thermal: return thermal && !electric && !others;
    case Field::Electric: return electric && !thermal && !others;
    }
    return false;
}

class Lister {
public:
    Lister(const ResultSets& sets, const ResultHeader& header, const FileMesh& mesh)
        : sets_(sets), units_(units_of(header.units)),
          // Sectors are put together of what turns with them.
          invariants_(header.has_principal && header.sectors <= 1) {
        std::vector<bool> used(mesh.kinds.size());
        for (const FileElement& element : mesh.elements)
            used[element.kind] = used[element.kind] || element.index != kNoElement;
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!used[i] || !has_values(mesh.kinds[i])) continue;
            any_ = true;
            shells_ = shells_ || has_layers(mesh.kinds[i]);
            middles_ = middles_ || (has_layers(mesh.kinds[i]) && mesh.kinds[i].keyopt(8) == 2);
        }
        for (const ElementBlock& block : mesh.mesh.blocks)
            quadratic_ = quadratic_ || element_row(block.type).order == 2;
    }

    std::vector<ElementResult> list() {
        for (std::size_t i = 0; any_ && i < sets_.sets.size(); ++i) {
            const ResultSet& set = sets_.sets[i];
            if (set.elements == 0) continue;
            for (const ElementQuantity& quantity : kQuantities) {
                if (set.has(quantity.item) && is_field(set, quantity.field)) add(i, quantity);
            }
        }
        return std::move(out_);
    }

private:
    void add(std::size_t i, const ElementQuantity& quantity) {
        const ResultSet& set = sets_.sets[i];
        ResultInfo info;
        info.name = quantity.name;
        info.solver_name = quantity.label;
        info.step = set.step;
        info.complex = set.complex;
        info.location = Location::ElementNodal;
        info.averaging = Averaging::None;
        info.shape = quantity.shape;
        info.corner_only = quadratic_;
        const StepKind kind = sets_.steps[set.step].kind;
        const bool free_size = kind == StepKind::Mode || kind == StepKind::Buckling;
        if (quantity.shape == Shape::Vector) {
            info.components = {"x", "y", "z"};
            if (quantity.item == Item::Flux && quantity.field == Field::Thermal && !free_size)
                info.unit = units_.heat_flux;
        } else {
            info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
            if (quantity.item == Item::Stress) {
                if (!free_size) info.unit = units_.stress;
                const auto more = invariants_ ? kInvariants.end() : kInvariants.begin();
                info.components.insert(info.components.end(), kInvariants.begin(), more);
            } else {
                info.shear = Shear::Engineering;
            }
        }
        if (!shells_ || quantity.shape == Shape::Vector) {
            out_.push_back({info, i, &quantity});
            return;
        }
        for (const Layer layer : {Layer::Top, Layer::Middle, Layer::Bottom}) {
            info.layer = layer;
            if (layer != Layer::Middle || middles_) out_.push_back({info, i, &quantity});
        }
    }

    const ResultSets& sets_;
    Units units_;
    bool any_ = false, shells_ = false, middles_ = false, quadratic_ = false;
    bool invariants_;
    std::vector<ElementResult> out_;
};

class ValueReader {
public:
    ValueReader(const ElementSource& source, const ResultSet& set, const ElementResult& result)
        : source_(source), info_(result.info), quantity_(*result.quantity),
          width_(result.info.components.size()),
          stored_(quantity_.item == Item::Stress && source.header.has_principal ? 11 : quantity_.stored),
          tables_(source.records, set, source.mesh.element_count, result.info.name) {}

    ElementValues read() {
        for (const std::uint32_t at : source_.order) read_element(source_.mesh.elements[at]);
        return std::move(out_);
    }

private:
    void read_element(const FileElement& element) {
        const ElementKindOfFile& kind = source_.mesh.kinds[element.kind];
        if (!has_values(kind) || (has_layers(kind) && quantity_.shape == Shape::Vector)) return;
        if (!tables_.go_to(element.place) || !tables_.read(quantity_.entry, values_)) return;
        const auto plan = has_layers(kind) ? plan_shell(kind, values_.size() / stored_, info_.layer)
                                           : plan_solid(kind, values_.size() / stored_);
        if (!plan || values_.size() % stored_ != 0) {
            ++out_.not_understood;
            return;
        }
        if (plan->corners.empty()) return;
        const std::span<const NodeIndex> corners =
            std::span(source_.mesh.corners).subspan(element.first_corner, element.corner_count);
        if (!tables_.read(kEulerEntry, angles_)) angles_.clear();
        if (!axes_.read(angles_, corners, plan->layers)) {
            ++out_.not_understood;
            return;
        }
        for (std::size_t k = 0; k < corners.size() && k < plan->corners.size(); ++k) {
            // Corners of a degenerate element stand twice, with equal values.
            const bool again =
                std::ranges::find(corners.first(k), corners[k]) != corners.begin() + std::ptrdiff_t(k);
            if (again || corners[k] == kNoNode) continue;
            add_row(element, k, plan->corners[k]);
        }
    }

    void add_row(const FileElement& element, std::size_t corner, const RowPlan::Corner& place) {
        const double* row = values_.data() + place.row * stored_;
        std::array<double, 11> values{};
        std::copy_n(row, width_, values.begin());
        if (!axes_.is_global()) turn(axes_.axes(corner, place.in_last_layer), values);
        out_.row_owner.push_back(raw(element.index));
        out_.row_node.push_back(source_.mesh.corners[element.first_corner + corner]);
        for (std::size_t c = 0; c < width_; ++c) {
            const StoredValue stored = stored_value(values[c]);
            out_.values.push_back(stored.value);
            if (!stored.is_number) ++out_.without_number;
        }
    }

    /// Invariants behind a tensor are the same in all axes.
    void turn(const Matrix3& axes, std::array<double, 11>& values) const {
        if (quantity_.shape == Shape::Vector) {
            const auto turned = to_global(axes, std::array<double, 3>{values[0], values[1], values[2]});
            std::ranges::copy(turned, values.begin());
            return;
        }
        // Engineering shear is twice the tensor's.
        const double shear = info_.shear == Shear::Engineering ? 2 : 1;
        Tensor6 tensor{};
        for (std::size_t i = 0; i < 6; ++i) tensor[i] = values[i] / (i < 3 ? 1 : shear);
        tensor = to_global(axes, tensor);
        for (std::size_t i = 0; i < 6; ++i) values[i] = tensor[i] * (i < 3 ? 1 : shear);
    }

    const ElementSource& source_;
    const ResultInfo& info_;
    const ElementQuantity& quantity_;
    std::size_t width_, stored_;
    ElementTables tables_;
    std::vector<double> values_, angles_;
    ElementAxes axes_;
    ElementValues out_;
};

}  // namespace

StoredValue stored_value(double value) {
    constexpr double kNoValue = 1e30;
    const auto rounded = static_cast<float>(value);
    if (std::isfinite(rounded) && std::abs(value) < kNoValue) return {rounded, true};
    return {std::numeric_limits<float>::quiet_NaN(), std::isfinite(value)};
}

std::vector<ElementResult> list_element_results(
    const ResultSets& sets, const ResultHeader& header, const FileMesh& mesh
) {
    return Lister(sets, header, mesh).list();
}

std::vector<std::uint32_t> elements_in_mesh_order(const FileMesh& mesh) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
        if (mesh.elements[i].index != kNoElement) order.push_back(i);
    }
    const auto place = [&](std::uint32_t i) { return mesh.elements[i].index; };
    if (!std::ranges::is_sorted(order, {}, place)) std::ranges::stable_sort(order, {}, place);
    // An id that stands twice in a damaged file: the first one has the results.
    const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.elements[a].index == mesh.elements[b].index;
    };
    order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
    return order;
}

ElementValues read_element_values(
    const ElementSource& source, const ResultSet& set, const ElementResult& result
) {
    return ValueReader(source, set, result).read();
}

}  // namespace feelem::rst
