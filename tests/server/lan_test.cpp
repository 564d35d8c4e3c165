// SPDX-License-Identifier: Apache-2.0
// Serving to the local network: the link opens everything, and nothing opens without it.
#include "certificate.hpp"
#include "client.hpp"
#include "qr_code.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <qrcodegen/qrcodegen.hpp>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace feelem::test {
namespace {

using server::LanNames;
using server::PageServer;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kScene = "glTF and the secret MODEL NAME 412.75";

class SharedScene : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = scratch_folder(std::string("stand_ins/lan_") + test->name());
        write_file(folder_ + "/boiler.glb", kScene);
        options_ = {folder_ + "/boiler.glb", 0, false, true};
        options_.certificate_folder = folder_ + "/kept";
        server_ = std::make_unique<PageServer>(options_);
        server_->start();
    }

    std::string folder_;
    server::ServeOptions options_;
    std::unique_ptr<PageServer> server_;
};

TEST_F(SharedScene, the_link_opens_page_and_scene_under_tls_and_on_this_machine) {
    for (const bool tls : {true, false}) {
        const std::string page = ask(server_->port(), tls, prefix_of(*server_));
        EXPECT_EQ(status_of(page), 200);
        EXPECT_THAT(body_of(page), StartsWith("<!doctype html>"));
        EXPECT_EQ(body_of(ask(server_->port(), tls, prefix_of(*server_) + "scene.glb")), kScene);
    }
    EXPECT_THAT(server_->links(), Each(StartsWith("https://")));
    EXPECT_THAT(server_->links(), Each(HasSubstr(prefix_of(*server_))));
}

TEST_F(SharedScene, without_the_link_there_is_not_a_byte_and_all_paths_look_the_same) {
    const std::string token = prefix_of(*server_).substr(1, 26);
    ASSERT_EQ(token.size(), 26U);
    std::vector<std::string> wrong{
        "/",
        "/scene.glb",
        "/boiler.glb",
        "/absent",
        "/connect.html",
        "/index.html",
        "/?k=" + token,
        "/" + token.substr(0, 25) + "/scene.glb",
        "/" + token + "0/scene.glb",
        "//" + token + "/scene.glb",
        "/x/../" + token + "/scene.glb",
        "/" + std::string(26, 'a') + "/scene.glb"};
    for (std::size_t i = 0; i < token.size(); ++i) {
        std::string near = token;
        near[i] = near[i] == 'a' ? 'b' : 'a';
        wrong.push_back("/" + near + "/scene.glb");
    }
    const std::string usual = body_of(ask(server_->port(), true, "/"));
    EXPECT_EQ(usual, "the whole link is needed, as it was printed\n");
    for (const std::string& path : wrong) {
        const std::string answer = ask(server_->port(), true, path);
        EXPECT_EQ(status_of(answer), 403) << path;
        EXPECT_EQ(body_of(answer), usual) << path;
        EXPECT_THAT(answer, Not(HasSubstr("ETag"))) << path;
        EXPECT_THAT(answer, Not(HasSubstr("boiler"))) << path;
    }
    EXPECT_EQ(status_of(ask(server_->port(), false, "/scene.glb")), 403) << "nor on this machine";
}

TEST_F(SharedScene, idle_connections_give_way_long_before_patience_with_them_ends) {
    std::vector<std::unique_ptr<Client>> idle;
    for (int i = 0; i < 300; ++i) idle.push_back(std::make_unique<Client>(server_->port()));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(body_of(ask(server_->port(), true, prefix_of(*server_) + "scene.glb")), kScene);
    EXPECT_LT(std::chrono::steady_clock::now() - start, options_.limits.idle - std::chrono::seconds(5));
    EXPECT_TRUE(idle.front()->is_closed_within(std::chrono::seconds(5))) << "the oldest goes first";
    EXPECT_FALSE(idle.back()->is_closed_within(std::chrono::milliseconds(50)));
}

TEST_F(SharedScene, a_link_without_its_last_slash_is_led_on) {
    std::string path = prefix_of(*server_);
    path.pop_back();
    const std::string answer = ask(server_->port(), true, path);
    EXPECT_EQ(status_of(answer), 308);
    EXPECT_EQ(header_of(answer, "Location"), path + "/");
}

TEST_F(SharedScene, the_connect_page_shows_code_link_and_fingerprint) {
    const std::string page = body_of(ask(server_->port(), true, prefix_of(*server_) + "connect.html"));
    EXPECT_THAT(page, HasSubstr(server_->fingerprint()));
    if (!server_->links().empty()) {
        EXPECT_THAT(page, HasSubstr(server_->links().front()));
        EXPECT_THAT(page, HasSubstr(server::qr_for_page(server_->links().front())));
    }
    EXPECT_EQ(status_of(ask(server_->port(), true, prefix_of(*server_) + "connect.css")), 200);
    EXPECT_THAT(body_of(ask(server_->port(), true, prefix_of(*server_))), HasSubstr("<"));
}

TEST_F(SharedScene, the_certificate_is_shown_as_it_was_printed_and_kept_for_its_owner_alone) {
    Client client(server_->port(), true);
    EXPECT_EQ(client.fingerprint(), server_->fingerprint());
    EXPECT_TRUE(server_->has_new_certificate());
    struct stat status {};
    ASSERT_EQ(stat((options_.certificate_folder + "/lan.pem").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
    ASSERT_EQ(stat(options_.certificate_folder.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0700U);

    const PageServer next(options_);
    EXPECT_EQ(next.fingerprint(), server_->fingerprint()) << "or the browser would warn again";
    EXPECT_FALSE(next.has_new_certificate());
    EXPECT_NE(prefix_of(next), prefix_of(*server_)) << "but the link is another each time";
}

TEST_F(SharedScene, a_certificate_of_the_users_own_is_taken_and_a_wrong_key_refused) {
    // Any PEM with both will do: ours.
    const std::string pem = options_.certificate_folder + "/lan.pem";
    options_.certificate_folder = "/nowhere";
    options_.certificate_file = options_.key_file = pem;
    const PageServer given(options_);
    EXPECT_EQ(given.fingerprint(), server_->fingerprint());
    EXPECT_FALSE(given.has_own_certificate());
    if (!server::lan_names().host.empty()) {
        EXPECT_THAT(given.links().front(), Not(HasSubstr("https://1"))) << "its names before addresses";
    }

    server::own_certificate(folder_ + "/other", {});
    options_.key_file = folder_ + "/other/lan.pem";
    EXPECT_THROW(PageServer{options_}, Error) << "a key of another certificate";
    options_.key_file = folder_ + "/boiler.glb";
    EXPECT_THROW(PageServer{options_}, Error) << "no key at all";
}

using Paper = std::unique_ptr<X509, decltype(&X509_free)>;

Paper read_certificate(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "r"), std::fclose);
    return {PEM_read_X509(file.get(), nullptr, nullptr, nullptr), X509_free};
}

TEST(OwnCertificate, is_for_all_addresses_the_host_and_its_local_name) {
    const std::string folder = scratch_folder("own_certificate_names");
    const LanNames names{{"192.168.7.9", "fd00::7"}, "desk.example"};
    const server::Certificate made = server::own_certificate(folder, names);
    const Paper paper = read_certificate(folder + "/lan.pem");
    ASSERT_TRUE(paper);
    for (const char* address : {"192.168.7.9", "fd00::7", "127.0.0.1", "::1"}) {
        EXPECT_EQ(X509_check_ip_asc(paper.get(), address, 0), 1) << address;
    }
    for (const char* name : {"desk.example", "desk.local", "localhost"}) {
        EXPECT_EQ(X509_check_host(paper.get(), name, 0, 0, nullptr), 1) << name;
        EXPECT_THAT(made.names, testing::Contains(name));
    }
    EXPECT_EQ(X509_check_ip_asc(paper.get(), "192.168.7.8", 0), 0);
    const EVP_PKEY* key = X509_get0_pubkey(paper.get());
    EXPECT_EQ(EVP_PKEY_get_bits(key), 256);
    EXPECT_EQ(EVP_PKEY_get_base_id(key), EVP_PKEY_EC);
    EXPECT_EQ(X509_get_extension_flags(paper.get()) & EXFLAG_CA, 0U);
}

TEST(OwnCertificate, is_made_anew_when_an_address_is_new_and_kept_when_one_is_gone) {
    const std::string folder = scratch_folder("own_certificate_addresses");
    const auto made = [&](const LanNames& names) { return server::own_certificate(folder, names); };
    const std::string first = made({{"192.168.7.9", "10.0.0.1"}, "desk"}).fingerprint;
    EXPECT_EQ(made({{"192.168.7.9"}, "desk"}).fingerprint, first);
    EXPECT_NE(made({{"192.168.7.10"}, "desk"}).fingerprint, first);
    const std::string second = made({{"192.168.7.10"}, "desk"}).fingerprint;
    EXPECT_NE(made({{"192.168.7.10"}, "bench"}).fingerprint, second) << "another host name";
}

TEST(OwnCertificate, is_made_anew_within_a_month_of_its_end) {
    const std::string folder = scratch_folder("own_certificate_end");
    const std::string path = folder + "/lan.pem";
    const std::string first = server::own_certificate(folder, {}).fingerprint;
    const auto end_in_days = [&](long days) {
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
            std::fopen(path.c_str(), "r+"), std::fclose
        );
        EVP_PKEY* key = PEM_read_PrivateKey(file.get(), nullptr, nullptr, nullptr);
        const Paper paper(PEM_read_X509(file.get(), nullptr, nullptr, nullptr), X509_free);
        X509_gmtime_adj(X509_getm_notAfter(paper.get()), days * 86400);
        X509_sign(paper.get(), key, EVP_sha256());
        std::rewind(file.get());
        PEM_write_PrivateKey(file.get(), key, nullptr, nullptr, 0, nullptr, nullptr);
        PEM_write_X509(file.get(), paper.get());
        EVP_PKEY_free(key);
    };
    end_in_days(40);
    const std::string changed = server::own_certificate(folder, {}).fingerprint;
    EXPECT_NE(changed, first) << "the test's own change";
    EXPECT_FALSE(server::own_certificate(folder, {}).is_new);
    end_in_days(20);
    EXPECT_TRUE(server::own_certificate(folder, {}).is_new);
}

TEST(OwnCertificate, is_made_anew_when_others_could_read_the_key_or_the_file_is_broken) {
    const std::string folder = scratch_folder("own_certificate_seen");
    const std::string path = folder + "/lan.pem";
    server::own_certificate(folder, {});
    std::filesystem::permissions(path, std::filesystem::perms{0644});
    EXPECT_TRUE(server::own_certificate(folder, {}).is_new);
    EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms{0600});
    std::filesystem::resize_file(path, 300);
    EXPECT_TRUE(server::own_certificate(folder, {}).is_new);
}

TEST(OwnCertificate, says_when_it_cannot_be_kept) {
    const std::string folder = scratch_folder("own_certificate_nowhere");
    write_file(folder + "/file", "");
    EXPECT_THROW(server::own_certificate(folder + "/file/folder", {}), Error);
    EXPECT_THROW(server::own_certificate("", {}), Error);
}

const std::string kLink = "https://192.168.178.123:8322/932t1wmg91rgvhesgatfxn55q8/";

std::vector<std::string> rows_of(const qrcodegen::QrCode& code, int quiet) {
    std::vector<std::string> rows;
    for (int y = -quiet; y < code.getSize() + quiet; ++y) {
        std::string& row = rows.emplace_back();
        for (int x = -quiet; x < code.getSize() + quiet; ++x) row += code.getModule(x, y) ? '#' : '.';
    }
    return rows;
}

TEST(QrCode, in_the_terminal_is_the_code_of_the_link_with_its_quiet_zone) {
    const auto code = qrcodegen::QrCode::encodeText(kLink.c_str(), qrcodegen::QrCode::Ecc::MEDIUM);
    std::vector<std::string> found;
    std::istringstream text(server::qr_for_terminal(kLink));
    for (std::string line; std::getline(text, line);) {
        ASSERT_THAT(line, StartsWith("\x1b[38;5;16;48;5;231m"));
        std::string upper, lower;
        for (std::size_t i = line.find('m') + 1; line[i] != '\x1b';) {
            const bool is_blank = line[i] == ' ';
            const std::string glyph = line.substr(i, is_blank ? 1 : 3);
            i += glyph.size();
            upper += glyph == "▀" || glyph == "█" ? '#' : '.';
            lower += glyph == "▄" || glyph == "█" ? '#' : '.';
        }
        found.push_back(upper);
        found.push_back(lower);
    }
    const std::vector<std::string> wanted = rows_of(code, 4);
    ASSERT_GE(found.size(), wanted.size());
    found.resize(wanted.size());  // An odd number of rows: a blank one ends it.
    EXPECT_EQ(found, wanted);
}

TEST(QrCode, on_the_page_has_a_square_for_each_dark_module) {
    const auto code = qrcodegen::QrCode::encodeText(kLink.c_str(), qrcodegen::QrCode::Ecc::MEDIUM);
    std::vector<std::string> found(
        static_cast<std::size_t>(code.getSize() + 8),
        std::string(static_cast<std::size_t>(code.getSize() + 8), '.')
    );
    const std::string svg = server::qr_for_page(kLink);
    for (std::size_t at = svg.find('M'); at != std::string::npos; at = svg.find('M', at + 1)) {
        std::size_t x = 0, y = 0;
        ASSERT_EQ(std::sscanf(svg.c_str() + at, "M%zu,%zuh1v1h-1z", &x, &y), 2);
        found.at(y).at(x) = '#';
    }
    EXPECT_EQ(found, rows_of(code, 4));
}

}  // namespace
}  // namespace feelem::test
