// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_contents.hpp"

#include "read/nastran/op2_steps.hpp"
#include "read/nastran/op2_unused.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace feelem::op2 {
namespace {

/// Tables of results: O..., and B... for those in the basic system. All others hold the deck.
bool is_result_table(const Table& table) {
    return !table.matrix && (table.name.starts_with('O') || table.name.starts_with("BO"));
}

constexpr int kMpcForceCode = 39;

class Lister {
public:
    Lister(const Input& input, const Layout& layout, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics) {}

    Contents list() {
        for (const Table& table : layout_.tables) {
            if (is_result_table(table)) list_table(table);
        }
        unused_.report(input_.name(), diagnostics_);
        read_frequencies();
        contents_.steps = steps_.finish();
        leave_out_twins();
        for (const NodalBlock& block : contents_.nodal) {
            const auto kind = nodal_kind(block.ident);
            if (kind) list_nodal(block, *kind);
        }
        for (const ElementResult& result : elements_.finish()) list_element(result);
        return std::move(contents_);
    }

private:
    /// LAMA: mode, order, eigenvalue, radians and cycles a second, mass, stiffness. For modes of tables that
    /// are sorted by node.
    void read_frequencies() {
        constexpr std::size_t kModeWords = 7;
        for (const Table& table : layout_.tables) {
            if (table.name != "LAMA" || table.last_record < table.first_record + 2) continue;
            if (layout_.record_bytes(table.first_record + 1) % (kModeWords * layout_.form.size) != 0)
                continue;
            for_each_row(input_, layout_, table.first_record + 1, kModeWords, [&](const Words& row) {
                steps_.set_frequency(row.integer(0), row.real(4));
            });
        }
    }

    /// Idents and data take turns; a block without data has its ident alone.
    void list_table(const Table& table) {
        by_node_.clear();
        by_element_.clear();
        for (std::size_t i = table.first_record; i < table.last_record; ++i) {
            const auto ident = read_ident(record_head(input_, layout_, i, kIdentWords + 1, scratch_));
            if (!ident) {
                report_unused(table.name + " holds records that Feelem does not use");
                continue;
            }
            const bool has_data = i + 1 < table.last_record;
            if (!has_data || layout_.record_bytes(i + 1) == 0) {
                diagnostics_.add(
                    Code::EmptyResult, input_.name(), table.name + " has a block without values"
                );
                continue;
            }
            const Words texts = record_words(input_, layout_, i, scratch_);
            ++i;
            // OGSTR1 are strains at grid points.
            if (nodal_kind(*ident) && !table.name.starts_with("OGSTR")) {
                list_block(table, *ident, texts, i);
            } else if (element_layout(*ident) != nullptr) {
                collect_elements(table, *ident, texts, i);
            } else {
                unused_.add(table.name, *ident);
            }
        }
    }

    void report_unused(std::string text) {
        diagnostics_.add(Code::UnknownBlock, input_.name(), std::move(text));
    }

    void list_block(const Table& table, Ident ident, const Words& ident_words, std::size_t record) {
        // NX gives the forces of multipoint constraints the code of those of single-point ones.
        if (table.name.starts_with("OQM")) ident.table_code = kMpcForceCode;
        const Texts texts = read_texts(ident_words);
        if (contents_.title.empty()) contents_.title = texts.title;
        if (ident.sort2) {
            list_sorted_by_node(table, ident, texts, record);
            return;
        }
        NodalBlock block{ident, step_of(ident), table.name, record, nullptr, 0};
        if (is_written_before(block)) return;
        steps_.add(block.step, value_of(ident, block.step), texts);
        contents_.nodal.push_back(std::move(block));
    }

    /// Some runs write a table twice, byte for byte.
    bool is_written_before(const NodalBlock& block) {
        const auto key = std::tuple(block.table, block.ident.table_code, block.step);
        const auto [found, is_new] = written_.try_emplace(key, block.record);
        if (is_new || layout_.record_bytes(found->second) != layout_.record_bytes(block.record)) return false;
        std::vector<std::byte> scratch;
        const Words before = record_words(input_, layout_, found->second, scratch);
        const Words now = record_words(input_, layout_, block.record, scratch_);
        return std::ranges::equal(before.bytes(), now.bytes());
    }

    /// The longest rows of a node or element say which steps there are: calls each(step, row) for new ones.
    template <class Group, class Each>
    void add_sorted(
        Group& group, const Table& table, const Ident& ident, std::size_t record, const Each& each
    ) {
        constexpr std::size_t kMostSteps = 100000;
        if (layout_.record_bytes(record) <= group.longest) return;
        group.longest = layout_.record_bytes(record);
        const Words words = record_words(input_, layout_, record, scratch_);
        for (std::size_t at = 0; at + ident.row_words <= words.count(); at += ident.row_words) {
            const StepKey step = step_of_row(ident, words.part(at, ident.row_words));
            if (group.steps.size() >= kMostSteps) {
                report_unused(table.name + " has more steps than Feelem takes");
                return;
            }
            if (group.steps.insert(step).second) each(step, at / ident.row_words);
        }
    }

    void list_sorted_by_node(const Table& table, const Ident& ident, const Texts& texts, std::size_t record) {
        NodeGroup& group = by_node_[{ident.subcase, ident.approach, ident.table_code, ident.row_words}];
        if (group.records == nullptr) group.records = std::make_shared<std::vector<SortedRecord>>();
        group.records->push_back({ident.integer5 / 10, record});
        add_sorted(group, table, ident, record, [&](const StepKey& step, std::size_t row) {
            steps_.add(step, step.value, texts);
            contents_.nodal.push_back({ident, step, table.name, 0, group.records, row});
        });
    }

    /// Heat transfer runs list everything twice, by step and by node: the first way is quicker to read.
    void leave_out_twins() {
        const auto key = [](const NodalBlock& block) {
            return std::tuple(block.ident.table_code, block.ident.row_words, block.is_basic(), block.step);
        };
        std::map<decltype(key(NodalBlock{})), std::uint64_t> rows;
        for (const NodalBlock& block : contents_.nodal) {
            if (!block.ident.sort2) rows[key(block)] = row_count(layout_, block);
        }
        const auto is_twin = [&](const NodalBlock& block) {
            const auto found = rows.find(key(block));
            const bool twin =
                block.ident.sort2 && found != rows.end() && found->second == row_count(layout_, block);
            if (twin) report_unused(block.table + " lists by node what another table lists by step");
            return twin;
        };
        std::erase_if(contents_.nodal, is_twin);
    }

    void collect_elements(
        const Table& table, const Ident& ident, const Words& ident_words, std::size_t record
    ) {
        const Texts texts = read_texts(ident_words);
        if (contents_.title.empty()) contents_.title = texts.title;
        constexpr int kMagnitudeAndPhase = 3;
        ElementGroups::Block block{
            table.name,
            {},
            block_kind(ident, table.name, layout_.version),
            ident.format == kMagnitudeAndPhase};
        const ElementLayout* layout = element_layout(ident);
        if (layout->shape == RowShape::Ply) {
            const std::set<std::int64_t>& plies = plies_of(table.name, ident, record);
            block.plies.assign(plies.begin(), plies.end());
            if (plies.empty()) {
                unused_.add(table.name, ident);
                return;
            }
        }
        if (!ident.sort2) {
            block.step = step_of(ident);
            steps_.add(block.step, value_of(ident, block.step), texts);
            elements_.add(block, {layout, record, nullptr, 0});
            return;
        }
        ElementGroup& group = by_element_[{ident.subcase, ident.approach, layout, ident.stress_bits}];
        if (group.records == nullptr) {
            group.records = std::make_shared<ElementRecords>();
            group.records->ident = ident;
        }
        group.records->records.push_back({ident.integer5 / 10, record});
        add_sorted(group, table, ident, record, [&](const StepKey& step, std::size_t row) {
            block.step = step;
            steps_.add(step, step.value, texts);
            elements_.add(block, {layout, 0, group.records, row});
        });
    }

    /// The plies of the first block of a type: those after it in its subcase have the same.
    const std::set<std::int64_t>& plies_of(const std::string& table, const Ident& ident, std::size_t record) {
        constexpr std::size_t kMostPlies = 1000;
        const auto entry = plies_.try_emplace({table, ident.element_type, ident.subcase});
        std::set<std::int64_t>& plies = entry.first->second;
        if (!entry.second) return plies;
        for_each_row(input_, layout_, record, ident.row_words, [&](const Words& row) {
            const std::int64_t ply = row.integer(1);
            if (ply > 0 && plies.size() < kMostPlies) plies.insert(ply);
        });
        return plies;
    }

    void list_element(const ElementResult& result) {
        Listed listed;
        listed.of_elements = true;
        listed.block = contents_.elements.size();
        listed.info = element_info(result);
        listed.info.step = steps_.index_of(result.step);
        listed.info.name = names_.unique(listed.info, listed.info.name);
        contents_.elements.push_back(result);
        contents_.results.push_back(std::move(listed));
    }

    void list_nodal(const NodalBlock& block, const NodalKind& kind) {
        const auto index = static_cast<std::size_t>(&block - contents_.nodal.data());
        if (kind.is_stress) {
            list_grid_stress(index, kind);
            return;
        }
        const bool is_scalar = kind.rotation.empty();
        constexpr std::size_t kDegrees = 6;
        for (std::size_t part = 0; part < (block.is_complex() ? 2U : 1U); ++part) {
            add(index, kind.name, part * kDegrees, part, is_scalar);
        }
        if (is_scalar) return;
        for (std::size_t part = 0; part < (block.is_complex() ? 2U : 1U); ++part) {
            add(index, kind.rotation, part * kDegrees + 3, part, false);
        }
    }

    /// Averaged by the solver. The tensor counts where it is in the basic system.
    void list_grid_stress(std::size_t index, const NodalKind& kind) {
        constexpr int kBasicSystem = 3;
        const NodalBlock& block = contents_.nodal[index];
        Listed listed;
        listed.block = index;
        ResultInfo& info = listed.info;
        info.solver_name = block.table;
        info.step = steps_.index_of(block.step);
        info.averaging = Averaging::Solver;
        if (block.ident.output_system == kBasicSystem) {
            info.shape = Shape::SymmetricTensor;
            info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        } else {
            info.shape = Shape::Other;
            listed.first = 6;
        }
        info.components.emplace_back("mean_pressure");
        info.components.emplace_back(block.ident.stress_bits % 2 != 0 ? "von_mises" : "octahedral_shear");
        info.name = names_.unique(info, kind.name);
        contents_.results.push_back(std::move(listed));
    }

    void add(std::size_t index, std::string_view name, std::size_t first, std::size_t part, bool is_scalar) {
        const NodalBlock& block = contents_.nodal[index];
        Listed listed;
        listed.block = index;
        listed.first = first;
        ResultInfo& info = listed.info;
        info.solver_name = block.table;
        info.step = steps_.index_of(block.step);
        info.location = Location::Nodal;
        info.shape = is_scalar ? Shape::Scalar : Shape::Vector;
        info.components =
            is_scalar ? std::vector<std::string>{"value"} : std::vector<std::string>{"x", "y", "z"};
        constexpr int kMagnitudeAndPhase = 3;
        if (block.is_complex()) {
            const bool polar = block.ident.format == kMagnitudeAndPhase;
            info.complex = part == 0 ? (polar ? Complex::Amplitude : Complex::Real)
                                     : (polar ? Complex::Phase : Complex::Imaginary);
        }
        info.name = names_.unique(info, name);
        contents_.results.push_back(std::move(listed));
    }

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    Contents contents_;
    StepList steps_;
    struct NodeGroup {
        std::shared_ptr<std::vector<SortedRecord>> records;
        std::set<StepKey> steps;
        std::size_t longest = 0;  ///< Bytes of a node's rows.
    };
    std::map<std::tuple<std::int32_t, int, int, std::size_t>, NodeGroup> by_node_;
    struct ElementGroup {
        std::shared_ptr<ElementRecords> records;
        std::set<StepKey> steps;
        std::size_t longest = 0;
    };
    std::map<std::tuple<std::int32_t, int, const ElementLayout*, int>, ElementGroup> by_element_;
    std::map<std::tuple<std::string, std::int64_t, std::int32_t>, std::set<std::int64_t>> plies_;
    ElementGroups elements_;
    UnusedBlocks unused_;
    ResultNames names_;
    std::map<std::tuple<std::string, int, StepKey>, std::size_t> written_;
    std::vector<std::byte> scratch_;
};

}  // namespace

Contents list_contents(const Input& input, const Layout& layout, Diagnostics& diagnostics) {
    return Lister(input, layout, diagnostics).list();
}

}  // namespace feelem::op2
