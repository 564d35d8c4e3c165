// SPDX-License-Identifier: Apache-2.0
// How calls of OpenXR are made here: one that fails throws, and the session's owner decides what that means.
#pragma once

#include "viewer/core/space.hpp"

#include <glm/vec2.hpp>
#include <openxr/openxr.h>

#include <cstdint>
#include <vector>

namespace feelem::viewer::xr {

/// Never leaves the folder.
struct Failure {
    XrResult result = XR_SUCCESS;
    const char* call = "";
};

inline XrResult must(XrResult result, const char* call) {
    if (XR_FAILED(result)) throw Failure{result, call};
    return result;
}

/// The two calls that OpenXR gives an array by: `call(capacity, &count, out)`.
template <class Thing, class Call>
std::vector<Thing> all_of(const char* name, const Thing& empty, Call call) {
    std::uint32_t count = 0;
    must(call(0U, &count, static_cast<Thing*>(nullptr)), name);
    std::vector<Thing> things(count, empty);
    if (count > 0) must(call(count, &count, things.data()), name);
    things.resize(count);
    return things;
}

inline Pose from_xr(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    return {{pose.position.x, pose.position.y, pose.position.z}, glm::quat(q.w, q.x, q.y, q.z)};
}

inline XrPosef to_xr(const Pose& pose) {
    const glm::quat& q = pose.orientation;
    return {{q.x, q.y, q.z, q.w}, {pose.position.x, pose.position.y, pose.position.z}};
}

/// A structure of OpenXR, all zero but its type.
template <class Structure>
Structure typed(XrStructureType type) {
    Structure structure{};
    structure.type = type;
    return structure;
}

inline constexpr XrPosef kNoPose{{0, 0, 0, 1}, {0, 0, 0}};

/// Of an extension's function; throws when the runtime has it not, though it offers the extension.
template <class Function>
Function function_of(XrInstance instance, const char* name) {
    PFN_xrVoidFunction found = nullptr;
    must(xrGetInstanceProcAddr(instance, name, &found), name);
    return reinterpret_cast<Function>(found);
}

}  // namespace feelem::viewer::xr
