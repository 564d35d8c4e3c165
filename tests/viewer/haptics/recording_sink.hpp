// SPDX-License-Identifier: Apache-2.0
// A hand that writes down what it feels.
#pragma once

#include "viewer/haptics/haptic_sink.hpp"

#include <vector>

namespace feelem::test {

class RecordingSink : public viewer::HapticSink {
public:
    struct Call {
        double amplitude, milliseconds;
    };
    bool pulse(double amplitude, double milliseconds) override {
        if (refuses) return false;
        calls.push_back({amplitude, milliseconds});
        return true;
    }
    void stop() override { ++stops; }

    std::vector<Call> calls;
    int stops = 0;
    bool refuses = false;
};

}  // namespace feelem::test
