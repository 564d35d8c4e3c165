// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_nodal.hpp"

#include "base/huge_pages.hpp"
#include "base/letter_case.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace feelem::rst {
namespace {

enum class Measure : std::uint8_t {
    None,
    Length,
    Angle,
    Temperature,
    Voltage,
    Pressure
};

/// An unknown of the solver and what we call it.
struct Dof {
    std::int32_t code;
    std::string_view label;     ///< The solver's.
    std::string_view quantity;  ///< Label of the vector it belongs to; our solver_name.
    std::string_view name;      ///< Ours.
    std::string_view component;
    Measure measure = Measure::None;
    Layer layer = Layer::No;
};

constexpr std::array kDofs{
    Dof{1, "UX", "U", "displacement", "x", Measure::Length},
    Dof{2, "UY", "U", "displacement", "y", Measure::Length},
    Dof{3, "UZ", "U", "displacement", "z", Measure::Length},
    Dof{4, "ROTX", "ROT", "rotation", "x", Measure::Angle},
    Dof{5, "ROTY", "ROT", "rotation", "y", Measure::Angle},
    Dof{6, "ROTZ", "ROT", "rotation", "z", Measure::Angle},
    Dof{7, "AX", "A", "magnetic_vector_potential", "x"},
    Dof{8, "AY", "A", "magnetic_vector_potential", "y"},
    Dof{9, "AZ", "A", "magnetic_vector_potential", "z"},
    Dof{10, "VX", "V", "velocity", "x"},
    Dof{11, "VY", "V", "velocity", "y"},
    Dof{12, "VZ", "V", "velocity", "z"},
    Dof{16, "WARP", "WARP", "warp", "value"},
    Dof{17, "CONC", "CONC", "concentration", "value"},
    Dof{18, "HDSP", "HDSP", "hydrostatic_pressure", "value", Measure::Pressure},
    Dof{19, "PRES", "PRES", "pressure", "value", Measure::Pressure},
    Dof{20, "TEMP", "TEMP", "temperature", "value", Measure::Temperature},
    Dof{21, "VOLT", "VOLT", "electric_potential", "value", Measure::Voltage},
    Dof{22, "MAG", "MAG", "magnetic_scalar_potential", "value"},
    Dof{23, "ENKE", "ENKE", "turbulent_kinetic_energy", "value"},
    Dof{24, "ENDS", "ENDS", "turbulent_energy_dissipation", "value"},
    Dof{25, "EMF", "EMF", "emf", "value"},
    Dof{26, "CURR", "CURR", "electric_current", "value"},
    Dof{33, "TBOT", "TEMP", "temperature", "value", Measure::Temperature, Layer::Bottom},
    Dof{64, "TTOP", "TEMP", "temperature", "value", Measure::Temperature, Layer::Top},
};

std::string_view unit_of(Measure measure, const Units& units) {
    switch (measure) {
    case Measure::Length: return units.length;
    case Measure::Angle: return "rad";
    case Measure::Temperature: return units.temperature;
    case Measure::Voltage: return units.voltage;
    case Measure::Pressure: return units.stress;
    case Measure::None: break;
    }
    return {};
}

/// Also of codes that have no row above: SP01 to SP06, TE2 to TE31, and what later releases bring.
std::string label_of(std::int32_t code) {
    const auto* found = std::ranges::find(kDofs, code, &Dof::code);
    if (found != kDofs.end()) return std::string(found->label);
    if (code >= 27 && code <= 32) return fmt::format("SP{:02}", code - 26);
    if (code >= 34 && code <= 63) return fmt::format("TE{}", code - 32);
    return fmt::format("DOF{}", code);
}

/// Fills in what is known of an unknown by itself.
ResultInfo nodal_info(std::int32_t code, const Units& units) {
    ResultInfo info;
    const auto* found = std::ranges::find(kDofs, code, &Dof::code);
    if (found == kDofs.end()) {
        info.solver_name = label_of(code);
        info.name = lower_case(info.solver_name);
        info.components = {"value"};
        return info;
    }
    info.name = found->name;
    info.solver_name = found->quantity;
    info.components = {std::string(found->component)};
    info.layer = found->layer;
    info.unit = unit_of(found->measure, units);
    return info;
}

class NodalLister {
public:
    NodalLister(const ResultSets& sets, const ResultHeader& header, const Records& records, bool rotated)
        : sets_(sets), records_(records), units_(units_of(header.units)), rotated_(rotated) {}

    std::vector<NodalResult> list() {
        for (std::size_t i = 0; i < sets_.sets.size(); ++i) {
            const ResultSet& set = sets_.sets[i];
            if (set.nodal != 0) add_columns(i, {NodalRecord::Solution, set.nodal, set.columns}, set.dofs);
            if (set.velocity != 0) add_rates(i, NodalRecord::Velocity, set.velocity);
            if (set.acceleration != 0) add_rates(i, NodalRecord::Acceleration, set.acceleration);
            if (set.reaction != 0) add_columns(i, {NodalRecord::Reaction, set.reaction, 0}, set.dofs);
        }
        return std::move(out_);
    }

private:
    /// Velocities and accelerations: of the structural unknowns, or of all.
    void add_rates(std::size_t i, NodalRecord record, Word at) {
        const ResultSet& set = sets_.sets[i];
        std::vector<std::int32_t> structural;
        for (const std::int32_t code : set.dofs) {
            if (code >= 1 && code <= 6) structural.push_back(code);
        }
        std::size_t count = 0;
        try {
            count = Records::count(records_.find(at));
        } catch (const Error&) {
            return;  // The rest of the set may be whole.
        }
        if (structural.empty() || set.nodes == 0) return;
        if (count == structural.size() * set.nodes)
            add_columns(i, {record, at, structural.size()}, structural);
    }

    struct Source {
        NodalRecord record;
        Word at;
        std::size_t width;
    };

    void add_columns(std::size_t i, const Source& source, const std::vector<std::int32_t>& codes) {
        const ResultSet& set = sets_.sets[i];
        const std::size_t first = out_.size();
        for (std::size_t column = 0; column < codes.size(); ++column) {
            ResultInfo info = nodal_info(codes[column], units_);
            rename(info, source.record);
            info.step = set.step;
            info.complex = set.complex;
            const bool free_size = sets_.steps[set.step].kind == StepKind::Mode ||
                                   sets_.steps[set.step].kind == StepKind::Buckling;
            // Shapes of modes have no size of their own.
            if (free_size) info.unit.clear();
            const auto same = std::find_if(
                out_.begin() + static_cast<std::ptrdiff_t>(first),
                out_.end(),
                [&](const NodalResult& other) {
                    return other.info.name == info.name && other.info.layer == info.layer;
                }
            );
            if (same != out_.end()) {
                same->info.components.push_back(info.components.front());
                same->columns.push_back(column);
            } else {
                out_.push_back({std::move(info), i, source.record, source.at, source.width, {column}});
            }
        }
        for (std::size_t k = first; k < out_.size(); ++k) finish(out_[k].info);
    }

    void rename(ResultInfo& info, NodalRecord record) const {
        if (record == NodalRecord::Solution) return;
        const bool moves = info.name == "displacement", turns = info.name == "rotation";
        if (record == NodalRecord::Reaction) {
            const std::string name = moves   ? "reaction_force"
                                     : turns ? "reaction_moment"
                                     : info.name == "temperature"
                                         ? "reaction_heat_flow"
                                         : "reaction_" + lower_case(info.solver_name);
            info.unit = moves ? units_.force : "";
            info.solver_name = moves ? "F" : turns ? "M" : info.name == "temperature" ? "HEAT" : "RF";
            info.name = name;
            return;
        }
        const bool first = record == NodalRecord::Velocity;
        info.name = std::string(turns ? "rotational_" : "") + (first ? "velocity" : "acceleration");
        info.solver_name = std::string(turns ? "OMG" : first ? "VEL" : "ACC");
        if (turns && !first) info.solver_name = "DMG";
        info.unit = info.unit.empty() ? "" : fmt::format("{}/s{}", info.unit, first ? "" : "^2");
    }

    void finish(ResultInfo& info) const {
        const bool is_value = info.components.front() == "value";
        info.shape = is_value                      ? Shape::Scalar
                     : info.components.size() == 3 ? Shape::Vector
                     : info.components.size() == 1 ? Shape::Scalar
                                                   : Shape::Other;
        info.nodal_system = rotated_ && !is_value;
    }

    const ResultSets& sets_;
    const Records& records_;
    Units units_;
    bool rotated_;
    std::vector<NodalResult> out_;
};

/// 2^100 and beyond: "this node has no such unknown".
constexpr double kNoValue = 1e30;

class NodalValueReader {
public:
    NodalValueReader(
        const Records& records,
        const ResultSet& set,
        const NodalResult& result,
        std::span<const NodeIndex> row_nodes
    )
        : records_(records), set_(set), result_(result), row_nodes_(row_nodes) {}

    NodalValues read(std::size_t node_count) {
        reserve_big(out_.values, node_count * result_.columns.size());
        out_.values.assign(node_count * result_.columns.size(), std::numeric_limits<float>::quiet_NaN());
        if (result_.record == NodalRecord::Reaction) {
            read_reactions();
        } else {
            read_rows();
        }
        return std::move(out_);
    }

private:
    void read_rows() {
        const Word at = result_.at;
        const std::size_t width = result_.width;
        const Record record = records_.find(at);
        const Reals values(records_, record, row_nodes_.size() * std::max<std::size_t>(1, width));
        if (width == 0 || values.size() % width != 0 || result_.columns.back() >= width)
            bad(at, fmt::format("{} values in rows of {}", values.size(), width));
        const std::size_t rows = values.size() / width;
        std::vector<std::int32_t> listed;
        if (rows != set_.nodes || rows > row_nodes_.size()) listed = listed_rows(record, rows);
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t place = listed.empty() ? row : static_cast<std::size_t>(listed[row]) - 1;
            for (std::size_t c = 0; c < result_.columns.size(); ++c)
                store(place, c, values[row * width + result_.columns[c]]);
        }
    }

    /// Values of some nodes only: the record behind says of which.
    std::vector<std::int32_t> listed_rows(const Record& record, std::size_t rows) const {
        std::vector<std::int32_t> listed;
        records_.unpack(records_.find(record.next), rows, listed);
        if (listed.size() < rows)
            bad(record.at, fmt::format("{} rows of values, but {} nodes", rows, listed.size()));
        for (const std::int32_t place : listed) {
            if (place < 1 || static_cast<std::size_t>(place) > row_nodes_.size())
                bad(record.at, fmt::format("values of node {} of {}", place, row_nodes_.size()));
        }
        return listed;
    }

    void read_reactions() {
        const Record index = records_.find(result_.at);
        std::vector<std::int32_t> places;
        records_.unpack(index, 2 * set_.reactions, places);
        const Reals values(records_, records_.find(index.next), set_.reactions);
        const bool is_wide = places.size() >= 2 * set_.reactions;
        const std::size_t count = std::min(is_wide ? places.size() / 2 : places.size(), values.size());
        const std::size_t width = set_.dofs.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t place = is_wide ? wide(places[2 * i], places[2 * i + 1]) : wide(places[i], 0);
            if (place == 0 || place > row_nodes_.size() * width)
                bad(index.at,
                    fmt::format("a reaction at unknown {} of {}", place, row_nodes_.size() * width));
            const std::size_t column = (place - 1) % width;
            const auto found = std::ranges::find(result_.columns, column);
            if (found == result_.columns.end()) continue;
            store((place - 1) / width, static_cast<std::size_t>(found - result_.columns.begin()), values[i]);
        }
    }

    void store(std::size_t row, std::size_t component, double value) {
        if (row >= row_nodes_.size() || row_nodes_[row] == kNoNode) {
            ++out_.without_node;
            return;
        }
        if (std::isfinite(value) && std::abs(value) >= kNoValue) return;
        const auto rounded = static_cast<float>(value);
        if (!std::isfinite(rounded)) {
            ++out_.without_number;
            return;
        }
        out_.values[raw(row_nodes_[row]) * result_.columns.size() + component] = rounded;
    }

    [[noreturn]] void bad(Word at, const std::string& text) const {
        throw Error(
            Code::BadStructure,
            records_.where(at),
            fmt::format("{} ({}): the file is damaged", text, result_.info.name)
        );
    }

    const Records& records_;
    const ResultSet& set_;
    const NodalResult& result_;
    std::span<const NodeIndex> row_nodes_;
    NodalValues out_;
};

}  // namespace

std::vector<NodalResult> list_nodal_results(
    const ResultSets& sets, const ResultHeader& header, const Records& records, bool rotated
) {
    return NodalLister(sets, header, records, rotated).list();
}

NodalValues read_nodal_values(
    const Records& records,
    const ResultSet& set,
    const NodalResult& result,
    const Mesh& mesh,
    std::span<const NodeIndex> row_nodes
) {
    return NodalValueReader(records, set, result, row_nodes).read(mesh.node_count());
}

}  // namespace feelem::rst
