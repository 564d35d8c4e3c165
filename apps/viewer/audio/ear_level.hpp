// SPDX-License-Identifier: Apache-2.0
// How strong the mixer into directions makes each pitch from each direction, and what makes up for it:
// otherwise loudness would change with pitch and place, and would seem to say something.
#pragma once

#include "viewer/audio/spatialiser.hpp"

#include <array>
#include <vector>

namespace feelem::viewer {

class EarLevel {
public:
    /// Factors at one direction.
    class Factors {
    public:
        /// For a sine of that pitch: both ears together get as much as when it is played in both, 0.7071 of
        /// it each.
        double at(double hz) const;

    private:
        friend class EarLevel;
        static constexpr std::size_t kPitches = 32;  ///< 50 Hz to 10.8 kHz, four an octave.
        std::array<double, kPitches> factors_{};
    };

    /// Measured with impulses, each 15 degrees; `spatialiser` is as before afterwards but for its clock.
    static EarLevel measured(Spatialiser& spatialiser);
    /// `direction` in the axes of the head; between the measured ones, in straight lines.
    Factors towards(const glm::vec3& direction) const;

private:
    std::vector<Factors> factors_;  ///< Elevation by azimuth.
};

}  // namespace feelem::viewer
