// SPDX-License-Identifier: Apache-2.0
#include "base/byte_reader.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <string>

namespace feelem {

std::span<const std::byte> ByteReader::take(std::size_t count) {
    if (offset_ > input_->size() || count > remaining()) {
        throw Error(
            Code::Truncated,
            input_->where_byte(offset_),
            "the file ends here, but " + std::to_string(count) +
                " more bytes belong to this record. Was it copied whole?"
        );
    }
    const auto result = input_->bytes().subspan(offset_, count);
    offset_ += count;
    return result;
}

void ByteReader::reverse(std::span<std::byte> bytes) {
    std::reverse(bytes.begin(), bytes.end());
}

}  // namespace feelem
