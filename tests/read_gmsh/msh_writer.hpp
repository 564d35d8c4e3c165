// SPDX-License-Identifier: Apache-2.0
// Tiny .msh files in every version and coding, written independently of the reader.
#pragma once

#include <string>
#include <vector>

namespace feelem::test {

struct MshForm {
    int version = 41;  ///< 22, 40, 41
    bool binary = false;
    bool big_endian = false;
};

/// One element of gmsh's type with nodes 1.. at the given places, and a result "T" with value node + 0.25.
std::string write_msh(const MshForm& form, int type, const std::vector<std::vector<double>>& places);

}  // namespace feelem::test
