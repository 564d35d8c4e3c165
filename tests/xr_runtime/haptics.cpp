// SPDX-License-Identifier: Apache-2.0
// What a hand would feel: written down, whichever way it was asked for.
#include "extensions.hpp"
#include "runtime.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem::xr_runtime {

namespace {

constexpr const char* kApply = "xrApplyHapticFeedback";

struct Shaking {
    const char* kind = "vibration";
    double amplitude = 0, milliseconds = 0, hz = 0;
    std::string fault;
};

double to_milliseconds(XrDuration duration) {
    return static_cast<double>(duration) / 1e6;
}

Shaking read(const XrHapticVibration& vibration) {
    Shaking out;
    out.amplitude = vibration.amplitude;
    out.milliseconds = to_milliseconds(vibration.duration);
    out.hz = vibration.frequency;
    if (!(vibration.amplitude >= 0 && vibration.amplitude <= 1)) out.fault = "the amplitude is not 0..1";
    if (vibration.duration <= 0 && vibration.duration != XR_MIN_HAPTIC_DURATION) out.fault = "the duration";
    return out;
}

Shaking read(const EnvelopeVibration& envelope) {
    Shaking out;
    out.kind = "envelope";
    out.milliseconds = to_milliseconds(envelope.duration);
    if (envelope.amplitude_count == 0 || envelope.amplitude_count > kMostEnvelopeSamples)
        out.fault = "samples";
    else
        out.amplitude =
            *std::max_element(envelope.amplitudes, envelope.amplitudes + envelope.amplitude_count);
    if (envelope.duration <= 0) out.fault = "the duration";
    return out;
}

Shaking read(const ParametricVibration& vibration) {
    Shaking out;
    out.kind = "parametric";
    if (vibration.amplitude_count < 2 || vibration.amplitude_count > kMostParametricPoints) {
        out.fault = "amplitude points";
        return out;
    }
    XrDuration last = -1;
    for (std::uint32_t i = 0; i < vibration.amplitude_count; ++i) {
        const ParametricPoint& point = vibration.amplitudes[i];
        if (point.time <= last || !(point.value >= 0 && point.value <= 1))
            out.fault = "points out of order or range";
        last = point.time;
        out.amplitude = std::max(out.amplitude, static_cast<double>(point.value));
    }
    out.milliseconds = to_milliseconds(last);
    out.hz = vibration.highest_hz;
    return out;
}

XrResult apply(XrSession handle, const XrHapticActionInfo* info, const XrHapticBaseHeader* header) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, kApply); result != XR_SUCCESS) return result;
    const Action* action = runtime().actions.find(number_of(info->action));
    if (!action || action->type != XR_ACTION_TYPE_VIBRATION_OUTPUT)
        return broken(XR_ERROR_ACTION_TYPE_MISMATCH, kApply, "not an action of vibration");
    if (session->state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    const auto& extensions = only_instance()->extensions;
    Shaking shaking;
    if (header->type == XR_TYPE_HAPTIC_VIBRATION)
        shaking = read(*reinterpret_cast<const XrHapticVibration*>(header));
    else if (header->type == kEnvelopeType && extensions.count(kEnvelopeName))
        shaking = read(*reinterpret_cast<const EnvelopeVibration*>(header));
    else if (header->type == kParametricType && extensions.count(kParametricName))
        shaking = read(*reinterpret_cast<const ParametricVibration*>(header));
    else
        shaking.fault = "a kind whose extension is not enabled";
    if (!shaking.fault.empty()) return broken(XR_ERROR_VALIDATION_FAILURE, kApply, shaking.fault);
    const std::size_t side = side_of(text_of(info->subactionPath));
    const bool is_felt = !active_profile(side).empty();
    if (runtime().world.refuses_haptics) {
        record(fmt::format(R"("haptic":"refused","hand":{})", side));
        return XR_ERROR_RUNTIME_FAILURE;
    }
    record(fmt::format(
        R"("haptic":"{}","hand":{},"felt":{},"amplitude":{:.4f},"milliseconds":{:.3f},"hz":{:.1f})",
        shaking.kind,
        side,
        is_felt,
        shaking.amplitude,
        shaking.milliseconds,
        shaking.hz
    ));
    return XR_SUCCESS;
}

XrResult stop(XrSession handle, const XrHapticActionInfo* info) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrStopHapticFeedback"); result != XR_SUCCESS) return result;
    if (session->state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    record(fmt::format(R"("haptic":"stop","hand":{})", side_of(text_of(info->subactionPath))));
    return XR_SUCCESS;
}

}  // namespace

std::span<const Entry> haptic_calls() {
    static const std::array kCalls{
        entry<PFN_xrApplyHapticFeedback>(kApply, apply),
        entry<PFN_xrStopHapticFeedback>("xrStopHapticFeedback", stop),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
