// SPDX-License-Identifier: Apache-2.0
// Pulses as OpenXR takes them.
#include "viewer/xr/controller_haptics.hpp"

#include "viewer/xr/extensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer::xr {

namespace {

constexpr double kLongest = 200;  ///< Milliseconds, whatever is asked for.

XrHapticActionInfo info_of(const ShakeTarget& target) {
    auto info = typed<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
    info.action = target.action;
    info.subactionPath = target.hand;
    return info;
}

template <class Vibration>
XrResult send(const ShakeTarget& target, const Vibration& vibration) {
    const XrHapticActionInfo info = info_of(target);
    return xrApplyHapticFeedback(
        target.session, &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)
    );
}

}  // namespace

std::string_view word(ShakeWay way) {
    switch (way) {
    case ShakeWay::Vibration: return "vibration";
    case ShakeWay::Envelope: return "envelope";
    case ShakeWay::Parametric: return "parametric";
    }
    return "";
}

void ControllerHaptics::connect(const ShakeTarget& target) {
    target_ = target;
    is_held_ = was_refused_ = false;
    refusal_ = XR_SUCCESS;
}

void ControllerHaptics::disconnect() {
    target_ = {};
    is_held_ = false;
}

bool ControllerHaptics::pulse(double amplitude, double milliseconds) {
    if (!can_shake() || !(amplitude >= 0) || !(milliseconds > 0)) return false;
    const auto strength = static_cast<float>(std::min(1.0, amplitude));
    const auto duration = static_cast<XrDuration>(std::llround(std::min(kLongest, milliseconds) * 1e6));
    note(apply(strength, duration));
    return can_shake();
}

void ControllerHaptics::stop() {
    if (!can_shake()) return;
    const XrHapticActionInfo info = info_of(target_);
    note(xrStopHapticFeedback(target_.session, &info));
}

XrResult ControllerHaptics::apply(float amplitude, XrDuration duration) const {
    switch (target_.way) {
    case ShakeWay::Envelope: {
        // Two equal samples: the strength is held to the end.
        const std::array samples{amplitude, amplitude};
        HapticEnvelope envelope;
        envelope.duration = duration;
        envelope.amplitudeCount = static_cast<std::uint32_t>(samples.size());
        envelope.amplitudes = samples.data();
        return send(target_, envelope);
    }
    case ShakeWay::Parametric: {
        const std::array points{ParametricPoint{0, amplitude}, ParametricPoint{duration, amplitude}};
        HapticParametric parametric;
        parametric.amplitudePointCount = static_cast<std::uint32_t>(points.size());
        parametric.amplitudePoints = points.data();
        return send(target_, parametric);
    }
    case ShakeWay::Vibration: break;
    }
    auto vibration = typed<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    vibration.amplitude = amplitude;
    vibration.duration = duration;
    // Values are told by strength and rhythm: many motors have one frequency only.
    vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
    return send(target_, vibration);
}

void ControllerHaptics::note(XrResult result) {
    if (XR_SUCCEEDED(result)) return;  // Also when another program has the focus: nobody is to feel it then.
    // The session's end says more than its last pulse.
    if (result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST) return disconnect();
    was_refused_ = true;
    refusal_ = result;
}

}  // namespace feelem::viewer::xr
