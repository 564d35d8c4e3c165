// SPDX-License-Identifier: Apache-2.0
// Files of one model in, one ModelSource out; recognised by content.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

struct ReadOptions {
    std::string from;            ///< Force a reader by id; empty: by content.
    std::string types;           ///< "1=SOLID92,2=SHELL63" or the path of an ETLIST listing.
    bool expand_cyclic = false;  ///< Show all sectors of a cyclic model, where the file says how.
    bool hash_inputs = true;     ///< InputRecord::sha256 needs every byte of every input; else it is empty.
    bool hash_early = false;     ///< All digests will be asked for: makes them while the inputs are read.
};

/// A kind of file that can be read, for `feelem formats` and the docs.
struct ReadFormatInfo {
    std::string_view id;        ///< "calculix-frd"
    std::string_view title;     ///< "CalculiX results"
    std::string_view suffixes;  ///< ".frd"
    bool has_mesh = false;
    bool has_results = false;
};
std::vector<ReadFormatInfo> read_formats();

/// Opens the files (or folders) of one model. Throws Error when none can be used. `diagnostics` must outlive
/// the model: load() reports there, once a result, what only the values show (NaN, unknown nodes).
std::unique_ptr<ModelSource> open_model(
    std::span<const std::string> paths, const ReadOptions& options, Diagnostics& diagnostics
);

/// The same from bytes in memory (tests, fuzzing, and later the browser). Names are for messages.
struct NamedBytes {
    std::string name;
    std::string bytes;
};
std::unique_ptr<ModelSource> open_model(
    std::vector<NamedBytes> files, const ReadOptions& options, Diagnostics& diagnostics
);

}  // namespace feelem
