// SPDX-License-Identifier: Apache-2.0
#include "scene/array_writer.hpp"

#include "feelem/error.hpp"

#include <cstring>
#include <limits>
#include <memory>
#include <utility>

namespace feelem {
namespace {

std::vector<std::uint32_t> numbers_of(std::span<const std::byte> bytes, std::size_t width) {
    std::vector<std::uint32_t> numbers(bytes.size() / width);
    for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(&numbers[i], &bytes[i * width], width);
    return numbers;
}

bool comes_back(std::span<const std::byte> packed, const PackedView& view, std::span<const std::byte> rows) {
    const auto found = unpack(packed, view);
    return found && std::ranges::equal(found->span(), rows);
}

/// A grid that the exponential filter can say: other values are packed as they are.
bool fits_filter(std::span<const std::byte> bytes, float grid) {
    if (!(grid > 0x1p-100F && grid < 0x1p100F)) return false;
    for (std::size_t at = 0; at < bytes.size(); at += 4) {
        float value = 0;
        std::memcpy(&value, &bytes[at], 4);
        if (!(std::abs(value) < 0x1p23F * grid)) return false;
        // The filter knows no -0.
        if (value == 0 && std::signbit(value)) return false;
    }
    return true;
}

}  // namespace

void ArrayWriter::begin(const ArraySpec& spec, int component_type) {
    file_->pad_to(4);
    document_->views.push_back({buffer_, file_->size(), 0, spec.target, std::nullopt});
    gltf::Accessor accessor;
    accessor.name = spec.name;
    accessor.view = static_cast<int>(document_->views.size()) - 1;
    accessor.component_type = component_type;
    accessor.components = spec.components;
    accessor.count = spec.count;
    accessor.steps = spec.steps;
    document_->accessors.push_back(std::move(accessor));
    digest_ = std::make_shared<Sha256>();
    low_.fill(std::numeric_limits<float>::infinity());
    high_.fill(-std::numeric_limits<float>::infinity());
}

int ArrayWriter::end(const ArraySpec& spec, Packing mode) {
    gltf::View& view = document_->views.back();
    gltf::Accessor& accessor = document_->accessors.back();
    if (packs_ && used_ > 0) {
        write_packed(spec, mode);
    } else {
        flush();
        view.bytes = file_->size() - view.offset;
    }
    if (spec.bounds && !spec.steps && accessor.component_type == gltf::kFloat && spec.count > 0) {
        accessor.min.assign(low_.begin(), low_.begin() + spec.components);
        accessor.max.assign(high_.begin(), high_.begin() + spec.components);
    }
    digests_.push_back({spec.name, {}});
    running_.push_back(std::move(digest_));
    return static_cast<int>(document_->accessors.size()) - 1;
}

void ArrayWriter::write_packed(const ArraySpec& spec, Packing mode) {
    gltf::View& view = document_->views.back();
    const int type = document_->accessors.back().component_type;
    const std::size_t width = type == gltf::kUnsignedShort ? 2 : 4;
    PackedView packed{buffer_, file_->size(), 0, spec.count, width * spec.components, mode, {}};
    const std::span<const std::byte> block = used();
    std::vector<std::byte> bytes;
    if (mode != Packing::Attributes) {
        bytes = pack_indices(numbers_of(block, width), mode);
        packed.bytes = bytes.size();
        // Triangles whose corners it would turn: as a plain list.
        if (mode == Packing::Triangles && !comes_back(bytes, packed, block)) {
            packed.mode = Packing::Indices;
            bytes = pack_indices(numbers_of(block, width), packed.mode);
        }
    } else if (fits_filter(block, spec.grid)) {
        std::vector<float> values(block.size() / 4);
        std::memcpy(values.data(), block.data(), block.size());
        const std::vector<std::uint32_t> numbers = with_one_exponent(values, spec.grid);
        bytes = pack_rows(std::as_bytes(std::span(numbers)), packed.stride);
        packed.filter = PackingFilter::Exponential;
    } else {
        bytes = pack_rows(block, packed.stride);
    }
    packed.bytes = bytes.size();
    // What is promised is what comes out again, bit for bit.
    if (!comes_back(bytes, packed, block))
        throw Error(Code::BadStructure, "", spec.name + " does not survive its packing");
    digest_->add(block);
    file_->write(bytes);
    view.bytes = block.size();
    view.offset = (document_->unpacked_bytes + 3) / 4 * 4;
    document_->unpacked_bytes = view.offset + view.bytes;
    view.packed = packed;
    used_ = 0;
}

void ArrayWriter::put_steps(std::span<const float> row, const gltf::Steps& steps) {
    for (const float value : row) {
        const auto whole = static_cast<std::int32_t>(steps.number(static_cast<double>(value)));
        put(&whole, sizeof whole);
    }
}

void ArrayWriter::make_room() {
    // A packed array is packed as a whole.
    if (!packs_) flush();
    block_.resize(packs_ ? std::max(kBlock, 2 * block_.size()) : kBlock);
}

void ArrayWriter::flush() {
    if (used_ == 0) return;
    block_.resize(used_);
    file_->write_behind(std::exchange(block_, {}), digest_);
    used_ = 0;
}

std::vector<Digest>& ArrayWriter::digests() {
    if (file_ != nullptr) file_->settle();
    const std::size_t first = digests_.size() - running_.size();
    for (std::size_t i = 0; i < running_.size(); ++i) digests_[first + i].sha256 = running_[i]->hex();
    running_.clear();
    return digests_;
}

int ArrayWriter::blob(std::span<const std::byte> bytes) {
    file_->pad_to(4);
    document_->views.push_back({buffer_, file_->size(), bytes.size(), 0, std::nullopt});
    file_->write(bytes);
    return static_cast<int>(document_->views.size()) - 1;
}

}  // namespace feelem
