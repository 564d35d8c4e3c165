// SPDX-License-Identifier: Apache-2.0
// Puts one stream of sound into a direction of the head: OpenAL Soft as a mixer into memory, never as a
// device, so that tests hear what people hear and a lost sound device takes no state with it.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace feelem::viewer {

/// Everything is made in steps of so many samples, whatever the device asks for: same calls, same samples.
inline constexpr std::size_t kSoundStep = 128;
using MonoStep = std::array<float, kSoundStep>;
using StereoStep = std::array<float, 2 * kSoundStep>;

class Spatialiser {
public:
    Spatialiser();
    ~Spatialiser();
    Spatialiser(const Spatialiser&) = delete;
    Spatialiser& operator=(const Spatialiser&) = delete;

    /// "HRTF default-48000", "panned"; "centred" when OpenAL could not be had: then `render` gives silence.
    const std::string& words() const;
    bool works() const;
    /// `direction` in the axes of the head (right, up, back); its length means nothing. What comes out lags
    /// by one step.
    void render(const MonoStep& mono, const glm::vec3& direction, StereoStep& stereo);

private:
    struct State;
    class Turn;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
