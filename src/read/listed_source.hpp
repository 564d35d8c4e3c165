// SPDX-License-Identifier: Apache-2.0
// What sources of one file have in common: a mesh that may be known already, results listed on opening,
// values on demand with notes once a result.
#pragma once

#include "base/input.hpp"
#include "read/read_format.hpp"

#include "feelem/model.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace feelem {

/// A result as a reader gives it, and what only its values show.
struct LoadedResult {
    Result result;
    std::uint64_t without_owner = 0;   ///< Rows whose node or element the mesh does not have.
    std::uint64_t without_number = 0;  ///< NaN or infinity in the file; missing here.
    std::uint64_t left_over = 0;       ///< Rows with more values than are read (shell layers).
};

class ListedSource : public ModelSource {
public:
    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    Result load(std::size_t index) override;

protected:
    ListedSource(Input input, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics) {}

    /// `own`; the mesh of an input before this one where that is the same, or `own` has no elements. Throws
    /// Error(NoNodes) with `hint` when there is neither.
    void set_mesh(Mesh own, const ReadContext& context, const std::string& hint);
    void set_contents(std::vector<Step> steps, std::vector<ResultInfo> infos);
    /// The values of results()[index].
    virtual LoadedResult read(std::size_t index) = 0;

    const Input& input() const noexcept { return input_; }

private:
    void report(const ResultInfo& info, const LoadedResult& loaded);

    Input input_;
    Diagnostics& diagnostics_;
    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    std::vector<Step> steps_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

/// Rows of an element-nodal result in the order of their elements.
void sort_rows_by_owner(Result& result);

}  // namespace feelem
