// SPDX-License-Identifier: Apache-2.0
// Formats that other people's libraries read in the helper program: VTK's own, Exodus, EnSight, CGNS,
// LS-DYNA's d3plot, MED. Only what their first bytes look like is known here.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat vtk_legacy_format();
ReadFormat vtk_xml_format();
ReadFormat pvd_format();
ReadFormat exodus_format();
ReadFormat ensight_format();
ReadFormat cgns_format();
ReadFormat lsdyna_d3plot_format();
ReadFormat med_format();

}  // namespace feelem
