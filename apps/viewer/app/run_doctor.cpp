// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/run_doctor.hpp"

#include "viewer/desktop/window.hpp"
#include "viewer/doctor/doctor.hpp"
#include "viewer/render/gl_context.hpp"
#include "viewer/render/gl_words.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

namespace feelem::viewer {
namespace {

/// A service that starts on demand answers within this.
constexpr double kTryFor = 2.0;
constexpr auto kBetweenTries = std::chrono::milliseconds(50);

std::string first_sentence(const std::string& text) {
    std::string out = text.substr(0, text.find('\n'));
    while (out.ends_with('.')) out.pop_back();
    return out;
}

std::unique_ptr<GlContext> try_graphics(TriedGraphics& tried) {
    try {
        auto context = std::make_unique<GlContext>();
        tried.version = gl_version();
        tried.renderer = gl_renderer();
        return context;
    } catch (const Error& error) {
        tried.trouble = first_sentence(error.what());
        return nullptr;
    }
}

void try_window(TriedGraphics& tried) {
    try {
        WindowOptions options;
        options.hidden = true;
        const Window window(options);
    } catch (const NoWindow& error) {
        tried.screen_trouble = error.what();
    }
}

XrStatus try_headset() {
    XrSystem system({"feelem-xr doctor", false});
    XrStatus status;
    for (double time = 0; time < kTryFor; time += 0.05) {
        status = system.poll(time);
        if (status.state != XrState::NoService && status.state != XrState::Starting) break;
        if (!status.headset.empty()) break;
        std::this_thread::sleep_for(kBetweenTries);
    }
    return status;
}

}  // namespace

int run_doctor() {
    TriedGraphics tried;
    try_window(tried);
    std::optional<XrStatus> headset;
    if (const auto context = try_graphics(tried)) headset = try_headset();
    const std::vector<Finding> findings = examine(this_machine(), tried, headset ? &*headset : nullptr);
    fmt::print("{}", report_of(findings));
    const Verdict verdict = verdict_on(findings);
    return verdict.desk || verdict.headset ? 0 : 1;
}

}  // namespace feelem::viewer
