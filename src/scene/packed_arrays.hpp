// SPDX-License-Identifier: Apache-2.0
// Arrays as EXT_meshopt_compression packs them (vertex codec 0, index codec 1), and back.
#pragma once

#include "base/huge_pages.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace feelem {

/// `mode` of the extension.
enum class Packing : std::uint8_t {
    Attributes,  ///< Rows of a multiple of 4 bytes, each beside the one before.
    Triangles,   ///< Three indices each. The codec may turn a triangle's corners round.
    Indices      ///< Any list of indices.
};
/// `filter` of the extension.
enum class PackingFilter : std::uint8_t {
    None,
    Exponential  ///< float32 whose low bits are zero: 24 bits of mantissa and 8 of exponent a number.
};

/// How a bufferView is packed: the extension's keys.
struct PackedView {
    int buffer = 0;
    std::uint64_t offset = 0, bytes = 0;  ///< Of the packed bytes.
    std::uint64_t count = 0;
    std::uint64_t stride = 0;  ///< Bytes of an unpacked row: 2 or 4 for indices.
    Packing mode = Packing::Attributes;
    PackingFilter filter = PackingFilter::None;
};

std::string_view packing_word(Packing mode);                 ///< "ATTRIBUTES"
std::string_view packing_filter_word(PackingFilter filter);  ///< "EXPONENTIAL"

/// `rows`: count rows of `stride` bytes (a multiple of 4, at most 256).
std::vector<std::byte> pack_rows(std::span<const std::byte> rows, std::size_t stride);
/// Triangles: a multiple of three.
std::vector<std::byte> pack_indices(std::span<const std::uint32_t> indices, Packing mode);
/// `values` are whole multiples of `grid`, a power of two from 2^-100 to 2^100, below 2^23 times it: what the
/// exponential filter keeps bit for bit.
std::vector<std::uint32_t> with_one_exponent(std::span<const float> values, float grid);

/// The rows again; nothing when the bytes cannot be what `view` says (then no memory was taken for them).
std::optional<ZeroedArray<std::byte>> unpack(std::span<const std::byte> packed, const PackedView& view);

}  // namespace feelem
