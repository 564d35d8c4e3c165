// SPDX-License-Identifier: Apache-2.0
// The heads of a result file: which release wrote it, in which units, and where everything stands.
#pragma once

#include "read/ansys/rst_record.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::rst {

/// KAN of the result header.
enum class Analysis : std::int32_t {
    Static = 0,
    Buckling = 1,
    Modal = 2,
    Harmonic = 3,
    Transient = 4,
    TransientByModes = 5,
    HarmonicByModes = 6,
};

struct ResultHeader {
    std::string version;              ///< "24.2"
    std::string title;                ///< UTF-8.
    std::int32_t date = 0, time = 0;  ///< Of the run.
    std::int32_t units = -1;
    std::int32_t analysis = 0;     ///< Analysis, or a number that is none of it.
    std::size_t nodes = 0;         ///< In the solution: the table of nodes may hold more.
    std::size_t nodes_of_all = 0;  ///< Of all parts of a distributed run; 0 in old files.
    std::size_t elements = 0;
    std::size_t sets = 0;
    std::size_t set_table = 0;      ///< Length of half of the table of sets.
    std::int32_t sectors = 1;       ///< More than one: cyclic symmetry, one sector is in the file.
    std::int32_t sector_nodes = 0;  ///< Nodes of the base sector.
    std::int32_t sector_elements = 0;
    std::int32_t sector_system = 0;  ///< Coordinate system whose z axis is the axis of symmetry.
    bool is_complex = false;
    bool has_principal = false;  ///< Stresses are followed by S1 S2 S3 SINT SEQV.
    Word set_pointers = 0, times = 0, load_steps = 0, cyclic = 0, element_ids = 0, node_ids = 0, geometry = 0;
};

/// Throws Error when this is no result file that can be read.
ResultHeader read_header(const Records& records);

/// The item of a header, counted from 1 as Ansys' documents do; 0 behind its end (old, shorter headers).
std::int32_t item(const std::vector<std::int32_t>& header, std::size_t number);
/// A pointer in two items, the low one first.
Word pointer(const std::vector<std::int32_t>& header, std::size_t low, std::size_t high);

/// Names of quantities in the file's system of units; empty where it is not known.
struct Units {
    std::string_view length, force, stress, temperature, heat_flux, voltage, time;
};
Units units_of(std::int32_t code);

}  // namespace feelem::rst
