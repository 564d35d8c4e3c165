// SPDX-License-Identifier: Apache-2.0
// The list of plain output formats: a new one is a file beside this one and one line here.
#include "feelem/write.hpp"

namespace feelem {

std::vector<WriteFormatInfo> write_formats() {
    return {
        {"ply", "the skin for other programs, text", ".ply"},
        {"vtu", "the whole mesh for ParaView and others that use VTK, binary", ".vtu"},
    };
}

}  // namespace feelem
