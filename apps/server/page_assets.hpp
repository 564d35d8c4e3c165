// SPDX-License-Identifier: Apache-2.0
// The page's files as they are carried inside the program.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace feelem::server {

struct PageAsset {
    std::string_view path;            ///< "/index.html"
    std::span<const std::byte> gzip;  ///< Its bytes, compressed.
};
std::vector<PageAsset> page_assets();

}  // namespace feelem::server
