// SPDX-License-Identifier: Apache-2.0
// Serves the page and one scene, on this machine only.
#pragma once

#include <memory>
#include <string>

namespace feelem::server {

struct ServeOptions {
    std::string scene_path;
    int port = 8322;         ///< 0: any free one.
    bool only_that = false;  ///< Else the next free port of the twenty after it.
};

/// Bound to 127.0.0.1 when made; answers from start() to stop(). Answers only requests for this machine's own
/// names, only GET and HEAD, and only what the page and the scene consist of.
class PageServer {
public:
    /// Throws Error(FileNotFound) for the scene, Error(BadOption) when no port is free.
    explicit PageServer(const ServeOptions& options);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    void start();
    void stop();
    int port() const noexcept;
    std::string address() const;  ///< "http://127.0.0.1:8322/"

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::server
