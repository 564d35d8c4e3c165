// SPDX-License-Identifier: Apache-2.0
// Paths that lead out, links that are guessed, names and origins of others.
#include "hostile_client.hpp"

#include <cctype>

namespace feelem::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

// --- paths

TEST_F(HostileClient, path_climbs_out_by_dots) {
    not_found(
        {"../outside.txt",
         "boiler.d/../outside.txt",
         "scene.d/../../outside.txt",
         "boiler.d/../boiler.glb/../outside.txt"}
    );
}

TEST_F(HostileClient, path_climbs_out_by_encoded_dots_and_slashes) {
    not_found(
        {"boiler.d/%2e%2e/outside.txt",
         "boiler.d/..%2foutside.txt",
         "boiler.d/%2e%2e%2foutside.txt",
         "%2e%2e%2foutside.txt"}
    );
}

TEST_F(HostileClient, path_is_encoded_twice) {
    not_found({"boiler.d/%252e%252e%252foutside.txt", "boiler.d/..%252foutside.txt"});
}

TEST_F(HostileClient, path_has_overlong_and_broken_utf8) {
    not_found(
        {"boiler.d/%c0%ae%c0%ae/outside.txt",
         "boiler.d/%e0%80%ae./outside.txt",
         "boiler.d/%ff%fe",
         "boiler.d/%u002e%u002e/outside.txt"}
    );
}

TEST_F(HostileClient, path_has_back_slashes_and_drives) {
    not_found(
        {"boiler.d\\..\\outside.txt",
         "boiler.d/..%5coutside.txt",
         "C:/outside.txt",
         "boiler.d/%5c%5chost%5cshare"}
    );
}

TEST_F(HostileClient, path_ends_at_a_zero_byte) {
    not_found({"boiler.d/stress.bin%00.txt", "%00", "boiler.d/..%00/outside.txt", "scene.glb%00"});
}

TEST_F(HostileClient, path_is_absolute) {
    not_found(
        {"/etc/passwd",
         "//etc/passwd",
         "boiler.d//etc/passwd",
         "boiler.d/%2fetc%2fpasswd",
         "file:///etc/passwd"}
    );
}

TEST_F(HostileClient, path_follows_a_link_out_of_the_folder) {
    not_found({"boiler.d/link.bin", "scene.d/link.bin"});
}

TEST_F(HostileClient, path_names_folders_and_hidden_files) {
    not_found({"boiler.d", "boiler.d/", "boiler.d/.", "boiler.d/..", ".", "kept/lan.pem", "boiler.d/.hidden"}
    );
}

TEST_F(HostileClient, path_names_files_beside_the_scene) {
    not_found({"outside.txt", "boiler.gltf", "kept", "boiler.glb.bak", "BOILER.GLB"});
}

TEST_F(HostileClient, percent_signs_are_cut_short) {
    not_found({"%", "%2", "boiler.d/%", "boiler.d/%zz", "%%%%%%%"});
}

// --- the link

TEST_F(HostileClient, no_token_for_anything_there_is) {
    for (const char* target :
         {"/",
          "/scene.glb",
          "/boiler.glb",
          "/boiler.d/stress.bin",
          "/connect.html",
          "/index.html",
          "/absent"}) {
        refused(get(target), {403, 429});
    }
}

TEST_F(HostileClient, token_is_wrong_in_one_letter_or_cut_or_longer) {
    const std::string token = path("").substr(1, 26);
    std::string near = token;
    near.back() = near.back() == 'a' ? 'b' : 'a';
    for (const std::string& wrong :
         {near, token.substr(0, 25), token + "a", token + token, std::string(26, '0')}) {
        refused(get("/" + wrong + "/scene.glb"), {403, 429});
    }
}

TEST_F(HostileClient, token_stands_elsewhere) {
    const std::string token = path("").substr(1, 26);
    refused(get("/?token=" + token), {403, 429});
    refused(
        get("/scene.glb", "Authorization: Bearer " + token + "\r\nCookie: token=" + token + "\r\n"),
        {403, 429}
    );
    refused(get("//" + token + "/scene.glb"), {403, 429});
    refused(get("/a/../" + token + "/scene.glb"), {403, 429});
}

TEST_F(HostileClient, token_in_capitals_or_with_zero_bytes) {
    std::string token = path("").substr(1, 26);
    for (char& c : token) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    refused(get("/" + token + "/scene.glb"), {403, 429});
    refused(get("/" + path("").substr(1, 25) + "%00/scene.glb"), {403, 429});
}

TEST_F(HostileClient, guessing_is_slowed_down_while_the_link_still_works) {
    int slowed = 0;
    for (int i = 0; i < 200; ++i) {
        const int status = status_of(ask(port(), false, fmt::format("/{:026}/scene.glb", i)));
        EXPECT_THAT(status, AnyOf(403, 429));
        slowed += status == 429 ? 1 : 0;
    }
    EXPECT_GT(slowed, 100);
    good_client_is_answered();
}

// --- names and origins

TEST_F(HostileClient, host_is_a_foreign_name_that_points_here) {
    for (const char* host :
         {"evil.example", "evil.example:8322", "localhost.evil.example", "127.0.0.1.evil.example"}) {
        refused(
            fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", path("scene.glb"), host),
            {421, 429}
        );
    }
}

TEST_F(HostileClient, host_is_absent_or_there_twice) {
    refused(fmt::format("GET {} HTTP/1.1\r\nConnection: close\r\n\r\n", path("scene.glb")), {421, 429});
    refused(get(path("scene.glb"), "Host: evil.example\r\n"), {421, 429});
    refused(get(path("scene.glb"), host_line()), {421, 429});
}

TEST_F(HostileClient, target_names_another_host) {
    refused(
        fmt::format("GET http://evil.example{} HTTP/1.1\r\n{}\r\n", path("scene.glb"), host_line()), {400}
    );
    refused(fmt::format("CONNECT evil.example:443 HTTP/1.1\r\n{}\r\n", host_line()), {400});
}

TEST_F(HostileClient, page_of_another_origin_asks_with_the_right_token) {
    for (const char* origin :
         {"https://evil.example", "null", "http://127.0.0.1", "https://127.0.0.1:1", "file://"}) {
        refused(get(path("scene.glb"), fmt::format("Origin: {}\r\n", origin)), {403, 429});
    }
}

TEST_F(HostileClient, page_of_another_site_embeds_a_file) {
    refused(
        get(path("scene.glb"),
            "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\nSec-Fetch-Dest: image\r\n"),
        {403, 429}
    );
    refused(
        get(path(""), "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: iframe\r\n"),
        {403, 429}
    );
}

TEST_F(HostileClient, preflight_gets_no_permission) {
    Client client(port(), true);
    client.send(fmt::format(
        "OPTIONS {} HTTP/1.1\r\n{}Origin: https://evil.example\r\nAccess-Control-Request-Method: "
        "GET\r\nConnection: close\r\n\r\n",
        path("scene.glb"),
        host_line()
    ));
    const std::string answer = client.receive();
    EXPECT_THAT(status_of(answer), AnyOf(405, 429));
    EXPECT_THAT(answer, Not(HasSubstr("Access-Control-Allow")));
}

}  // namespace
}  // namespace feelem::test
