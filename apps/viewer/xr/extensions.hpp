// SPDX-License-Identifier: Apache-2.0
// Ways to shake a controller that are younger than Debian 12's OpenXR headers (1.0.20), laid out as in the
// registry: XR_FB_haptic_amplitude_envelope 1, XR_EXT_haptic_parametric 1.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>

namespace feelem::viewer::xr {

inline constexpr const char* kEnvelopeExtension = "XR_FB_haptic_amplitude_envelope";
inline constexpr auto kEnvelopeType = static_cast<XrStructureType>(1000173001);

struct HapticEnvelope {  // XrHapticAmplitudeEnvelopeVibrationFB
    XrStructureType type = kEnvelopeType;
    const void* next = nullptr;
    XrDuration duration = 0;
    std::uint32_t amplitudeCount = 0;
    const float* amplitudes = nullptr;
};

inline constexpr const char* kParametricExtension = "XR_EXT_haptic_parametric";
inline constexpr auto kParametricType = static_cast<XrStructureType>(1000775000);
inline constexpr auto kSystemParametricType = static_cast<XrStructureType>(1000775002);

struct ParametricPoint {  // XrHapticParametricPointEXT
    XrDuration time = 0;
    float value = 0;
};

struct HapticParametric {  // XrHapticParametricVibrationEXT
    XrStructureType type = kParametricType;
    const void* next = nullptr;
    std::uint32_t amplitudePointCount = 0;
    const ParametricPoint* amplitudePoints = nullptr;
    std::uint32_t frequencyPointCount = 0;
    const ParametricPoint* frequencyPoints = nullptr;
    std::uint32_t transientCount = 0;
    const void* transients = nullptr;
    float minFrequencyHz = XR_FREQUENCY_UNSPECIFIED;
    float maxFrequencyHz = XR_FREQUENCY_UNSPECIFIED;
    std::int32_t streamFrameType = 0;  ///< The vibration is whole, no frame of a stream.
};

struct SystemHapticParametric {  // XrSystemHapticParametricPropertiesEXT
    XrStructureType type = kSystemParametricType;
    void* next = nullptr;
    XrBool32 supportsParametricHaptics = XR_FALSE;
};

}  // namespace feelem::viewer::xr
