// SPDX-License-Identifier: Apache-2.0
// A .dat file as a ModelSource: tables are found on opening, rows read on demand.
#include "read/calculix/calculix_dat.hpp"

#include "read/calculix/dat_tables.hpp"
#include "read/element_lookup.hpp"
#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace feelem {
namespace {

using namespace dat;

Likelihood recognise_dat(const Input& input) {
    return starts_like_tables(head_of(input)) ? Likelihood::Sure : Likelihood::No;
}

/// Values of the rows of a mesh: the last one counts, or the mean of all.
class Rows {
public:
    Rows(std::size_t rows, std::size_t width, bool mean)
        : width_(width), mean_(mean), sums_(rows * width), counts_(rows * width) {}

    void add(std::size_t row, std::size_t component, double value) {
        const std::size_t at = row * width_ + component;
        sums_[at] = mean_ ? sums_[at] + value : value;
        counts_[at] = mean_ ? counts_[at] + 1 : 1;
    }
    std::vector<float> values() const {
        std::vector<float> out(sums_.size(), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (counts_[i] > 0) out[i] = static_cast<float>(sums_[i] / counts_[i]);
        }
        return out;
    }

private:
    std::size_t width_;
    bool mean_;
    std::vector<double> sums_;
    std::vector<std::uint32_t> counts_;
};

class DatSource : public ModelSource {
public:
    DatSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics), mesh_(context.mesh),
          tables_(find_tables(input_)) {
        if (mesh_ == nullptr) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                "CalculiX' printed tables hold values without a mesh. Open them together with the .inp or "
                ".frd "
                "of the same job."
            );
        }
        dat::Contents contents = list_tables(tables_);
        steps_ = std::move(contents.steps);
        listed_ = std::move(contents.results);
        for (const dat::Listed& listed : listed_) infos_.push_back(listed.info);
        reported_.resize(listed_.size());
        for (const Table& table : tables_) note(table);
        if (tables_.empty()) {
            diagnostics_.add(
                Code::EmptyResult, input_.name(), "the printed tables hold no values of nodes or elements"
            );
        }
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"CalculiX", ""}; }

    Result load(std::size_t index) override {
        const dat::Listed& listed = listed_.at(index);
        const bool elemental = listed.info.location == Location::Elemental;
        if (elemental && elements_ == nullptr) elements_ = std::make_unique<ElementLookup>(*mesh_);
        Rows rows(
            elemental ? mesh_->element_count() : mesh_->node_count(),
            listed.columns.size(),
            tables_[listed.tables.front()].has_points
        );
        lost_ = broken_ = 0;
        for (const std::size_t table : listed.tables) read_rows(listed, tables_[table], rows);
        if (!reported_[index]) report(listed);
        reported_[index] = true;
        Result result;
        result.info = listed.info;
        result.values = rows.values();
        return result;
    }

private:
    void read_rows(const dat::Listed& listed, const Table& table, Rows& rows) {
        TextLines lines(input_, table.begin, table.end);
        std::vector<double> values(table.columns);
        while (const auto line = lines.next()) {
            std::string_view rest = *line;
            const auto id = take_integer(rest);
            if (!id) continue;
            if (table.has_points) take_word(rest);
            for (double& value : values) {
                const std::string_view word = take_word(rest);
                // One rounding: a mean is rounded at its end, a single value here.
                const auto number =
                    table.has_points ? parse_double(word) : std::optional<double>(parse_float(word));
                if (!number) {
                    throw Error(
                        Code::BadNumber,
                        lines.where(),
                        fmt::format(
                            "found \"{}\" where a value of {} is expected", word.substr(0, 40), table.label
                        )
                    );
                }
                value = *number;
            }
            const std::size_t row = row_of(table, *id);
            if (row == kNoRow) {
                ++lost_;
                continue;
            }
            for (std::size_t i = 0; i < listed.columns.size(); ++i) {
                const double value = values[listed.columns[i]];
                if (!std::isfinite(static_cast<float>(value))) {
                    ++broken_;
                } else {
                    rows.add(row, i, value);
                }
            }
        }
    }

    std::size_t row_of(const Table& table, std::int64_t id) const {
        if (table.of_elements) {
            const ElementIndex element = (*elements_)(ElementId{id});
            return element == kNoElement ? kNoRow : raw(element);
        }
        const NodeIndex node = find_node(*mesh_, NodeId{id});
        return node == kNoNode ? kNoRow : raw(node);
    }

    void note(const Table& table) {
        if (table.has_points) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return input_.where_line(table.begin); },
                fmt::format("{}: an element shows the mean of its integration points", table.label)
            );
        }
        if (table.is_local) {
            diagnostics_.add(
                Code::CoordinateSystem,
                [&] { return input_.where_line(table.begin); },
                fmt::format("{} are in the local systems of their elements", table.label)
            );
        }
        if (!table.of_elements && table.rows < mesh_->node_count()) {
            diagnostics_.add(
                Code::ResultForPartOfModel,
                [&] { return input_.where_line(table.begin); },
                fmt::format("{} have values for {} of {} nodes", table.label, table.rows, mesh_->node_count())
            );
        }
    }

    void report(const dat::Listed& listed) {
        const std::string& label = listed.info.solver_name;
        if (lost_ > 0) {
            diagnostics_.add(
                Code::ResultWithoutNode,
                input_.name(),
                fmt::format("{} lists nodes or elements that the mesh does not have", label),
                lost_
            );
        }
        if (broken_ > 0) {
            diagnostics_.add(
                Code::NonFiniteValue,
                input_.name(),
                fmt::format("{} has values that are no finite numbers; they count as missing", label),
                broken_
            );
        }
    }

    static constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();

    Input input_;
    Diagnostics& diagnostics_;
    const Mesh* mesh_;
    std::vector<Table> tables_;
    std::unique_ptr<ElementLookup> elements_;
    std::vector<Step> steps_;
    std::vector<dat::Listed> listed_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
    std::uint64_t lost_ = 0, broken_ = 0;
};

std::unique_ptr<ModelSource> open_dat(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<DatSource>(inputs.front(), context, diagnostics);
}

}  // namespace

ReadFormat calculix_dat_format() {
    return {{"calculix-dat", "CalculiX printed tables", ".dat", false, true}, false, recognise_dat, open_dat};
}

}  // namespace feelem
