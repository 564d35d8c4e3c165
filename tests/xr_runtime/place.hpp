// SPDX-License-Identifier: Apache-2.0
// Poses of the scripted room, whose middle is the STAGE space.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <openxr/openxr.h>

#include <cmath>

namespace feelem::xr_runtime {

struct Place {
    glm::vec3 position{0};
    glm::quat orientation{1, 0, 0, 0};
};

inline Place operator*(const Place& outer, const Place& inner) {
    return {outer.position + outer.orientation * inner.position, outer.orientation * inner.orientation};
}

inline Place inverse(const Place& place) {
    const glm::quat turned = glm::conjugate(place.orientation);
    return {turned * -place.position, turned};
}

inline XrPosef to_xr(const Place& place) {
    const glm::quat& q = place.orientation;
    return {{q.x, q.y, q.z, q.w}, {place.position.x, place.position.y, place.position.z}};
}

inline Place from_xr(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    return {{pose.position.x, pose.position.y, pose.position.z}, glm::quat(q.w, q.x, q.y, q.z)};
}

inline bool is_pose(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    const XrVector3f& p = pose.position;
    const float length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return std::abs(length - 1) < 0.01F && std::isfinite(p.x + p.y + p.z);
}

}  // namespace feelem::xr_runtime
