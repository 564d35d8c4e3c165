// SPDX-License-Identifier: Apache-2.0
// The program `feelem-xr`. The only catch, and the only place that knows exit codes.
#include "viewer/app/run.hpp"
#include "viewer/desktop/window.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace {

constexpr int kCannotGoOn = 1;
constexpr int kWrongUsage = 2;

int fail(int code, std::string_view text) {
    std::fflush(stdout);
    fmt::print(stderr, "feelem-xr: error: {}\n", text);
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace feelem;
    try {
        const viewer::ParsedLine line = viewer::parse_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
        if (line.text) {
            fmt::print("{}", *line.text);
            return 0;
        }
        return viewer::run(line.options);
    } catch (const viewer::UsageError& error) {
        return fail(kWrongUsage, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kCannotGoOn, "not enough memory for this model");
    } catch (const std::exception& error) {
        return fail(kCannotGoOn, error.what());
    }
}
