// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/fil_contents.hpp"

#include "base/number.hpp"
#include "read/abaqus/fil_mesh.hpp"
#include "read/abaqus/fil_names.hpp"
#include "read/result_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace feelem::fil {
namespace {

/// Steps and what is in them.
class ResultRecords {
public:
    explicit ResultRecords(Contents& contents) : contents_(contents) {}

    void set_dofs(const Record& record) {
        for (std::size_t i = 0; i < std::min<std::size_t>(record.words.size(), 6); ++i)
            dofs_[i] =
                static_cast<std::int32_t>(std::clamp<std::int64_t>(record.words[i].as_integer(), 0, 1000));
    }

    void begin_increment(const Record& record, std::size_t position) {
        end_step(position);
        const auto integer = [&](std::size_t i) {
            const std::int64_t value = i < record.words.size() ? record.words[i].as_integer() : 0;
            return static_cast<std::int32_t>(std::clamp<std::int64_t>(value, INT32_MIN, INT32_MAX));
        };
        const auto real = [&](std::size_t i) {
            return i < record.words.size() ? record.words[i].as_real() : 0;
        };
        step_ = Step{};
        step_.step = integer(5);
        step_.substep = integer(6);
        const double frequency = real(9);
        step_.kind = frequency != 0    ? StepKind::Frequency
                     : integer(4) == 1 ? StepKind::Static
                                       : StepKind::Time;
        step_.value = frequency != 0 ? frequency : real(0);
        step_.label = joined_text(record, 11);
        if (!std::isfinite(step_.value)) step_.value = 0;
        begin_step(position);
    }

    void begin_mode(const Record& record, std::size_t position) {
        if (record.words.size() < 2) return;
        end_step(position);
        const double eigenvalue = record.words[1].as_real();
        // A generalized mass follows the eigenvalue of a frequency, none that of a buckling load.
        const bool is_frequency = record.words.size() > 2;
        step_.kind = is_frequency ? StepKind::Mode : StepKind::Buckling;
        step_.substep =
            static_cast<std::int32_t>(std::clamp<std::int64_t>(record.words[0].as_integer(), 0, INT32_MAX));
        step_.value =
            is_frequency ? std::sqrt(std::max(eigenvalue, 0.0)) / (2 * std::numbers::pi) : eigenvalue;
        if (!std::isfinite(step_.value)) step_.value = 0;
        begin_step(position);
    }

    void use(const Record& record) {
        if (record.key == 1) head_ = read_head(record);
        if (record.key == 85) contents_.has_local_directions = true;
        if (record.key == 1911 && !record.words.empty()) of_elements_ = record.words[0].as_integer() == 0;
        const Variable* variable = find_variable(record.key);
        if (variable == nullptr || !inside_) return;
        const bool of_nodes = !of_elements_ || record.key > 100;
        const At at = of_nodes ? At::Node : head_.at;
        if (at == At::Rebar) return;
        const std::size_t values = of_nodes
                                       ? record.words.size() - std::min<std::size_t>(record.words.size(), 1)
                                       : record.words.size();
        std::size_t& most =
            found_[{record.key, static_cast<std::int64_t>(at), of_nodes ? 0 : head_.section_point}];
        most = std::max(most, std::min<std::size_t>(values, 512));
    }

    void end_step(std::size_t position) {
        if (!inside_) return;
        inside_ = false;
        if (found_.empty()) return;
        step_index_ = static_cast<std::uint32_t>(contents_.steps.size());
        contents_.steps.push_back(step_);
        for (const auto& [what, values] : found_) {
            const auto [key, at, point] = what;
            if (values > 0) list(key, static_cast<At>(at), point, values, position);
        }
        found_.clear();
    }

    void make_names_unique() {
        ResultNames names;
        for (Listed& listed : contents_.results) names.make_unique(listed.info);
    }

private:
    void begin_step(std::size_t position) {
        inside_ = true;
        begin_ = position;
        found_.clear();
        head_ = {};
    }

    void list(std::int64_t key, At at, std::int64_t point, std::size_t values, std::size_t end) {
        const Variable& variable = *find_variable(key);
        Listed listed;
        listed.key = key;
        listed.at = at;
        listed.section_point = point;
        listed.begin = begin_;
        listed.end = end;
        ResultInfo& info = listed.info;
        info.name = std::string(variable.ours);
        info.solver_name = std::string(variable.solver);
        info.step = step_index_;
        info.shear = variable.shear;
        info.location = at == At::Node || at == At::Averaged ? Location::Nodal
                        : at == At::ElementNodes             ? Location::ElementNodal
                                                             : Location::Elemental;
        if (at == At::Averaged) info.averaging = Averaging::Solver;
        if (at == At::ElementNodes) info.averaging = Averaging::None;
        if (at == At::Point) info.solver_name += " (mean of integration points)";
        info.layer = layer_of(key, at, point);
        if (point > 0 && info.layer == Layer::No) info.name += fmt::format("_point_{}", point);
        // Harmonic response: the real parts of all values, then the imaginary ones.
        const bool complex = step_.kind == StepKind::Frequency && values % 2 == 0;
        for (int part = complex ? 1 : 0; part <= (complex ? 2 : 0); ++part) {
            Listed one = listed;
            one.imaginary = complex ? static_cast<std::size_t>(3 - part) : 0;
            if (complex) one.info.complex = part == 1 ? Complex::Real : Complex::Imaginary;
            name_components(one, variable, complex ? values / 2 : values);
        }
    }

    /// Shells: the first section point is the bottom, the last the top.
    Layer layer_of(std::int64_t key, At at, std::int64_t point) const {
        if (point == 0) return Layer::No;
        std::int64_t first = point, last = point;
        for (const auto& [what, values] : found_) {
            const auto [other_key, other_at, other] = what;
            if (other_key != key || other_at != static_cast<std::int64_t>(at) || other == 0) continue;
            first = std::min(first, other);
            last = std::max(last, other);
        }
        if (first == last) return Layer::No;
        return point == first ? Layer::Bottom : point == last ? Layer::Top : Layer::No;
    }

    void name_components(Listed listed, const Variable& variable, std::size_t values) {
        ResultInfo& info = listed.info;
        if (variable.form == Form::Tensor) {
            listed.is_tensor = true;
            info.shape = Shape::SymmetricTensor;
            info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
            listed.columns = {0, 1, 2, 3, 5, 4};
        } else if (variable.form == Form::Vector) {
            add_axes(listed, {0, 1, 2}, values);
        } else if (variable.form == Form::Dofs) {
            Listed rotation = listed;
            add_axes(rotation, {dofs_[3] - 1, dofs_[4] - 1, dofs_[5] - 1}, values);
            add_axes(listed, {dofs_[0] - 1, dofs_[1] - 1, dofs_[2] - 1}, values);
            if (!rotation.columns.empty()) {
                rotation.info.name = info.name == "displacement"     ? "rotation"
                                     : info.name == "reaction_force" ? "reaction_moment"
                                                                     : "rotational_" + info.name;
                contents_.results.push_back(std::move(rotation));
            }
        } else {
            for (std::size_t i = 0; i < values; ++i) {
                listed.columns.push_back(static_cast<std::int32_t>(i));
                info.components.push_back(i == 0 && values == 1 ? "value" : fmt::format("v{}", i + 1));
            }
            info.shape = values == 1 ? Shape::Scalar : Shape::Other;
        }
        if (!listed.columns.empty()) contents_.results.push_back(std::move(listed));
    }

    static void add_axes(Listed& listed, const std::array<std::int32_t, 3>& columns, std::size_t values) {
        constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
        for (std::size_t i = 0; i < 3; ++i) {
            if (columns[i] < 0 || static_cast<std::size_t>(columns[i]) >= values) continue;
            listed.columns.push_back(columns[i]);
            listed.info.components.emplace_back(kAxes[i]);
        }
        listed.info.shape = listed.columns.size() == 1 ? Shape::Scalar : Shape::Vector;
    }

    Contents& contents_;
    std::array<std::int32_t, 6> dofs_{1, 2, 3, 4, 5, 6};
    Step step_;
    std::uint32_t step_index_ = 0;
    std::size_t begin_ = 0;
    bool inside_ = false;
    bool of_elements_ = true;
    Head head_;
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, std::size_t> found_;
};

}  // namespace

Head read_head(const Record& record) {
    const auto integer = [&](std::size_t i) {
        return i < record.words.size() ? record.words[i].as_integer() : 0;
    };
    Head head;
    head.id = integer(0);
    head.point = integer(1);
    head.section_point = integer(2);
    const std::int64_t at = integer(3);
    head.at = at >= 0 && at <= 5 ? static_cast<At>(at) : At::Rebar;
    head.direct = integer(5);
    head.shear = integer(6);
    return head;
}

int tensor_word(const Head& head, int place) {
    if (place < 3) return place < head.direct ? place : -1;
    return place - 3 < head.shear ? static_cast<int>(head.direct) + place - 3 : -1;
}

Contents read_contents(const Input& input, Coding coding, Diagnostics& diagnostics) {
    Contents contents;
    MeshRecords mesh(diagnostics);
    ResultRecords results(contents);
    RecordReader reader(input, coding);
    Record record;
    for (std::size_t position = 0; reader.next(record); position = reader.position()) {
        switch (record.key) {
        case 1921:
            if (!record.words.empty())
                contents.solver = {"Abaqus", std::string(trim(record.words[0].as_text()))};
            break;
        case 1922: contents.title = joined_text(record, 0); break;
        case 1902: results.set_dofs(record); break;
        case 2000: results.begin_increment(record, reader.position()); break;
        case 1980: results.begin_mode(record, reader.position()); break;
        case 2001: results.end_step(position); break;
        default: mesh.use(record); results.use(record);
        }
    }
    results.end_step(reader.position());
    results.make_names_unique();
    if (reader.broken()) {
        diagnostics.add(
            Code::TruncatedInput,
            [&] { return reader.where(); },
            "a record of the results file is cut off or damaged; what came before it is used"
        );
    }
    contents.mesh = mesh.finish();
    return contents;
}

}  // namespace feelem::fil
