// SPDX-License-Identifier: Apache-2.0
// zstd, piece by piece: for numbers on their way through the air.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace feelem::server {

class ZstdPacker {
public:
    ZstdPacker();
    ~ZstdPacker();
    ZstdPacker(const ZstdPacker&) = delete;
    ZstdPacker& operator=(const ZstdPacker&) = delete;
    /// What has become of the bytes so far; the rest when they were the last.
    std::string add(std::string_view bytes, bool is_last);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::server
