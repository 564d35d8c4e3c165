// SPDX-License-Identifier: Apache-2.0
// Must: make number, colour, tone and pulse of a frame from one reading each. How: a place is read once a
// pointer; everything else takes its values from there, by the formulas of feelem/present.hpp.
#include "viewer/core/snapshot_maker.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// Less than this of the range, and of the model's size, is standing still.
constexpr double kStillValue = 0.005, kStillPlace = 0.0025;
/// Of the range: how far back over the limit a value must come before the next crossing counts.
constexpr double kLimitSlack = 0.01;
/// Of the range: how near to the end counts as being there; how far from it as having left.
constexpr double kAtEnd = 0.01, kLeftEnd = 0.02;
constexpr double kBandSlack = 0.005;
/// Seconds before an event comes again.
constexpr double kRefractory = 0.5;
constexpr double kWideLow = 48, kWideHigh = 96;

const Reading* reading_of(const Probed& probed, const std::string& key) {
    const auto found = std::ranges::find(probed.readings, key, &Reading::key);
    return found == probed.readings.end() ? nullptr : &*found;
}

/// What a sense is made of: its effect, its result, its range, the value at the place.
struct Sensed {
    const PresentedEffect* effect = nullptr;
    const PresentedResult* result = nullptr;
    ValueRange range;
    double value = std::nan("");
    bool is_there = false;
};

struct MakerFrame {
    SnapshotMaker& maker;
    const Interaction& interaction;
    const ViewerState& state;
    const ViewedModel& model;
    const FrameInput& input;

    Sensed sensed(const Probed& probed, Sense sense) const;
};

Sensed MakerFrame::sensed(const Probed& probed, Sense sense) const {
    Sensed out;
    out.effect = effect_of(state.presentation, sense);
    out.result = result_of(state.presentation, sense);
    const Reading* reading = out.result != nullptr ? reading_of(probed, out.result->key) : nullptr;
    if (out.effect == nullptr || reading == nullptr) return out;
    out.range = range_at(state, model, *out.result);
    out.value = reading->value;
    out.is_there = true;
    return out;
}

PitchEffect personal(PitchEffect effect, const Person& person) {
    if (person.wide) {
        effect.midi_low = kWideLow;
        effect.midi_high = kWideHigh;
    }
    return effect;
}

PulseEffect personal(PulseEffect effect, const Person& person) {
    if (person.weakest) effect.amplitude_min = *person.weakest;
    return effect;
}

/// Ticks of their own result, else those that stand in for pulses where nothing vibrates.
double tick_rate_at(const MakerFrame& frame, const Probed& probed, bool can_vibrate) {
    const Sensed ticks = frame.sensed(probed, Sense::Ticks);
    if (ticks.is_there) return tick_rate_of(ticks.value, ticks.range, ticks.effect->ticks);
    const Sensed pulses = frame.sensed(probed, Sense::Pulses);
    if (!pulses.is_there || can_vibrate || !pulses.effect->falls_back_to_ticks) return 0;
    return tick_rate_of(pulses.value, pulses.range, pulses.effect->ticks);
}

SoundFrame sound_of(
    const MakerFrame& frame, const Probed& probed, const PointerState& pointer, bool beyond, bool still
) {
    SoundFrame sound;
    const Sensed pitch = frame.sensed(probed, Sense::Pitch);
    if (pitch.is_there) {
        const Tone tone =
            tone_of(pitch.value, pitch.range, personal(pitch.effect->pitch, frame.state.person));
        sound.hz = tone.hz;
        sound.gain = tone.gain;
        sound.negative = tone.negative;
        const Normalised at = normalise(pitch.value, pitch.range);
        sound.tremolo = at.above && !pitch.result->limit;
        sound.dull = at.below;
    }
    sound.tick_rate = tick_rate_at(frame, probed, pointer.can_vibrate);
    sound.tremolo |= beyond;
    sound.still = still;
    const Pose& head = frame.input.head;
    sound.source = glm::conjugate(head.orientation) * (probed.world - head.position);
    return sound;
}

/// Ticks alone: the faster, the higher the value of what is seen ranks; at the top it is said once.
SoundFrame guiding_sound(
    const MakerFrame& frame, const Probed& probed, SnapshotMaker::Hand& hand, std::vector<SenseEvent>& events
) {
    SoundFrame sound;
    const Sensed seen = frame.sensed(probed, Sense::Colour);
    double rank = 0;
    if (seen.is_there && !std::isnan(seen.value)) {
        const FieldChoice field = reading_of(probed, seen.result->key)->field;
        rank = frame.maker.ranks.rank(frame.state, frame.model, field, seen.value);
        sound.tick_rate = guide_rate(rank);
    }
    const bool is_top = rank >= kTopRank;
    if (is_top && !hand.on_top) events.push_back(SenseEvent::Maximum);
    hand.on_top = is_top;
    return sound;
}

std::optional<HapticFrame> touch_of(const MakerFrame& frame, const Probed& probed, bool beyond, bool still) {
    const Sensed pulses = frame.sensed(probed, Sense::Pulses);
    if (!pulses.is_there) return std::nullopt;
    const PulseEffect effect = personal(pulses.effect->pulses, frame.state.person);
    const Pulse pulse = pulse_of(pulses.value, pulses.range, effect);
    return HapticFrame{pulse.rate, pulse.amplitude, effect.milliseconds, beyond, still};
}

/// Limits and gaps of all results that some sense shows; true while one is past its limit.
bool watch_limits(
    const MakerFrame& frame, const Probed& probed, SnapshotMaker::Hand& hand, std::vector<SenseEvent>& events
) {
    bool beyond = false;
    std::vector<std::string> done;
    for (const Sense sense : {Sense::Colour, Sense::Pitch, Sense::Ticks, Sense::Pulses}) {
        const Sensed sensed = frame.sensed(probed, sense);
        if (!sensed.is_there || std::ranges::count(done, sensed.result->key) > 0) continue;
        done.push_back(sensed.result->key);
        EventWatch& watch = hand.watches[sensed.result->key];
        const auto event = watch.update(sensed.value, sensed.range, *sensed.result);
        beyond |= watch.beyond();
        if (event) events.push_back(*event);
    }
    return beyond;
}

/// Once on the way in: within 1 % of the end; out again at 2 %.
bool reaches(double excess, double width, bool& is_there) {
    const bool here = excess <= (is_there ? kLeftEnd : kAtEnd) * width;
    const bool came = here && !is_there;
    is_there = here;
    return came;
}

void watch_ends(
    const MakerFrame& frame, const Probed& probed, SnapshotMaker::Hand& hand, std::vector<SenseEvent>& events
) {
    Sensed sensed = frame.sensed(probed, Sense::Pitch);
    if (!sensed.is_there) sensed = frame.sensed(probed, Sense::Colour);
    if (!frame.state.events.extremes || !sensed.is_there || std::isnan(sensed.value)) return;
    const auto ends = extremes_at(frame.model, *sensed.result, frame.state.step);
    if (!ends || !((*ends)[0] < (*ends)[1])) return;
    const double width = (*ends)[1] - (*ends)[0];
    if (reaches((*ends)[1] - sensed.value, width, hand.at_maximum)) events.push_back(SenseEvent::Maximum);
    if (reaches(sensed.value - (*ends)[0], width, hand.at_minimum)) events.push_back(SenseEvent::Minimum);
}

void watch_bands(
    const MakerFrame& frame, const Probed& probed, SnapshotMaker::Hand& hand, std::vector<SenseEvent>& events
) {
    const Sensed seen = frame.sensed(probed, Sense::Colour);
    if (!seen.is_there || std::isnan(seen.value) || seen.effect->colour.bands < 2) {
        hand.band.reset();
        return;
    }
    const int bands = seen.effect->colour.bands;
    const double at = normalise(seen.value, seen.range).position;
    const int band = band_of(at, bands);
    if (!hand.band) hand.band = band;
    if (band == *hand.band) return;
    // Within the slack of the edge that was crossed it stays as it was.
    const double edge = static_cast<double>(band > *hand.band ? band : band + 1) / bands;
    if (std::abs(at - edge) < kBandSlack) return;
    if (frame.state.events.band_edges) {
        events.push_back(band > *hand.band ? SenseEvent::BandUp : SenseEvent::BandDown);
    }
    hand.band = band;
}

void forget(SnapshotMaker::Hand& hand) {
    for (auto& [key, watch] : hand.watches) watch.left();
    hand.band.reset();
    hand.at_maximum = hand.at_minimum = hand.on_model = hand.on_top = false;
}

struct Heard {
    Probed probed;
    bool beyond = false, still = false;
    std::vector<SenseEvent> events;
};

/// A pointer that is held on the model.
Heard hear(const MakerFrame& frame, const SkinHit& hit, SnapshotMaker::Hand& hand) {
    Heard heard;
    heard.probed = read_place(frame.state, frame.model, hit);
    heard.still = hand.rest.update(heard.probed, frame.model.largest_side());
    if (!hand.on_model && frame.state.events.enter) heard.events.push_back(SenseEvent::Enter);
    hand.on_model = true;
    heard.beyond = watch_limits(frame, heard.probed, hand, heard.events);
    if (frame.state.guide) return heard;
    watch_ends(frame, heard.probed, hand, heard.events);
    watch_bands(frame, heard.probed, hand, heard.events);
    return heard;
}

bool is_wanted(const EventOptions& options, SenseEvent event) {
    if (event == SenseEvent::NoValue) return options.no_value;
    if (event == SenseEvent::LimitUp || event == SenseEvent::LimitDown) return options.limit;
    return true;
}

/// The gravest first; each waits before it comes again.
std::vector<SenseEvent> said_now(const MakerFrame& frame, std::vector<SenseEvent> events) {
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    std::vector<SenseEvent> out;
    for (const SenseEvent event : events) {
        if (!is_wanted(frame.state.events, event)) continue;
        const auto last = frame.maker.said.find(event);
        if (last != frame.maker.said.end() && frame.input.time - last->second < kRefractory) continue;
        frame.maker.said[event] = frame.input.time;
        out.push_back(event);
    }
    return out;
}

/// The mouse and the pin are felt in the right hand: a gamepad lies there.
std::size_t side_of(Pointer pointer) {
    return pointer == Pointer::Left ? 0 : 1;
}

}  // namespace

std::optional<SenseEvent> EventWatch::update(
    double value, const ValueRange& range, const PresentedResult& result
) {
    if (std::isnan(value)) {
        const bool is_first = !missing_;
        missing_ = true;
        beyond_ = false;
        return is_first ? std::optional(SenseEvent::NoValue) : std::nullopt;
    }
    missing_ = false;
    if (!result.limit) {
        beyond_ = false;
        return std::nullopt;
    }
    const double excess = result.limit_is_upper ? value - *result.limit : *result.limit - value;
    const double slack = kLimitSlack * std::abs(range.hi - range.lo);
    const bool before = beyond_;
    beyond_ = excess > 0 || (before && excess > -slack);
    if (beyond_ == before) return std::nullopt;
    return beyond_ ? SenseEvent::LimitUp : SenseEvent::LimitDown;
}

void EventWatch::left() noexcept {
    beyond_ = missing_ = false;
}

bool Rest::update(const Probed& probed, double size) {
    std::vector<double> values;
    for (const Reading& reading : probed.readings) {
        values.push_back(std::isnan(reading.value) ? -1 : reading.at.u);
    }
    bool rests = values.size() == values_.size();
    for (std::size_t k = 0; k < 3; ++k) {
        rests = rests && std::abs(probed.model[k] - place_[k]) <= kStillPlace * size;
    }
    for (std::size_t i = 0; rests && i < values.size(); ++i) {
        rests = std::abs(values[i] - values_[i]) <= kStillValue;
    }
    if (!rests) {
        place_ = probed.model;
        values_ = values;
    }
    return rests;
}

Snapshot make_snapshot(
    SnapshotMaker& maker,
    const Interaction& interaction,
    const ViewerState& state,
    const ViewedModel& model,
    const FrameInput& input
) {
    const MakerFrame frame{maker, interaction, state, model, input};
    Snapshot snapshot;
    snapshot.frame = maker.frame++;
    snapshot.time = input.time;
    snapshot.pointer = leading(interaction);
    for (std::size_t i = 0; i < kPointers; ++i) {
        const PointerState& pointer = interaction.pointers[i];
        const auto name = static_cast<Pointer>(i);
        const bool leads = snapshot.pointer == name;
        if (!pointer.hit || !pointer.is_held || !input.is_focused) {
            forget(maker.pointers[i]);
            if (leads) snapshot.probed = read_place(state, model, *pointer.hit);
            continue;
        }
        Heard heard = hear(frame, *pointer.hit, maker.pointers[i]);
        if (state.touch && pointer.can_vibrate) {
            snapshot.touch[side_of(name)] = touch_of(frame, heard.probed, heard.beyond, heard.still);
        }
        if (!leads) continue;
        snapshot.is_held = true;
        const SoundFrame sound = state.guide
                                     ? guiding_sound(frame, heard.probed, maker.pointers[i], heard.events)
                                     : sound_of(frame, heard.probed, pointer, heard.beyond, heard.still);
        snapshot.events = said_now(frame, heard.events);
        if (state.sound) snapshot.sound = sound;
        snapshot.probed = heard.probed;
    }
    if (snapshot.probed) {
        const Sensed seen = frame.sensed(*snapshot.probed, Sense::Colour);
        if (seen.is_there) snapshot.colour = colour_of(seen.value, seen.range, seen.effect->colour);
    }
    return snapshot;
}

}  // namespace feelem::viewer
