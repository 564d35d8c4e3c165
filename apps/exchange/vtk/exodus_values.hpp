// SPDX-License-Identifier: Apache-2.0
// Values at nodes of Exodus files without the attribute file_size, as meshio writes them: the Exodus library
// takes them for an older layout, finds nothing, and says nothing.
#pragma once

#include "vtk/vtk_readers.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace feelem::exchange {

class ExodusValues {
public:
    explicit ExodusValues(const std::string& path);
    ~ExodusValues();
    ExodusValues(const ExodusValues&) = delete;
    ExodusValues& operator=(const ExodusValues&) = delete;

    /// Replaces what the library gave for the nodes by what stands in the file. Nothing to do for other
    /// files.
    void put_into(std::vector<Leaf>& leaves, std::size_t step) const;

private:
    std::vector<std::string> names() const;
    void put(std::vector<Leaf>& leaves, std::size_t step, std::size_t variable, const std::string& name)
        const;

    int file_ = -1;  ///< netCDF's; -1: the library reads this one right.
};

}  // namespace feelem::exchange
