// SPDX-License-Identifier: Apache-2.0
// One frame of a session: wait, look, hand out; take back, submit.
#include "viewer/xr/session.hpp"

#include <epoxy/gl.h>

#include <utility>

namespace feelem::viewer::xr {

namespace {

FieldOfView field_of(const XrFovf& fov) {
    return {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown};
}

/// Views of a projection layer, and the depth that each may carry; they point to each other.
struct ProjectionLayer {
    std::array<XrCompositionLayerProjectionView, 2> views{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depths{};
    XrCompositionLayerProjection layer =
        typed<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
};

}  // namespace

XrFrame Session::begin_frame(bool is_focused) {
    auto state = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
    must(xrWaitFrame(handle(), nullptr, &state), "xrWaitFrame");
    must(xrBeginFrame(handle(), nullptr), "xrBeginFrame");
    mend("xrBeginFrame");
    has_begun_frame_ = true;
    shown_at_ = state.predictedDisplayTime;
    place_room(shown_at_);

    XrFrame frame;
    frame.shown_at = static_cast<double>(state.predictedDisplayTime) * 1e-9;
    frame.period = static_cast<double>(state.predictedDisplayPeriod) * 1e-9;
    frame.should_render = locate_eyes(shown_at_, frame) && state.shouldRender;
    frame.input.is_headset = true;
    frame.input.head = head_;
    read_hands(is_focused, shown_at_, frame);
    for (std::size_t i = 0; frame.should_render && i < eyes_.size(); ++i) {
        eyes_[i].colour->acquire();
        frame.eyes[i].framebuffer = eyes_[i].colour->framebuffer();
        if (!eyes_[i].depth) continue;
        eyes_[i].depth->acquire();
        frame.eyes[i].depth_texture = eyes_[i].depth->texture();
    }
    mend("xrAcquireSwapchainImage");
    return frame;
}

bool Session::locate_eyes(XrTime time, XrFrame& frame) {
    auto info = typed<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    info.displayTime = time;
    info.space = room_.handle();
    auto state = typed<XrViewState>(XR_TYPE_VIEW_STATE);
    std::array views{typed<XrView>(XR_TYPE_VIEW), typed<XrView>(XR_TYPE_VIEW)};
    std::uint32_t count = 0;
    must(
        xrLocateViews(
            handle(), &info, &state, static_cast<std::uint32_t>(views.size()), &count, views.data()
        ),
        "xrLocateViews"
    );
    constexpr XrViewStateFlags both = XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    // A headset that loses its way keeps the last view: a picture that stands still is better than none.
    if (count == views.size() && (state.viewStateFlags & both) == both) {
        views_ = views;
        has_views_ = true;
    }
    for (std::size_t i = 0; has_views_ && i < views_.size(); ++i) {
        XrEye& eye = frame.eyes[i];
        eye.view = {from_xr(views_[i].pose), field_of(views_[i].fov)};
        eye.width = eyes_[i].colour->width();
        eye.height = eyes_[i].colour->height();
    }
    if (const auto head = view_.locate(room_, time)) head_ = *head;
    return has_views_;
}

void Session::read_hands(bool is_focused, XrTime time, XrFrame& frame) {
    const bool is_ours = parts_.actions->sync(handle()) && is_focused;
    frame.input.is_focused = is_ours;
    if (is_ours && !std::exchange(knows_profiles_, true))
        for (const Side side : {Side::Left, Side::Right})
            profiles_[static_cast<std::size_t>(side)] = parts_.actions->profile(handle(), side);
    for (const Side side : {Side::Left, Side::Right}) {
        const auto at = static_cast<std::size_t>(side);
        HandInput hand;
        hand.aim = hands_[at].aim;  // Of a hand that is lost, what was last seen: a ghost may stand there.
        hand.grip = hands_[at].grip;
        hand.is_bare = hands_[at].is_bare;
        const auto aim = is_ours ? aim_[at].locate(room_, time) : std::nullopt;
        const auto grip = is_ours ? grip_[at].locate(room_, time) : std::nullopt;
        const auto joints = is_ours && trackers_ && !profiles_[at]
                                ? trackers_->locate(side, room_.handle(), time)
                                : std::nullopt;
        if (is_ours && profiles_[at]) {
            hand.is_bare = false;
            hand.can_vibrate = true;
            hand.is_tracked = aim && grip;
            if (hand.is_tracked) parts_.actions->read(handle(), side, profiles_[at], hand);
        }
        if (aim && grip) {
            hand.aim = *aim;
            hand.grip = *grip;
        }
        if (joints) read_joints(*joints, head_, side, hand);
        hands_[at] = frame.input.hands[at] = hand;
    }
}

void Session::show_panels(std::span<const XrQuad> quads, std::vector<XrCompositionLayerQuad>& layers) {
    for (const XrQuad& quad : quads) {
        PanelPicture& panel = panels_[quad.name];
        const bool fits =
            panel.picture && panel.picture->width() == quad.width && panel.picture->height() == quad.height;
        if (!fits) {
            panel = {};
            panel.picture = std::make_unique<Picture>(
                handle(), PictureInfo{formats_.colour, false, quad.width, quad.height}
            );
            mend("xrCreateSwapchain");
            panel.picture->make_framebuffers();
        }
        if (quad.has_changed || !panel.is_filled) {
            panel.picture->acquire();
            mend("xrAcquireSwapchainImage");
            copy_bytes(quad.texture, quad.width, quad.height, *panel.picture);
            panel.picture->release();
            mend("xrReleaseSwapchainImage");
            panel.is_filled = true;
        }
        auto layer = typed<XrCompositionLayerQuad>(XR_TYPE_COMPOSITION_LAYER_QUAD);
        layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
        layer.space = room_.handle();
        layer.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
        layer.subImage = panel.picture->whole();
        layer.pose = to_xr(quad.pose);
        layer.size = {quad.size.x, quad.size.y};
        layers.push_back(layer);
    }
}

void Session::end_frame(const XrPictures& pictures) {
    if (!std::exchange(has_begun_frame_, false)) return;
    ProjectionLayer projection;
    std::vector<XrCompositionLayerQuad> quads;
    std::vector<const XrCompositionLayerBaseHeader*> layers;
    const bool is_drawn = eyes_[0].colour->is_acquired();
    for (std::size_t i = 0; is_drawn && i < eyes_.size(); ++i) {
        Eye& eye = eyes_[i];
        eye.colour->release();
        auto& view = projection.views[i];
        view = typed<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
        view.pose = views_[i].pose;
        view.fov = views_[i].fov;
        view.subImage = eye.colour->whole();
        if (!eye.depth) continue;
        eye.depth->release();
        if (!pictures.depth) continue;
        auto& depth = projection.depths[i];
        depth = typed<XrCompositionLayerDepthInfoKHR>(XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR);
        depth.subImage = eye.depth->whole();
        depth.maxDepth = 1;
        depth.nearZ = pictures.depth->near;
        depth.farZ = pictures.depth->far;
        view.next = &depth;
    }
    mend("xrReleaseSwapchainImage");
    if (is_drawn) {
        projection.layer.space = room_.handle();
        projection.layer.viewCount = static_cast<std::uint32_t>(projection.views.size());
        projection.layer.views = projection.views.data();
        layers.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&projection.layer));
        show_panels(pictures.quads, quads);
        for (const auto& quad : quads)
            layers.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&quad));
    }
    auto info = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    info.displayTime = shown_at_;
    info.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    info.layerCount = static_cast<std::uint32_t>(layers.size());
    info.layers = layers.data();
    const XrResult result = xrEndFrame(handle(), &info);
    mend("xrEndFrame");
    must(result, "xrEndFrame");
}

}  // namespace feelem::viewer::xr
