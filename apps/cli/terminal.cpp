// SPDX-License-Identifier: Apache-2.0
#include "terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>

namespace feelem::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int) {
    interrupted = 1;
}

/// Bytes of memory that no file stands behind: what the program itself holds.
std::size_t anonymous_memory() {
    std::ifstream pages("/proc/self/statm");
    std::size_t all = 0, resident = 0, of_files = 0;
    if (!(pages >> all >> resident >> of_files)) return 0;
    return (resident - std::min(resident, of_files)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Terminal::Terminal(bool verbose) : verbose_(verbose), has_bar_(!verbose && isatty(STDERR_FILENO) == 1) {
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
    // The terminal was closed; under nohup that is no reason to end.
    if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    if (verbose_) watcher_ = std::thread([this] { watch_memory(); });
}

Terminal::~Terminal() {
    stop_watching_ = true;
    if (watcher_.joinable()) watcher_.join();
    finish();
}

void Terminal::watch_memory() {
    constexpr std::chrono::milliseconds kPause{2};
    while (!stop_watching_) {
        const std::size_t now = anonymous_memory();
        std::size_t most = most_anonymous_;
        while (now > most && !most_anonymous_.compare_exchange_weak(most, now)) {}
        std::this_thread::sleep_for(kPause);
    }
}

Progress Terminal::progress() {
    return [this](std::string_view stage, double fraction) {
        show(stage, fraction);
        return !was_interrupted();
    };
}

void Terminal::show(std::string_view stage, double fraction) {
    if (stage != stage_) {
        end_stage();
        stage_ = stage;
        stage_began_ = seconds_now();
        shown_percent_ = -1;
    }
    const int percent = static_cast<int>(fraction * 100);
    if (!has_bar_ || percent == shown_percent_) return;
    shown_percent_ = percent;
    constexpr int kWidth = 30;
    const std::string bar(static_cast<std::size_t>(percent * kWidth / 100), '#');
    fmt::print(stderr, "\r{:<10} [{:<{}}] {:3} %", stage_, bar, kWidth, percent);
    std::fflush(stderr);
}

void Terminal::end_stage() {
    if (stage_.empty()) return;
    constexpr double kMiB = 1024.0 * 1024.0;
    if (verbose_) {
        fmt::print(
            stderr,
            "{:<10} {:9.3f} s  peak {:9.1f} MiB  anonymous {:9.1f} MiB\n",
            stage_,
            seconds_now() - stage_began_,
            static_cast<double>(peak_memory()) / kMiB,
            static_cast<double>(std::max(most_anonymous_.exchange(0), anonymous_memory())) / kMiB
        );
    }
    stage_.clear();
}

void Terminal::finish() {
    end_stage();
    if (has_bar_ && shown_percent_ >= 0) fmt::print(stderr, "\r{:<60}\r", "");
    shown_percent_ = -1;
    std::fflush(stderr);
}

bool was_interrupted() {
    return interrupted != 0;
}

void print_diagnostics(const Diagnostics& diagnostics) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        const Severity severity = code_info(entry.code).severity;
        fmt::print(
            stderr,
            "{:<9}{}{}{}{}\n",
            severity == Severity::Note ? "note:" : "warning:",
            entry.where,
            entry.where.empty() ? "" : ": ",
            entry.text,
            entry.count > 1 ? fmt::format(" ({} times)", entry.count) : ""
        );
    }
}

ToldDiagnostics::ToldDiagnostics(Terminal& terminal)
    : terminal_(terminal), errors_before_(std::uncaught_exceptions()) {}

ToldDiagnostics::~ToldDiagnostics() {
    if (std::uncaught_exceptions() > errors_before_) print();
}

void ToldDiagnostics::print() {
    terminal_.finish();
    print_diagnostics(diagnostics_);
}

std::size_t peak_memory() {
    std::ifstream status("/proc/self/status");
    std::string word;
    std::size_t kib = 0;
    while (status >> word) {
        if (word == "VmHWM:" && status >> kib) return kib * 1024;
    }
    return 0;
}

}  // namespace feelem::cli
