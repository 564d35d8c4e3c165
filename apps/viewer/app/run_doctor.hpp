// SPDX-License-Identifier: Apache-2.0
// `feelem-xr doctor`: tries what can only be tried, and prints the report.
#pragma once

namespace feelem::viewer {

/// Exit code: 0 when the window works or a headset does, else 1.
int run_doctor();

}  // namespace feelem::viewer
