// SPDX-License-Identifier: Apache-2.0
// What is let in: heads of requests, names, origins, secrets, rates.
#include "guard.hpp"
#include "rate_limit.hpp"
#include "request_head.hpp"

#include <gtest/gtest.h>

#include <set>

namespace feelem::test {
namespace {

using server::Guard;
using server::HeadState;
using server::read_head;
using server::RequestHead;

RequestHead head_of(std::string_view text) {
    server::HeadAnswer answer = read_head(text);
    EXPECT_EQ(answer.state, HeadState::Good) << text;
    return answer.head;
}

int status_of_judgement(
    const Guard& guard, std::string_view head, const server::Way& way = {false, "127.0.0.1"}
) {
    return guard.judge(head_of(head), way).status;
}

TEST(RequestHead, is_read_with_names_in_lower_case_and_the_next_request_left) {
    const std::string_view text = "GET /a?b HTTP/1.1\r\nHost:x\r\nX-Long:  two words \r\n\r\nGET /next";
    const server::HeadAnswer answer = read_head(text);
    ASSERT_EQ(answer.state, HeadState::Good);
    EXPECT_EQ(answer.head.target, "/a?b");
    EXPECT_EQ(answer.head.header("x-long"), "two words");
    EXPECT_EQ(text.substr(answer.size), "GET /next");
    EXPECT_EQ(read_head(text.substr(0, answer.size - 1)).state, HeadState::Incomplete);
}

TEST(RequestHead, whatever_two_readers_could_understand_differently_is_refused) {
    const auto refused = [](std::string_view line, std::string_view headers) {
        const server::HeadAnswer answer =
            read_head(std::string(line) + "\r\n" + std::string(headers) + "\r\n");
        return answer.state == HeadState::Refused ? answer.status : 0;
    };
    EXPECT_EQ(refused("GET / HTTP/1.1", "Content-Length: 5\r\n"), 413);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Content-Length: 0\r\nContent-Length: 0\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Content-Length: +0\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Transfer-Encoding: chunked\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "transfer-encoding: \tidentity\r\n"), 400);
    EXPECT_EQ(refused("POST / HTTP/1.1", "Content-Length: 5\r\n"), 405);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Host : x\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Host: x\r\n folded\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Host: x\nY: z\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Host: x\rY: z\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", ": x\r\n"), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "no colon\r\n"), 400);
    EXPECT_EQ(refused("GET  / HTTP/1.1", ""), 400);
    EXPECT_EQ(refused("GET /\t HTTP/1.1", ""), 400);
    EXPECT_EQ(refused("GET http://x/ HTTP/1.1", ""), 400);
    EXPECT_EQ(refused("GET * HTTP/1.1", ""), 400);
    EXPECT_EQ(refused("GET /", ""), 400);
    EXPECT_EQ(refused("GET / HTTP/2.0", ""), 505);
    EXPECT_EQ(refused("GET / HTTP/1.1", std::string("X: a\0b\r\n", 8)), 400);
    EXPECT_EQ(refused("GET / HTTP/1.1", "Content-Length: 0\r\n"), 0);
}

TEST(RequestHead, has_a_longest_size_that_is_found_before_its_end) {
    EXPECT_EQ(read_head("GET /" + std::string(5000, 'a')).status, 414);
    EXPECT_EQ(read_head("GET / HTTP/1.1\r\nX: " + std::string(20000, 'a')).status, 431);
    std::string many = "GET / HTTP/1.1\r\n";
    for (int i = 0; i < 65; ++i) many += "A: b\r\n";
    EXPECT_EQ(read_head(many + "\r\n").status, 431);
}

TEST(Guard, takes_our_own_names_with_our_port_alone) {
    const Guard guard({"127.0.0.1", "localhost", "desk.local", "*.corp.example"}, 8322, "");
    const auto judged = [&](const std::string& host) {
        return status_of_judgement(
            guard, "GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n", {true, "192.168.7.9"}
        );
    };
    for (const char* host :
         {"127.0.0.1:8322", "LocalHost:8322", "desk.local:8322", "a.corp.example:8322", "192.168.7.9:8322"}) {
        EXPECT_EQ(judged(host), 0) << host;
    }
    for (const char* host :
         {"evil.example:8322",
          "desk.local",
          "desk.local:80",
          "desk.local:83220",
          "desk.local.:8322",
          "a.b.corp.example:8322",
          ".corp.example:8322",
          "192.168.7.8:8322",
          "localhost:8322:8322",
          "localhost@evil.example:8322",
          ""}) {
        EXPECT_EQ(judged(host), 421) << host;
    }
    EXPECT_EQ(status_of_judgement(guard, "GET / HTTP/1.1\r\n\r\n"), 421);
    EXPECT_EQ(
        status_of_judgement(guard, "GET / HTTP/1.1\r\nHost: localhost:8322\r\nHost: localhost:8322\r\n\r\n"),
        421
    );
}

TEST(Guard, gives_nothing_to_pages_of_other_origins) {
    const Guard guard({"localhost"}, 8322, "");
    const auto judged = [&](const std::string& headers) {
        return status_of_judgement(guard, "GET / HTTP/1.1\r\nHost: localhost:8322\r\n" + headers + "\r\n");
    };
    EXPECT_EQ(judged("Origin: http://localhost:8322\r\n"), 0);
    EXPECT_EQ(judged("Origin: https://localhost:8322\r\n"), 403) << "another scheme is another origin";
    EXPECT_EQ(judged("Origin: null\r\n"), 403);
    EXPECT_EQ(judged("Origin: http://evil.example\r\n"), 403);
    EXPECT_EQ(judged("Origin: http://localhost:8322\r\nOrigin: http://evil.example\r\n"), 403);
    EXPECT_EQ(judged("Sec-Fetch-Site: same-origin\r\n"), 0);
    EXPECT_EQ(judged("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n"), 403);
    EXPECT_EQ(judged("Sec-Fetch-Site: same-site\r\nSec-Fetch-Mode: cors\r\n"), 403);
    EXPECT_EQ(
        judged("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document\r\n"), 0
    );
    EXPECT_EQ(
        judged("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: iframe\r\n"), 403
    );
}

TEST(Guard, takes_the_token_off_the_path) {
    const std::string token = server::make_token();
    const Guard guard({"localhost"}, 1, token);
    const auto judged = [&](const std::string& path) {
        return guard.judge(head_of("GET " + path + " HTTP/1.1\r\nHost: localhost:1\r\n\r\n"), {});
    };
    EXPECT_EQ(judged("/" + token + "/a?b=c").target, "/a?b=c");
    EXPECT_EQ(judged("/" + token + "/").target, "/");
    EXPECT_TRUE(judged("/" + token).lacks_slash);
    EXPECT_EQ(judged("/" + token.substr(1) + "/").status, 403);
    EXPECT_EQ(judged("/").status, 403);
}

TEST(Token, is_long_plain_and_never_the_same) {
    std::set<std::string> seen;
    for (int i = 0; i < 200; ++i) {
        const std::string token = server::make_token();
        EXPECT_EQ(token.size(), 26U);
        EXPECT_EQ(token.find_first_not_of("0123456789abcdefghjkmnpqrstvwxyz"), std::string::npos);
        seen.insert(token);
    }
    EXPECT_EQ(seen.size(), 200U);
}

TEST(Secret, is_the_same_only_when_all_of_it_is) {
    EXPECT_TRUE(server::is_same_secret("abc", "abc"));
    for (const std::string_view wrong : {"", "ab", "abd", "abcd", "bbc"})
        EXPECT_FALSE(server::is_same_secret(wrong, "abc")) << wrong;
    EXPECT_FALSE(server::is_same_secret(std::string_view("ab\0", 3), "abc"));
}

TEST(RateLimit, lets_so_many_in_at_once_and_so_many_a_second) {
    server::RateLimit limit(3, 2);
    const server::RateLimit::Time start{};
    const auto taken = [&](int milliseconds) {
        return limit.take("a", start + std::chrono::milliseconds(milliseconds));
    };
    EXPECT_TRUE(taken(0) && taken(0) && taken(0));
    EXPECT_FALSE(taken(0));
    EXPECT_FALSE(taken(400));
    EXPECT_TRUE(taken(500));
    EXPECT_FALSE(taken(600));
    EXPECT_TRUE(limit.take("b", start)) << "another address has its own";
}

TEST(RateLimit, remembers_a_bounded_number_of_addresses) {
    server::RateLimit limit(3, 2);
    for (int i = 0; i < 10'000; ++i) limit.take(std::to_string(i), server::RateLimit::Time{});
    EXPECT_LE(limit.addresses(), 1024U);
}

}  // namespace
}  // namespace feelem::test
