// SPDX-License-Identifier: Apache-2.0
#include "convert/stale_files.hpp"

#include "base/number.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

namespace feelem {
namespace {

namespace fs = std::filesystem;

bool is_gone(std::int64_t process) {
    if (process <= 0 || process > std::numeric_limits<pid_t>::max() || process == getpid()) return false;
    return kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

/// "boiler.glb.tmp-4711" and "boiler.d.tmp-4711" for the output boiler.glb.
bool is_stale(std::string_view name, const fs::path& output) {
    for (const std::string& base : {output.filename().string(), output.stem().string() + ".d"}) {
        const std::string head = base + ".tmp-";
        if (!name.starts_with(head)) continue;
        const auto process = parse_integer(name.substr(head.size()));
        if (process && is_gone(*process)) return true;
    }
    return false;
}

}  // namespace

void remove_stale_files(const std::string& output) {
    const fs::path path(output);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<fs::path> stale;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (is_stale(entry->path().filename().string(), path)) stale.push_back(entry->path());
    }
    for (const fs::path& file : stale) fs::remove_all(file, error);
}

}  // namespace feelem
