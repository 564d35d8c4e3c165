// SPDX-License-Identifier: Apache-2.0
// Which result drives which sense when nobody has said so (docs/effects.md 7).
// Must: one result a slot, never two tones. Algorithm: one component of each result, the most telling four;
// the first of them that suits it is seen; each other takes the first free slot of its kind's list.
#include "feelem/present.hpp"

#include <algorithm>
#include <array>

namespace feelem {
namespace {

constexpr std::size_t kMaxResults = 4;

/// What a kind of result suits. Row order is the order of importance. Names and components are lists of
/// words; an empty list means any.
struct Kind {
    std::string_view names;
    std::string_view components;
    std::string_view key;        ///< Empty: made of the name.
    std::array<Sense, 3> slots;  ///< In order of preference; Shape: no more.
    bool percentile = false;     ///< Singular peaks would spoil the range.
    bool sign_matters = false;   ///< Zero has a meaning: tension and pressure, not hot and cold.
    bool needs_colour = false;   ///< It is seen rather than anything below it in the table.
};
using enum Sense;
constexpr std::array<Kind, 19> kKinds{{
    {"temperature", "", "T", {Colour, Pitch, Pulses}, false, false, true},
    {"displacement", "magnitude", "U", {Pitch, Ticks, Colour}},
    {"stress", "von_mises tresca", "S", {Pulses, Ticks, Colour}, true, false, true},
    {"utilisation", "", "UT", {Ticks, Pulses, Colour}, false, false, true},
    {"safety_factor", "", "SF", {Ticks, Pulses, Colour}, false, false, true},
    {"plastic_strain", "equivalent von_mises value", "PE", {Ticks, Pulses, Colour}, true, false, true},
    {"damage", "", "D", {Ticks, Pulses, Colour}, false, false, true},
    {"contact_pressure", "", "CP", {Pulses, Ticks, Colour}, true, false, true},
    {"pressure", "", "P", {Pitch, Colour, Shape}, false, true, true},
    {"stress", "principal_1", "S", {Pitch, Colour, Shape}, true, true, true},
    {"stress", "", "S", {Pitch, Colour, Shape}, true, true, true},
    {"heat_flux", "magnitude", "Q", {Ticks, Pitch, Colour}, true, false, true},
    {"velocity acceleration", "magnitude", "", {Ticks, Pitch, Colour}, false, false, true},
    {"electric_potential", "", "EP", {Pitch, Colour, Shape}, false, true, true},
    {"strain elastic_strain", "equivalent von_mises", "E", {Pulses, Ticks, Colour}, true, false, true},
    {"displacement", "", "U", {Pitch, Colour, Shape}, false, true},
    {"", "magnitude", "", {Ticks, Pitch, Colour}, false, false, true},
    {"", "value", "", {Pitch, Colour, Shape}, false, true, true},
    {"", "", "", {Pitch, Colour, Shape}, true, true, true},
}};
/// Ids and measures of the model itself: never a sound.
constexpr std::array<std::string_view, 6> kSeenOnly{
    "material", "part", "id", "status", "thickness", "density"};

struct Choice {
    const Candidate* candidate;
    std::size_t kind;
    bool seen_only;
};

std::string_view base_name(const Candidate& candidate) {
    return std::string_view(candidate.name).substr(0, candidate.name.find('@'));
}

bool lists(std::string_view words, std::string_view word) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (words.substr(0, end) == word) {
            return true;
        }
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

std::size_t kind_of(const Candidate& candidate) {
    const auto suits = [&](const Kind& kind) {
        return (kind.names.empty() || lists(kind.names, base_name(candidate))) &&
               (kind.components.empty() || lists(kind.components, candidate.component));
    };
    return static_cast<std::size_t>(std::ranges::find_if(kKinds, suits) - kKinds.begin());
}

bool is_seen_only(const Candidate& candidate) {
    const std::string_view name = base_name(candidate);
    return std::ranges::find(kSeenOnly, name) != kSeenOnly.end() || name.ends_with("_id") ||
           name.ends_with("_status");
}

/// One choice a result name, the most telling first.
std::vector<Choice> most_telling(std::span<const Candidate> candidates) {
    std::vector<Choice> choices;
    for (const Candidate& candidate : candidates) {
        const Choice choice{&candidate, kind_of(candidate), is_seen_only(candidate)};
        const auto same = std::ranges::find_if(choices, [&](const Choice& c) {
            return c.candidate->name == candidate.name;
        });
        if (same == choices.end()) {
            choices.push_back(choice);
        } else if (choice.kind < same->kind) {
            *same = choice;
        }
    }
    std::ranges::stable_sort(choices, [](const Choice& a, const Choice& b) {
        return std::pair(a.seen_only, a.kind) < std::pair(b.seen_only, b.kind);
    });
    choices.resize(std::min(choices.size(), kMaxResults));
    return choices;
}

std::string key_for(const Choice& choice, const std::vector<PresentedResult>& results) {
    std::string key(kKinds[choice.kind].key);
    if (key.empty()) {
        const std::string_view name = base_name(*choice.candidate);
        const char first = name.empty() ? 'R' : name.front();
        key = first >= 'a' && first <= 'z' ? std::string(1, static_cast<char>(first - 'a' + 'A')) : "R";
    }
    const std::string stem = key;
    for (int number = 2; std::ranges::find(results, key, &PresentedResult::key) != results.end(); ++number) {
        key = stem + std::to_string(number);
    }
    return key;
}

PresentedResult result_for(const Choice& choice, const std::vector<PresentedResult>& results) {
    const Kind& kind = kKinds[choice.kind];
    PresentedResult result;
    result.key = key_for(choice, results);
    result.name = choice.candidate->name;
    result.component = choice.candidate->component;
    result.unit = choice.candidate->unit;
    if (kind.percentile) {
        result.range_mode = "percentile";
    }
    if (kind.sign_matters && choice.candidate->has_sign) {
        result.scale = Scale::Signed;
        result.symmetric = true;
    }
    return result;
}

PresentedEffect effect_for(const PresentedResult& result, Sense sense) {
    PresentedEffect effect;
    effect.result = result.key;
    effect.sense = sense;
    if (sense == Colour) {
        effect.colour.map = result.scale == Scale::Signed ? "cool_warm" : "batlow";
        effect.colour.invert = result.name == "safety_factor";
    } else if (sense == Ticks) {
        effect.ticks.invert = result.name == "safety_factor";
    } else if (sense == Pulses) {
        effect.pulses.invert = result.name == "safety_factor";
    }
    return effect;
}

/// The slots a result may take, best first: R4 signed ones have no rate, R5 mostly-zero ones prefer one, R6
/// ids have colour only.
std::vector<Sense> slots_for(const Choice& choice, const PresentedResult& result) {
    if (choice.seen_only) {
        return {Colour};
    }
    std::vector<Sense> slots;
    for (const Sense slot : kKinds[choice.kind].slots) {
        const bool rate = slot == Ticks || slot == Pulses;
        if (slot != Shape && !(rate && result.scale == Scale::Signed)) {
            slots.push_back(slot);
        }
    }
    if (choice.candidate->mostly_zero && result.scale != Scale::Signed) {
        for (const Sense rate : {Pulses, Ticks}) {
            std::erase(slots, rate);
            slots.insert(slots.begin(), rate);
        }
    }
    return slots;
}

}  // namespace

Presentation choose_presentation(std::span<const Candidate> candidates, std::string_view title) {
    const std::vector<Choice> choices = most_telling(candidates);
    Presentation presentation;
    presentation.title = title;
    for (const Choice& choice : choices) {
        presentation.results.push_back(result_for(choice, presentation.results));
        presentation.card.push_back(presentation.results.back().key);
        if (base_name(*choice.candidate) == "displacement" && presentation.deformation_result.empty()) {
            presentation.deformation_result = presentation.results.back().key;
        }
    }
    if (choices.empty()) {
        return presentation;
    }
    auto seen = std::ranges::find_if(choices, [](const Choice& c) {
        return kKinds[c.kind].needs_colour && !c.seen_only && !c.candidate->mostly_zero;
    });
    const std::size_t seen_at = seen == choices.end() ? 0 : static_cast<std::size_t>(seen - choices.begin());

    std::vector<PresentedEffect>& effects = presentation.effects;
    effects.push_back(effect_for(presentation.results[seen_at], Colour));
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const PresentedResult& result = presentation.results[i];
        const auto is_free = [&](Sense slot) {
            return std::ranges::find(effects, slot, &PresentedEffect::sense) == effects.end();
        };
        const std::vector<Sense> slots = slots_for(choices[i], result);
        if (const auto slot = std::ranges::find_if(slots, is_free); i != seen_at && slot != slots.end()) {
            effects.push_back(effect_for(result, *slot));
        }
    }
    if (choices.size() == 1 && !choices[0].seen_only) {
        effects.push_back(effect_for(presentation.results[0], Pitch));  // Heard as well as seen.
    }
    return presentation;
}

}  // namespace feelem
