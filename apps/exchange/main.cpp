// SPDX-License-Identifier: Apache-2.0
// feelem-exchange: reads one file through other people's libraries and writes what is in it to standard
// output, for src/read/exchange. A program of its own, bounded in time and memory, because those libraries
// may crash on damaged files.
//
// feelem-exchange MEBIBYTES SECONDS FORMAT PATH list|REQUEST...
#include "read/exchange/neutral_form.hpp"

#ifdef FEELEM_HAS_VTK
#include "vtk/vtk_model.hpp"
#endif
#ifdef FEELEM_HAS_HDF5
#include "med/med_model.hpp"
#endif

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace feelem::exchange;

std::uint64_t number_of(std::string_view word) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) throw std::invalid_argument("not a number");
    return value;
}

void bound(std::uint64_t mebibytes, std::uint64_t seconds) {
    const rlimit memory{mebibytes << 20, mebibytes << 20}, time{seconds, seconds + 5}, core{0, 0};
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_CORE, &core);
}

std::string error_answer(std::string_view text) {
    return static_cast<char>(Answer::Error) + std::string(text);
}

[[maybe_unused]] std::string unsupported_answer(std::string_view text) {
    return static_cast<char>(Answer::Unsupported) + std::string(text);
}

std::string answer(const std::string& format, const std::string& path, std::span<char* const> what) {
    const bool list = std::string_view(what.front()) == "list";
    std::vector<NeutralResult> results;
    for (std::size_t i = 0; !list && i < what.size(); ++i) results.push_back(read_request(what[i]));
    if (format == "med") {
#ifdef FEELEM_HAS_HDF5
        return list ? list_med(path) : load_med(path, results);
#else
        return unsupported_answer("this build reads no MED files: install libhdf5-dev and build Feelem again"
        );
#endif
    }
#ifdef FEELEM_HAS_VTK
    return list ? list_vtk(format, path) : load_vtk(format, path, results);
#else
    return unsupported_answer("this build reads no such files: install libvtk9-dev and build Feelem again");
#endif
}

bool write_all(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t done = write(to, bytes.data(), bytes.size());
        if (done <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    // A library that reads less than it says must not make up numbers: fresh memory is all ones, which is NaN
    // in every float, and so a missing value. (glibc fills with the lowest byte of this number, turned round;
    // zero alone would mean not to fill.)
    mallopt(M_PERTURB, 0x100);
    // Libraries may print: that must not get between our bytes.
    const int out = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    std::string bytes;
    try {
        if (argc < 6) throw std::invalid_argument("this program is run by feelem, not by people");
        bound(number_of(argv[1]), number_of(argv[2]));
        bytes = answer(argv[3], argv[4], std::span(argv + 5, static_cast<std::size_t>(argc - 5)));
    } catch (const std::bad_alloc&) {
        bytes = error_answer("the file asks for far more memory than one of its size should need");
    } catch (const std::exception& error) {
        bytes = error_answer(error.what());
    }
    const bool whole = write_all(out, bytes);
    // Without destructors: libraries have crashed in theirs.
    _exit(whole ? 0 : 1);
}
