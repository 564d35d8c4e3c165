// SPDX-License-Identifier: Apache-2.0
// Xvfb chooses a free number itself and says it through a pipe.
#include "virtual_screen.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

extern char** environ;  // NOLINT: POSIX wants it declared.

namespace feelem::viewer::test {
namespace {

constexpr int kPatienceMilliseconds = 20'000;

class Server {
public:
    Server() {
        std::array<int, 2> pipe_ends{};
        if (pipe(pipe_ends.data()) != 0) {
            why_ = "no pipe to Xvfb";
            return;
        }
        start(pipe_ends[1]);
        close(pipe_ends[1]);
        if (why_.empty()) listen(pipe_ends[0]);
        close(pipe_ends[0]);
    }
    ~Server() {
        if (process_ <= 0) return;
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    const std::string& why() const { return why_; }

private:
    void start(int answer) {
        std::string number = std::to_string(answer);
        std::array<std::string, 9> words{
            "Xvfb", "-displayfd", number, "-screen", "0", "1280x800x24", "-nolisten", "tcp", "-noreset"};
        std::array<char*, 10> arguments{};
        for (std::size_t i = 0; i < words.size(); ++i) arguments.at(i) = words.at(i).data();
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 1, 0);
        if (posix_spawnp(&process_, "Xvfb", &actions, nullptr, arguments.data(), environ) != 0) {
            process_ = 0;
            why_ = "Xvfb is not installed: package xvfb";
        }
        posix_spawn_file_actions_destroy(&actions);
    }
    void listen(int answer) {
        pollfd wanted{.fd = answer, .events = POLLIN, .revents = 0};
        std::array<char, 16> text{};
        if (poll(&wanted, 1, kPatienceMilliseconds) != 1 || read(answer, text.data(), text.size() - 1) <= 0) {
            why_ = "Xvfb does not start here";
            return;
        }
        const std::string display = ":" + std::to_string(std::atoi(text.data()));
        setenv("DISPLAY", display.c_str(), 1);
        setenv("SDL_VIDEODRIVER", "x11", 1);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    }

    pid_t process_ = 0;
    std::string why_;
};

}  // namespace

const std::string& virtual_screen() {
    static const Server server;
    return server.why();
}

}  // namespace feelem::viewer::test
