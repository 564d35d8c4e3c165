// SPDX-License-Identifier: Apache-2.0
// The blocks of a CalculiX .frd file: where they are and what their heads say. Bodies are skipped.
#pragma once

#include "base/input.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::frd {

/// How a body is written: the format digit of its head.
enum class Coding : std::uint8_t {
    Short,   ///< 0: text, ids in five columns.
    Long,    ///< 1: text, ids in ten columns.
    Float,   ///< 2: int32 and float32.
    Double,  ///< 3: int32 and float64.
};
inline bool is_text(Coding coding) {
    return coding == Coding::Short || coding == Coding::Long;
}
inline std::size_t id_width(Coding coding) {
    return coding == Coding::Short ? 5 : 10;
}

/// A run of records in the file. `count` is what the head says (text: what is there).
struct Body {
    std::size_t first = 0;
    std::size_t last = 0;
    std::uint64_t count = 0;
    Coding coding = Coding::Long;
};

/// A line that starts with " -5".
struct Component {
    std::string name;
    int kind = 0;  ///< 1 scalar, 2 vector, 4 tensor, 12 and 14 amplitudes and phases.
    int first_index = 0, second_index = 0;
};

/// What a "100C" line, the parameters before it and its "-4" and "-5" lines say. Components that are not
/// stored (iexist 1) are left out.
struct ResultBlock {
    Body body;
    std::string name;
    std::vector<Component> components;
    double value = 0;
    int analysis = 0;  ///< 0 static, 1 time, 2 frequency, 3 load step and others, 4 buckling.
    std::int32_t step = 1;
    std::int32_t mode = -1;       ///< 1PMODE; -1: none.
    std::int32_t diameter = -1;   ///< 1PHID, the nodal diameter of a cyclic mode; -1: none.
    std::int32_t load_step = -1;  ///< 1PSTEP.
    std::int32_t increment = -1;
};

struct Layout {
    Body nodes;
    Body elements;
    bool has_nodes = false;
    bool has_elements = false;
    bool swap = false;  ///< Binary, and the other byte order.
    std::vector<ResultBlock> results;
    SolverInfo solver;
    std::string title;
};

/// Throws Error(Truncated | BadStructure) when nodes or elements cannot be found whole. A result that the end
/// of the file cuts off is left out (TruncatedInput), as is one without values (EmptyResult).
Layout find_blocks(const Input& input, Diagnostics& diagnostics);

}  // namespace feelem::frd
