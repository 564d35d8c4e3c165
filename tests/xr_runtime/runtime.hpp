// SPDX-License-Identifier: Apache-2.0
// A runtime of OpenXR for tests: no device, no compositor, no clock of its own. A script says what the person
// and the headset do; a record says what the program did. Swapchain images are textures in the program's own
// context.
//
//   FEELEM_XR_SCRIPT  file of lines as script.hpp has them
//   FEELEM_XR_RECORD  file that lines of JSON are added to
//   FEELEM_XR_FAULTS  words: no_headset no_service slow_service no_stage no_array no_egl no_opengl
//                     no_depth no_hands no_envelope no_parametric no_srgb leaves_gl_error loses_context;
//                     read anew whenever it matters
#pragma once

#include "script.hpp"

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string_view>

namespace feelem::xr_runtime {

inline constexpr XrDuration kPeriod = 11'111'111;
inline constexpr std::int32_t kEyeWidth = 96, kEyeHeight = 80;
inline constexpr XrSystemId kSystem = 1;

struct Action {
    std::uint64_t set = 0;
    std::string name;
    XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
    std::vector<XrPath> subactions;
};

struct ActionSet {
    std::string name;
    bool is_attached = false;
};

struct Binding {
    std::uint64_t action = 0;
    std::string path;
};

struct Instance {
    std::set<std::string> extensions;
    std::vector<std::string> paths;  ///< XrPath - 1
    std::map<std::string, std::vector<Binding>> suggested;
    std::deque<XrEventDataBuffer> events;
    bool is_lost = false;
    bool knows_requirements = false;
    bool has_attached = false;
};

/// What to make current again after the program's context has been taken away: a platform's own handles.
struct ContextKept {
    void *display = nullptr, *context = nullptr;
    bool is_egl = false;
};

struct Session {
    XrSessionState state = XR_SESSION_STATE_UNKNOWN, target = XR_SESSION_STATE_FOCUSED;
    bool is_running = false, is_lost = false, is_headless = false, exits = false;
    bool has_waited = false, has_begun = false;
    int polls_to_ready = -1;
    bool is_synced = false;     ///< xrSyncActions has been called while focused.
    std::array<Hand, 2> hands;  ///< As of that call.
    std::array<std::string, 2> profiles;
    ContextKept graphics;
};

struct Swapchain {
    std::uint64_t session = 0;
    std::vector<std::uint32_t> textures;
    std::int32_t width = 0, height = 0;
    std::int64_t format = 0;
    std::uint32_t next = 0;
    bool is_acquired = false, is_waited = false, has_released = false;
    std::uint32_t released = 0;
};

struct Space {
    std::uint64_t session = 0;
    XrReferenceSpaceType reference = XR_REFERENCE_SPACE_TYPE_LOCAL;
    std::uint64_t action = 0;  ///< 0: a reference space.
    std::size_t side = 0;
    Place offset;
};

struct HandTracker {
    std::uint64_t session = 0;
    std::size_t side = 0;
};

/// Things by number; a number never comes twice, and tells its kind, so that mixed-up handles are found out.
template <class Thing, std::uint64_t kind>
class Table {
public:
    std::uint64_t add(Thing thing) {
        const std::uint64_t number = (kind << 32U) | ++last_;
        things_.emplace(number, std::move(thing));
        return number;
    }
    Thing* find(std::uint64_t number) {
        const auto found = things_.find(number);
        return found == things_.end() ? nullptr : &found->second;
    }
    bool erase(std::uint64_t number) { return things_.erase(number) != 0; }
    std::map<std::uint64_t, Thing>& all() { return things_; }

private:
    std::map<std::uint64_t, Thing> things_;
    std::uint64_t last_ = 0;
};

struct Runtime {
    std::string script_path;
    std::vector<Line> script;
    std::size_t played = 0;  ///< Lines.
    std::uint64_t frame = 0;
    int refused_creations = 0;  ///< xrCreateInstance fails so often before it works again.
    World world;
    Table<Instance, 1> instances;
    Table<Session, 2> sessions;
    Table<Swapchain, 3> swapchains;
    Table<Space, 4> spaces;
    Table<ActionSet, 5> sets;
    Table<Action, 6> actions;
    Table<HandTracker, 7> trackers;
};

/// Lives as long as the process, also when the loader lets the library go between two instances.
Runtime& runtime();
/// Begins anew when FEELEM_XR_SCRIPT names another file than before.
void begin_script();
/// Carries out what the script has for the frame.
void play(Session& session);

bool has_fault(std::string_view word);
/// Adds a line to the record: the inside of a JSON object.
void record(const std::string& members);
/// Records that the program broke a rule, and gives the code back.
XrResult broken(XrResult code, const char* call, const std::string& why);

template <class Handle>
std::uint64_t number_of(Handle handle) {
    return reinterpret_cast<std::uint64_t>(handle);
}
template <class Handle>
Handle handle_of(std::uint64_t number) {
    return reinterpret_cast<Handle>(number);
}

Instance* only_instance();
/// XR_SUCCESS, or what a call with this session must answer.
XrResult check(Session* session, const char* call);
void go(Session& session, XrSessionState state);
/// One step nearer to what the script wants, among SYNCHRONIZED, VISIBLE and FOCUSED.
void step_towards_target(Session& session);
void post(const void* event, std::size_t bytes);
const char* word(XrSessionState state);

const std::string& text_of(XrPath path);
XrPath path_of(const std::string& text);
/// 0, 1 for /user/hand/left and right; 2 for anything else.
std::size_t side_of(const std::string& path);
/// Profile in that hand which the program has bindings for; empty: none.
std::string active_profile(std::size_t side);
void tell_changed_profiles(Session& session);
std::optional<Place> place_of(const Space& space, const Session& session);

/// Sets a GL error, or takes the program's context away, where such faults are wanted.
void play_gl_faults(const Session& session);
/// What the program keeps alive under a session, counted into the record and removed.
void forget_children(std::uint64_t session);

struct Entry {
    const char* name;
    PFN_xrVoidFunction function;
};
template <class Function>
Entry entry(const char* name, Function function) {
    return {name, reinterpret_cast<PFN_xrVoidFunction>(function)};
}
std::span<const Entry> instance_calls();
std::span<const Entry> session_calls();
std::span<const Entry> frame_calls();
std::span<const Entry> swapchain_calls();
std::span<const Entry> action_calls();
std::span<const Entry> input_calls();
std::span<const Entry> haptic_calls();
std::span<const Entry> space_calls();

/// Fills one of OpenXR's two-call arrays.
template <class Thing>
XrResult give(std::span<const Thing> things, std::uint32_t capacity, std::uint32_t* count, Thing* out) {
    if (!count) return XR_ERROR_VALIDATION_FAILURE;
    *count = static_cast<std::uint32_t>(things.size());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < things.size()) return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::size_t i = 0; i < things.size(); ++i) out[i] = things[i];
    return XR_SUCCESS;
}
XrResult give_text(std::string_view text, std::uint32_t capacity, std::uint32_t* count, char* out);

}  // namespace feelem::xr_runtime
