// SPDX-License-Identifier: Apache-2.0
// Any bytes into open_model: whichever reader takes them must give a sound model or an Error.
#include "support/exercise.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace feelem;
    std::vector<NamedBytes> files{{"fuzz", std::string(data, data + size)}};
    try {
        Diagnostics diagnostics;
        const auto model = open_model(std::move(files), {}, diagnostics);
        if (!test::exercise(*model).empty()) std::abort();
    } catch (const Error&) {
        // What a reader may always do.
    }
    return 0;
}
