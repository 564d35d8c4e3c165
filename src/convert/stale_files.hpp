// SPDX-License-Identifier: Apache-2.0
// What killed processes left beside an output.
#pragma once

#include <string>

namespace feelem {

/// Removes NAME.tmp-PID (files or folders) of processes that are gone, for this output and its side folder.
/// Never fails: what cannot be removed stays.
void remove_stale_files(const std::string& output);

}  // namespace feelem
