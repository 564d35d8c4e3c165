// SPDX-License-Identifier: Apache-2.0
// All that a person can change, in one plain struct, and the functions that change it: what commands, panels
// and hands call alike.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/core/look.hpp"
#include "viewer/core/model_source.hpp"

#include "feelem/present.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

enum class Deformation : std::uint8_t {
    Automatic,  ///< 5 % of the largest side.
    True,
    None,
    Typed,
};

struct CutState {
    CutPlane plane;
    bool on = true;
};

/// A note at a node.
struct Marker {
    int id = 0;
    std::int64_t node = 0;
    std::string text;
};
inline constexpr std::size_t kMostMarkers = 50;

/// What belongs to the person and not to the presentation.
struct Person {
    double master = 0.5;  ///< 0..1
    bool mono = false;
    bool captions = true;
    double strength = 1;  ///< Of vibration, 0..1.5.
    bool left_handed = false;
    bool wide = false;              ///< Tones over four octaves instead of three.
    std::optional<double> weakest;  ///< Amplitude of the weakest pulse, 0.08..0.4; empty: the presentation's.
    bool upright = true;            ///< Two hands turn the model about the vertical alone.
    bool by_touch = false;          ///< In the headset a touch is heard and felt without a press.
};

/// Which events are said.
struct EventOptions {
    bool limit = true, extremes = true, no_value = true, enter = true;
    bool band_edges = false;
};

struct HotOptions {
    std::size_t count = 5;
    double share = 0.05;          ///< Of the diagonal: nearer ones count as the same place.
    bool by_utilisation = false;  ///< By how much of their limit they use, over all results that have one.
    bool largest = true;
    bool shown = false;             ///< Their numbers stand on the model.
    std::optional<std::size_t> at;  ///< The one that was gone to last.
};

struct HotSpot {
    std::size_t part = 0;
    std::uint32_t vertex = 0;
    std::int64_t node = 0;
    std::string key;  ///< Of the presented result.
    double value = 0;
    std::optional<double> utilisation;  ///< Share of the limit that is used.
};

/// Where the person stands and looks, level with the floor.
struct Stand {
    glm::vec3 position{0};
    float yaw = 0;
};

/// What the desk's camera is to look at, and from how far: metres of the world.
struct LookAt {
    glm::vec3 place{0};
    float distance = 1;
};

struct ViewerState {
    Presentation presentation;
    std::size_t step = 0;  ///< Into Scene::steps.
    Deformation deformation = Deformation::Automatic;
    double typed_factor = 1;
    bool playing = false;  ///< A mode swings, other results go through their steps.
    double speed = 1;
    double angle = 0;  ///< Position in the swing of a mode, radians.
    bool edges = true;
    bool isolines = false;
    bool ghost = false;
    bool shading = false;         ///< Off: colours are read off a legend, so light leaves them alone.
    double shade_floor = 0.75;    ///< Share of the light that a place seen edge-on keeps, with shading.
    bool extremes = true;         ///< MX and MN stand on the model.
    std::vector<PartLook> parts;  ///< One a part.
    std::vector<CutState> cuts;   ///< At most kMostCuts.
    HotOptions hot;
    std::vector<Marker> markers;
    std::optional<std::int64_t> pin;  ///< The node that was gone to.
    std::optional<LookAt> look_at;  ///< A wish: the desk's camera goes there, and who has it takes this away.
    bool sound = true;              ///< False: muted.
    bool touch = true;              ///< False: still, no vibration.
    bool guide = false;             ///< Ticks lead to the largest value of what is seen.
    Person person;
    EventOptions events;
    glm::mat4 placement{1};  ///< Metres of the model -> metres of the world.
    /// Where the person stands; empty: the next frame of a headset lays the room out before them.
    std::optional<Stand> stand;
    std::uint64_t most_triangles = UINT64_MAX;  ///< What is drawn in time, as the renderer finds it.
    std::string notice;                         ///< What happened last, for people.
    bool leaves = false;                        ///< The person wants to leave.
    bool wants_save = false;  ///< A wish: who has a disk saves the presentation and takes this away.
    bool changed = false;     ///< The presentation differs from what was read or saved.
};

ViewerState first_state(const ViewedModel& model);
/// What a command needs to know beside the state.
struct Circumstances {
    bool is_headset = false;
    std::optional<std::int64_t> node;  ///< That is pointed at, or was pressed last.
};
void run(ViewerState& state, const ViewedModel& model, Command command, const Circumstances& now);

// Results and senses.

/// The effect that drives a sense; null: none does. Not for Sense::Shape.
const PresentedEffect* effect_of(const Presentation& presentation, Sense sense);
/// The result that drives a sense (also Sense::Shape); null: none does.
const PresentedResult* result_of(const Presentation& presentation, Sense sense);
/// The component that a presentation means, at a step. Empty: not there.
std::optional<FieldChoice> find_field(const Scene& scene, const PresentedResult& wanted, std::size_t step);
/// The same, whether or not the step has values of it: FieldChoice::values is kNoValues.
std::optional<FieldChoice> find_component(const Scene& scene, const PresentedResult& wanted);
inline constexpr std::size_t kNoValues = SIZE_MAX;
/// The range in force at the state's step, which all senses of the result share.
ValueRange range_at(const ViewerState& state, const ViewedModel& model, const PresentedResult& result);
/// Smallest and largest value at a step: over the model where the scene states it, else on the skin.
std::optional<std::array<double, 2>> extremes_at(
    const ViewedModel& model, const PresentedResult& result, std::size_t step
);
/// Solver's name and unit as people read them: "von Mises stress", "MPa".
std::string label_of(const Scene& scene, const PresentedResult& result);
std::string unit_of(const Scene& scene, const PresentedResult& result);

/// Lets a result drive a sense; what drove it before drives it no longer.
void assign(ViewerState& state, std::string_view key, Sense sense);
void release(ViewerState& state, Sense sense);
/// Puts a component of the scene on the list; its key.
std::string add_result(ViewerState& state, const Scene& scene, std::size_t result, std::size_t component);
/// `mode` as PresentedResult::range_mode; lo and hi count for "manual".
void set_range(ViewerState& state, std::string_view key, std::string_view mode, double lo = 0, double hi = 1);
/// Empty takes the limit away.
void set_limit(ViewerState& state, std::string_view key, std::optional<double> limit, bool is_upper = true);
void set_colour(ViewerState& state, const ColourEffect& effect);
void next_result(ViewerState& state, const ViewedModel& model);

// Steps and shape.

void set_step(ViewerState& state, const ViewedModel& model, std::size_t step);
/// Forward or back, round at the ends.
void step_by(ViewerState& state, const ViewedModel& model, int count);
/// Whether there is anything to play: several steps, or a mode with a shape.
bool can_play(const ViewerState& state, const ViewedModel& model);
/// The vector result that moves the shape at the step.
std::optional<FieldChoice> shape_field(const ViewerState& state, const ViewedModel& model);
/// The other part of a complex shape.
std::optional<FieldChoice> imaginary_shape(const ViewerState& state, const ViewedModel& model);
/// Whether the step is a mode whose shape can swing.
bool swings(const ViewerState& state, const ViewedModel& model);
/// Swings a second of a mode: never its real frequency. Seconds that a step stays.
inline constexpr double kSwings = 0.5, kStepSeconds = 0.6;
/// So many seconds have passed; `step_age`: how long the step has been shown.
void play(ViewerState& state, const ViewedModel& model, double seconds, double& step_age);
double automatic_factor(const ViewerState& state, const ViewedModel& model);
/// The deformation factor in force; 0: undeformed.
double factor_of(const ViewerState& state, const ViewedModel& model);

// Parts, cuts, places.

void set_part(ViewerState& state, std::size_t part, PartLook look);
void isolate_part(ViewerState& state, std::size_t part);
/// Through the middle of the model, across the first free axis.
void add_cut(ViewerState& state, const ViewedModel& model);
/// Across an axis (0 x, 1 y, 2 z), through the middle.
void turn_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, std::size_t axis);
void flip_cut(ViewerState& state, std::size_t cut);
/// By a share of the plane's way through the model.
void move_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, double share);
/// As far as the model reaches.
void place_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, float offset);
/// All off, or all on; the first time one is added.
void toggle_cuts(ViewerState& state, const ViewedModel& model);
/// Where along a direction the undeformed model begins and ends, model units minus origin.
std::array<float, 2> reach_along(const ViewedModel& model, const glm::vec3& normal);
/// Planes in force.
std::vector<CutPlane> cuts_of(const ViewerState& state);

/// Peaks of the visible skin, the most extreme first. Looks at every vertex: see HotSpotList.
std::vector<HotSpot> hot_spots(const ViewerState& state, const ViewedModel& model);
/// The same, found anew only when what they depend on is another.
class HotSpotList {
public:
    const std::vector<HotSpot>& of(const ViewerState& state, const ViewedModel& model);

private:
    std::string key_;
    std::vector<HotSpot> found_;
};
/// Forward or back through the hot spots: pins the node.
void next_hot_spot(ViewerState& state, const ViewedModel& model, int by);
/// A note at a node; says why not in the notice.
void place_marker(ViewerState& state, std::optional<std::int64_t> node);
void remove_marker(ViewerState& state, int id);
/// 1: at the limit. Empty without a limit, or where a share of it means nothing.
std::optional<double> utilisation(double value, std::optional<double> limit, bool limit_is_upper);
std::optional<double> utilisation(double value, const PresentedResult& result);

bool is_past_limit(double value, const PresentedResult& result);
/// Marks the node, and wishes the desk's camera there. Not on the skin: says so in the notice.
void go_to_node(ViewerState& state, const ViewedModel& model, std::int64_t node);

/// A level of detail that fits the budget and states bounds for all that is drawn; empty: the full triangles.
std::optional<std::size_t> level_within(
    const ViewedModel& model, std::uint64_t budget, std::span<const FieldChoice> drawn
);
/// What a headset draws in time, before anything is known of it.
inline constexpr std::uint64_t kHeadsetTriangles = 500'000;

// Where the model stands.

/// Metres.
inline constexpr float kTableSize = 0.8F, kTableDistance = 1.2F, kTableHeight = 1.0F;
Stand stand_of(const Pose& head);
/// A place before the person: metres to the right, above the floor, ahead.
glm::vec3 place_before(const Stand& stand, float right, float height, float ahead);
/// Puts the model on the table before the person, 0.8 m large.
void put_on_table(ViewerState& state, const ViewedModel& model, const Stand& stand);
void put_at_true_size(ViewerState& state, const ViewedModel& model, const Stand& stand);
/// Model units minus origin -> metres of the world.
glm::mat4 model_to_world(const ViewerState& state, const ViewedModel& model);

Look make_look(const ViewerState& state, const ViewedModel& model, bool is_headset);

/// Throws Error(WriteFailed).
void save_presentation(ViewerState& state, const ViewedModel& model, const std::string& path);

}  // namespace feelem::viewer
