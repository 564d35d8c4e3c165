// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_elements.hpp"

#include "model/node_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace feelem::op2 {
namespace {

constexpr int kStressCode = 5;
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kSolidHead = 4;  ///< Number, system, "GRID", how many corners.
constexpr std::size_t kSolidPoint = 21;
constexpr std::size_t kShellHead = 2;  ///< Number, "CEN/".
constexpr std::size_t kShellPoint = 17;
constexpr std::size_t kFibreWords = 8;

constexpr std::size_t kBeamStation =
    10;  ///< Grid (0: between the ends), place, four fibres, largest, smallest, margins.

constexpr ElementLayout solid(int type, std::size_t corners) {
    return {type, RowShape::Solid, corners, kSolidHead + kSolidPoint * (corners + 1), kSolidPoint};
}
/// 13 words a point, or 14 with a von Mises amplitude.
constexpr ElementLayout complex_solid(int type, std::size_t corners, std::size_t point) {
    return {type, RowShape::SolidComplex, corners, kSolidHead + point * (corners + 1), point};
}
constexpr ElementLayout shell(int type, std::size_t corners) {
    return {type, RowShape::ShellCorner, corners, kShellHead + kShellPoint * (corners + 1), kShellPoint};
}
constexpr ElementLayout centre(int type) {
    return {type, RowShape::ShellCentre, 0, kShellPoint, kShellPoint};
}

constexpr std::array kLayouts{
    ElementLayout{1, RowShape::Bar, 1, 5, 0},   // CROD
    ElementLayout{3, RowShape::Bar, 1, 5, 0},   // CTUBE
    ElementLayout{10, RowShape::Bar, 1, 5, 0},  // CONROD
    ElementLayout{34, RowShape::Bar, 5, 16, 0},
    ElementLayout{34, RowShape::BarEnds, 2, 16, 0},
    ElementLayout{2, RowShape::BarEnds, 11, 111, kBeamStation},  // CBAR
    solid(39, 4),                                                // CTETRA
    solid(67, 8),                                                // CHEXA
    solid(68, 6),                                                // CPENTA
    solid(255, 5),                                               // CPYRAM
    complex_solid(39, 4, 13),
    complex_solid(39, 4, 14),
    complex_solid(67, 8, 13),
    complex_solid(67, 8, 14),
    complex_solid(68, 6, 13),
    complex_solid(68, 6, 14),
    complex_solid(255, 5, 13),
    complex_solid(255, 5, 14),
    centre(33),     // CQUAD4
    centre(74),     // CTRIA3
    centre(227),    // CTRIAR
    centre(228),    // CQUADR
    shell(64, 4),   // CQUAD8
    shell(70, 3),   // CTRIAR
    shell(75, 3),   // CTRIA6
    shell(82, 4),   // CQUADR
    shell(144, 4),  // CQUAD4
};

/// Words of xx yy zz xy yz zx and the equivalent value after the point's grid.
constexpr std::array<std::size_t, 7> kSolidColumns{1, 9, 15, 2, 10, 16, 8};
/// Words of xx yy zz xy yz zx after the point's grid: of one part, and of the other.
constexpr std::array<std::array<std::size_t, 6>, 2> kComplexColumns{
    {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}}};
/// Words of the equivalent value and the larger and smaller principal one after the fibre's distance.
constexpr std::array<std::size_t, 3> kShellColumns{7, 5, 6};

class ValueReader {
public:
    ValueReader(const ElementResult& result, const Mesh& mesh, const ElementLookup& lookup)
        : result_(result), mesh_(mesh), lookup_(lookup), nodes_(mesh.node_ids) {
        if (by_element()) values_.values.assign(mesh.element_count() * width(), kMissing);
    }

    void read(const Words& row, const ElementLayout& layout) {
        const ElementIndex element = lookup_(ElementId{row.integer(0) / 10});
        if (element == kNoElement) {
            ++values_.without_element;
            return;
        }
        switch (layout.shape) {
        case RowShape::SolidComplex:
        case RowShape::Solid: read_solid(row, layout, element); break;
        case RowShape::ShellCorner: read_shell(row, layout, element); break;
        case RowShape::ShellCentre: read_centre(row, element); break;
        case RowShape::BarEnds: read_ends(row, layout, element); break;
        case RowShape::Bar: put(row, std::array{layout.corners}, values_.values.data() + raw(element)); break;
        }
    }

    ElementValues finish() {
        if (!by_element()) sort_rows();
        return std::move(values_);
    }

private:
    bool by_element() const {
        return result_.quantity == Quantity::Axial || result_.quantity == Quantity::ShellCentre;
    }
    std::size_t width() const {
        switch (result_.quantity) {
        case Quantity::SolidCorner: return kSolidColumns.size();
        case Quantity::SolidComplex: return kComplexColumns[0].size();
        case Quantity::Axial: return 1;
        case Quantity::BarEnds: return 2;
        default: return kShellColumns.size();
        }
    }

    template <std::size_t count>
    void put(const Words& words, const std::array<std::size_t, count>& columns, float* out) {
        for (std::size_t c = 0; c < count; ++c) {
            const auto value = static_cast<float>(words.real(columns[c]));
            out[c] = std::isfinite(value) ? value : kMissing;
            if (!std::isfinite(value)) ++values_.without_number;
        }
    }

    float* add_row(ElementIndex element, NodeIndex node) {
        values_.row_owner.push_back(raw(element));
        values_.row_node.push_back(node);
        values_.values.resize(values_.values.size() + width(), kMissing);
        return values_.values.data() + values_.values.size() - width();
    }

    /// The node of a corner; kNoNode when the mesh or the element does not have it.
    NodeIndex corner(std::int64_t grid, ElementIndex element) {
        const NodeIndex node = nodes_(NodeId{grid});
        const auto nodes = element_at(mesh_, element).nodes();
        if (node != kNoNode && std::ranges::find(nodes, node) != nodes.end()) return node;
        ++values_.without_element;
        return kNoNode;
    }

    void read_solid(const Words& row, const ElementLayout& layout, ElementIndex element) {
        const bool is_basic = row.integer(1) == 0;
        if (!is_basic) ++values_.other_system;
        for (std::size_t i = 1; i <= layout.corners; ++i) {
            const Words point = row.part(kSolidHead + i * layout.point_words, layout.point_words);
            const NodeIndex node = corner(point.integer(0), element);
            if (node == kNoNode) continue;
            float* out = add_row(element, node);
            if (layout.shape == RowShape::Solid) {
                put(point, kSolidColumns, out);
            } else {
                put(point, kComplexColumns[result_.fibre == 0 ? 0 : 1], out);
            }
            if (!is_basic) std::fill(out, out + 6, kMissing);
        }
    }

    /// The fibre with the smaller distance is the lower one, wherever it stands.
    Words fibre_of(const Words& fibres) const {
        const Words first = fibres.part(0, kFibreWords);
        const Words second = fibres.part(kFibreWords, kFibreWords);
        const bool swapped = !result_.kind.curvature && second.real(0) < first.real(0);
        return (result_.fibre == 0) != swapped ? first : second;
    }

    void read_shell(const Words& row, const ElementLayout& layout, ElementIndex element) {
        for (std::size_t i = 1; i <= layout.corners; ++i) {
            const Words point = row.part(kShellHead + i * kShellPoint, kShellPoint);
            const NodeIndex node = corner(point.integer(0), element);
            if (node != kNoNode)
                put(fibre_of(point.part(1, 2 * kFibreWords)), kShellColumns, add_row(element, node));
        }
    }

    /// Beside shells with corners, those without have the same values at each of theirs.
    void read_centre(const Words& row, ElementIndex element) {
        const Words fibre = fibre_of(row.part(1, 2 * kFibreWords));
        if (by_element()) {
            put(fibre, kShellColumns, values_.values.data() + raw(element) * width());
            return;
        }
        const ElementRef found = element_at(mesh_, element);
        const std::size_t corners = element_row(found.block->type).corner_count;
        for (const NodeIndex node : found.nodes().first(corners))
            put(fibre, kShellColumns, add_row(element, node));
    }

    void read_ends(const Words& row, const ElementLayout& layout, ElementIndex element) {
        constexpr std::array<std::array<std::size_t, 2>, 2> kBarColumns{{{6, 7}, {13, 14}}};
        constexpr std::array<std::size_t, 2> kBeamColumns{6, 7};
        for (std::size_t i = 0; i < layout.corners; ++i) {
            if (layout.point_words == 0) {
                const auto nodes = element_at(mesh_, element).nodes();
                if (i < nodes.size()) put(row, kBarColumns[i], add_row(element, nodes[i]));
                continue;
            }
            const Words station = row.part(1 + i * kBeamStation, kBeamStation);
            if (station.integer(0) == 0) continue;
            const NodeIndex node = corner(station.integer(0), element);
            if (node != kNoNode) put(station, kBeamColumns, add_row(element, node));
        }
    }

    void sort_rows() {
        const auto key = [&](std::size_t row) {
            return std::pair(values_.row_owner[row], values_.row_node[row]);
        };
        std::vector<std::size_t> order(values_.row_owner.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, key);
        ElementValues sorted = values_;
        for (std::size_t i = 0; i < order.size(); ++i) {
            sorted.row_owner[i] = values_.row_owner[order[i]];
            sorted.row_node[i] = values_.row_node[order[i]];
            std::copy_n(
                values_.values.data() + order[i] * width(), width(), sorted.values.data() + i * width()
            );
        }
        values_ = std::move(sorted);
    }

    const ElementResult& result_;
    const Mesh& mesh_;
    const ElementLookup& lookup_;
    NodeLookup nodes_;
    ElementValues values_;
};

}  // namespace

const ElementLayout* element_layout(const Ident& ident) {
    const bool plain = ident.table_code == kStressCode && !ident.sort2 && !ident.random;
    if (!plain || !stress_kind(ident)) return nullptr;
    const auto found = std::ranges::find_if(kLayouts, [&](const ElementLayout& layout) {
        return layout.type == ident.element_type && layout.row_words == ident.row_words &&
               (layout.shape == RowShape::SolidComplex) == ident.is_complex;
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

const ElementLayout* ends_layout(const ElementLayout& layout) {
    if (layout.shape != RowShape::Bar) return nullptr;
    const auto found = std::ranges::find_if(kLayouts, [&](const ElementLayout& other) {
        return other.type == layout.type && other.shape == RowShape::BarEnds;
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

std::optional<StressKind> stress_kind(const Ident& ident) {
    switch (ident.stress_bits) {
    case 0: return StressKind{};
    case 1: return StressKind{false, true, false};
    case 10: return StressKind{true, false, true};
    case 11: return StressKind{true, true, true};
    case 14: return StressKind{true, false, false};
    case 15: return StressKind{true, true, false};
    default: return {};
    }
}

ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
) {
    ValueReader reader(result, mesh, lookup);
    for (const ElementBlockRef& block : result.blocks) {
        const std::size_t words = layout.record_bytes(block.record) / layout.form.size;
        const std::size_t width = block.layout->row_words;
        if (words % width != 0) {
            const auto segments = layout.record(block.record);
            throw Error(
                Code::BadStructure,
                input.where_byte(segments.empty() ? 0 : segments.front().first),
                fmt::format("{} has {} words of data where each element needs {}", result.table, words, width)
            );
        }
        for_each_row(input, layout, block.record, width, [&](const Words& row) {
            reader.read(row, *block.layout);
        });
    }
    return reader.finish();
}

ResultInfo element_info(const ElementResult& result) {
    ResultInfo info;
    info.solver_name = result.table;
    const StressKind& kind = result.kind;
    const bool is_shell =
        result.quantity == Quantity::ShellCorner || result.quantity == Quantity::ShellCentre;
    switch (result.quantity) {
    case Quantity::SolidCorner:
        info.shape = Shape::SymmetricTensor;
        info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        info.components.emplace_back(kind.von_mises ? "von_mises" : "octahedral_shear");
        break;
    case Quantity::SolidComplex:
        info.shape = Shape::SymmetricTensor;
        info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        info.complex = result.fibre == 0 ? (result.polar ? Complex::Amplitude : Complex::Real)
                                         : (result.polar ? Complex::Phase : Complex::Imaginary);
        break;
    case Quantity::Axial: info.components = {"value"}; break;
    case Quantity::BarEnds:
        info.shape = Shape::Other;
        info.components = {"max", "min"};
        break;
    default:
        info.shape = Shape::Other;
        info.components = {kind.von_mises ? "von_mises" : "max_shear", "major", "minor"};
        break;
    }
    const bool by_element = result.quantity == Quantity::Axial || result.quantity == Quantity::ShellCentre;
    info.location = by_element ? Location::Elemental : Location::ElementNodal;
    info.averaging = by_element ? Averaging::NotApplicable : Averaging::None;
    if (kind.strain) info.shear = Shear::Engineering;
    if (is_shell && !kind.curvature) info.layer = result.fibre == 0 ? Layer::Bottom : Layer::Top;
    if (is_shell && kind.curvature && result.fibre == 0) info.layer = Layer::Middle;
    info.name = kind.strain ? "strain" : "stress";
    if (result.quantity == Quantity::Axial) info.name = "axial_" + info.name;
    if (result.quantity == Quantity::BarEnds) info.name = "bar_" + info.name;
    if (is_shell && kind.curvature && result.fibre == 1) info.name = "curvature";
    return info;
}

}  // namespace feelem::op2
