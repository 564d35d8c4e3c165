// SPDX-License-Identifier: Apache-2.0
// One result file as a ModelSource: heads are read on opening, values on demand.
#pragma once

#include "read/ansys/rst_beams.hpp"
#include "read/ansys/rst_element.hpp"
#include "read/ansys/rst_energies.hpp"
#include "read/ansys/rst_header.hpp"
#include "read/ansys/rst_mesh.hpp"
#include "read/ansys/rst_nodal.hpp"
#include "read/ansys/rst_steps.hpp"

#include "feelem/model.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace feelem::rst {

class RstSource : public ModelSource {
public:
    RstSource(Input input, Diagnostics& diagnostics);

    const Mesh& mesh() const override { return file_mesh_.mesh; }
    std::span<const Step> steps() const override { return sets_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return {"Ansys", header_.version}; }
    std::string title() const override { return header_.title; }
    Result load(std::size_t index) override;

    const Records& records() const noexcept { return records_; }
    const ResultHeader& header() const noexcept { return header_; }
    const ResultSets& sets() const noexcept { return sets_; }

private:
    enum class Group : std::uint8_t {
        Nodal,
        Element,
        Beam,
        Energy
    };
    /// A result by its group and place there.
    struct Listed {
        Group group = Group::Nodal;
        std::size_t place = 0;
    };

    void find_row_nodes();
    void list_results();
    void make_unique(ResultInfo& info);
    void note_averages();
    const ResultInfo& info_of(const Listed& listed) const;
    ElementSource element_source() const { return {records_, header_, file_mesh_, element_order_}; }
    Result load_nodal(std::size_t index);
    ElementValues load_of_elements(const Listed& listed) const;
    void report(std::size_t index, std::uint64_t without_node, std::uint64_t without_number);
    void report_elements(std::size_t index, std::uint64_t not_understood);

    Records records_;
    Diagnostics& diagnostics_;
    ResultHeader header_;
    FileMesh file_mesh_;
    ResultSets sets_;
    std::vector<NodeIndex> row_nodes_;
    std::vector<ResultInfo> infos_;
    std::vector<Listed> listed_;
    std::vector<NodalResult> nodal_;
    std::vector<ElementResult> elements_;
    std::vector<BeamResult> beams_;
    std::vector<EnergyResult> energies_;
    std::vector<std::uint32_t> element_order_;
    std::vector<bool> reported_;
    std::map<std::tuple<std::uint32_t, Layer, Complex, std::string>, int> names_;
};

}  // namespace feelem::rst
