// SPDX-License-Identifier: Apache-2.0
// What goes to stderr: the progress bar (on a terminal only), stages with --verbose, diagnostics at the end.
#pragma once

#include "feelem/convert.hpp"

#include <atomic>
#include <cstddef>
#include <string>
#include <string_view>
#include <thread>

namespace feelem::cli {

/// One while a command works. Ctrl-C cancels the work by way of progress().
class Terminal {
public:
    explicit Terminal(bool verbose);
    ~Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    /// To hand to the library; the Terminal must outlive its use.
    Progress progress();
    /// Ends the last stage and removes the bar.
    void finish();

private:
    void show(std::string_view stage, double fraction);
    void end_stage();
    void watch_memory();

    bool verbose_ = false;
    bool has_bar_ = false;
    int shown_percent_ = -1;
    std::string stage_;
    double stage_began_ = 0;
    std::atomic<std::size_t> most_anonymous_ = 0;  ///< Bytes, the most that was seen in this stage.
    std::atomic<bool> stop_watching_ = false;
    std::thread watcher_;  ///< With --verbose only: the system keeps no peak of this memory.
};

/// True after Ctrl-C or a polite kill, from the first Terminal on.
bool was_interrupted();

/// "warning: file.lis:12: text (3 times)", a line each.
void print_diagnostics(const Diagnostics& diagnostics);

/// The diagnostics of one command. What was found before an error is printed before the error.
class ToldDiagnostics {
public:
    /// Ends the terminal's bar before it prints.
    explicit ToldDiagnostics(Terminal& terminal);
    ~ToldDiagnostics();
    ToldDiagnostics(const ToldDiagnostics&) = delete;
    ToldDiagnostics& operator=(const ToldDiagnostics&) = delete;

    Diagnostics& operator*() noexcept { return diagnostics_; }
    /// The work is done: prints them.
    void print();

private:
    Terminal& terminal_;
    Diagnostics diagnostics_;
    int errors_before_ = 0;
};

/// Largest resident memory of this process so far, in bytes.
std::size_t peak_memory();

}  // namespace feelem::cli
