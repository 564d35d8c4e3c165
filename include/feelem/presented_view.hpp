// SPDX-License-Identifier: Apache-2.0
// What a presentation suggests to a viewer besides results and effects.
#pragma once

#include <string>
#include <string_view>

namespace feelem {

struct PresentedView {
    bool isolines = false;      ///< Of the colour effect.
    double shade_floor = 0.75;  ///< Of the colour effect: 0..1.
    bool ghost = false;         ///< The undeformed shape beside the deformed one.
    bool limit_events = true, extreme_events = true, no_value_events = true, band_events = false;
    double master = 0.5;  ///< 0..1
    bool mono = false, captions = true;
};

/// Of a presentation's document; whatever is not as expected there means its default. Empty text: all
/// defaults. Throws Error(BadPresentation) for text that is no JSON.
PresentedView presented_view(std::string_view json);
/// The document with lines and ghost as the view has them; what has not changed stays as it was written.
std::string with_presented_view(std::string_view json, const PresentedView& view);

}  // namespace feelem
