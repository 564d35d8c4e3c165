// SPDX-License-Identifier: Apache-2.0
// All that lives as long as a session: spaces, pictures of the eyes and panels, trackers.
#pragma once

#include "viewer/xr/actions.hpp"
#include "viewer/xr/gl_current.hpp"
#include "viewer/xr/hands.hpp"
#include "viewer/xr/instance.hpp"
#include "viewer/xr/picture.hpp"
#include "viewer/xr/xr_system.hpp"

#include <map>
#include <memory>
#include <set>
#include <utility>

namespace feelem::viewer::xr {

/// One of XrSpace, destroyed with it.
class Space {
public:
    Space() = default;
    Space(XrSession session, XrReferenceSpaceType type, const Pose& pose = {});
    Space(XrSession session, XrAction action, XrPath hand);
    Space(Space&& other) noexcept : handle_(std::exchange(other.handle_, XR_NULL_HANDLE)) {}
    Space& operator=(Space&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Space();

    XrSpace handle() const { return handle_; }
    /// Empty: the runtime does not know now.
    std::optional<Pose> locate(const Space& base, XrTime time) const;

private:
    XrSpace handle_ = XR_NULL_HANDLE;
};

/// XrSession, destroyed after all that is declared behind it.
struct OwnedSession {
    XrSession handle = XR_NULL_HANDLE;
    const GlCurrent* gl = nullptr;

    OwnedSession() = default;
    OwnedSession(const OwnedSession&) = delete;
    OwnedSession& operator=(const OwnedSession&) = delete;
    ~OwnedSession();
};

struct SessionParts {
    const Instance* instance = nullptr;
    System system;
    const Actions* actions = nullptr;
    const GlCurrent* gl = nullptr;
};

/// Calls throw Failure.
class Session {
public:
    explicit Session(const SessionParts& parts);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    XrSession handle() const { return owned_.handle; }
    void begin();
    void end();
    void request_exit();
    void profiles_changed() { knows_profiles_ = false; }
    /// The runtime has put LOCAL elsewhere: what recentre() did is void.
    void local_changed();
    void recentre() { wants_recentre_ = true; }

    XrFrame begin_frame(bool is_focused);
    void end_frame(const XrPictures& pictures);

    /// Name of what is in the hands; empty: nothing.
    std::string input_name() const;
    /// What had to be mended after calls of the runtime; added to `quirks` once each.
    void take_quirks(std::vector<std::string>& quirks);

private:
    void make_eyes();
    void place_room(XrTime time);
    bool locate_eyes(XrTime time, XrFrame& frame);
    void read_hands(bool is_focused, XrTime time, XrFrame& frame);
    void show_panels(std::span<const XrQuad> quads, std::vector<XrCompositionLayerQuad>& layers);
    /// After a call that may have changed the program's OpenGL.
    void mend(const char* call);

    SessionParts parts_;
    OwnedSession owned_;
    PictureFormats formats_;
    struct Eye {
        std::unique_ptr<Picture> colour, depth;
    };
    std::array<Eye, 2> eyes_;
    struct PanelPicture {
        std::unique_ptr<Picture> picture;
        bool is_filled = false;
    };
    std::map<int, PanelPicture> panels_;
    std::unique_ptr<HandTrackers> trackers_;
    Space local_, view_, stage_, room_;
    std::array<Space, kSides> aim_, grip_;
    std::optional<float> floor_;  ///< In LOCAL; empty: not known yet.
    Pose room_in_local_;
    bool wants_recentre_ = false;
    XrTime shown_at_ = 0;
    bool has_begun_frame_ = false;
    std::array<XrView, 2> views_{};
    bool has_views_ = false;
    Pose head_;
    std::array<HandInput, kSides> hands_;
    std::array<const Profile*, kSides> profiles_{};
    bool knows_profiles_ = false;
    std::set<std::string> quirks_, told_;
};

}  // namespace feelem::viewer::xr
