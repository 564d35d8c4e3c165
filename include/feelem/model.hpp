// SPDX-License-Identifier: Apache-2.0
// What a reader hands over: the mesh, the list of steps and results, and values on demand.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace feelem {

/// A file the model was read from, as `info` and the certificate name it.
struct InputRecord {
    std::string path;
    std::string format;  ///< Id of the reader: "calculix-frd".
    std::uint64_t bytes = 0;
    std::string sha256;  ///< Lower-case hex; empty: none was made (ReadOptions::hash_inputs).
};

struct SolverInfo {
    std::string name;  ///< "CalculiX", "Ansys"; empty = unknown.
    std::string version;
};

/// The only virtual class of the core: results can be far larger than memory.
class ModelSource {
public:
    virtual ~ModelSource() = default;
    virtual const Mesh& mesh() const = 0;
    virtual std::span<const Step> steps() const = 0;
    virtual std::span<const ResultInfo> results() const = 0;
    /// Values of results()[index]: the costly part, one at a time. Throws Error on a damaged block.
    virtual Result load(std::size_t index) = 0;
    virtual std::span<const InputRecord> inputs() const = 0;
    virtual SolverInfo solver() const { return {}; }
    virtual std::string title() const { return {}; }
};

}  // namespace feelem
