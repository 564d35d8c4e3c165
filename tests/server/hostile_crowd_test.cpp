// SPDX-License-Identifier: Apache-2.0
// The slow, the silent, the many, and those that are gone in the middle.
#include "hostile_client.hpp"

#include <sys/socket.h>

#include <atomic>
#include <thread>

namespace feelem::test {
namespace {

using namespace std::chrono_literals;
using testing::AnyOf;

// --- time

/// Sends a byte every 50 ms until it is closed; how long that took.
std::chrono::milliseconds dribble(Client& client, const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    for (const char c : text) {
        if (!client.send({&c, 1}) || client.is_closed_within(50ms)) break;
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
}

TEST_F(HostileClient, head_comes_a_byte_at_a_time) {
    Client client(port());
    EXPECT_LT(dribble(client, get(path("scene.glb"), "X: " + std::string(2000, 'a') + "\r\n")), 8s);
}

TEST_F(HostileClient, handshake_comes_a_byte_at_a_time) {
    Client client(port());
    // The head of a client's hello that says it is 512 bytes long.
    EXPECT_LT(dribble(client, "\x16\x03\x01\x02\x01\x01" + std::string(500, '\x01')), 8s);
}

TEST_F(HostileClient, fifty_heads_never_end) {
    std::vector<std::unique_ptr<Client>> loris;
    for (int i = 0; i < 50; ++i) {
        loris.push_back(std::make_unique<Client>(port()));
        loris.back()->send("GET / HTTP/1.1\r\nX: ");
    }
    good_client_is_answered();
    for (const auto& client : loris) EXPECT_TRUE(client->is_closed_within(8s));
}

TEST_F(HostileClient, nothing_is_said_at_all) {
    Client plain(port()), tls(port(), true);
    EXPECT_TRUE(plain.is_closed_within(8s));
    EXPECT_TRUE(tls.is_closed_within(8s));
}

TEST_F(HostileClient, two_hundred_connections_stay_idle) {
    std::vector<std::unique_ptr<Client>> idle;
    for (int i = 0; i < 200; ++i) {
        idle.push_back(std::make_unique<Client>(port()));
        EXPECT_TRUE(idle.back()->is_connected());
    }
    good_client_is_answered();
    for (const auto& client : idle) EXPECT_TRUE(client->is_closed_within(8s));
}

TEST_F(HostileClient, two_hundred_connections_stay_idle_after_the_handshake) {
    std::vector<std::unique_ptr<Client>> idle;
    for (int i = 0; i < 200; ++i) idle.push_back(std::make_unique<Client>(port(), true));
    good_client_is_answered();
}

TEST_F(HostileClient, strangers_push_nobody_out_who_has_the_link) {
    Client good(port(), true);
    const std::string request = fmt::format("HEAD {} HTTP/1.1\r\n{}\r\n", path("scene.glb"), host_line());
    good.send(request);
    EXPECT_EQ(status_of(good.receive_one(false)), 200);
    std::vector<std::unique_ptr<Client>> crowd;
    for (int i = 0; i < 300; ++i) crowd.push_back(std::make_unique<Client>(port()));
    good.send(request);
    EXPECT_EQ(status_of(good.receive_one(false)), 200) << "the same connection still stands";
}

TEST_F(HostileClient, answers_are_asked_for_and_never_read) {
    std::vector<std::unique_ptr<Client>> deaf;
    for (int i = 0; i < 40; ++i) {
        deaf.push_back(std::make_unique<Client>(port()));
        deaf.back()->send(get(path("scene.glb")));
    }
    good_client_is_answered();
}

// --- cut off

TEST_F(HostileClient, connections_are_cut_at_once) {
    for (int i = 0; i < 300; ++i) {
        Client client(port());
        const linger reset{1, 0};
        setsockopt(client.socket(), SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
        client.cut();
    }
}

TEST_F(HostileClient, handshakes_are_cut_after_every_number_of_bytes) {
    // What a real client says first.
    const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(
        SSL_CTX_new(TLS_client_method()), SSL_CTX_free
    );
    const std::unique_ptr<SSL, decltype(&SSL_free)> tls(SSL_new(context.get()), SSL_free);
    BIO* out = BIO_new(BIO_s_mem());
    SSL_set_bio(tls.get(), BIO_new(BIO_s_mem()), out);
    SSL_connect(tls.get());
    char* bytes = nullptr;
    const auto size = static_cast<std::size_t>(BIO_get_mem_data(out, &bytes));
    ASSERT_GT(size, 100U);
    for (std::size_t cut = 1; cut <= size; cut += 3) {
        Client client(port());
        client.send({bytes, cut});
    }
}

TEST_F(HostileClient, handshake_is_garbage) {
    for (int seed = 0; seed < 30; ++seed) {
        Client client(port());
        std::string garbage = "\x16\x03\x01";
        for (int i = 0; i < 200; ++i) garbage += static_cast<char>((i * 7919 + seed * 104729) >> 3);
        client.send(garbage);
        EXPECT_TRUE(client.is_closed_within(8s));
    }
}

TEST_F(HostileClient, tls_is_old_or_without_a_common_cipher) {
    for (const int version : {TLS1_VERSION, TLS1_1_VERSION}) {
        const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(
            SSL_CTX_new(TLS_client_method()), SSL_CTX_free
        );
        SSL_CTX_set_security_level(context.get(), 0);
        SSL_CTX_set_min_proto_version(context.get(), version);
        SSL_CTX_set_max_proto_version(context.get(), version);
        const Client client(port());
        const std::unique_ptr<SSL, decltype(&SSL_free)> tls(SSL_new(context.get()), SSL_free);
        SSL_set_fd(tls.get(), client.socket());
        EXPECT_NE(SSL_connect(tls.get()), 1);
    }
}

TEST_F(HostileClient, streams_are_cut_in_the_middle) {
    for (int i = 0; i < 60; ++i) {
        Client client(port(), i % 2 == 0);
        client.send(get(path("scene.glb")));
        client.receive_one(false);
        client.cut();
    }
}

TEST_F(HostileClient, half_a_request_and_then_the_end) {
    for (int i = 0; i < 60; ++i) {
        Client client(port());
        client.send(get(path("scene.glb")).substr(0, static_cast<std::size_t>(i)));
        shutdown(client.socket(), SHUT_WR);
        EXPECT_TRUE(client.is_closed_within(8s));
    }
}

TEST_F(HostileClient, plain_text_is_spoken_to_tls_and_the_other_way_round) {
    Client client(port(), true);
    const std::string hello = "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03";
    client.send(hello + std::string(600, '\x01'));
    EXPECT_THAT(status_of(client.receive(2s)), AnyOf(0, 400, 414, 431));
    refused(std::string(600, '\x80'), {0, 400, 414});
}

// --- many

TEST_F(HostileClient, ten_thousand_requests_by_eight_at_once) {
    std::atomic<int> answered = 0, others = 0;
    const auto work = [&] {
        const std::string scene = fmt::format("HEAD {} HTTP/1.1\r\n{}\r\n", path("scene.glb"), host_line());
        auto client = std::make_unique<Client>(port(), true);
        for (int i = 0; i < 1250; ++i) {
            client->send(scene);
            const int status = status_of(client->receive_one(false));
            ++(status == 200 ? answered : others);
            // Too fast: the connection is closed, and we come again.
            if (status != 200) client = std::make_unique<Client>(port(), true);
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(answered + others, 10'000);
    EXPECT_GE(answered, 4000) << "those that are allowed at once, at least";
}

TEST_F(HostileClient, a_thousand_requests_in_one_breath) {
    Client client(port(), true);
    const std::string one = fmt::format("HEAD {} HTTP/1.1\r\n{}\r\n", path("absent"), host_line());
    std::string all;
    for (int i = 0; i < 1000; ++i) all += one;
    std::thread sender([&] { client.send(all + get(path("absent"))); });
    const std::string answers = client.receive();
    sender.join();
    EXPECT_GT(answers.size(), 1000U);
}

TEST_F(HostileClient, two_thousand_connections_one_after_another) {
    for (int i = 0; i < 2000; ++i) {
        Client client(port());
        client.send("GET / HTTP/1.1\r\n\r\n");
    }
}

}  // namespace
}  // namespace feelem::test
