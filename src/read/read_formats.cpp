// SPDX-License-Identifier: Apache-2.0
// The list of readers: a new one is a folder beside this file and one line here.
#include "read/abaqus/abaqus_dat.hpp"
#include "read/abaqus/abaqus_deck.hpp"
#include "read/abaqus/abaqus_fil.hpp"
#include "read/ansys/ansys_cdb.hpp"
#include "read/ansys/ansys_lists.hpp"
#include "read/ansys/ansys_rst.hpp"
#include "read/calculix/calculix_dat.hpp"
#include "read/calculix/calculix_frd.hpp"
#include "read/exchange/exchange_formats.hpp"
#include "read/gmsh/gmsh_format.hpp"
#include "read/nastran/nastran_bulk.hpp"
#include "read/nastran/nastran_f06.hpp"
#include "read/nastran/nastran_op2.hpp"
#include "read/nastran/nastran_punch.hpp"
#include "read/read_format.hpp"
#include "read/unv/unv_format.hpp"

#include <vector>

namespace feelem {

std::span<const ReadFormat> read_format_list() {
    // One a line: several people add to it.
    // clang-format off
    static const std::vector<ReadFormat> list{
        ansys_rst_format(),
        calculix_frd_format(),
        ansys_cdb_format(),
        unv_format(),
        abaqus_deck_format(),
        abaqus_fil_format(),
        abaqus_dat_format(),
        ansys_lists_format(),
        nastran_bulk_format(),
        nastran_op2_format(),
        nastran_punch_format(),
        nastran_f06_format(),
        calculix_dat_format(),
        gmsh_msh_format(),
        vtk_legacy_format(),
        vtk_xml_format(),
        pvd_format(),
        exodus_format(),
        ensight_format(),
        cgns_format(),
        med_format(),
        lsdyna_d3plot_format(),
    };
    // clang-format on
    return list;
}

std::vector<ReadFormatInfo> read_formats() {
    std::vector<ReadFormatInfo> infos;
    for (const ReadFormat& format : read_format_list()) infos.push_back(format.info);
    return infos;
}

std::string_view head_of(const Input& input) {
    constexpr std::size_t kHead = 64u << 10;
    return input.text().substr(0, kHead);
}

}  // namespace feelem
