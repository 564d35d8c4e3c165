// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/fil_names.hpp"

#include <algorithm>
#include <array>

namespace feelem::fil {
namespace {

constexpr Shear kEngineering = Shear::Engineering;

constexpr auto kVariables = std::to_array<Variable>({
    {2, "TEMP", "temperature"},
    {5, "SDV", "sdv"},
    {9, "FV", "fv"},
    {11, "S", "stress", Form::Tensor},
    {12, "SINV", "sinv"},
    {13, "SF", "sf"},
    {14, "ENER", "ener"},
    {19, "ELEN", "elen"},
    {21, "E", "strain", Form::Tensor, kEngineering},
    {22, "PE", "plastic_strain", Form::Tensor, kEngineering},
    {23, "CE", "creep_strain", Form::Tensor, kEngineering},
    {24, "IE", "inelastic_strain", Form::Tensor, kEngineering},
    {25, "EE", "elastic_strain", Form::Tensor, kEngineering},
    {28, "HFL", "heat_flux", Form::Vector},
    {29, "SE", "section_strain"},
    {73, "PEEQ", "peeq"},
    {75, "MISES", "mises"},
    {88, "THE", "thermal_strain", Form::Tensor, kEngineering},
    {89, "LE", "logarithmic_strain", Form::Tensor, kEngineering},
    {90, "NE", "nominal_strain", Form::Tensor, kEngineering},
    {101, "U", "displacement", Form::Dofs},
    {102, "V", "velocity", Form::Dofs},
    {103, "A", "acceleration", Form::Dofs},
    {104, "RF", "reaction_force", Form::Dofs},
    {105, "EPOT", "electric_potential"},
    {106, "CF", "concentrated_force", Form::Dofs},
    {108, "POR", "pore_pressure"},
    {201, "NT", "temperature"},
    {204, "RFL", "reaction_flux"},
    {206, "CFL", "concentrated_flux"},
});

}  // namespace

const Variable* find_variable(std::int64_t key) {
    const auto* found = std::ranges::find(kVariables, key, &Variable::key);
    return found == kVariables.end() ? nullptr : found;
}

const Variable* find_variable(std::string_view solver) {
    const auto* found = std::ranges::find(kVariables, solver, &Variable::solver);
    return found == kVariables.end() ? nullptr : found;
}

}  // namespace feelem::fil
