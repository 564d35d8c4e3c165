// SPDX-License-Identifier: Apache-2.0
// The program from the command line to the last frame.
#pragma once

#include "viewer/app/options.hpp"

namespace feelem::viewer {

/// Exit code. Throws Error, NoWindow.
int run(const Options& options);

}  // namespace feelem::viewer
