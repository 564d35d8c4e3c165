// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.hpp"

#include "base/byte_reader.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>

namespace feelem {
namespace {

struct Chunks {
    std::string_view json;
    std::size_t binary_begin = 0, binary_size = 0;
};

Chunks chunks_of(const Input& file) {
    const std::string_view text = file.text();
    if (!text.starts_with("glTF")) return {text, 0, 0};
    ByteReader reader(file, 4);
    Chunks chunks;
    const auto version = reader.read<std::uint32_t>();
    const auto length = reader.read<std::uint32_t>();
    if (version != 2 || length != file.size()) {
        throw Error(
            Code::BadScene,
            file.name(),
            fmt::format(
                "says {} bytes of version {}, but has {} bytes: damaged?", length, version, file.size()
            )
        );
    }
    while (reader.remaining() >= 8) {
        const auto size = reader.read<std::uint32_t>();
        const auto type = reader.read<std::uint32_t>();
        const std::size_t begin = reader.offset();
        reader.take(size);
        constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
        if (type == kJson && chunks.json.empty()) chunks.json = text.substr(begin, size);
        if (type == kBinary && chunks.binary_size == 0) {
            chunks.binary_begin = begin;
            chunks.binary_size = size;
        }
    }
    return chunks;
}

/// A relative path that stays below the scene's folder, else empty.
std::string safe_path(const std::string& scene, const std::string& uri) {
    namespace fs = std::filesystem;
    const fs::path relative(uri);
    if (uri.empty() || relative.is_absolute() || uri.find(':') != std::string::npos) return "";
    for (const fs::path& step : relative) {
        if (step == "..") return "";
    }
    return (fs::path(scene).parent_path() / relative).string();
}

std::vector<float> values_on_steps(std::span<const std::byte> bytes, const gltf::Steps& steps) {
    std::vector<float> values(bytes.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::int32_t number = 0;
        std::memcpy(&number, &bytes[4 * i], 4);
        values[i] = steps.value(number);
    }
    return values;
}

}  // namespace

SceneFile::SceneFile(const std::string& path) : path_(path), main_(Input::from_file(path)) {
    Chunks chunks;
    try {
        chunks = chunks_of(main_);
    } catch (const Error& error) {
        if (error.code() == Code::Truncated) bad("ends in the middle of a chunk");
        throw;
    }
    document_ = parse_scene_json(chunks.json, path);
    binary_begin_ = chunks.binary_begin;
    binary_size_ = chunks.binary_size;
    side_.resize(document_.buffers.size());
}

void SceneFile::bad(const std::string& text) const {
    throw Error(Code::BadScene, path_, text);
}

int SceneFile::find(const std::string& name) const {
    const auto found = document_.by_name.find(name);
    if (found == document_.by_name.end()) bad(fmt::format("there is no accessor '{}'", name));
    return found->second;
}

const Input& SceneFile::buffer(int index) const {
    std::optional<Input>& input = side_[static_cast<std::size_t>(index)];
    if (input) return *input;
    const std::string& uri = document_.buffers[static_cast<std::size_t>(index)].uri;
    const std::string file = safe_path(path_, uri);
    if (file.empty())
        bad(fmt::format("buffer {} has the uri '{:.80}': only files beside the scene are read", index, uri));
    input = Input::from_file(file);
    return *input;
}

std::span<const std::byte> SceneFile::buffer_bytes(int index) const {
    const bool in_chunk = document_.buffers[static_cast<std::size_t>(index)].uri.empty();
    return in_chunk ? main_.bytes().subspan(binary_begin_, binary_size_) : buffer(index).bytes();
}

std::span<const std::byte> SceneFile::view_bytes(
    const ReadView& view, std::optional<ZeroedArray<std::byte>>& room
) const {
    const auto cut = [this](std::span<const std::byte> bytes, std::uint64_t offset, std::uint64_t size) {
        if (offset > bytes.size() || size > bytes.size() - offset)
            bad("a bufferView reaches beyond its buffer");
        return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
    };
    if (!view.view.packed) return cut(buffer_bytes(view.view.buffer), view.view.offset, view.view.bytes);
    const PackedView& packed = *view.view.packed;
    room = unpack(cut(buffer_bytes(packed.buffer), packed.offset, packed.bytes), packed);
    if (!room || room->size() != view.view.bytes)
        bad("a packed bufferView does not hold what it says: damaged?");
    return room->span();
}

std::vector<std::byte> SceneFile::packed(int accessor) const {
    const ReadAccessor& read = document_.accessors[static_cast<std::size_t>(accessor)];
    const gltf::Accessor& array = read.accessor;
    const int type = array.component_type;
    const std::size_t width = type == gltf::kFloat || type == gltf::kUnsignedInt ? 4
                              : type == gltf::kUnsignedShort                     ? 2
                                                                                 : 0;
    if (array.view < 0 || width == 0 || array.components == 0)
        bad(fmt::format("accessor '{}' is of a kind that scenes do not have", array.name));
    const ReadView& view = document_.views[static_cast<std::size_t>(array.view)];
    std::optional<ZeroedArray<std::byte>> room;
    std::span<const std::byte> bytes = view_bytes(view, room);
    const std::size_t row = width * array.components;
    const std::uint64_t stride = view.stride == 0 ? row : view.stride;
    const bool row_fits =
        stride >= row && read.offset <= bytes.size() &&
        (array.count == 0 || (bytes.size() - read.offset >= row &&
                              (array.count - 1) <= (bytes.size() - read.offset - row) / stride));
    if (!row_fits) bad(fmt::format("accessor '{}' reaches beyond its buffer", array.name));
    bytes = bytes.subspan(static_cast<std::size_t>(read.offset));
    std::vector<std::byte> out(static_cast<std::size_t>(array.count) * row);
    if (stride == row) {
        if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size());
        return out;
    }
    for (std::size_t i = 0; i < array.count; ++i)
        std::memcpy(out.data() + i * row, bytes.data() + i * stride, row);
    return out;
}

std::vector<float> SceneFile::floats(int accessor, unsigned components) const {
    const gltf::Accessor& array = document_.accessors[static_cast<std::size_t>(accessor)].accessor;
    const bool as_steps = array.steps && array.component_type == gltf::kUnsignedInt;
    if ((array.component_type != gltf::kFloat && !as_steps) || array.components != components)
        bad(fmt::format("accessor '{}' is not {} floats a row", array.name, components));
    const std::vector<std::byte> bytes = packed(accessor);
    if (as_steps) return values_on_steps(bytes, *array.steps);
    std::vector<float> out(bytes.size() / sizeof(float));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
}

std::vector<std::uint32_t> SceneFile::integers(int accessor) const {
    const gltf::Accessor& array = document_.accessors[static_cast<std::size_t>(accessor)].accessor;
    if (array.component_type == gltf::kFloat || array.components != 1)
        bad(fmt::format("accessor '{}' is not a list of integers", array.name));
    const std::vector<std::byte> bytes = packed(accessor);
    std::vector<std::uint32_t> out;
    out.reserve(static_cast<std::size_t>(array.count));
    const std::size_t width = array.component_type == gltf::kUnsignedInt ? 4 : 2;
    for (std::size_t at = 0; at < bytes.size(); at += width) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, width);
        out.push_back(value);
    }
    return out;
}

}  // namespace feelem
