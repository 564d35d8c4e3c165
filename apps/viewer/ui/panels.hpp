// SPDX-License-Identifier: Apache-2.0
// The panels: each draws a part of the model at the cursor and adds what is wished. Free functions; nothing
// is kept.
#pragma once

#include "viewer/ui/widgets.hpp"

namespace feelem::viewer {

/// As high as `height` where the scale can be long enough.
void legend_panel(Pen& pen, float height);
/// Range, map and bands, to be changed.
void legend_settings(Pen& pen);
void card_panel(Pen& pen, const UiCard& card);
/// Which result is seen, heard and felt.
void results_panel(Pen& pen);
void limits_panel(Pen& pen);
/// Play, step before and after, the list, a slider.
void steps_panel(Pen& pen, float list_width, float slider_width);
void deformation_panel(Pen& pen);
void parts_panel(Pen& pen);
void cuts_panel(Pen& pen);
void hot_spots_panel(Pen& pen);
void markers_panel(Pen& pen);
/// Home, fit, and along the axes.
void views_panel(Pen& pen);
/// Edges, undeformed shape, lines between bands.
void drawing_panel(Pen& pen);
void sound_panel(Pen& pen);
void touch_panel(Pen& pen);
void headset_panel(Pen& pen);
void certificate_panel(Pen& pen);
void keys_panel(Pen& pen);

/// What a sense does with a value: "seen as colour".
const char* verb_of(Sense sense);
Icon icon_of(Sense sense);

}  // namespace feelem::viewer
