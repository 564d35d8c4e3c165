// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/wishes.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace feelem::viewer {
namespace {

struct Granter {
    Viewer& viewer;
    DeviceWords& devices;
    WindowWishes& window;

    ViewerState& state() const { return viewer.state; }
    bool has_cut(std::size_t cut) const { return cut < viewer.state.cuts.size(); }

    void operator()(Command wish) const { run(viewer, wish); }
    void operator()(const AssignSense& wish) const {
        if (wish.on)
            assign(state(), wish.key, wish.sense);
        else
            release(state(), wish.sense);
    }
    void operator()(const ReleaseAll& wish) const {
        for (const Sense sense : senses_of(state().presentation, wish.key)) release(state(), sense);
    }
    void operator()(const GoToStep& wish) const { set_step(state(), viewer.model, wish.step); }
    void operator()(const SetFactor& wish) const {
        state().deformation = wish.factor ? Deformation::Typed : Deformation::Automatic;
        if (wish.factor) state().typed_factor = *wish.factor;
        state().changed = true;
    }
    void operator()(const SetPart& wish) const { set_part(state(), wish.part, wish.look); }
    void operator()(const OnlyPart& wish) const { isolate_part(state(), wish.part); }
    void operator()(const ShowAllParts&) const { std::ranges::fill(state().parts, PartLook::Shown); }
    void operator()(const AddCut& wish) const {
        const std::size_t before = state().cuts.size();
        add_cut(state(), viewer.model);
        if (state().cuts.size() == before) return;
        const glm::vec3 size = glm::abs(wish.normal);
        turn_cut(
            state(),
            viewer.model,
            before,
            size.y > size.x && size.y >= size.z ? 1U
            : size.z > size.x                   ? 2U
                                                : 0U
        );
    }
    void operator()(const SetCut& wish) const {
        if (has_cut(wish.cut)) state().cuts[wish.cut] = {wish.plane, wish.is_on};
    }
    void operator()(const TurnCut& wish) const { turn_cut(state(), viewer.model, wish.cut, wish.axis); }
    void operator()(const RemoveCut& wish) const {
        if (has_cut(wish.cut))
            state().cuts.erase(state().cuts.begin() + static_cast<std::ptrdiff_t>(wish.cut));
    }
    void operator()(const GoToHotSpot& wish) const {
        const std::vector<HotSpot> spots = viewer.spots.of(state(), viewer.model);
        if (wish.spot >= spots.size()) return;
        go_to_node(state(), viewer.model, spots[wish.spot].node);
        state().hot.at = wish.spot;
    }
    void operator()(const GoToMarker& wish) const {
        if (wish.marker < state().markers.size())
            go_to_node(state(), viewer.model, state().markers[wish.marker].node);
    }
    void operator()(const RemoveMarker& wish) const {
        if (wish.marker < state().markers.size()) remove_marker(state(), state().markers[wish.marker].id);
    }
    void operator()(const LookFrom& wish) const { window.looks.push_back(wish); }
    void operator()(const SetColour& wish) const { set_colour(state(), wish.colour); }
    void operator()(const SetRange& wish) const {
        set_range(state(), wish.key, "manual", wish.range.lo, wish.range.hi);
    }
    void operator()(const SetRangeMode& wish) const { set_range(state(), wish.key, wish.mode); }
    void operator()(const SetLimit& wish) const { set_limit(state(), wish.key, wish.limit, wish.is_upper); }
    void operator()(const SetVolume& wish) const { state().person.master = wish.volume; }
    void operator()(const SetMono& wish) const { state().person.mono = wish.on; }
    void operator()(const SetStrength& wish) const { state().person.strength = wish.strength; }
    void operator()(const SetTheme& wish) const { devices.theme = wish.theme; }
    void operator()(const SetHelp& wish) const { devices.show_help = wish.on; }
    void operator()(const ReleasePin&) const { state().pin.reset(); }
    void operator()(const TryHeadset&) const { window.try_headset = true; }
};

}  // namespace

void grant(const UiWishes& wishes, Viewer& viewer, DeviceWords& devices, WindowWishes& window) {
    for (const UiWish& wish : wishes) std::visit(Granter{viewer, devices, window}, wish);
}

}  // namespace feelem::viewer
