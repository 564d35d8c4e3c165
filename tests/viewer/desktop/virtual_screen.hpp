// SPDX-License-Identifier: Apache-2.0
// A screen of its own for tests of windows: Xvfb, started and ended with the test program.
#pragma once

#include <string>

namespace feelem::viewer::test {

/// Starts it at the first call and points DISPLAY at it. Empty: it runs. Else why there is none, for
/// GTEST_SKIP.
const std::string& virtual_screen();

}  // namespace feelem::viewer::test
