// SPDX-License-Identifier: Apache-2.0
// Any bytes to one reader: a sound model or an Error. Built once a reader, with its id in FEELEM_FUZZ_FORMAT.
#include "support/exercise.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace feelem;

/// A brick with nodes 1 to 8, for readers of results without a mesh.
constexpr const char* kBrick = R"(    1C
    2C                             8                                     1
 -1         1 0.00000E+00 0.00000E+00 0.00000E+00
 -1         2 1.00000E+00 0.00000E+00 0.00000E+00
 -1         3 1.00000E+00 1.00000E+00 0.00000E+00
 -1         4 0.00000E+00 1.00000E+00 0.00000E+00
 -1         5 0.00000E+00 0.00000E+00 1.00000E+00
 -1         6 1.00000E+00 0.00000E+00 1.00000E+00
 -1         7 1.00000E+00 1.00000E+00 1.00000E+00
 -1         8 0.00000E+00 1.00000E+00 1.00000E+00
 -3
    3C                             1                                     1
 -1         1    1    0    1
 -2         1         2         3         4         5         6         7         8
 -3
 9999
)";

bool has_mesh() {
    const std::vector<ReadFormatInfo> formats = read_formats();
    const auto found = std::ranges::find(formats, FEELEM_FUZZ_FORMAT, &ReadFormatInfo::id);
    if (found == formats.end()) std::abort();
    return found->has_mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const bool is_forced = has_mesh();
    std::vector<NamedBytes> files{{"fuzz", std::string(data, data + size)}};
    ReadOptions options;
    if (is_forced)
        options.from = FEELEM_FUZZ_FORMAT;
    else
        files.push_back({"brick.frd", kBrick});
    try {
        Diagnostics diagnostics;
        const auto model = open_model(std::move(files), options, diagnostics);
        if (!test::exercise(*model).empty()) std::abort();
    } catch (const Error&) {
        // What a reader may always do.
    }
    return 0;
}
