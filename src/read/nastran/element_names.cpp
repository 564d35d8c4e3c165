// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/element_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace feelem::op2 {
namespace {

struct ElementTypeName {
    int type = 0;
    std::string_view name;
};

/// As the manuals of MSC Nastran and of NX Nastran number them, in ascending order.
constexpr ElementTypeName kElementTypeNames[]{
    {1, "CROD"},
    {2, "CBEAM"},
    {3, "CTUBE"},
    {4, "CSHEAR"},
    {10, "CONROD"},
    {11, "CELAS1"},
    {12, "CELAS2"},
    {13, "CELAS3"},
    {14, "CELAS4"},
    {17, "CTRIAX"},
    {18, "CQUADX"},
    {20, "CDAMP1"},
    {21, "CDAMP2"},
    {22, "CDAMP3"},
    {23, "CDAMP4"},
    {24, "CVISC"},
    {25, "CMASS1"},
    {26, "CMASS2"},
    {27, "CMASS3"},
    {28, "CMASS4"},
    {29, "CONM1"},
    {30, "CONM2"},
    {33, "CQUAD4"},
    {34, "CBAR"},
    {35, "CCONEAX"},
    {38, "CGAP"},
    {39, "CTETRA"},
    {40, "CBUSH1D"},
    {47, "CAXIF2"},
    {48, "CAXIF3"},
    {49, "CAXIF4"},
    {50, "CSLOT3"},
    {51, "CSLOT4"},
    {52, "CHBDY"},
    {53, "CTRIAX6"},
    {60, "CRAC2D"},
    {61, "CRAC3D"},
    {64, "CQUAD8"},
    {67, "CHEXA"},
    {68, "CPENTA"},
    {69, "CBEND"},
    {70, "CTRIAR with corners"},
    {74, "CTRIA3"},
    {75, "CTRIA6"},
    {82, "CQUADR with corners"},
    {85, "nonlinear CTETRA"},
    {86, "nonlinear CGAP"},
    {87, "nonlinear CTUBE"},
    {88, "nonlinear CTRIA3"},
    {89, "nonlinear CROD"},
    {90, "nonlinear CQUAD4"},
    {91, "nonlinear CPENTA"},
    {92, "nonlinear CONROD"},
    {93, "nonlinear CHEXA"},
    {94, "nonlinear CBEAM"},
    {95, "composite CQUAD4"},
    {96, "composite CQUAD8"},
    {97, "composite CTRIA3"},
    {98, "composite CTRIA6"},
    {100, "CBAR at intermediate stations"},
    {102, "CBUSH"},
    {103, "p-version quadrilateral"},
    {104, "p-version triangle"},
    {105, "p-version beam"},
    {106, "CDAMP5"},
    {107, "CHBDYE"},
    {108, "CHBDYG"},
    {109, "CHBDYP"},
    {110, "CONV"},
    {111, "CONVM"},
    {115, "RADBC"},
    {117, "CWELD (CWELDC)"},
    {118, "CWELD (CWELDP)"},
    {119, "CSEAM"},
    {126, "CFAST"},
    {139, "hyperelastic CQUAD4"},
    {140, "hyperelastic CHEXA"},
    {144, "CQUAD4 with corners"},
    {160, "hyperelastic CPENTA"},
    {161, "hyperelastic CTETRA"},
    {162, "hyperelastic CTRIA3"},
    {163, "hyperelastic CHEXA"},
    {164, "hyperelastic CQUAD8"},
    {165, "hyperelastic CPENTA"},
    {166, "hyperelastic CTETRA"},
    {167, "hyperelastic CTRIA6"},
    {168, "hyperelastic CTRIAX"},
    {169, "hyperelastic CTRIAX6"},
    {170, "hyperelastic CQUADX4"},
    {171, "hyperelastic CQUADX8"},
    {172, "nonlinear CQUADR"},
    {173, "nonlinear CTRIAR"},
    {184, "CBEAM3"},
    {189, "view quadrilateral"},
    {190, "view triangle"},
    {191, "view beam"},
    {200, "CWELD"},
    {224, "nonlinear CELAS1"},
    {225, "nonlinear CELAS3"},
    {226, "nonlinear CBUSH"},
    {227, "CTRIAR"},
    {228, "CQUADR"},
    {232, "composite CQUADR"},
    {233, "composite CTRIAR"},
    {238, "nonlinear CBAR"},
    {239, "nonlinear CBEAM"},
    {255, "CPYRAM"},
    {256, "nonlinear CPYRAM"},
    {269, "composite CHEXA"},
    {270, "composite CPENTA"},
};
static_assert(std::ranges::is_sorted(kElementTypeNames, {}, &ElementTypeName::type));

}  // namespace

std::string element_name(std::int64_t type) {
    const auto* const found = std::ranges::lower_bound(kElementTypeNames, type, {}, &ElementTypeName::type);
    if (found == std::end(kElementTypeNames) || found->type != type)
        return fmt::format("elements of type {}", type);
    return fmt::format("{} (type {})", found->name, type);
}

}  // namespace feelem::op2
