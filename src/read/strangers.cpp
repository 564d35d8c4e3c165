// SPDX-License-Identifier: Apache-2.0
#include "read/strangers.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"
#include "read/read_format.hpp"

#include <string>

namespace feelem {
namespace {

std::string lower_head(const Input& input) {
    constexpr std::size_t kEnough = 2000;
    return lower_case(head_of(input).substr(0, kEnough));
}

bool is_tecplot(std::string_view head) {
    if (head.starts_with("#!tdv")) return true;
    const std::string_view start = trim(head);
    const bool begins =
        start.starts_with("title") || start.starts_with("variables") || start.starts_with("zone");
    return begins && head.find("variables") != std::string_view::npos &&
           head.find("zone") != std::string_view::npos;
}

}  // namespace

std::string_view advice_for(const Input& input) {
    const std::string head = lower_head(input);
    if (head.find("<xdmf") != std::string::npos) {
        return "this is an XDMF file, which is not read. ParaView opens it: File > Save Data as .vtu keeps "
               "mesh and results; or run: meshio convert FILE.xdmf FILE.vtu";
    }
    if (is_tecplot(head)) {
        return "this is a Tecplot file, which is not read. ParaView opens it (Tecplot reader): File > Save "
               "Data as .vtu keeps mesh and results";
    }
    if (head.starts_with("\x89hdf\r\n\x1a\n")) {
        return "this is an HDF5 file of a kind that is not read (MED, Exodus and CGNS are). If it is the "
               "data of "
               "an .xdmf file, ParaView opens that: File > Save Data as .vtu keeps mesh and results";
    }
    return {};
}

}  // namespace feelem
