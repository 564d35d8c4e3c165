// SPDX-License-Identifier: Apache-2.0
// The mesh of a MED file.
#pragma once

#include "med/hdf5_file.hpp"
#include "read/exchange/neutral_form.hpp"

#include <map>
#include <string>

namespace feelem::exchange {

/// The elements of one type in a file: where they stand in the model's list.
struct MedBlock {
    std::size_t first = 0, count = 0;
};

struct MedMesh {
    std::string name;
    std::map<std::string, MedBlock, std::less<>> blocks;  ///< By MED's name of the type.
    std::size_t nodes = 0, elements = 0;
};

/// The first mesh of the file. Throws std::runtime_error.
MedMesh read_med_mesh(const Hdf5File& file, NeutralModel& model);

}  // namespace feelem::exchange
