// SPDX-License-Identifier: Apache-2.0
// A loaded scene as core wants it.
#pragma once

#include "viewer/core/model_source.hpp"
#include "viewer/scene/loaded_scene.hpp"

namespace feelem::viewer {

/// `scene` must outlive what is made of it.
ModelSource source_of(LoadedScene& scene);

}  // namespace feelem::viewer
