// SPDX-License-Identifier: Apache-2.0
// The server for real, on 127.0.0.1, asked by hand-written requests.
#include "byte_range.hpp"
#include "page_server.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace feelem::test {
namespace {

using server::PageServer;
using server::RangeAnswer;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Sends the text as it is and reads until the server closes.
std::string raw_answer(int port, const std::string& request) {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(
        ::send(socket, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size())
    );
    std::string answer(1 << 16, '\0');
    std::size_t size = 0;
    for (ssize_t got = 1; got > 0; size += static_cast<std::size_t>(std::max<ssize_t>(got, 0))) {
        if (size == answer.size()) answer.resize(2 * size);
        got = ::recv(socket, answer.data() + size, answer.size() - size, 0);
    }
    close(socket);
    answer.resize(size);
    return answer;
}

class ServedScene : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = scratch_folder(std::string("stand_ins/server_") + test->name());
        for (int i = 0; i < 3000; ++i) scene_ += fmt::format("glTF bytes {} ", i);
        write_file(folder_ + "/boiler.glb", scene_);
        std::filesystem::create_directory(folder_ + "/boiler.d");
        write_file(folder_ + "/boiler.d/temperature.2.bin", "side file");
        write_file(folder_ + "/secret.txt", "SECRET");
        std::filesystem::create_symlink("../secret.txt", folder_ + "/boiler.d/link.bin");
        server_ = std::make_unique<PageServer>(server::ServeOptions{folder_ + "/boiler.glb", 0, false});
        server_->start();
    }

    std::string get(
        const std::string& path, const std::string& headers = "", const std::string& method = "GET"
    ) {
        return raw_answer(
            server_->port(),
            fmt::format(
                "{} {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n{}\r\n",
                method,
                path,
                server_->port(),
                headers
            )
        );
    }
    static std::string body_of(const std::string& answer) {
        return answer.substr(answer.find("\r\n\r\n") + 4);
    }
    static std::string header_of(const std::string& answer, const std::string& name) {
        const std::size_t at = answer.find("\r\n" + name + ": ");
        if (at == std::string::npos) return "";
        const std::size_t from = at + name.size() + 4;
        return answer.substr(from, answer.find("\r\n", from) - from);
    }

    std::string folder_, scene_;
    std::unique_ptr<PageServer> server_;
};

TEST_F(ServedScene, page_and_scene_are_served_with_their_types) {
    const std::string page = get("/");
    EXPECT_THAT(page, StartsWith("HTTP/1.1 200 "));
    EXPECT_EQ(header_of(page, "Content-Type"), "text/html; charset=utf-8");
    EXPECT_THAT(body_of(page), HasSubstr("<!doctype html>"));

    const std::string scene = get("/scene.glb");
    EXPECT_EQ(header_of(scene, "Content-Type"), "model/gltf-binary");
    EXPECT_TRUE(body_of(scene) == scene_);
    EXPECT_TRUE(body_of(get("/boiler.glb")) == scene_) << "also by its own name";
}

TEST_F(ServedScene, side_files_are_found_by_the_scene_name_and_by_its_own) {
    EXPECT_EQ(body_of(get("/boiler.d/temperature.2.bin")), "side file");
    EXPECT_EQ(body_of(get("/scene.d/temperature.2.bin")), "side file");
    EXPECT_THAT(get("/boiler.d/absent.bin"), StartsWith("HTTP/1.1 404 "));
}

TEST_F(ServedScene, nothing_outside_the_scene_is_reached) {
    for (const std::string path :
         {"/secret.txt",
          "/../secret.txt",
          "/boiler.d/../secret.txt",
          "/scene.d/../../secret.txt",
          "/boiler.d/%2e%2e/secret.txt",
          "/boiler.d/..%2fsecret.txt",
          "/boiler.d/%2e%2e%2fsecret.txt",
          "//etc/passwd",
          "/boiler.d//etc/passwd",
          "/boiler.d/link.bin",
          "/boiler.d/",
          "/boiler.d",
          "/scene.glb/../secret.txt",
          "/assets/../../etc/passwd"}) {
        const std::string answer = get(path);
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 404 ")) << path;
        EXPECT_THAT(answer, Not(HasSubstr("SECRET"))) << path;
    }
}

TEST_F(ServedScene, every_answer_is_closed_to_other_origins) {
    for (const std::string path : {"/", "/scene.glb", "/absent"}) {
        const std::string answer = get(path);
        const std::string policy = header_of(answer, "Content-Security-Policy");
        EXPECT_THAT(policy, StartsWith("default-src 'self';")) << path;
        // WebAssembly may be compiled (the decoder of compressed scenes), scripts may not be made of text.
        EXPECT_THAT(policy, HasSubstr("script-src 'self' 'wasm-unsafe-eval';")) << path;
        EXPECT_THAT(policy, Not(HasSubstr("'unsafe"))) << path;
        EXPECT_THAT(policy, Not(HasSubstr("http"))) << path;
        EXPECT_EQ(header_of(answer, "X-Content-Type-Options"), "nosniff") << path;
        EXPECT_EQ(header_of(answer, "Cross-Origin-Resource-Policy"), "same-origin") << path;
        EXPECT_EQ(header_of(answer, "Access-Control-Allow-Origin"), "") << path;
    }
}

TEST_F(ServedScene, other_host_names_are_refused) {
    for (const std::string host : {"evil.example", "127.0.0.1", "127.0.0.1:1", "evil.example:8322"}) {
        const std::string answer = raw_answer(
            server_->port(), "GET /scene.glb HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n"
        );
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 421 ")) << host;
        EXPECT_THAT(answer, Not(HasSubstr("glTF"))) << host;
    }
    const std::string answer =
        raw_answer(server_->port(), "GET /scene.glb HTTP/1.1\r\nConnection: close\r\n\r\n");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 421 ")) << "no host at all";
}

TEST_F(ServedScene, only_reading_is_allowed) {
    for (const std::string method : {"POST", "PUT", "DELETE", "PATCH"}) {
        EXPECT_THAT(get("/scene.glb", "Content-Length: 0\r\n", method), StartsWith("HTTP/1.1 405 "))
            << method;
    }
    const std::string head = get("/scene.glb", "", "HEAD");
    EXPECT_THAT(head, StartsWith("HTTP/1.1 200 "));
    EXPECT_EQ(header_of(head, "Content-Length"), std::to_string(scene_.size()));
    EXPECT_EQ(body_of(head), "");
}

TEST_F(ServedScene, ranges_give_exactly_those_bytes) {
    const std::string part = get("/scene.glb", "Range: bytes=100-149\r\n");
    EXPECT_THAT(part, StartsWith("HTTP/1.1 206 "));
    EXPECT_EQ(body_of(part), scene_.substr(100, 50));
    EXPECT_EQ(header_of(part, "Content-Range"), fmt::format("bytes 100-149/{}", scene_.size()));

    EXPECT_EQ(body_of(get("/scene.glb", "Range: bytes=-7\r\n")), scene_.substr(scene_.size() - 7));
    const std::string tail =
        get("/scene.glb", fmt::format("Range: bytes={}-999999999\r\n", scene_.size() - 3));
    EXPECT_EQ(body_of(tail), scene_.substr(scene_.size() - 3));
    EXPECT_EQ(header_of(tail, "Content-Length"), "3");
}

TEST_F(ServedScene, ranges_beyond_the_end_are_not_satisfiable) {
    const std::string answer = get("/scene.glb", fmt::format("Range: bytes={}-\r\n", scene_.size()));

    EXPECT_THAT(answer, StartsWith("HTTP/1.1 416 "));
    EXPECT_EQ(header_of(answer, "Content-Range"), fmt::format("bytes */{}", scene_.size()));
}

TEST_F(ServedScene, several_ranges_give_the_whole) {
    for (const std::string range : {"bytes=0-1,5-6", "bytes=0-1, 3-"}) {
        const std::string answer = get("/scene.glb", "Range: " + range + "\r\n");
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 ")) << range;
        EXPECT_TRUE(body_of(answer) == scene_) << range;
    }
}

TEST_F(ServedScene, a_known_version_is_not_sent_again_and_a_new_one_is) {
    const std::string tag = header_of(get("/scene.glb"), "ETag");
    const std::string again = get("/scene.glb", "If-None-Match: " + tag + "\r\n");
    EXPECT_THAT(again, StartsWith("HTTP/1.1 304 "));
    EXPECT_EQ(body_of(again), "");

    write_file(folder_ + "/new", "glTF made anew");
    std::filesystem::rename(folder_ + "/new", folder_ + "/boiler.glb");

    const std::string fresh = get("/scene.glb", "If-None-Match: " + tag + "\r\n");
    EXPECT_THAT(fresh, StartsWith("HTTP/1.1 200 "));
    EXPECT_EQ(body_of(fresh), "glTF made anew");
}

TEST_F(ServedScene, page_is_sent_compressed_to_those_who_take_it) {
    const std::string packed = get("/", "Accept-Encoding: gzip, br\r\n");

    EXPECT_EQ(header_of(packed, "Content-Encoding"), "gzip");
    EXPECT_EQ(header_of(packed, "Content-Length"), std::to_string(body_of(packed).size()));
    EXPECT_THAT(body_of(packed), StartsWith("\x1f\x8b"));
    EXPECT_NE(header_of(packed, "ETag"), header_of(get("/"), "ETag"));
}

TEST_F(ServedScene, another_server_takes_the_next_port_unless_told_otherwise) {
    const int port = server_->port();
    PageServer next({folder_ + "/boiler.glb", port, false});
    EXPECT_GT(next.port(), port);

    EXPECT_THROW(PageServer({folder_ + "/boiler.glb", port, true}), Error);
}

TEST(PageServer, does_not_start_without_its_scene) {
    EXPECT_THROW(PageServer({scratch_folder("server_none") + "/absent.glb", 0, false}), Error);
}

TEST(ByteRange, is_read_as_the_standard_says) {
    const auto answer = [](std::string_view header) { return server::read_range(header, 10); };

    EXPECT_EQ(answer("bytes=2-5").range.last, 5U);
    EXPECT_EQ(answer("bytes=2-").range.last, 9U);
    EXPECT_EQ(answer("bytes=-3").range.first, 7U);
    EXPECT_EQ(answer("bytes=-30").range.first, 0U);
    EXPECT_EQ(answer("bytes=10-").answer, RangeAnswer::NotSatisfiable);
    EXPECT_EQ(answer("bytes=-0").answer, RangeAnswer::NotSatisfiable);
    for (const std::string_view senseless :
         {"",
          "bytes=",
          "bytes=-",
          "bytes=a-b",
          "bytes=1",
          "items=0-1",
          "bytes=+1-2",
          "bytes=18446744073709551616-"}) {
        EXPECT_EQ(answer(senseless).answer, RangeAnswer::Whole) << senseless;
    }
}

}  // namespace
}  // namespace feelem::test
