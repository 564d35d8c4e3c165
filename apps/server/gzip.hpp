// SPDX-License-Identifier: Apache-2.0
// gzip, piece by piece.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace feelem::server {

class GzipPacker {
public:
    GzipPacker();
    ~GzipPacker();
    GzipPacker(const GzipPacker&) = delete;
    GzipPacker& operator=(const GzipPacker&) = delete;
    /// What has become of the bytes so far; the rest when they were the last.
    std::string add(std::string_view bytes, bool is_last);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Of bytes that this program itself packed.
std::string unpack(std::span<const std::byte> gzip);

}  // namespace feelem::server
