// SPDX-License-Identifier: Apache-2.0
// The motor of a controller, by the best way that its runtime offers.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/haptics/haptic_sink.hpp"
#include "viewer/xr/calls.hpp"

#include <string>
#include <string_view>

namespace feelem::viewer::xr {

enum class ShakeWay : std::uint8_t {
    Vibration,   ///< Of OpenXR's core: one strength for the whole pulse.
    Envelope,    ///< XR_FB_haptic_amplitude_envelope: the strength over time.
    Parametric,  ///< XR_EXT_haptic_parametric: likewise, and for every maker.
};
std::string_view word(ShakeWay way);

struct ShakeTarget {
    XrSession session = XR_NULL_HANDLE;
    XrAction action = XR_NULL_HANDLE;
    XrPath hand = XR_NULL_PATH;
    ShakeWay way = ShakeWay::Vibration;
};

class ControllerHaptics final : public HapticSink {
public:
    /// From now on that hand of that session. Forgets what went wrong in the last one.
    void connect(const ShakeTarget& target);
    void disconnect();
    /// `is_held`: something that can shake is in the hand. Gives can_shake().
    bool offer(bool is_held) {
        is_held_ = is_held;
        return can_shake();
    }
    bool can_shake() const { return target_.session != XR_NULL_HANDLE && is_held_ && !was_refused_; }
    /// A call failed: nothing more is sent until the next session. Said once.
    bool was_refused() const { return was_refused_; }
    XrResult refusal() const { return refusal_; }

    bool pulse(double amplitude, double milliseconds) override;
    void stop() override;

private:
    XrResult apply(float amplitude, XrDuration duration) const;
    void note(XrResult result);

    ShakeTarget target_;
    bool is_held_ = false, was_refused_ = false;
    XrResult refusal_ = XR_SUCCESS;
};

}  // namespace feelem::viewer::xr
