// SPDX-License-Identifier: Apache-2.0
// The fixed signals of the sound engine, always the same: those of web/src/sense/signals.ts.
#pragma once

#include <vector>

namespace feelem::viewer {

/// One tick: white noise through a band-pass at 3.2 kHz; 1 ms attack, decay of 4 ms, 16 ms in all.
std::vector<float> tick_samples();
/// Two seconds of pink noise (Kellet's filter), peak 1.
std::vector<float> pink_noise();
/// Untouched up to a knee, then bent so that nothing passes -6 dBFS.
double limited(double x);

/// Second-order low-pass, coefficients as Web Audio's BiquadFilterNode has them.
class LowPass {
public:
    LowPass(double hz, double quality_decibel);
    void set(double hz);
    double next(double x);

private:
    double quality_;
    double b0_ = 0, b1_ = 0, a1_ = 0, a2_ = 0;
    double x1_ = 0, x2_ = 0, y1_ = 0, y2_ = 0;
};

}  // namespace feelem::viewer
