// SPDX-License-Identifier: Apache-2.0
// Colour differences as people see them: CIE Lab, CIEDE2000, and vision without one kind of cone.
#pragma once

#include "feelem/present.hpp"

#include <array>

namespace feelem::test {

using Lab = std::array<double, 3>;

/// Machado, Oliveira, Fernandes 2009, severity 1.
enum class Vision {
    Normal,
    Protan,
    Deutan,
    Tritan
};
inline constexpr std::array<Vision, 4> kVisions{
    Vision::Normal, Vision::Protan, Vision::Deutan, Vision::Tritan};

Lab lab_of(const Rgb& colour, Vision vision = Vision::Normal);
/// CIEDE2000 (Sharma, Wu, Dalal 2005).
double difference(const Lab& first, const Lab& second);

}  // namespace feelem::test
