// SPDX-License-Identifier: Apache-2.0
// What an attacker on the local network would try, one case each. After every one the server must still
// answer a good client; no answer to a stranger may hold anything of the scene; and memory stays bounded.
#pragma once

#include "client.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace feelem::test {

/// One server for all cases, as it would stand in an office all day; with shorter patience, so that the tests
/// of patience end.
class HostileClient : public testing::Test {
protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void TearDown() override;

    static void good_client_is_answered();
    /// Over TLS and on loopback: an answer of that status, or none (0), without a byte of the scene.
    static void refused(const std::string& request, const std::vector<int>& statuses);
    static std::string get(const std::string& target, const std::string& headers = "");
    /// Every one of these paths, with the right token: there is no such file.
    static void not_found(const std::vector<std::string>& targets);

    static int port();
    static std::string path(const std::string& file);  ///< With the token.
    static std::string host_line();
    static const std::string& folder();
};

}  // namespace feelem::test
