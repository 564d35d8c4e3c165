// SPDX-License-Identifier: Apache-2.0
// Asked by the thread sanitizer when a program of its build begins.

extern "C" const char* __tsan_default_suppressions();

/// The library is not built for it: tables that its first request makes look unguarded to the second.
extern "C" const char* __tsan_default_suppressions() {
    return "called_from_lib:libcpp-httplib.so\n";
}
