// SPDX-License-Identifier: Apache-2.0
// Any bytes as a presentation: refused, or read, written and read again to the same text.
#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    std::string once;
    try {
        once = feelem::presentation_json(feelem::parse_presentation(bytes, "fuzz"));
    } catch (const feelem::Error&) {
        return 0;
    }
    // What was accepted must come back: an Error here is a finding, so it is not caught.
    if (feelem::presentation_json(feelem::parse_presentation(once, "again")) != once) std::abort();
    return 0;
}
