// SPDX-License-Identifier: Apache-2.0
// A scene on disk: container, buffers and side files, arrays by name.
#pragma once

#include "base/input.hpp"
#include "scene/scene_json.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem {

/// Everything is checked against the bytes that are there; throws Error(BadScene).
class SceneFile {
public:
    explicit SceneFile(const std::string& path);

    const SceneDocument& document() const noexcept { return document_; }
    /// Index of an accessor. Throws when there is none of that name.
    int find(const std::string& name) const;
    /// The bytes of an array, elements packed.
    std::vector<std::byte> packed(int accessor) const;
    std::vector<float> floats(int accessor, unsigned components) const;
    std::vector<std::uint32_t> integers(int accessor) const;  ///< From shorts or ints.
    const std::string& path() const noexcept { return path_; }

private:
    const Input& buffer(int index) const;
    /// Of a bufferView, wherever it lies, unpacked.
    std::span<const std::byte> view_bytes(const ReadView& view, std::optional<ZeroedArray<std::byte>>& room)
        const;
    std::span<const std::byte> buffer_bytes(int index) const;
    [[noreturn]] void bad(const std::string& text) const;

    std::string path_;
    Input main_;
    SceneDocument document_;
    std::size_t binary_begin_ = 0, binary_size_ = 0;
    mutable std::vector<std::optional<Input>> side_;
};

}  // namespace feelem
