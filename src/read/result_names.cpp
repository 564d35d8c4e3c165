// SPDX-License-Identifier: Apache-2.0
#include "read/result_names.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace feelem {
namespace {

struct CommonName {
    std::string_view label;  ///< In lower case, without _ - and blanks.
    std::string_view ours;
    std::size_t components;
};
constexpr CommonName kCommonNames[]{
    {"displacement", "displacement", 3},
    {"displacements", "displacement", 3},
    {"disp", "displacement", 3},
    {"displ", "displacement", 3},
    {"u", "displacement", 3},
    {"depl", "displacement", 3},
    {"vite", "velocity", 3},
    {"acce", "acceleration", 3},
    {"reacnoda", "reaction_force", 3},
    {"fluxnoeu", "heat_flux", 3},
    {"sief", "stress", 6},
    {"siefnoeu", "stress", 6},
    {"sigm", "stress", 6},
    {"sigmnoeu", "stress", 6},
    {"epsinoeu", "strain", 6},
    {"deplacement", "displacement", 3},
    {"deflection", "displacement", 3},
    {"velocity", "velocity", 3},
    {"vel", "velocity", 3},
    {"velo", "velocity", 3},
    {"v", "velocity", 3},
    {"acceleration", "acceleration", 3},
    {"accel", "acceleration", 3},
    {"acc", "acceleration", 3},
    {"rotation", "rotation", 3},
    {"temperature", "temperature", 1},
    {"temp", "temperature", 1},
    {"ndtemp", "temperature", 1},
    {"t", "temperature", 1},
    {"heatflux", "heat_flux", 3},
    {"flux", "heat_flux", 3},
    {"hflux", "heat_flux", 3},
    {"stress", "stress", 6},
    {"s", "stress", 6},
    {"sigma", "stress", 6},
    {"cauchystress", "stress", 6},
    {"stress", "stress", 9},
    {"strain", "strain", 6},
    {"strain", "strain", 9},
    {"reactionforce", "reaction_force", 3},
    {"rf", "reaction_force", 3},
    {"pressure", "pressure", 1},
    {"thickness", "thickness", 1},
};

std::string without_separators(std::string_view label) {
    std::string out;
    for (const char c : lower_name(label)) {
        if (c != '_' && c != '-' && c != ' ') out += c;
    }
    return out;
}

constexpr std::array<std::string_view, 3> kVectorNames{"x", "y", "z"};
constexpr std::array<std::string_view, 9> kTensorNames{"xx", "yy", "zz", "xy", "yz", "zx", "yx", "zy", "xz"};
/// Places of the numbers of kTensorNames in the file.
std::vector<std::uint32_t> tensor_places(std::size_t count, TensorOrder order) {
    if (count == 9) {
        if (order == TensorOrder::Ideas) return {0, 4, 8, 3, 7, 2, 1, 5, 6};
        return {0, 4, 8, 1, 5, 6, 3, 7, 2};
    }
    switch (order) {
    case TensorOrder::Vtk: break;
    case TensorOrder::Med: return {0, 1, 2, 3, 5, 4};
    case TensorOrder::Ideas: return {0, 2, 5, 1, 4, 3};
    }
    return {0, 1, 2, 3, 4, 5};
}

}  // namespace

std::string lower_name(std::string_view label) {
    std::string out = lower_case(trim(label));
    return out.empty() ? "unnamed" : out;
}

std::string common_name(std::string_view label, std::size_t components) {
    const std::string key = without_separators(label);
    for (const CommonName& name : kCommonNames) {
        if (name.label == key && name.components == components) return std::string(name.ours);
    }
    return lower_name(label);
}

std::vector<std::uint32_t> name_components(ResultInfo& info, std::size_t count, TensorOrder order) {
    if (count == 6 || count == 9) {
        info.shape = Shape::SymmetricTensor;
        info.components.assign(
            kTensorNames.begin(), kTensorNames.begin() + static_cast<std::ptrdiff_t>(count)
        );
        return tensor_places(count, order);
    }
    if (count == 1) {
        info.shape = Shape::Scalar;
        info.components = {"value"};
    } else if (count == 2 || count == 3) {
        info.shape = count == 3 ? Shape::Vector : Shape::Other;
        info.components.assign(
            kVectorNames.begin(), kVectorNames.begin() + static_cast<std::ptrdiff_t>(count)
        );
    } else {
        info.shape = Shape::Other;
        info.components.clear();
        for (std::size_t i = 0; i < count; ++i) info.components.push_back(fmt::format("c{}", i + 1));
    }
    std::vector<std::uint32_t> places(count);
    std::iota(places.begin(), places.end(), 0U);
    return places;
}

void ResultNames::make_unique(ResultInfo& info) {
    const std::string wanted = info.name;
    const auto take = [&] { return taken_.emplace(info.step, info.layer, info.complex, info.name).second; };
    if (take()) return;
    info.name = lower_name(info.solver_name);
    for (int number = 2; !take(); ++number) info.name = fmt::format("{}_{}", wanted, number);
}

}  // namespace feelem
