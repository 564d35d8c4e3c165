// SPDX-License-Identifier: Apache-2.0
// What the panels show, from the state of the viewer.
#pragma once

#include "viewer/core/viewer.hpp"
#include "viewer/ui/ui_model.hpp"

#include <string>
#include <vector>

namespace feelem::viewer {

/// What the devices say of themselves, and what belongs to the window alone.
struct DeviceWords {
    UiHeadset headset;
    std::string sound_trouble, touch_trouble;
    Theme theme = Theme::Light;
    bool show_help = false;
    std::string trouble;
};

UiModel panel_model(Viewer& viewer, const Look& look, const Snapshot& snapshot, const DeviceWords& devices);
/// What a result drives.
std::vector<Sense> senses_of(const Presentation& presentation, const std::string& key);

}  // namespace feelem::viewer
