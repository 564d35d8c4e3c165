// SPDX-License-Identifier: Apache-2.0
// Names of results in exchange files, which every program chooses for itself -> Feelem's.
#pragma once

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace feelem {

/// Lower case without blanks at the ends; "unnamed" when nothing is left.
std::string lower_name(std::string_view label);

/// Our name of a label that programs commonly use (TEMP, DISP, disp_, S_Mises keeps its own), else the label
/// in lower case. `components`: a label is only taken for what has as many (a displacement has three).
std::string common_name(std::string_view label, std::size_t components);

/// How many numbers stand for a tensor, and in which order.
enum class TensorOrder : std::uint8_t {
    Vtk,   ///< Six: xx yy zz xy yz xz. Nine: row by row.
    Med,   ///< Six: xx yy zz xy xz yz.
    Ideas  ///< Six: xx xy yy xz yz zz. Nine: column by column.
};

/// Sets shape and component names of a result of `count` numbers; returns for each component the place of its
/// number in the file. Two numbers are the first two of a vector. Of nine, the six of a symmetric tensor come
/// first and the other three after them: nothing is lost should the tensor not be symmetric.
std::vector<std::uint32_t> name_components(ResultInfo& info, std::size_t count, TensorOrder order);

/// Sees to it that no two results of a step have the same name, layer and complex part.
class ResultNames {
public:
    void make_unique(ResultInfo& info);

private:
    std::set<std::tuple<std::uint32_t, Layer, Complex, std::string>> taken_;
};

}  // namespace feelem
