// SPDX-License-Identifier: Apache-2.0
// Must: give each end of a beam its own numbers, and no number of a kind of beam whose order was not proved.
// Algorithm: a table says where in which record the numbers of the first and of the second end stand; the
// numbers are those of Ansys' element reference (SMISC, NMISC, LS), proved on real files by equilibrium:
// force over area is the direct stress, moments over lengths are the shear forces, and sums give the
// extremes.
#include "read/ansys/rst_beams.hpp"

#include "read/ansys/rst_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace feelem::rst {
namespace {

/// What is known of a kind of beam.
enum class BeamFamily : std::uint8_t {
    Section,  ///< BEAM188: forces and stresses of the section are summable items.
    Classic   ///< BEAM4, BEAM44: stresses stand in the stress record.
};

std::optional<BeamFamily> family_of(const ElementKindOfFile& kind) {
    switch (kind.routine) {
    case 188: return BeamFamily::Section;
    case 4:
    case 44: return BeamFamily::Classic;
    default: return std::nullopt;
    }
}

}  // namespace

/// Where the numbers of the two ends stand in a record, from 1.
struct BeamPlaces {
    Item item = Item::Summable;
    std::size_t entry = 0;  ///< Of the element's table; 0: this family has none.
    std::array<std::size_t, 5> first{}, second{};
};

struct BeamQuantity {
    std::string_view name;
    std::array<std::string_view, 5> components;
    std::size_t count;
    std::array<std::string_view, 2> labels;  ///< For each family.
    std::array<BeamPlaces, 2> places;        ///< Likewise.
};

namespace {

/// Numbers in a row.
constexpr std::array<std::size_t, 5> row_from(std::size_t first) {
    return {first, first + 1, first + 2, first + 3, first + 4};
}

constexpr std::array kBeamQuantities{
    BeamQuantity{
        "beam_force",
        {"fx", "fy", "fz"},
        3,
        {"SMISC FX SFY SFZ", "SMISC MFOR"},
        {BeamPlaces{Item::Summable, kSummableEntry, {1, 6, 5}, {14, 19, 18}},
         BeamPlaces{Item::Summable, kSummableEntry, row_from(1), row_from(7)}}},
    BeamQuantity{
        "beam_moment",
        {"mx", "my", "mz"},
        3,
        {"SMISC TQ MY MZ", "SMISC MMOM"},
        {BeamPlaces{Item::Summable, kSummableEntry, {4, 2, 3}, {17, 15, 16}},
         BeamPlaces{Item::Summable, kSummableEntry, row_from(4), row_from(10)}}},
    BeamQuantity{
        "beam_stress",
        {"sdir", "sbyt", "sbyb", "sbzt", "sbzb"},
        5,
        {"SMISC SDIR SBY SBZ", "LS SDIR SBY SBZ"},
        {BeamPlaces{Item::Summable, kSummableEntry, row_from(31), row_from(36)},
         BeamPlaces{Item::Stress, kStressEntry, row_from(1), row_from(6)}}},
    BeamQuantity{
        "beam_strain",
        {"epeldir", "epelbyt", "epelbyb", "epelbzt", "epelbzb"},
        5,
        {"SMISC EPELDIR EPELBY EPELBZ", "LEPEL EPELDIR EPELBY EPELBZ"},
        {BeamPlaces{Item::Summable, kSummableEntry, row_from(41), row_from(46)},
         BeamPlaces{Item::ElasticStrain, kElasticStrainEntry, row_from(1), row_from(6)}}},
    BeamQuantity{
        "beam_stress_extremes",
        {"smax", "smin"},
        2,
        {"", "NMISC SMAX SMIN"},
        {BeamPlaces{}, BeamPlaces{Item::NotSummable, kNotSummableEntry, {1, 2}, {3, 4}}}},
};

bool is_line(const ElementKindOfFile& kind) {
    return kind.name && kind.name->kind == ansys::ElementKind::Line;
}

/// Which families are drawn, and how many elements of other kinds.
struct BeamsOfMesh {
    std::array<bool, 2> families{};
    std::map<std::string, std::uint64_t> unknown;
};

BeamsOfMesh beams_of(const FileMesh& mesh) {
    BeamsOfMesh found;
    for (const FileElement& element : mesh.elements) {
        const ElementKindOfFile& kind = mesh.kinds[element.kind];
        if (element.index == kNoElement || !is_line(kind)) continue;
        if (const auto family = family_of(kind)) {
            found.families[static_cast<std::size_t>(*family)] = true;
        } else {
            ++found.unknown[std::string(kind.name->name)];
        }
    }
    return found;
}

void tell_left_out_beams(
    const BeamsOfMesh& beams, const ResultSets& sets, const std::string& file, Diagnostics& diagnostics
) {
    const bool any = std::ranges::any_of(sets.sets, [](const ResultSet& set) {
        return set.elements != 0 && (set.has(Item::Summable) || set.has(Item::Stress));
    });
    if (!any) return;
    std::uint64_t count = 0;
    std::vector<std::string> names;
    for (const auto& [name, elements] : beams.unknown) {
        count += elements;
        names.push_back(name);
    }
    if (count > 0) {
        diagnostics.add(
            Code::UnknownBlock,
            file,
            fmt::format(
                "forces and stresses of {} are left out: no file was to be had that proves in which order "
                "they stand",
                fmt::join(names, ", ")
            ),
            count
        );
    }
    if (!beams.families[static_cast<std::size_t>(BeamFamily::Section)]) return;
    diagnostics.add(
        Code::UnknownBlock,
        file,
        "stresses at the points of beam sections are left out; beam_stress holds direct and bending stresses"
    );
}

/// Beside solids and shells, unaveraged results would part the vertices of these.
bool has_beams_alone(const Mesh& mesh) {
    return std::ranges::all_of(mesh.blocks, [](const ElementBlock& block) {
        return element_row(block.type).dimension < 2;
    });
}

ResultInfo beam_info(
    const BeamQuantity& quantity, const ResultSets& sets, const ResultSet& set, Units units
) {
    ResultInfo info;
    info.name = quantity.name;
    info.components.assign(quantity.components.begin(), quantity.components.begin() + quantity.count);
    info.step = set.step;
    info.complex = set.complex;
    info.location = Location::ElementNodal;
    // Along the axes of each beam: no vector in space, and no mean of beams of several directions.
    info.averaging = Averaging::NotApplicable;
    info.shape = Shape::Other;
    const StepKind kind = sets.steps[set.step].kind;
    if (kind == StepKind::Mode || kind == StepKind::Buckling) return info;
    if (info.name == "beam_force") info.unit = units.force;
    if (info.name.starts_with("beam_stress")) info.unit = units.stress;
    return info;
}

class BeamReader {
public:
    BeamReader(const ElementSource& source, const ResultSet& set, const BeamResult& result)
        : source_(source), quantity_(*result.quantity),
          tables_(source.records, set, source.mesh.element_count, result.info.name) {}

    ElementValues read() {
        for (const std::uint32_t at : source_.order) {
            const FileElement& element = source_.mesh.elements[at];
            const ElementKindOfFile& kind = source_.mesh.kinds[element.kind];
            if (const auto family = family_of(kind)) read_beam(element, *family);
        }
        return std::move(out_);
    }

private:
    void read_beam(const FileElement& element, BeamFamily family) {
        const BeamPlaces& places = quantity_.places[static_cast<std::size_t>(family)];
        if (places.entry == 0 || element.corner_count < 2) return;
        if (!tables_.go_to(element.place) || !tables_.read(places.entry, values_)) return;
        const std::span<const std::size_t> first(places.first.data(), quantity_.count);
        const std::span<const std::size_t> second(places.second.data(), quantity_.count);
        if (values_.size() < std::max(*std::ranges::max_element(first), *std::ranges::max_element(second))) {
            ++out_.not_understood;
            return;
        }
        add_end(element, 0, first);
        add_end(element, 1, second);
    }

    void add_end(const FileElement& element, std::size_t end, std::span<const std::size_t> places) {
        const NodeIndex node = source_.mesh.corners[element.first_corner + end];
        if (node == kNoNode) return;
        out_.row_owner.push_back(raw(element.index));
        out_.row_node.push_back(node);
        for (const std::size_t place : places) {
            const StoredValue stored = stored_value(values_[place - 1]);
            out_.values.push_back(stored.value);
            if (!stored.is_number) ++out_.without_number;
        }
    }

    const ElementSource& source_;
    const BeamQuantity& quantity_;
    ElementTables tables_;
    std::vector<double> values_;
    ElementValues out_;
};

}  // namespace

std::vector<BeamResult> list_beam_results(
    const ResultSets& sets,
    const ResultHeader& header,
    const FileMesh& mesh,
    const std::string& file,
    Diagnostics& diagnostics
) {
    const BeamsOfMesh beams = beams_of(mesh);
    tell_left_out_beams(beams, sets, file, diagnostics);
    const bool alone = has_beams_alone(mesh.mesh);
    std::vector<BeamResult> out;
    for (std::size_t i = 0; i < sets.sets.size(); ++i) {
        const ResultSet& set = sets.sets[i];
        if (set.elements == 0) continue;
        for (const BeamQuantity& quantity : kBeamQuantities) {
            std::string label;
            for (std::size_t family = 0; family < 2; ++family) {
                const BeamPlaces& places = quantity.places[family];
                if (!beams.families[family] || places.entry == 0 || !set.has(places.item)) continue;
                label += (label.empty() ? "" : "; ") + std::string(quantity.labels[family]);
            }
            if (label.empty()) continue;
            out.push_back({beam_info(quantity, sets, set, units_of(header.units)), i, &quantity});
            out.back().info.solver_name = std::move(label);
            out.back().info.on_request = !alone;
        }
    }
    return out;
}

ElementValues read_beam_values(const ElementSource& source, const ResultSet& set, const BeamResult& result) {
    return BeamReader(source, set, result).read();
}

}  // namespace feelem::rst
