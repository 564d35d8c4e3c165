// SPDX-License-Identifier: Apache-2.0
// The door to a runtime: what it offers, and the instance that uses it.
#pragma once

#include "viewer/xr/calls.hpp"

#include <string>

namespace feelem::viewer::xr {

/// What is enabled, because the runtime offers it.
struct Enabled {
    bool depth = false, hands = false, envelope = false, parametric = false;
};

struct Instance {
    XrInstance handle = XR_NULL_HANDLE;
    Enabled enabled;
    std::string runtime;  ///< "Monado(XRT) by Collabora et al 25.0.0"
};

struct InstanceTry {
    XrResult result = XR_SUCCESS;
    Instance instance;  ///< Where that succeeded.
};

/// May take its time while a service starts; needs no OpenGL, and so can be called on another thread.
InstanceTry make_instance(const std::string& application, bool is_egl);

struct System {
    XrSystemId id = XR_NULL_SYSTEM_ID;
    std::string headset;
    bool has_hands = false, has_parametric = false;
};
/// Throws Failure(XR_ERROR_FORM_FACTOR_UNAVAILABLE): no headset is there now.
System find_headset(const Instance& instance);

}  // namespace feelem::viewer::xr
