// SPDX-License-Identifier: Apache-2.0
// What comes of a wish of the panels.
#pragma once

#include "viewer/app/panel_model.hpp"

namespace feelem::viewer {

/// What only the window can do of it.
struct WindowWishes {
    std::vector<LookFrom> looks;
    bool try_headset = false;
};
void grant(const UiWishes& wishes, Viewer& viewer, DeviceWords& devices, WindowWishes& window);

}  // namespace feelem::viewer
