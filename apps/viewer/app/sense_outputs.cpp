// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/sense_outputs.hpp"

#include <utility>

namespace feelem::viewer {

std::vector<SentPulse> SenseOutputs::play(
    const Snapshot& snapshot, const ViewerState& state, bool is_focused
) {
    engine_.set_muted(!state.sound);
    engine_.set_master(state.person.master);
    engine_.set_mono(state.person.mono);
    engine_.update(snapshot, is_focused);
    output_.update(snapshot.time);
    haptics_.set_strength(state.person.strength);
    if (is_focused && state.touch) return haptics_.update(snapshot);
    haptics_.stop();
    return {};
}

void SenseOutputs::set_sink(Side side, HapticSink* sink) {
    if (std::exchange(sinks_[static_cast<std::size_t>(side)], sink) != sink) haptics_.set_sink(side, sink);
}

void SenseOutputs::stop() {
    engine_.stop();
    haptics_.stop();
}

std::string SenseOutputs::sound_trouble() const {
    if (!wants_device_ || output_.is_heard()) return {};
    return output_.trouble().empty() ? "Nothing is heard: no sound device"
                                     : "Nothing is heard: " + output_.trouble();
}

std::string SenseOutputs::touch_trouble() const {
    for (const Side side : {Side::Left, Side::Right})
        if (haptics_.was_refused(side)) return "A hand refused to vibrate: ticks stand in";
    return {};
}

}  // namespace feelem::viewer
