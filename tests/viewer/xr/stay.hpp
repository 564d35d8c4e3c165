// SPDX-License-Identifier: Apache-2.0
// A stay in the scripted headset: a script goes in, frames and the runtime's record come out.
#pragma once

#include "viewer/render/gl_context.hpp"
#include "viewer/xr/xr_system.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Tests that are skipped, and counted, where there is no OpenGL.
class NeedsOpenGl : public testing::Test {
protected:
    void SetUp() override;
};

/// Environment variables of the loader and the runtime; set again to what they were at the end.
class Environment {
public:
    ~Environment();
    void set(const std::string& name, const std::string& value);
    void unset(const std::string& name);

private:
    void remember(const std::string& name);
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

class Stay {
public:
    /// Lines as tests/xr_runtime/script.hpp has them; words of FEELEM_XR_FAULTS.
    explicit Stay(const std::string& script, const std::string& faults = "", const XrOptions& options = {});
    /// In the OpenGL context that is current, such as a window's.
    struct InCurrentContext {};
    Stay(InCurrentContext, const std::string& script, const std::string& faults = "");
    ~Stay();
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;

    void set_faults(const std::string& faults);
    /// One turn of the program's loop, 20 ms long. True: it had a frame.
    bool turn();
    /// Turns until the state is reached, at most so many seconds of the program's clock. False: it never was.
    bool reach(XrState state, double seconds = 20);
    /// So many frames. False: they did not come within 60 seconds.
    bool frames(std::size_t count);
    void pass(double seconds);
    /// Ends everything, so that the record is whole.
    void end();

    /// What the program does with a frame before it is submitted.
    std::function<void(const XrFrame&)> draw;
    std::function<XrPictures()> pictures;

    std::unique_ptr<GlContext> gl;
    std::unique_ptr<XrSystem> system;
    XrFrame last;
    double time = 0;

    /// Lines of the record that have the member.
    std::vector<nlohmann::json> record(const std::string& member) const;
    /// Rules broken, and what was left behind; empty when all was well.
    std::vector<std::string> complaints() const;

private:
    void start(const std::string& script, const std::string& faults, const XrOptions& options);

    Environment environment_;
    std::string record_path_;
};

/// Fills both eyes by a blit from a texture of these bytes, as the renderer does.
void fill_eyes(const XrFrame& frame, const std::array<std::array<std::uint8_t, 4>, 2>& colours);
/// A GL_RGBA8 texture of one colour.
unsigned texture_of(int width, int height, const std::array<std::uint8_t, 4>& colour);

}  // namespace feelem::viewer
