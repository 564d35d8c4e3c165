// SPDX-License-Identifier: Apache-2.0
// Which OpenXR runtime this machine has chosen, as its files say it: the order is that of Khronos' loader.
#pragma once

#include "viewer/doctor/machine.hpp"

#include <string>
#include <vector>

namespace feelem::viewer {

enum class RuntimeKind {
    Unknown,
    Monado,
    SteamVr,
    Wivrn,
};

enum class RuntimeFault {
    None,
    NotInstalled,
    NotChosen,       ///< Installed, but nothing points to it.
    ForcedIsAbsent,  ///< XR_RUNTIME_JSON names a file that is not there.
    LinkIsBroken,    ///< active_runtime.json points to a file that is not there.
    NotADescription,
    NoLibrary,  ///< The description names a library that is not there.
};

struct RuntimeFiles {
    RuntimeFault fault = RuntimeFault::None;
    RuntimeKind kind = RuntimeKind::Unknown;
    std::string name;              ///< "Monado"
    std::filesystem::path chosen;  ///< The file that chooses it, as the machine sees the path.
    bool is_forced = false;        ///< By XR_RUNTIME_JSON.
    std::filesystem::path link;    ///< LinkIsBroken: where it points to.
    std::string library;
    std::vector<std::filesystem::path> installed;  ///< Descriptions found in the usual places.
};

RuntimeFiles find_runtime(const Machine& machine);

}  // namespace feelem::viewer
