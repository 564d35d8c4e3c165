// SPDX-License-Identifier: Apache-2.0
// The program `feelem`: runs one command. The only catch, and the only place that knows exit codes.
#include "base/parallel.hpp"
#include "command_line.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace {

constexpr int kDataCannotBeUsed = 1;
constexpr int kWrongUsage = 2;

int fail(int code, std::string_view text) {
    std::fflush(stdout);
    fmt::print(stderr, "feelem: error: {}\n", text);
    return code;
}

int run(const std::vector<std::string>& arguments) {
    const feelem::cli::ParsedLine line = feelem::cli::parse_command_line(arguments);
    if (line.text) {
        fmt::print("{}", *line.text);
        return 0;
    }
    feelem::set_thread_count(line.options.threads);
    return line.command->run(line.options);
}

bool is_usage(feelem::Code code) {
    return code == feelem::Code::BadOption || code == feelem::Code::UnknownName;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int code = run({argv + (argc > 0 ? 1 : 0), argv + argc});
        if (std::fflush(stdout) != 0) return fail(kDataCannotBeUsed, "cannot write to the standard output");
        return code;
    } catch (const feelem::cli::UsageError& error) {
        return fail(kWrongUsage, error.what());
    } catch (const feelem::Error& error) {
        return fail(is_usage(error.code()) ? kWrongUsage : kDataCannotBeUsed, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kDataCannotBeUsed, "not enough memory for this model");
    } catch (const std::exception& error) {
        return fail(kDataCannotBeUsed, error.what());
    }
}
