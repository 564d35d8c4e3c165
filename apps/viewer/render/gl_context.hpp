// SPDX-License-Identifier: Apache-2.0
// OpenGL without window or screen: for tests and for pictures made on a server.
#pragma once

#include <memory>
#include <string>

namespace feelem::viewer {

/// An OpenGL 4.5 core context by EGL's surfaceless platform, current in the thread that made it until it is
/// destroyed. Throws Error(UnsupportedFormat): what of it the machine cannot do.
class GlContext {
public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    void make_current() const;
    std::string renderer() const;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
