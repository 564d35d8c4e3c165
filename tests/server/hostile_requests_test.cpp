// SPDX-License-Identifier: Apache-2.0
// Requests that are read in two ways, too large, or senseless.
#include "hostile_client.hpp"

#include <filesystem>

namespace feelem::test {
namespace {

using namespace std::chrono_literals;
using testing::AnyOf;

// --- methods, bodies, requests inside requests

TEST_F(HostileClient, methods_that_write_are_refused) {
    for (const char* method :
         {"POST", "PUT", "DELETE", "PATCH", "TRACE", "OPTIONS", "PROPFIND", "BREW", "get"}) {
        refused(
            fmt::format(
                "{} {} HTTP/1.1\r\n{}Connection: close\r\n\r\n", method, path("scene.glb"), host_line()
            ),
            {405, 429}
        );
    }
}

TEST_F(HostileClient, method_is_overridden_by_a_header) {
    const std::string answer =
        ask(port(), true, path("absent"), {"GET", "X-HTTP-Method-Override: DELETE\r\n"});
    EXPECT_EQ(status_of(answer), 404);
    EXPECT_TRUE(std::filesystem::exists(folder() + "/boiler.glb"));
}

TEST_F(HostileClient, second_request_hides_in_a_body_by_length) {
    const std::string inner = "GET /scene.glb HTTP/1.1\r\nHost: x\r\n\r\n";
    refused(
        fmt::format(
            "GET {} HTTP/1.1\r\n{}Content-Length: {}\r\n\r\n{}", path(""), host_line(), inner.size(), inner
        ),
        {413}
    );
    refused(
        fmt::format(
            "POST {} HTTP/1.1\r\n{}Content-Length: {}\r\n\r\n{}", path(""), host_line(), inner.size(), inner
        ),
        {405}
    );
}

TEST_F(HostileClient, second_request_hides_behind_chunks) {
    const std::string tail = "0\r\n\r\nGET /scene.glb HTTP/1.1\r\nHost: x\r\n\r\n";
    refused(
        fmt::format("GET {} HTTP/1.1\r\n{}Transfer-Encoding: chunked\r\n\r\n{}", path(""), host_line(), tail),
        {400}
    );
    refused(
        fmt::format(
            "GET {} HTTP/1.1\r\n{}Content-Length: 4\r\nTransfer-Encoding: chunked\r\n\r\n{}",
            path(""),
            host_line(),
            tail
        ),
        {400}
    );
    refused(
        fmt::format(
            "GET {} HTTP/1.1\r\n{}Transfer-Encoding : chunked\r\n\r\n{}", path(""), host_line(), tail
        ),
        {400}
    );
}

TEST_F(HostileClient, lengths_disagree_or_are_no_numbers) {
    for (const char* lines :
         {"Content-Length: 0\r\nContent-Length: 40\r\n",
          "Content-Length: -1\r\n",
          "Content-Length: 0x0\r\n",
          "Content-Length: 99999999999999999999999\r\n",
          "Content-Length: 0, 0\r\n",
          "Content-Length:\r\n"}) {
        refused(get(path(""), lines), {400, 413});
    }
}

TEST_F(HostileClient, line_ends_are_bare) {
    refused(fmt::format("GET {} HTTP/1.1\nHost: 127.0.0.1:{}\n\n", path("scene.glb"), port()), {400});
    refused(fmt::format("GET {} HTTP/1.1\rHost: 127.0.0.1:{}\r\r\n\r\n", path("scene.glb"), port()), {400});
    refused(get(path("scene.glb"), "X: a\nOrigin: https://evil.example\r\n"), {400});
}

TEST_F(HostileClient, headers_are_folded_or_have_no_name) {
    refused(get(path("scene.glb"), "X: a\r\n b\r\n"), {400});
    refused(get(path("scene.glb"), ": a\r\n"), {400});
    refused(get(path("scene.glb"), "X a\r\n"), {400});
    refused(get(path("scene.glb"), std::string("X: a\0b\r\n", 8)), {400});
}

TEST_F(HostileClient, header_is_injected_through_the_path) {
    const std::string answer = ask(port(), true, path("absent%0d%0aSet-Cookie:%20a=b%0d%0a%0d%0aX"));
    EXPECT_EQ(status_of(answer), 404);
    EXPECT_EQ(header_of(answer, "Set-Cookie"), "");
}

TEST_F(HostileClient, answer_is_asked_for_by_other_versions) {
    refused("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", {400, 505});
    refused(fmt::format("GET {} HTTP/9.9\r\n{}\r\n", path("scene.glb"), host_line()), {505});
    refused(fmt::format("GET {}\r\n\r\n", path("scene.glb")), {400});
    refused(
        get(path("absent"), "Upgrade: websocket\r\nSec-WebSocket-Key: eA==\r\nSec-WebSocket-Version: 13\r\n"),
        {404}
    );
}

// --- sizes

TEST_F(HostileClient, target_is_a_megabyte) {
    refused("GET /" + std::string(1 << 20, 'a') + " HTTP/1.1\r\n\r\n", {414, 0});
}

TEST_F(HostileClient, header_is_a_megabyte_or_there_are_ten_thousand) {
    refused("GET / HTTP/1.1\r\nX: " + std::string(1 << 20, 'a') + "\r\n\r\n", {431, 0});
    std::string many = "GET / HTTP/1.1\r\n";
    for (int i = 0; i < 10'000; ++i) many += "A: b\r\n";
    refused(many + "\r\n", {431, 0});
}

TEST_F(HostileClient, line_without_end_goes_on_for_64_megabytes) {
    Client client(port());
    const std::string piece(1 << 20, 'a');
    int sent = 0;
    while (sent < 64 && client.send(piece)) ++sent;
    EXPECT_LT(sent, 64) << "it is closed long before";
}

TEST_F(HostileClient, body_of_a_gigabyte_is_announced_and_begun) {
    Client client(port(), true);
    client.send(fmt::format("POST {} HTTP/1.1\r\n{}Content-Length: 1073741824\r\n\r\n", path(""), host_line())
    );
    const std::string piece(1 << 20, 'a');
    for (int i = 0; i < 8 && client.send(piece);) ++i;
    EXPECT_TRUE(client.is_closed_within(8s));
}

TEST_F(HostileClient, expects_to_continue_with_a_body) {
    refused(get(path(""), "Expect: 100-continue\r\nContent-Length: 1000000\r\n"), {413});
}

// --- ranges

TEST_F(HostileClient, ranges_are_senseless) {
    const std::uint64_t size = std::filesystem::file_size(folder() + "/boiler.glb");
    for (const std::string range :
         {"bytes=-",
          "bytes=a-b",
          "bytes=5-2",
          "bytes=0--1",
          "lines=0-1",
          "bytes=0-1,0-1",
          "bytes = 0-1",
          "bytes=18446744073709551615-",
          "bytes=0-18446744073709551616",
          "bytes=-0",
          "bytes=99999999999-"}) {
        const std::string answer = ask(port(), false, path("scene.glb"), {"GET", "Range: " + range + "\r\n"});
        const int status = status_of(answer);
        EXPECT_THAT(status, AnyOf(200, 416)) << range;
        EXPECT_EQ(
            body_of(answer).size(),
            status == 200                               ? size
            : header_of(answer, "Content-Length") == "" ? 0
                                                        : std::stoul(header_of(answer, "Content-Length"))
        ) << range;
    }
}

TEST_F(HostileClient, a_thousand_overlapping_ranges_give_the_file_once) {
    std::string ranges = "bytes=0-";
    for (int i = 1; i < 1000; ++i) ranges += fmt::format(",{}-", i);
    const std::string answer = ask(port(), true, path("scene.glb"), {"GET", "Range: " + ranges + "\r\n"});
    EXPECT_EQ(status_of(answer), 200);
    EXPECT_EQ(body_of(answer).size(), std::filesystem::file_size(folder() + "/boiler.glb"));
}

}  // namespace
}  // namespace feelem::test
