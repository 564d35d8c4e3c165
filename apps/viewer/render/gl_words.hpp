// SPDX-License-Identifier: Apache-2.0
// How the OpenGL that is current names itself.
#pragma once

#include <string>

namespace feelem::viewer {

std::string gl_version();   ///< "4.5 (Core Profile) Mesa 22.3.6"; "" where none is current.
std::string gl_renderer();  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"

}  // namespace feelem::viewer
