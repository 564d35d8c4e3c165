// SPDX-License-Identifier: Apache-2.0
// Serves the page and one scene: on this machine only, or to the local network under TLS to those who have
// the link.
#pragma once

#include "front_door.hpp"
#include "inside_questions.hpp"
#include "opening.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace feelem::server {

struct ServeOptions {
    std::string scene_path{};
    int port = 8322;         ///< 0: any free one.
    bool only_that = false;  ///< Else the next free port of the twenty after it.
    bool lan = false;
    // For the local network only.
    std::string certificate_file{}, key_file{};  ///< Empty: a certificate of our own.
    std::string certificate_folder{};            ///< Where ours is kept; empty: the user's data folder.
    DoorLimits limits{};
    std::optional<Job> model{};  ///< That the scene was made of: questions to its inside are answered.
    InsideLimits inside{};
    std::shared_ptr<Opening> opening{};  ///< The scene is still being made; null: it is there.
};

/// Answers from start() to stop(): only requests for our own names, only GET and HEAD, only what the page and
/// the scene consist of, how far a scene is that is still being made, and questions to the inside of a model
/// that was opened. For the local network every
/// path begins with a random token, and without it there is not a byte of the model, its name or its numbers;
/// plain connections are taken from this machine alone.
class PageServer {
public:
    /// Throws Error(FileNotFound) for the scene, Error(BadOption) when no port is free, and what
    /// certificate.hpp says.
    explicit PageServer(const ServeOptions& options);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    void start();
    void stop();
    int port() const noexcept;
    std::string address() const;             ///< On this machine: "http://127.0.0.1:8322/", or with "TOKEN/".
    std::vector<std::string> links() const;  ///< For others, the best first; empty on loopback.
    std::string fingerprint() const;         ///< Of the certificate; empty on loopback.
    bool has_own_certificate() const;        ///< Browsers warn of it.
    bool has_new_certificate() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::server
