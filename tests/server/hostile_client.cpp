// SPDX-License-Identifier: Apache-2.0
#include "hostile_client.hpp"

#include "support/memory.hpp"
#include "support/paths.hpp"

#include <unistd.h>

#include <filesystem>

namespace feelem::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

const std::string kSecret = "glTF SECRET-SCENE stress 412.75 MPa ";

struct Shared {
    std::string folder;
    std::unique_ptr<server::PageServer> server;
    std::uint64_t peak_at_start = 0;
};
Shared& shared() {
    static Shared shared;
    return shared;
}

}  // namespace

void HostileClient::SetUpTestSuite() {
    // CTest runs each case as a process of its own, some at once.
    const std::string folder = shared().folder =
        scratch_folder(fmt::format("stand_ins/hostile_client_{}", getpid()));
    std::string scene;
    while (scene.size() < (2 << 20)) scene += kSecret;
    write_file(folder + "/boiler.glb", scene);
    write_file(folder + "/boiler.gltf", scene);
    std::filesystem::create_directory(folder + "/boiler.d");
    write_file(folder + "/boiler.d/stress.bin", kSecret);
    write_file(folder + "/outside.txt", kSecret);
    std::filesystem::create_symlink("../outside.txt", folder + "/boiler.d/link.bin");
    server::ServeOptions options{folder + "/boiler.glb", 0, false, true};
    options.certificate_folder = folder + "/kept";
    options.limits.handshake = options.limits.head = options.limits.idle = 700ms;
    shared().server = std::make_unique<server::PageServer>(options);
    shared().server->start();
    ask(port(), true, "/");  // Libraries load what they need.
    reset_peak_memory();
    shared().peak_at_start = peak_memory();
}

void HostileClient::TearDownTestSuite() {
    shared().server.reset();
    std::filesystem::remove_all(shared().folder);
}

void HostileClient::TearDown() {
    good_client_is_answered();
    if (kSanitized) return;
    EXPECT_LT(peak_memory(), shared().peak_at_start + (64 << 20)) << "memory of the server and of the test";
}

void HostileClient::good_client_is_answered() {
    const auto start = std::chrono::steady_clock::now();
    const std::string answer = ask(port(), true, path("scene.glb"), {"GET", "Range: bytes=0-35\r\n"});
    EXPECT_EQ(status_of(answer), 206);
    EXPECT_EQ(body_of(answer), kSecret);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
}

void HostileClient::refused(const std::string& request, const std::vector<int>& statuses) {
    for (const bool tls : {true, false}) {
        Client client(port(), tls);
        client.send(request);
        const std::string answer = client.receive(8s);
        EXPECT_THAT(statuses, testing::Contains(status_of(answer))) << request.substr(0, 200);
        EXPECT_THAT(answer, Not(HasSubstr("SECRET"))) << request.substr(0, 200);
        EXPECT_THAT(answer, Not(HasSubstr("boiler"))) << request.substr(0, 200);
    }
}

std::string HostileClient::get(const std::string& target, const std::string& headers) {
    return fmt::format(
        "GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n{}\r\n", target, port(), headers
    );
}

void HostileClient::not_found(const std::vector<std::string>& targets) {
    for (const std::string& target : targets) refused(get(path(target)), {404, 400});
}

int HostileClient::port() {
    return shared().server->port();
}

std::string HostileClient::path(const std::string& file) {
    return prefix_of(*shared().server) + file;
}

std::string HostileClient::host_line() {
    return fmt::format("Host: 127.0.0.1:{}\r\n", port());
}

const std::string& HostileClient::folder() {
    return shared().folder;
}

}  // namespace feelem::test
