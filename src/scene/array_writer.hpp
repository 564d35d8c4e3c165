// SPDX-License-Identifier: Apache-2.0
// Arrays streamed into the buffers of a scene: one bufferView and one named accessor each, with bounds and
// digest made on the way.
#pragma once

#include "base/sha256.hpp"
#include "scene/gltf.hpp"
#include "scene/scratch_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace feelem {

struct Digest {
    std::string accessor;
    std::string sha256;
};

struct ArraySpec {
    std::string name;
    unsigned components = 1;
    std::uint64_t count = 0;
    int target = 0;
    bool bounds = true;     ///< min and max in the accessor.
    bool of_lines = false;  ///< Indices: ends of lines, not corners of triangles.
    /// Floats are rounded to whole multiples of this power of two; 0: written as they are.
    float grid = 0;
    std::optional<gltf::Steps> steps{};  ///< Floats that stand on these steps are stored as their numbers.
};

/// One array after the other, into any buffer of the document. Memory: one block, or one array when packed.
class ArrayWriter {
public:
    explicit ArrayWriter(gltf::Document& document) : document_(&document) {}

    /// From now on arrays are packed by EXT_meshopt_compression.
    void pack() noexcept { packs_ = true; }
    bool packs() const noexcept { return packs_; }

    /// Later arrays go to this buffer (one of document.buffers).
    void direct_to(int buffer, ScratchFile& file) {
        buffer_ = buffer;
        file_ = &file;
    }
    /// fill(row, float* out) gives each row. Returns the accessor's index.
    template <class Fill>
    int floats(const ArraySpec& spec, const Fill& fill) {
        begin(spec, spec.steps ? gltf::kUnsignedInt : gltf::kFloat);
        std::array<float, 3> row{};
        for (std::uint64_t i = 0; i < spec.count; ++i) {
            fill(static_cast<std::size_t>(i), row.data());
            for (unsigned c = 0; c < spec.components; ++c) {
                if (spec.grid > 0) row[c] = gltf::on_grid(static_cast<double>(row[c]), spec.grid);
                // Bounds count -0 as 0: both compare equal, and JSON readers differ on -0.
                low_[c] = std::min(low_[c], row[c]);
                high_[c] = std::max(high_[c], row[c]);
            }
            if (spec.steps)
                put_steps(std::span(row).first(spec.components), *spec.steps);
            else
                put(row.data(), sizeof(float) * spec.components);
        }
        return end(spec, Packing::Attributes);
    }
    /// fill(row) gives an unsigned number; as shorts when `most` allows it (65535 is the restart value).
    template <class Fill>
    int indices(const ArraySpec& spec, std::uint32_t most, const Fill& fill) {
        const bool is_short = most < 65535;
        begin(spec, is_short ? gltf::kUnsignedShort : gltf::kUnsignedInt);
        for (std::uint64_t i = 0; i < spec.count; ++i) {
            const std::uint32_t number = fill(static_cast<std::size_t>(i));
            const auto narrow = static_cast<std::uint16_t>(number);
            if (is_short)
                put(&narrow, sizeof narrow);
            else
                put(&number, sizeof number);
        }
        return end(
            spec,
            spec.target != gltf::kIndexTarget ? Packing::Attributes
            : spec.of_lines                   ? Packing::Indices
                                              : Packing::Triangles
        );
    }
    /// A file as it is (a picture): a bufferView without accessor; its index.
    int blob(std::span<const std::byte> bytes);

    /// Of all arrays so far. Their files are written, or gone.
    std::vector<Digest>& digests();

private:
    void begin(const ArraySpec& spec, int component_type);
    int end(const ArraySpec& spec, Packing mode);
    void write_packed(const ArraySpec& spec, Packing mode);
    void put_steps(std::span<const float> row, const gltf::Steps& steps);
    void put(const void* value, std::size_t size) {
        if (used_ + size > block_.size()) make_room();
        std::memcpy(block_.data() + used_, value, size);
        used_ += size;
    }
    void make_room();
    void flush();
    std::span<const std::byte> used() const { return std::span(block_).first(used_); }

    static constexpr std::size_t kBlock = 1u << 16;
    gltf::Document* document_;
    int buffer_ = 0;
    bool packs_ = false;
    ScratchFile* file_ = nullptr;
    std::vector<std::byte> block_;
    std::size_t used_ = 0;  ///< Of the block.
    std::shared_ptr<Sha256> digest_;
    std::vector<std::shared_ptr<Sha256>> running_;  ///< Of digests_, from the first that has no text yet.
    std::array<float, 3> low_{}, high_{};
    std::vector<Digest> digests_;
};

}  // namespace feelem
