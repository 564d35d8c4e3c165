// SPDX-License-Identifier: Apache-2.0
// Haptic extensions that are younger than Debian 12's headers (1.0.20), as the OpenXR registry lays them out.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>

namespace feelem::xr_runtime {

inline constexpr const char* kEnvelopeName = "XR_FB_haptic_amplitude_envelope";
inline constexpr auto kEnvelopeType = static_cast<XrStructureType>(1000173001);
inline constexpr std::uint32_t kMostEnvelopeSamples = 4000;

struct EnvelopeVibration {
    XrStructureType type;
    const void* next;
    XrDuration duration;
    std::uint32_t amplitude_count;
    const float* amplitudes;
};

inline constexpr const char* kParametricName = "XR_EXT_haptic_parametric";
inline constexpr auto kParametricType = static_cast<XrStructureType>(1000775000);
inline constexpr auto kSystemParametricType = static_cast<XrStructureType>(1000775002);
inline constexpr std::uint32_t kMostParametricPoints = 500;

struct ParametricPoint {
    XrDuration time;
    float value;
};

struct ParametricTransient {
    XrDuration time;
    float amplitude;
    float frequency;
};

struct ParametricVibration {
    XrStructureType type;
    const void* next;
    std::uint32_t amplitude_count;
    const ParametricPoint* amplitudes;
    std::uint32_t frequency_count;
    const ParametricPoint* frequencies;
    std::uint32_t transient_count;
    const ParametricTransient* transients;
    float lowest_hz, highest_hz;
    std::int32_t stream_frame;  ///< 0: the vibration is whole.
};

struct SystemParametricProperties {
    XrStructureType type;
    void* next;
    XrBool32 is_supported;
};

}  // namespace feelem::xr_runtime
