// SPDX-License-Identifier: Apache-2.0
// The presentation as JSON. Must: keep what it does not know, and the order of keys; say the path of the key
// that is wrong. How: writing starts from the document that was read and puts in only what has changed since.
#include "present/presentation_node.hpp"

#include "feelem/present.hpp"
#include "feelem/presented_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

constexpr std::array<std::string_view, 4> kScales{"lin", "log", "signed", "symlog"};
constexpr std::array<std::string_view, 4> kRangeModes{"auto", "allSteps", "percentile", "manual"};
constexpr std::array<std::string_view, 5> kTypes{"colour", "pitch", "ticks", "pulses", "shape"};
constexpr std::array<std::string_view, 5> kSenses{"visual", "audio", "audio", "touch", "visual"};
constexpr std::array<std::string_view, 3> kQuantise{"none", "semitone", "pentatonic"};
constexpr std::array<std::string_view, 2> kLimitKinds{"above", "below"};
/// What `deformation.ghost` says where there is one.
constexpr std::string_view kGhost = "featureEdges";
constexpr std::array<std::string_view, 3> kDeformationModes{"auto5percent", "manual", "none"};

PresentedResult read_result(const Node& node) {
    PresentedResult result;
    result.key = node["key"].text({});
    result.name = node["name"].text({});
    if (result.key.empty()) {
        node["key"].fail("every result needs a key, a short name of its own like \"T\"");
    }
    if (result.name.empty()) {
        node["name"].fail("every result needs a name, like \"temperature\"");
    }
    result.component = node["component"].text(result.component);
    result.location = node["location"].text(result.location);
    result.averaging = node["averaging"].text({});
    result.layer = node["layer"].text({});
    result.unit = node["unit"].text({});

    const Node range = node["range"];
    result.range_mode = kRangeModes[range["mode"].word(kRangeModes, 0)];
    result.scale = static_cast<Scale>(range["scale"].word(kScales, 0));
    result.symmetric = range["symmetric"].flag(false);
    result.percentile = range["p"].pair(result.percentile, {0, 100});
    result.lo = range["lo"].number();
    result.hi = range["hi"].number();
    if (result.range_mode == "manual" && (!result.lo || !result.hi)) {
        range.fail("a manual range needs lo and hi");
    }
    if (result.lo && result.hi && *result.lo > *result.hi) {
        range.fail(fmt::format("lo {} is above hi {}", *result.lo, *result.hi));
    }
    const Node limit = node["limit"];
    result.limit = limit["value"].number();
    result.limit_is_upper = limit["kind"].word(kLimitKinds, 0) == 0;
    result.limit_label = limit["label"].text({});
    return result;
}

TickEffect read_ticks(const Node& node) {
    TickEffect ticks;
    const auto rate = node["rateHz"].pair({ticks.rate_low, ticks.rate_high}, {0.1, 12.5});
    ticks.rate_low = rate[0];
    ticks.rate_high = rate[1];
    ticks.invert = node["invert"].flag(false);
    return ticks;
}

PulseEffect read_pulses(const Node& node) {
    PulseEffect pulses;
    const auto rate = node["rateHz"].pair({pulses.rate_low, pulses.rate_high}, {0.1, 12.5});
    pulses.rate_low = rate[0];
    pulses.rate_high = rate[1];
    pulses.amplitude_min = node["ampMin"].number(Interval{0.01, 1}).value_or(pulses.amplitude_min);
    pulses.milliseconds = node["pulseMs"].number(Interval{5, 200}).value_or(pulses.milliseconds);
    pulses.invert = node["invert"].flag(false);
    return pulses;
}

PitchEffect read_pitch(const Node& node) {
    PitchEffect pitch;
    const auto midi = node["midi"].pair({pitch.midi_low, pitch.midi_high}, {0, 127});
    pitch.midi_low = midi[0];
    pitch.midi_high = midi[1];
    pitch.gamma = node["gamma"].number(Interval{0.5, 2}).value_or(pitch.gamma);
    pitch.invert = node["invert"].flag(false);
    pitch.quantise = static_cast<Quantise>(node["quantise"].word(kQuantise, 0));
    pitch.sign_timbre = node["signTimbre"].flag(true);
    return pitch;
}

ColourEffect read_colour(const Node& node) {
    ColourEffect colour;
    colour.map = colour_maps()[node["map"].word(colour_maps(), 0)];
    colour.bands = node["bands"].integer(colour.bands, {0, 100});
    colour.invert = node["invert"].flag(false);
    colour.above = node["above"].colour(colour.above);
    colour.below = node["below"].colour(colour.below);
    colour.missing = node["nan"].colour(colour.missing);
    return colour;
}

PresentedEffect read_effect(const Node& node) {
    PresentedEffect effect;
    effect.result = node["result"].text({});
    if (node["type"].missing()) {
        node["type"].fail(fmt::format("an effect needs a type, one of: {}", fmt::join(kTypes, " ")));
    }
    const std::size_t type = node["type"].word(kTypes, 0);
    effect.sense = static_cast<Sense>(type);
    const std::string sense = node["sense"].text(std::string(kSenses[type]));
    if (sense != kSenses[type]) {
        node["sense"].fail(fmt::format("'{}' is of sense '{}', not '{}'", kTypes[type], kSenses[type], sense)
        );
    }
    switch (effect.sense) {
    case Sense::Colour: effect.colour = read_colour(node); break;
    case Sense::Pitch: effect.pitch = read_pitch(node); break;
    case Sense::Ticks: effect.ticks = read_ticks(node); break;
    case Sense::Pulses:
        effect.pulses = read_pulses(node);
        effect.falls_back_to_ticks = node["fallback"].absent() || !node["fallback"].missing();
        node["fallback"]["type"].word(Words(kTypes).subspan(2, 1), 0);
        effect.ticks = read_ticks(node["fallback"]);
        break;
    case Sense::Shape: break;
    }
    return effect;
}

const PresentedResult* find_result(const Presentation& presentation, std::string_view key) {
    const auto found = std::ranges::find(presentation.results, key, &PresentedResult::key);
    return found == presentation.results.end() ? nullptr : &*found;
}

/// The result that a key of the document names.
const PresentedResult& result_of(const Presentation& presentation, const Node& key) {
    const std::string wanted = key.text({});
    const PresentedResult* result = find_result(presentation, wanted);
    if (result == nullptr) {
        key.fail(fmt::format("no result has the key '{}'", wanted));
    }
    return *result;
}

/// One result a slot, no two tones, one limit: docs/effects.md 7.
void check_rules(const Presentation& presentation, const Node& root) {
    const auto effects = root["effects"].items();
    for (std::size_t i = 0; i < effects.size(); ++i) {
        const PresentedEffect& effect = presentation.effects[i];
        const PresentedResult& result = result_of(presentation, effects[i]["result"]);
        for (std::size_t j = 0; j < i; ++j) {
            if (presentation.effects[j].sense == effect.sense) {
                effects[i]["type"].fail(fmt::format(
                    "effects[{}] already uses '{}'; one result at a time",
                    j,
                    kTypes[static_cast<std::size_t>(effect.sense)]
                ));
            }
        }
        if (result.scale == Scale::Signed &&
            (effect.sense == Sense::Ticks || effect.sense == Sense::Pulses)) {
            effects[i]["type"].fail("a signed result cannot be told by a rate; give it colour or pitch");
        }
    }
    const auto results = root["results"].items();
    for (std::size_t i = 0; i < results.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const PresentedResult& one = presentation.results[i];
            const PresentedResult& other = presentation.results[j];
            if (one.key == other.key) {
                results[i]["key"].fail(fmt::format("results[{}] already has the key '{}'", j, one.key));
            }
            if (one.limit && other.limit && one.limit_label == other.limit_label) {
                results[i]["limit"].fail(
                    fmt::format("results[{}] has a limit of the same label '{}'", j, one.limit_label)
                );
            }
        }
    }
}

/// A member of an object; null where there is none, or no object.
const Json& member_of(const Json& object, const char* key) {
    static const Json kNone;
    const auto found = object.find(key);
    return object.is_object() && found != object.end() ? *found : kNone;
}

bool flag_or(const Json& value, bool other) {
    return value.is_boolean() ? value.get<bool>() : other;
}

double share_or(const Json& value, double other) {
    return value.is_number() ? std::clamp(value.get<double>(), 0.0, 1.0) : other;
}

/// Which of the effects is the colour's; null where none is.
template <class Document>
auto colour_object(Document& document) -> decltype(&document["effects"][0]) {
    const auto effects = document.find("effects");
    if (effects == document.end() || !effects->is_array()) return nullptr;
    for (auto& effect : *effects) {
        if (member_of(effect, "type") == Json(kTypes[0])) return &effect;
    }
    return nullptr;
}

PresentedView read_view(const Json& document) {
    PresentedView view;
    if (const Json* colour = colour_object(document)) {
        view.isolines = flag_or(member_of(*colour, "isolines"), view.isolines);
        view.shade_floor = share_or(member_of(*colour, "shadeFloor"), view.shade_floor);
    }
    view.ghost = member_of(member_of(document, "deformation"), "ghost") == Json(kGhost);
    const Json& events = member_of(document, "events");
    view.limit_events = flag_or(member_of(events, "limit"), view.limit_events);
    view.extreme_events = flag_or(member_of(events, "extremes"), view.extreme_events);
    view.no_value_events = flag_or(member_of(events, "noData"), view.no_value_events);
    view.band_events = flag_or(member_of(events, "bandEdges"), view.band_events);
    const Json& audio = member_of(document, "audio");
    view.master = share_or(member_of(audio, "master"), view.master);
    view.mono = flag_or(member_of(audio, "mono"), view.mono);
    view.captions = flag_or(member_of(audio, "captions"), view.captions);
    return view;
}

Presentation read_presentation(const Json& document, std::string_view name) {
    const Node root(document, name);
    if (!document.is_object()) {
        root.fail(fmt::format("expected an object, found {}", document.type_name()));
    }
    if (const std::string format = root["format"].text("feelem-presentation");
        format != "feelem-presentation") {
        root["format"].fail(fmt::format("expected feelem-presentation, found '{}'", format));
    }
    if (const int version = root["version"].integer(1, {1, 1e6}); version != 1) {
        root["version"].fail(fmt::format("this program reads version 1, found {}", version));
    }
    Presentation presentation;
    presentation.title = root["title"].text({});
    if (const Node step = root["step"]; !step.missing()) {
        presentation.step = {
            step["input"].integer(0, {0, 1e9}),
            step["step"].integer(1, {-1e9, 1e9}),
            step["substep"].integer(1, {-1e9, 1e9})};
    }
    for (const Node& node : root["results"].items()) {
        presentation.results.push_back(read_result(node));
    }
    for (const Node& node : root["effects"].items()) {
        presentation.effects.push_back(read_effect(node));
    }
    check_rules(presentation, root);
    for (const Node& node : root["probe"]["card"].items()) {
        presentation.card.push_back(result_of(presentation, node).key);
    }
    const Node deformation = root["deformation"];
    const std::size_t mode = deformation["mode"].word(kDeformationModes, 0);
    presentation.deformation_factor = deformation["factor"].number();
    if (!deformation["result"].missing() && mode != 2) {
        presentation.deformation_result = result_of(presentation, deformation["result"]).key;
    }
    if (mode == 1 && !presentation.deformation_factor) {
        deformation["factor"].fail("a manual deformation needs a factor");
    }
    return presentation;
}

Json optional_json(const std::optional<double>& number) {
    return number ? Json(*number) : Json(nullptr);
}

std::string hex(const Rgb& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

/// Puts members of a struct into an object, but only those that differ from what the object already says.
template <class Struct>
class Change {
public:
    Change(Json& object, const Struct& now, const Struct* before)
        : object_(object), now_(now), before_(before) {}

    /// `make` turns a struct into the key's value; with nothing before, every key is written.
    template <class Make>
    Change& put(const char* key, Make make, const char* group = nullptr) {
        Json value = make(now_);
        if (before_ == nullptr || make(*before_) != value) {
            Json& object = group == nullptr ? object_ : object_[group];
            object[key] = std::move(value);
        }
        return *this;
    }

private:
    Json& object_;
    const Struct& now_;
    const Struct* before_;
};

void write_result(Json& object, const PresentedResult& now, const PresentedResult* before) {
    using R = PresentedResult;
    Change<R> change(object, now, before);
    change.put("key", [](const R& r) { return Json(r.key); })
        .put("name", [](const R& r) { return Json(r.name); })
        .put("component", [](const R& r) { return Json(r.component); })
        .put("location", [](const R& r) { return Json(r.location); })
        .put("unit", [](const R& r) { return r.unit.empty() ? Json(nullptr) : Json(r.unit); })
        .put(
            "mode", [](const R& r) { return Json(r.range_mode); }, "range"
        )
        .put(
            "lo", [](const R& r) { return optional_json(r.lo); }, "range"
        )
        .put(
            "hi", [](const R& r) { return optional_json(r.hi); }, "range"
        )
        .put(
            "scale", [](const R& r) { return Json(kScales[static_cast<std::size_t>(r.scale)]); }, "range"
        )
        .put(
            "symmetric", [](const R& r) { return Json(r.symmetric); }, "range"
        );
    if (!now.averaging.empty() || before != nullptr) {
        change.put("averaging", [](const R& r) { return Json(r.averaging); });
    }
    if (!now.layer.empty() || (before != nullptr && !before->layer.empty())) {
        change.put("layer", [](const R& r) { return Json(r.layer); });
    }
    if (now.range_mode == "percentile" || before != nullptr) {
        change.put(
            "p", [](const R& r) { return Json(r.percentile); }, "range"
        );
    }
    if (now.limit) {
        change
            .put(
                "value", [](const R& r) { return optional_json(r.limit); }, "limit"
            )
            .put(
                "kind", [](const R& r) { return Json(r.limit_is_upper ? "above" : "below"); }, "limit"
            )
            .put(
                "label", [](const R& r) { return Json(r.limit_label); }, "limit"
            );
    } else if (before != nullptr && before->limit) {
        object.erase("limit");
    }
}

Json rate(double low, double high) {
    return Json::array({low, high});
}

void write_colour(Change<PresentedEffect>& change) {
    using E = PresentedEffect;
    change.put("map", [](const E& e) { return Json(e.colour.map); })
        .put("bands", [](const E& e) { return Json(e.colour.bands); })
        .put("invert", [](const E& e) { return Json(e.colour.invert); })
        .put("above", [](const E& e) { return Json(hex(e.colour.above)); })
        .put("below", [](const E& e) { return Json(hex(e.colour.below)); })
        .put("nan", [](const E& e) { return Json(hex(e.colour.missing)); });
}

void write_pitch(Change<PresentedEffect>& change) {
    using E = PresentedEffect;
    change.put("midi", [](const E& e) { return rate(e.pitch.midi_low, e.pitch.midi_high); })
        .put("gamma", [](const E& e) { return Json(e.pitch.gamma); })
        .put("invert", [](const E& e) { return Json(e.pitch.invert); })
        .put(
            "quantise", [](const E& e) { return Json(kQuantise[static_cast<std::size_t>(e.pitch.quantise)]); }
        )
        .put("signTimbre", [](const E& e) { return Json(e.pitch.sign_timbre); });
}

Json fallback_json(const PresentedEffect& effect) {
    return effect.falls_back_to_ticks ? Json{
                                            {"sense", "audio"},
                                            {"type", "ticks"},
                                            {"rateHz", rate(effect.ticks.rate_low, effect.ticks.rate_high)},
                                            {"invert", effect.ticks.invert},
                                        }
                                      : Json(nullptr);
}

void write_effect(Json& object, const PresentedEffect& now, const PresentedEffect* before) {
    using E = PresentedEffect;
    const auto type = [](const E& e) { return static_cast<std::size_t>(e.sense); };
    Change<E> change(object, now, before);
    change.put(
              "result", [](const E& e) { return Json(e.result); }
    ).put("sense", [&](const E& e) {
         return Json(kSenses[type(e)]);
     }).put("type", [&](const E& e) { return Json(kTypes[type(e)]); });
    switch (now.sense) {
    case Sense::Colour: write_colour(change); break;
    case Sense::Pitch: write_pitch(change); break;
    case Sense::Ticks:
        change.put(
                  "rateHz", [](const E& e) { return rate(e.ticks.rate_low, e.ticks.rate_high); }
        ).put("invert", [](const E& e) { return Json(e.ticks.invert); });
        break;
    case Sense::Pulses:
        change.put("rateHz", [](const E& e) { return rate(e.pulses.rate_low, e.pulses.rate_high); })
            .put("ampMin", [](const E& e) { return Json(e.pulses.amplitude_min); })
            .put("pulseMs", [](const E& e) { return Json(e.pulses.milliseconds); })
            .put("invert", [](const E& e) { return Json(e.pulses.invert); })
            .put("fallback", fallback_json);
        break;
    case Sense::Shape: break;
    }
}

/// Rewrites an array of the document, each item starting from the one that was there for the same thing.
template <class Item, class Same, class Write>
void write_items(
    Json& document,
    const char* key,
    const std::vector<Item>& now,
    const std::vector<Item>& before,
    Same same,
    Write write
) {
    if (now == before && (document.contains(key) || now.empty())) {
        return;
    }
    const Json old = document.contains(key) ? document[key] : Json();
    Json items = Json::array();
    for (const Item& item : now) {
        const auto found = std::ranges::find_if(before, [&](const Item& b) { return same(b, item); });
        const bool known = found != before.end();
        Json object = known ? old[static_cast<std::size_t>(found - before.begin())] : Json::object();
        write(object, item, known ? &*found : nullptr);
        items.push_back(std::move(object));
    }
    document[key] = std::move(items);
}

/// A factor that somebody has chosen is manual; no shape, none.
Json deformation_mode(const Presentation& presentation) {
    if (presentation.deformation_result.empty()) return kDeformationModes[2];
    return presentation.deformation_factor ? kDeformationModes[1] : kDeformationModes[0];
}

/// What a document holds besides results and effects when nobody has said otherwise (docs/effects.md 8).
constexpr const char* kFreshDocument = R"({
    "format": "feelem-presentation", "version": 1, "title": "", "results": [], "effects": [],
    "events": {"limit": true, "bandEdges": false, "extremes": true, "noData": true},
    "probe": {"gate": "hold", "interpolate": true,
              "filter": {"type": "oneEuro", "minCutoff": 1.0, "beta": 0.02}, "card": []},
    "deformation": {"result": null, "mode": "auto5percent", "factor": null, "ghost": "featureEdges"},
    "view": {"preset": "tabletop", "scale": null, "clip": [], "pins": []},
    "audio": {"master": 0.5, "mono": false, "limiterDb": -6, "captions": true}})";

}  // namespace

Presentation parse_presentation(std::string_view json, std::string_view name) {
    Presentation presentation = read_presentation(parse_json(json, name), name);
    presentation.json = json;
    return presentation;
}

std::string presentation_json(const Presentation& presentation) {
    using P = Presentation;
    Json document =
        parse_json(presentation.json.empty() ? kFreshDocument : presentation.json, "presentation");
    const P before = read_presentation(document, "presentation");
    Change<P> change(document, presentation, &before);
    change.put("title", [](const P& p) { return Json(p.title); });
    change.put("step", [](const P& p) {
        return p.step ? Json{{"input", (*p.step)[0]}, {"step", (*p.step)[1]}, {"substep", (*p.step)[2]}}
                      : Json();
    });
    write_items(
        document,
        "results",
        presentation.results,
        before.results,
        [](const auto& a, const auto& b) { return a.key == b.key; },
        write_result
    );
    write_items(
        document,
        "effects",
        presentation.effects,
        before.effects,
        [](const auto& a, const auto& b) { return a.sense == b.sense; },
        write_effect
    );
    change
        .put(
            "card", [](const P& p) { return Json(p.card); }, "probe"
        )
        .put(
            "result",
            [](const P& p) { return p.deformation_result.empty() ? Json() : Json(p.deformation_result); },
            "deformation"
        )
        .put(
            "factor", [](const P& p) { return optional_json(p.deformation_factor); }, "deformation"
        )
        .put("mode", deformation_mode, "deformation");
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

PresentedView presented_view(std::string_view json) {
    return json.empty() ? PresentedView{} : read_view(parse_json(json, "presentation"));
}

std::string with_presented_view(std::string_view json, const PresentedView& view) {
    Json document = parse_json(json, "presentation");
    const PresentedView before = read_view(document);
    if (view.ghost != before.ghost) document["deformation"]["ghost"] = view.ghost ? Json(kGhost) : Json();
    Json* colour = colour_object(document);
    if (colour != nullptr && view.isolines != before.isolines) (*colour)["isolines"] = view.isolines;
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ValueRange value_range(const PresentedResult& result) {
    return {
        result.lo.value_or(std::numeric_limits<double>::quiet_NaN()),
        result.hi.value_or(std::numeric_limits<double>::quiet_NaN()),
        result.scale};
}

}  // namespace feelem
