// SPDX-License-Identifier: Apache-2.0
// Values at nodes of Exodus files without the attribute file_size, as meshio writes them: the Exodus library
// takes them for an older layout, finds nothing, and says nothing.
#pragma once

#include "vtk/netcdf_file.hpp"
#include "vtk/vtk_readers.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace feelem::exchange {

class ExodusValues {
public:
    explicit ExodusValues(const std::string& path);

    /// Replaces what the library gave for the nodes by what stands in the file. Nothing to do for other
    /// files.
    void put_into(std::vector<Leaf>& leaves, std::size_t step) const;

private:
    void put(std::vector<Leaf>& leaves, std::size_t step, std::size_t variable, const std::string& name)
        const;

    NetcdfFile file_;
    bool needed_ = false;  ///< Else the library reads this one right.
};

}  // namespace feelem::exchange
