// SPDX-License-Identifier: Apache-2.0
// The table of element names: after formats-ansys' list; numbers are unique, so a number alone finds a row.
#include "read/ansys/ansys_elements.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

namespace feelem::ansys {
namespace {

struct Family {
    ElementKind kind;
    ElementType type;
    std::string_view names;  ///< Separated by single blanks.
};

using enum ElementKind;

constexpr std::array kFamilies{
    Family{
        Solid,
        ElementType::Hex8,
        "SOLID5 SOLID45 SOLID46 SOLID62 SOLID64 SOLID65 SOLID69 SOLID70 SOLID73 SOLID96 SOLID97 SOLID164 "
        "SOLID185 SOLSH190 SOLID225 SOLID278 FLUID30 FLUID80 FLUID142 CPT215 HYPER58 HYPER86 VISCO107"},
    Family{
        Solid,
        ElementType::Hex20,
        "SOLID90 SOLID95 SOLID117 SOLID122 SOLID128 SOLID147 SOLID186 SOLID191 SOLID226 SOLID231 SOLID236 "
        "SOLID239 SOLID279 FLUID220 CPT216 VISCO89 HF120"},
    Family{
        Solid,
        ElementType::Tet10,
        "SOLID87 SOLID92 SOLID98 SOLID123 SOLID127 SOLID148 SOLID168 SOLID187 SOLID227 SOLID232 SOLID237 "
        "SOLID240 SOLID291 FLUID221 CPT217 HF119"},
    Family{Solid, ElementType::Tet4, "SOLID72 SOLID285"},
    Family{
        Shell,
        ElementType::Quad4,
        "SHELL28 SHELL41 SHELL43 SHELL57 SHELL63 SHELL131 SHELL143 SHELL157 SHELL163 SHELL181"},
    Family{Shell, ElementType::Quad8, "SHELL91 SHELL93 SHELL99 SHELL132 SHELL150 SHELL281"},
    Family{
        Plane,
        ElementType::Quad4,
        "PLANE13 PLANE25 PLANE42 PLANE55 PLANE67 PLANE75 PLANE162 PLANE182 PLANE222 PLANE292 FLUID29 FLUID79 "
        "FLUID81 FLUID141 CPT212 HYPER56 VISCO106"},
    Family{
        Plane,
        ElementType::Quad8,
        "PLANE53 PLANE77 PLANE78 PLANE82 PLANE83 PLANE121 PLANE145 PLANE183 PLANE223 PLANE230 PLANE233 "
        "PLANE238 PLANE293 CPT213 HYPER74 VISCO88 VISCO108 HF118"},
    Family{Plane, ElementType::Tri6, "PLANE2 PLANE35 PLANE146"},
    Family{
        Line,
        ElementType::Line2,
        "LINK1 LINK8 LINK10 LINK11 LINK31 LINK32 LINK33 LINK34 LINK68 LINK160 LINK167 LINK180 BEAM3 BEAM4 "
        "BEAM23 BEAM24 BEAM44 BEAM54 BEAM161 BEAM188 PIPE16 PIPE18 PIPE20 PIPE59 PIPE60 PIPE288 FLUID116 "
        "SHELL51 SHELL61 SHELL208"},
    Family{Line, ElementType::Line3, "BEAM189 PIPE289 ELBOW290 CABLE280 SHELL209"},
    Family{MeshOnly, ElementType::Point1, "MESH200"},
    Family{Point, ElementType::Point1, "MASS21 MASS71 MASS166"},
    Family{
        Spring,
        ElementType::Point1,
        "COMBIN7 COMBIN14 COMBIN37 COMBIN39 COMBIN40 COMBI165 COMBI214 COMBI250 MATRIX27 MATRIX50 MPC184"},
    Family{
        Contact,
        ElementType::Point1,
        "CONTAC12 CONTAC26 CONTAC48 CONTAC49 CONTAC52 INTER115 TARGE169 TARGE170 CONTA171 CONTA172 CONTA173 "
        "CONTA174 CONTA175 CONTA176 CONTA177 CONTA178 PRETS179 INTER192 INTER193 INTER194 INTER195 INTER202 "
        "INTER203 INTER204 INTER205"},
    Family{
        SurfaceEffect,
        ElementType::Point1,
        "SURF19 SURF22 SURF151 SURF152 SURF153 SURF154 SURF155 SURF156 SURF159 SURF251 SURF252"},
    Family{Revolved, ElementType::Point1, "SOLID272 SOLID273"},
    Family{
        Other,
        ElementType::Point1,
        "INFIN9 SOURC36 FLUID38 INFIN47 CIRCU94 USER100 USER101 USER102 USER103 USER104 USER105 TRANS109 "
        "INFIN110 INFIN111 CIRCU124 CIRCU125 TRANS126 FLUID129 FLUID130 FLUID136 FLUID138 FLUID139 ROM144 "
        "FOLLW201 HSFLD241 HSFLD242 INFIN257 INFIN258 INFIN259 INFIN260 GLINK262 REINF263 REINF264 REINF265 "
        "USER300"},
};

/// KEYOPT(1) of MESH200.
constexpr std::array kMesh200{
    ElementType::Line2,
    ElementType::Line3,
    ElementType::Line2,
    ElementType::Line3,
    ElementType::Tri3,
    ElementType::Tri6,
    ElementType::Quad4,
    ElementType::Quad8,
    ElementType::Tet4,
    ElementType::Tet10,
    ElementType::Hex8,
    ElementType::Hex20,
};

/// The number at the end of a name, or -1.
int number_of(std::string_view name) {
    const std::size_t first = name.find_last_not_of("0123456789") + 1;
    int number = -1;
    std::from_chars(name.data() + first, name.data() + name.size(), number);
    return number;
}

bool is_number(std::string_view name) {
    return name.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::optional<ElementName> find_element(int number) {
    for (const Family& family : kFamilies) {
        for (std::size_t at = 0; at < family.names.size();) {
            const std::size_t end = std::min(family.names.find(' ', at), family.names.size());
            const std::string_view name = family.names.substr(at, end - at);
            if (number_of(name) == number) return ElementName{number, name, family.kind, family.type};
            at = end + 1;
        }
    }
    return std::nullopt;
}

std::optional<ElementName> find_element(std::string_view name) {
    name = trim(name);
    if (name.ends_with('.')) name.remove_suffix(1);  // A NOTE of the solver ends its sentence there.
    const auto found = find_element(number_of(name));
    if (!found || is_number(name)) return found;
    // Spellings differ in the end (COMBI214, COMBIN214), so two letters must do.
    const bool same = to_capital(name[0]) == found->name[0] && to_capital(name[1]) == found->name[1];
    return same ? found : std::nullopt;
}

bool is_drawn(ElementKind kind) {
    return kind == Solid || kind == Shell || kind == Plane || kind == Line || kind == MeshOnly;
}

std::optional<RowShape> shape_of_row(const ElementName& element, std::size_t count, int keyopt1) {
    if (!is_drawn(element.kind)) return std::nullopt;
    ElementType type = element.type;
    if (element.kind == MeshOnly) {
        if (keyopt1 < 0 || static_cast<std::size_t>(keyopt1) >= kMesh200.size()) return std::nullopt;
        type = kMesh200[static_cast<std::size_t>(keyopt1)];
    }
    // Eight-node 2-D elements are six-node triangles with KEYOPT(1)=1; a row of six without that says so too.
    if (type == ElementType::Quad8 && element.kind == Plane && (keyopt1 == 1 || count == 6))
        type = ElementType::Tri6;
    if ((type == ElementType::Quad4 || type == ElementType::Quad8) && count == 3) type = ElementType::Tri3;
    if (type == ElementType::Line3 && count == 2) type = ElementType::Line2;
    const ElementRow& row = element_row(type);
    if (count < row.corner_count) return std::nullopt;
    return RowShape{type, std::min<std::size_t>(count, row.node_count)};
}

}  // namespace feelem::ansys
