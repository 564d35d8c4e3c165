// SPDX-License-Identifier: Apache-2.0
#include "viewer/doctor/runtime_files.hpp"

#include "base/letter_case.hpp"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace feelem::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kChoice = "openxr/1/active_runtime.json";

std::vector<fs::path> split_paths(const std::string& text) {
    std::vector<fs::path> paths;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(':', from), text.size());
        if (end > from) paths.emplace_back(text.substr(from, end - from));
        from = end + 1;
    }
    return paths;
}

fs::path home_of(const Machine& machine) {
    return machine.environment("HOME");
}

/// Where the loader looks, first come first served.
std::vector<fs::path> places_of_choice(const Machine& machine) {
    const std::string own = machine.environment("XDG_CONFIG_HOME");
    std::vector<fs::path> folders{own.empty() ? home_of(machine) / ".config" : fs::path(own)};
    const std::string shared = machine.environment("XDG_CONFIG_DIRS");
    for (const fs::path& folder : split_paths(shared.empty() ? "/etc/xdg" : shared))
        folders.push_back(folder);
    folders.emplace_back("/etc");
    return folders;
}

/// Value of a string member, wherever it stands; "": there is none.
std::string member(std::string_view json, std::string_view name) {
    const std::string quoted = '"' + std::string(name) + '"';
    std::size_t at = json.find(quoted);
    if (at == std::string_view::npos) return "";
    at = json.find_first_not_of(" \t\r\n", at + quoted.size());
    if (at == std::string_view::npos || json[at] != ':') return "";
    at = json.find_first_not_of(" \t\r\n", at + 1);
    if (at == std::string_view::npos || json[at] != '"') return "";
    std::string value;
    for (++at; at < json.size() && json[at] != '"'; ++at) {
        if (json[at] == '\\' && at + 1 < json.size()) ++at;
        value += json[at];
    }
    return value;
}

RuntimeKind kind_of(const std::string& library) {
    const std::string name = lower_case(library);
    if (name.find("wivrn") != std::string::npos) return RuntimeKind::Wivrn;
    if (name.find("monado") != std::string::npos) return RuntimeKind::Monado;
    if (name.find("vrclient") != std::string::npos) return RuntimeKind::SteamVr;
    return RuntimeKind::Unknown;
}

std::string name_of(RuntimeKind kind, const std::string& given, const std::string& library) {
    switch (kind) {
    case RuntimeKind::Monado: return "Monado";
    case RuntimeKind::SteamVr: return "SteamVR";
    case RuntimeKind::Wivrn: return "WiVRn";
    case RuntimeKind::Unknown: break;
    }
    return given.empty() ? fs::path(library).filename().string() : given;
}

bool library_is_there(const Machine& machine, const std::string& library, const fs::path& description) {
    const fs::path path(library);
    if (path.is_absolute()) return is_there(machine.at(path));
    if (library.find('/') != std::string::npos) {
        // Relative to the description itself, not to a link to it.
        std::error_code error;
        const fs::path real = fs::canonical(machine.at(description), error);
        return !error && is_there(real.parent_path() / path);
    }
    std::vector<fs::path> folders = split_paths(machine.environment("LD_LIBRARY_PATH"));
    for (const char* folder :
         {"/usr/local/lib",
          "/usr/lib/x86_64-linux-gnu",
          "/usr/lib/aarch64-linux-gnu",
          "/usr/lib64",
          "/usr/lib"}) {
        folders.emplace_back(folder);
    }
    return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
        return is_there(machine.at(folder / path));
    });
}

std::vector<fs::path> installed_descriptions(const Machine& machine) {
    std::vector<fs::path> found;
    for (const char* folder : {"/usr/local/share/openxr/1", "/usr/share/openxr/1"}) {
        std::error_code error;
        for (fs::directory_iterator entry(machine.at(folder), error), end; !error && entry != end;
             entry.increment(error)) {
            if (entry->path().extension() == ".json") found.push_back(folder / entry->path().filename());
        }
    }
    for (const char* steam : {".local/share/Steam", ".steam/steam"}) {
        const fs::path file = home_of(machine) / steam / "steamapps/common/SteamVR/steamxr_linux64.json";
        if (is_there(machine.at(file))) {
            found.push_back(file);
            break;
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

void choose(const Machine& machine, RuntimeFiles& found) {
    if (const std::string forced = machine.environment("XR_RUNTIME_JSON"); !forced.empty()) {
        found.chosen = forced;
        found.is_forced = true;
        if (!is_there(machine.at(forced))) found.fault = RuntimeFault::ForcedIsAbsent;
        return;
    }
    for (const fs::path& folder : places_of_choice(machine)) {
        const fs::path file = folder / kChoice;
        std::error_code error;
        if (is_there(machine.at(file))) {
            found.chosen = file;
            found.fault = RuntimeFault::None;
            return;
        }
        // The loader goes on behind a broken link; should nothing follow, it is what is wrong.
        if (found.fault == RuntimeFault::None && fs::is_symlink(machine.at(file), error)) {
            found.chosen = file;
            found.link = fs::read_symlink(machine.at(file), error);
            found.fault = RuntimeFault::LinkIsBroken;
        }
    }
    if (found.fault == RuntimeFault::None)
        found.fault = found.installed.empty() ? RuntimeFault::NotInstalled : RuntimeFault::NotChosen;
}

}  // namespace

RuntimeFiles find_runtime(const Machine& machine) {
    RuntimeFiles found;
    found.installed = installed_descriptions(machine);
    choose(machine, found);
    if (found.fault != RuntimeFault::None) return found;
    const std::string description = text_of(machine.at(found.chosen));
    found.library = member(description, "library_path");
    if (found.library.empty()) {
        found.fault = RuntimeFault::NotADescription;
        return found;
    }
    found.kind = kind_of(found.library);
    found.name = name_of(found.kind, member(description, "name"), found.library);
    if (!library_is_there(machine, found.library, found.chosen)) found.fault = RuntimeFault::NoLibrary;
    return found;
}

}  // namespace feelem::viewer
