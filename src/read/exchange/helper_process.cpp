// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/helper_process.hpp"

#include "read/exchange/neutral_form.hpp"

#include "feelem/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace feelem::exchange {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = 1u << 20;

/// Beside the running program.
fs::path helper_path() {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::path() : self.parent_path() / "feelem-exchange";
}

class Pipe {
public:
    Pipe() {
        if (pipe2(ends_, O_CLOEXEC) != 0)
            throw Error(
                Code::FileUnreadable,
                "",
                fmt::format("no pipe to the helper program: {}", std::strerror(errno))
            );
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    int read_end() const { return ends_[0]; }
    int write_end() const { return ends_[1]; }
    void close_write_end() { close_end(1); }

private:
    void close_end(int i) {
        if (ends_[i] >= 0) close(ends_[i]);
        ends_[i] = -1;
    }
    int ends_[2]{-1, -1};
};

pid_t start(const fs::path& program, const std::vector<std::string>& arguments, const Pipe& pipe) {
    std::string path = program.string();
    std::vector<std::string> words = arguments;
    std::vector<char*> argv{path.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe.write_end(), 1);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int error = posix_spawn(&child, path.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw Error(
            Code::FileUnreadable,
            path,
            fmt::format("cannot start the helper program: {}", std::strerror(error))
        );
    return child;
}

/// Everything the child writes, up to a limit; beyond it the pipe is closed and the child ends by itself.
std::string read_all(int from, std::uint64_t limit, bool& too_much) {
    std::string out;
    char buffer[1u << 16];
    while (true) {
        const ssize_t got = read(from, buffer, sizeof buffer);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        out.append(buffer, static_cast<std::size_t>(got));
        too_much = out.size() > limit;
        if (too_much) break;
    }
    return out;
}

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return status;
}

std::string ending_of(int status) {
    if (WIFSIGNALED(status)) {
        if (WTERMSIG(status) == SIGXCPU) return "took too long";
        return fmt::format("crashed (signal {})", WTERMSIG(status));
    }
    return fmt::format("gave up without a word (status {})", WEXITSTATUS(status));
}

}  // namespace

bool has_helper() {
    std::error_code error;
    return fs::is_regular_file(helper_path(), error);
}

std::string ask_helper(
    const std::vector<std::string>& arguments, const std::string& name, std::uint64_t bytes
) {
    if (!has_helper()) {
        throw Error(
            Code::UnsupportedFormat,
            name,
            "this kind of file is read by the helper program feelem-exchange, which is not beside this "
            "program: "
            "install libvtk9-dev and libhdf5-dev (./dev setup exchange) and build Feelem again"
        );
    }
    const std::uint64_t mib = bytes / kMiB + 1;
    std::vector<std::string> all{
        fmt::format("{}", 1024 + 400 * mib),  // MiB of address space
        fmt::format("{}", 4 + 2 * mib)};      // seconds of processor
    all.insert(all.end(), arguments.begin(), arguments.end());
    bool too_much = false;
    std::string answer;
    int status = 0;
    {
        Pipe pipe;
        const pid_t child = start(helper_path(), all, pipe);
        pipe.close_write_end();
        answer = read_all(pipe.read_end(), (64 + 200 * mib) * kMiB, too_much);
        if (too_much) kill(child, SIGKILL);
        status = wait_for(child);
    }
    if (too_much)
        throw Error(
            Code::TooLarge, name, "the helper program gave far more than a file of this size can hold"
        );
    if (!answer.empty() && answer[0] == static_cast<char>(Answer::Error)) {
        throw Error(Code::BadStructure, name, answer.substr(1));
    }
    if (!answer.empty() && answer[0] == static_cast<char>(Answer::Unsupported))
        throw Error(Code::UnsupportedFormat, name, answer.substr(1));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty()) {
        throw Error(
            Code::BadStructure,
            name,
            fmt::format(
                "the library that reads such files {} on this one: it must be damaged, or of a rare kind. "
                "Nothing was "
                "read.",
                ending_of(status)
            )
        );
    }
    return answer;
}

}  // namespace feelem::exchange
