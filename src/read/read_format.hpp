// SPDX-License-Identifier: Apache-2.0
// What a reader is: one row of the list in read_formats.cpp.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"

#include "feelem/read.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace feelem {

/// How sure a reader is that a file is its own. The surest reader gets the file; the earlier one on a tie.
enum class Likelihood : std::uint8_t {
    No,
    Maybe,  ///< Looks like it, but another reader may know better.
    Sure
};

/// What a reader is told besides its inputs.
struct ReadContext {
    const ReadOptions& options;
    /// The mesh of inputs that were opened before, or null. It outlives the source that is being opened:
    /// a source without elements of its own matches its ids against this one and returns it from mesh().
    const Mesh* mesh = nullptr;
    /// Opens what a deck includes (INCLUDE 'file'); null: includes cannot be had.
    IncludeFiles* includes = nullptr;
};

struct ReadFormat {
    ReadFormatInfo info;
    /// Listing formats get all their inputs at once (a node list, an element list and a result list are one
    /// model); others one source a file.
    bool many_inputs = false;
    /// Looks at head_of(input) only. Text is UTF-8 without a byte-order mark here, whatever the file has.
    Likelihood (*recognise)(const Input& input) = nullptr;
    /// Step::input counts within `inputs`. ModelSource::inputs() may be empty: open_model() knows them.
    /// Throws Error; never returns null.
    std::unique_ptr<ModelSource> (*open
    )(std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics) = nullptr;
};

/// All readers. Sources are opened in this order, so readers that bring a mesh come first.
std::span<const ReadFormat> read_format_list();

/// The bytes that recognise() may look at.
std::string_view head_of(const Input& input);

}  // namespace feelem
