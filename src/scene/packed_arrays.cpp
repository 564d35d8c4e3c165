// SPDX-License-Identifier: Apache-2.0
#include "scene/packed_arrays.hpp"

#include "feelem/error.hpp"

#include <meshoptimizer.h>

#include <cmath>
#include <mutex>

namespace feelem {
namespace {

constexpr std::size_t kMostStride = 256;
/// The versions that the extension names, whichever the library would choose.
void choose_versions() {
    static std::once_flag once;
    std::call_once(once, [] {
        meshopt_encodeVertexVersion(0);
        meshopt_encodeIndexVersion(1);
    });
}

[[noreturn]] void refuse(const char* text) {
    throw Error(Code::BadStructure, "", text);
}

/// The smallest that the codecs make of so much: a count in a file is not believed beyond it.
bool may_hold(std::size_t packed, const PackedView& view) {
    constexpr std::uint64_t kRowsOfAHead = 64, kMostRows = 1ull << 40;
    if (view.count > kMostRows) return false;
    if (view.mode == Packing::Triangles) return view.count / 3 <= packed;
    if (view.mode == Packing::Indices) return view.count <= packed;
    // Of each byte of a row, one packed byte says how four groups of 16 rows are stored.
    return view.count / kRowsOfAHead * view.stride <= packed;
}

bool is_possible(const PackedView& view) {
    if (view.mode == Packing::Attributes)
        return view.stride > 0 && view.stride % 4 == 0 && view.stride <= kMostStride;
    const bool whole = view.mode == Packing::Indices || view.count % 3 == 0;
    return whole && (view.stride == 2 || view.stride == 4) && view.filter == PackingFilter::None;
}

}  // namespace

std::string_view packing_word(Packing mode) {
    if (mode == Packing::Triangles) return "TRIANGLES";
    return mode == Packing::Indices ? "INDICES" : "ATTRIBUTES";
}

std::string_view packing_filter_word(PackingFilter filter) {
    return filter == PackingFilter::None ? "NONE" : "EXPONENTIAL";
}

std::vector<std::byte> pack_rows(std::span<const std::byte> rows, std::size_t stride) {
    choose_versions();
    if (stride == 0 || stride % 4 != 0 || stride > kMostStride || rows.size() % stride != 0)
        refuse("rows to pack have a multiple of 4 bytes, at most 256");
    const std::size_t count = rows.size() / stride;
    std::vector<std::byte> out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(
        reinterpret_cast<unsigned char*>(out.data()), out.size(), rows.data(), count, stride
    ));
    return out;
}

std::vector<std::byte> pack_indices(std::span<const std::uint32_t> indices, Packing mode) {
    choose_versions();
    std::uint32_t most = 0;
    for (const std::uint32_t index : indices) most = index > most ? index : most;
    const std::size_t vertices = std::size_t{most} + 1;
    std::vector<std::byte> out;
    if (mode == Packing::Triangles) {
        if (indices.size() % 3 != 0) refuse("triangles have three corners");
        out.resize(meshopt_encodeIndexBufferBound(indices.size(), vertices));
        out.resize(meshopt_encodeIndexBuffer(
            reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(), indices.size()
        ));
    } else {
        out.resize(meshopt_encodeIndexSequenceBound(indices.size(), vertices));
        out.resize(meshopt_encodeIndexSequence(
            reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(), indices.size()
        ));
    }
    return out;
}

std::vector<std::uint32_t> with_one_exponent(std::span<const float> values, float grid) {
    const int exponent = std::ilogb(grid);
    std::vector<std::uint32_t> out;
    out.reserve(values.size());
    for (const float value : values) {
        const float scaled = std::ldexp(value, -exponent);
        const auto mantissa = static_cast<std::int32_t>(scaled);
        if (static_cast<float>(mantissa) != scaled || std::abs(mantissa) >= 1 << 23)
            refuse("a value is not on the grid that it is packed with");
        out.push_back(
            (static_cast<std::uint32_t>(mantissa) & 0xFFFFFFu) | static_cast<std::uint32_t>(exponent) << 24
        );
    }
    return out;
}

std::optional<ZeroedArray<std::byte>> unpack(std::span<const std::byte> packed, const PackedView& view) {
    if (!is_possible(view) || !may_hold(packed.size(), view)) return std::nullopt;
    const auto count = static_cast<std::size_t>(view.count), stride = static_cast<std::size_t>(view.stride);
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    ZeroedArray<std::byte> out(count * stride);
    int status = 0;
    switch (view.mode) {
    case Packing::Attributes:
        status = meshopt_decodeVertexBuffer(out.data(), count, stride, from, packed.size());
        break;
    case Packing::Triangles:
        status = meshopt_decodeIndexBuffer(out.data(), count, stride, from, packed.size());
        break;
    case Packing::Indices:
        status = meshopt_decodeIndexSequence(out.data(), count, stride, from, packed.size());
        break;
    }
    if (status != 0) return std::nullopt;
    // The library's own filter takes four rows at a time; numbers of four bytes make any count right.
    if (view.filter == PackingFilter::Exponential) meshopt_decodeFilterExp(out.data(), out.size() / 4, 4);
    return out;
}

}  // namespace feelem
