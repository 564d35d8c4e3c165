// SPDX-License-Identifier: Apache-2.0
// What a results file holds: its mesh, and where the values of each result are. Values are read on demand.
#pragma once

#include "read/abaqus/fil_records.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::fil {

/// Record 1, attribute 4.
enum class At : std::int64_t {
    Point = 0,
    Centroid = 1,
    ElementNodes = 2,
    Rebar = 3,
    Averaged = 4,
    Element = 5,
    Node = -1,  ///< Ours: records of nodes have no head.
};

/// Values under one key in one increment or mode, at one kind of place and section point.
struct Listed {
    ResultInfo info;
    std::int64_t key = 0;
    At at = At::Node;
    std::int64_t section_point = 0;
    std::size_t begin = 0, end = 0;     ///< Positions of the records of its step.
    std::vector<std::int32_t> columns;  ///< Component i is the record's value columns[i]; tensors: see below.
    bool is_tensor = false;             ///< columns[i] is a place in xx yy zz xy xz yz.
    std::size_t imaginary = 0;          ///< 1: second half of the values, 2: first half; 0: all.
};

/// Head of an element's values (record 1).
struct Head {
    std::int64_t id = 0, point = 0, section_point = 0;
    At at = At::Point;
    std::int64_t direct = 3, shear = 3;
};
Head read_head(const Record& record);

struct Contents {
    Mesh mesh;
    std::vector<Step> steps;
    std::vector<Listed> results;
    std::string title;
    SolverInfo solver;
    bool has_local_directions = false;  ///< Record 85.
};

/// One pass over the file. A damaged end is reported (TruncatedInput).
Contents read_contents(const Input& input, Coding coding, Diagnostics& diagnostics);

/// Value `place` (0.. of xx yy zz xy xz yz) of a tensor with so many direct and shear components; -1: none.
int tensor_word(const Head& head, int place);

/// Key of our own exporter's records: the part of the elements that follow, as text. Abaqus' keys end at
/// 2001.
inline constexpr std::int64_t kPartKey = 9001;

}  // namespace feelem::fil
