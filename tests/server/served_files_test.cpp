// SPDX-License-Identifier: Apache-2.0
// Files from disk: big ones without being in memory, texts compressed on their way, versions and their parts.
#include "client.hpp"
#include "gzip.hpp"
#include "support/memory.hpp"
#include "support/paths.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <zstd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace feelem::test {
namespace {

using server::PageServer;

class ServedFiles : public testing::Test {
protected:
    void serve(const std::string& name, bool lan = false) {
        server::ServeOptions options{folder_ + "/" + name, 0, false, lan};
        options.certificate_folder = folder_ + "/kept";
        server_ = std::make_unique<PageServer>(options);
        server_->start();
    }
    std::string get(const std::string& file, const std::string& headers = "", bool tls = false) {
        return ask(server_->port(), tls, prefix_of(*server_) + file, {"GET", headers});
    }
    /// Reads an answer through without keeping it; how many bytes.
    std::uint64_t size_of(const std::string& file) {
        Client client(server_->port());
        client.send(fmt::format(
            "GET {}{} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n\r\n",
            prefix_of(*server_),
            file,
            server_->port()
        ));
        std::vector<char> bytes(1 << 18);
        std::uint64_t size = 0;
        for (ssize_t got = 1; got > 0; size += static_cast<std::uint64_t>(std::max<ssize_t>(got, 0))) {
            got = recv(client.socket(), bytes.data(), bytes.size(), 0);
        }
        return size;
    }
    /// A file of that size that takes no place on the disk; its last bytes are "the end".
    void make_sparse(const std::string& name, std::uint64_t size) {
        write_file(folder_ + "/" + name, "glTF");
        std::filesystem::resize_file(folder_ + "/" + name, size);
        std::fstream file(folder_ + "/" + name, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(-7, std::ios::end);
        file << "the end";
    }

    std::string folder_ = scratch_folder(
        std::string("stand_ins/served_files_") + testing::UnitTest::GetInstance()->current_test_info()->name()
    );
    std::unique_ptr<PageServer> server_;
};

TEST_F(ServedFiles, a_scene_of_two_gigabytes_is_served_within_a_few_megabytes) {
    constexpr std::uint64_t kSize = 2ULL << 30;
    make_sparse("big.glb", kSize);
    serve("big.glb");
    get("scene.glb", "Range: bytes=0-3\r\n");
    reset_peak_memory();
    const std::uint64_t before = peak_memory();

    EXPECT_GE(size_of("scene.glb"), kSize);
    EXPECT_EQ(body_of(get("scene.glb", "Range: bytes=-7\r\n")), "the end");
    const std::string middle = get("scene.glb", "Range: bytes=1073741824-1073741833\r\n");
    EXPECT_EQ(header_of(middle, "Content-Range"), "bytes 1073741824-1073741833/2147483648");
    EXPECT_EQ(body_of(middle), std::string(10, '\0'));

    if (!kSanitized) {
        EXPECT_LT(peak_memory(), before + (16 << 20));
    }
}

TEST_F(ServedFiles, a_scene_is_hashed_without_being_in_memory) {
    make_sparse("big.glb", 128 << 20);
    reset_peak_memory();
    const std::uint64_t before = peak_memory();
    serve("big.glb", true);
    const std::string tag = header_of(get("scene.glb", "Range: bytes=0-3\r\n", true), "ETag");
    EXPECT_EQ(tag.size(), 66U) << "SHA-256 in quotes";
    if (!kSanitized) {
        EXPECT_LT(peak_memory(), before + (16 << 20));
    }
}

TEST_F(ServedFiles, a_file_beyond_hashing_still_has_a_version_of_its_own) {
    make_sparse("big.glb", 300 << 20);
    serve("big.glb");
    const std::string tag = header_of(get("scene.glb", "Range: bytes=0-3\r\n"), "ETag");
    EXPECT_EQ(status_of(get("scene.glb", "If-None-Match: " + tag + "\r\n")), 304);
    make_sparse("new.glb", 300 << 20);
    std::filesystem::rename(folder_ + "/new.glb", folder_ + "/big.glb");
    EXPECT_NE(header_of(get("scene.glb", "Range: bytes=0-3\r\n"), "ETag"), tag);
}

/// The content of an answer in chunks.
std::string unchunked(const std::string& body) {
    std::string out;
    for (std::size_t at = 0; at < body.size();) {
        const std::size_t end = body.find("\r\n", at);
        const std::size_t size = std::strtoul(body.c_str() + at, nullptr, 16);
        if (size == 0) break;
        out += body.substr(end + 2, size);
        at = end + 2 + size + 2;
    }
    return out;
}

TEST_F(ServedFiles, a_text_is_compressed_on_its_way_to_those_who_take_it) {
    std::string text = "{";
    for (int i = 0; i < 100'000; ++i) text += fmt::format("\"key {}\": {},\n", i, i * i);
    write_file(folder_ + "/scene.gltf", text);
    serve("scene.gltf");

    const std::string packed = get("scene.gltf", "Accept-Encoding: br, gzip\r\n");
    EXPECT_EQ(header_of(packed, "Content-Encoding"), "gzip");
    EXPECT_EQ(header_of(packed, "Vary"), "Accept-Encoding");
    const std::string body = unchunked(body_of(packed));
    EXPECT_LT(body.size(), text.size() / 2);
    EXPECT_TRUE(server::unpack(std::as_bytes(std::span(body))) == text);

    const std::string plain = get("scene.gltf");
    EXPECT_EQ(header_of(plain, "Content-Encoding"), "");
    EXPECT_TRUE(body_of(plain) == text);
    EXPECT_NE(header_of(plain, "ETag"), header_of(packed, "ETag"));
    EXPECT_EQ(header_of(get("scene.gltf", "Accept-Encoding: gzip;q=0\r\n"), "Content-Encoding"), "");
    const std::string part = get("scene.gltf", "Accept-Encoding: gzip\r\nRange: bytes=0-9\r\n");
    EXPECT_EQ(body_of(part), text.substr(0, 10)) << "a part is a part of the text";
    EXPECT_EQ(
        status_of(
            get("scene.gltf", "Accept-Encoding: gzip\r\nIf-None-Match: " + header_of(packed, "ETag") + "\r\n")
        ),
        304
    );
}

TEST_F(ServedFiles, numbers_are_not_compressed_on_this_machine) {
    write_file(folder_ + "/scene.glb", std::string(10'000, 'a'));
    serve("scene.glb");
    const std::string answer = get("scene.glb", "Accept-Encoding: gzip, zstd\r\n");
    EXPECT_EQ(header_of(answer, "Content-Encoding"), "");
    EXPECT_EQ(header_of(answer, "Content-Length"), "10000");
}

std::string without_zstd(const std::string& packed) {
    std::string out(1 << 20, '\0');
    const std::size_t size = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
    out.resize(ZSTD_isError(size) != 0 ? 0 : size);
    return out;
}

TEST_F(ServedFiles, numbers_go_compressed_through_the_air_to_those_who_take_it) {
    std::string numbers;
    for (int i = 0; i < 50'000; ++i) numbers += static_cast<char>(i * i % 251 / 16);
    numbers += std::string(600'000, 'b');
    write_file(folder_ + "/scene.glb", numbers);
    serve("scene.glb", true);
    const std::string answer = get("scene.glb", "Accept-Encoding: gzip, deflate, br, zstd\r\n");
    EXPECT_EQ(header_of(answer, "Content-Encoding"), "zstd");
    EXPECT_EQ(header_of(answer, "Vary"), "Accept-Encoding");
    const std::string body = unchunked(body_of(answer));
    EXPECT_LT(body.size(), numbers.size() / 10);
    EXPECT_TRUE(without_zstd(body) == numbers);
    const std::string plain = get("scene.glb", "Accept-Encoding: gzip\r\n");
    EXPECT_EQ(header_of(plain, "Content-Encoding"), "");
    EXPECT_TRUE(body_of(plain) == numbers);
    EXPECT_NE(header_of(plain, "ETag"), header_of(answer, "ETag"));
    const std::string part = get("scene.glb", "Accept-Encoding: zstd\r\nRange: bytes=0-9\r\n");
    EXPECT_EQ(body_of(part), numbers.substr(0, 10));
}

TEST_F(ServedFiles, a_part_of_another_version_is_not_given) {
    write_file(folder_ + "/scene.glb", "glTF one");
    serve("scene.glb");
    const std::string tag = header_of(get("scene.glb"), "ETag");
    EXPECT_EQ(body_of(get("scene.glb", "Range: bytes=5-\r\nIf-Range: " + tag + "\r\n")), "one");
    const std::string whole = get("scene.glb", "Range: bytes=5-\r\nIf-Range: \"another\"\r\n");
    EXPECT_EQ(status_of(whole), 200);
    EXPECT_EQ(body_of(whole), "glTF one");
}

TEST_F(ServedFiles, under_a_link_nobody_on_the_way_keeps_anything) {
    write_file(folder_ + "/scene.glb", "glTF");
    serve("scene.glb", true);
    EXPECT_EQ(header_of(get("scene.glb"), "Cache-Control"), "private, no-cache");
    EXPECT_EQ(header_of(ask(server_->port(), true, "/"), "Cache-Control"), "no-store");
}

TEST_F(ServedFiles, a_file_cut_while_it_is_sent_ends_the_connection_and_not_the_server) {
    make_sparse("big.glb", 400 << 20);
    serve("big.glb");
    Client client(server_->port());
    client.send(fmt::format("GET /scene.glb HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", server_->port()));
    EXPECT_EQ(status_of(client.receive_one(false)), 200);
    std::filesystem::resize_file(folder_ + "/big.glb", 4);
    EXPECT_LT(client.receive().size(), 400U << 20);
    EXPECT_EQ(body_of(get("scene.glb")), "glTF");
}

TEST_F(ServedFiles, an_old_client_gets_a_length_and_the_end) {
    write_file(folder_ + "/scene.gltf", "{}");
    serve("scene.gltf");
    Client client(server_->port());
    client.send(fmt::format(
        "GET /scene.gltf HTTP/1.0\r\nHost: 127.0.0.1:{}\r\nAccept-Encoding: gzip\r\n\r\n", server_->port()
    ));
    const std::string answer = client.receive();
    EXPECT_EQ(header_of(answer, "Content-Length"), "2");
    EXPECT_EQ(body_of(answer), "{}");
}

}  // namespace
}  // namespace feelem::test
