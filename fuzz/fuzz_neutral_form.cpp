// SPDX-License-Identifier: Apache-2.0
// Any bytes as the answer of the helper program feelem-exchange: refused, or a model that comes back as it
// is.
#include "read/exchange/neutral_form.hpp"

#include "feelem/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace feelem::exchange;
    std::string once;
    try {
        once = write_model(read_model(std::string(data, data + size), "fuzz"));
    } catch (const feelem::Error&) {
        return 0;
    }
    // What was accepted must come back: an Error here is a finding, so it is not caught.
    if (write_model(read_model(once, "again")) != once) std::abort();
    return 0;
}
