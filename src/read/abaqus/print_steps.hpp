// SPDX-License-Identifier: Apache-2.0
// Steps, increments and modes of Abaqus' .dat as its text goes on.
#pragma once

#include "feelem/result.hpp"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace feelem::printed {

class StepWalk {
public:
    /// Whether the line (without blanks at its ends) is about them.
    bool use(std::string_view text);
    /// The step that tables belong to by now; made when it is new.
    std::uint32_t index(std::vector<Step>& steps) const;
    /// Values of a steady-state response are complex, in a form that is not known.
    bool is_complex() const noexcept { return complex_; }

private:
    bool begin_step(std::string_view text);
    void begin_mode(std::string_view text);
    bool use_table_of_modes(std::string_view text);

    Step step_{0, 1, 1, StepKind::Other, 0, ""};
    bool is_mode_ = false, lists_modes_ = false, buckling_ = false, complex_ = false;
    std::map<std::int32_t, double> modes_;
};

}  // namespace feelem::printed
