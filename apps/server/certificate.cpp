// SPDX-License-Identifier: Apache-2.0
#include "certificate.hpp"

#include "feelem/error.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <utility>

namespace feelem::server {
namespace {

namespace fs = std::filesystem;

constexpr int kDaysValid = 397;  ///< More is refused by some browsers.
constexpr int kDaysLeft = 30;
constexpr long kSecondsADay = 86'400;

template <auto Free>
struct Freed {
    template <class T>
    void operator()(T* object) const {
        Free(object);
    }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using Paper = std::unique_ptr<X509, Freed<X509_free>>;
using Bio = std::unique_ptr<BIO, Freed<BIO_free_all>>;
using Names = std::unique_ptr<GENERAL_NAMES, Freed<GENERAL_NAMES_free>>;

[[noreturn]] void fail(const std::string& where, const std::string& text) {
    throw Error(Code::WriteFailed, where, text);
}

std::vector<std::string> dns_names(const LanNames& names) {
    std::vector<std::string> found{"localhost"};
    if (names.host.empty()) return found;
    found.push_back(names.host);
    const std::string local = names.host.substr(0, names.host.find('.')) + ".local";
    if (local != names.host) found.push_back(local);
    return found;
}

std::vector<std::string> ip_addresses(const LanNames& names) {
    std::vector<std::string> found{"127.0.0.1", "::1"};
    found.insert(found.end(), names.addresses.begin(), names.addresses.end());
    return found;
}

void add_extension(X509& paper, int id, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx_nodb(&context);
    X509V3_set_ctx(&context, &paper, &paper, nullptr, nullptr, 0);
    X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, id, value.c_str());
    if (extension == nullptr) fail("certificate", "cannot add \"" + value + "\"");
    X509_add_ext(&paper, extension, -1);
    X509_EXTENSION_free(extension);
}

Paper make_paper(EVP_PKEY& key, const LanNames& names) {
    Paper paper(X509_new());
    if (!paper) throw std::bad_alloc();
    X509_set_version(paper.get(), X509_VERSION_3);
    std::array<unsigned char, 16> serial{};
    if (RAND_bytes(serial.data(), serial.size()) != 1) fail("certificate", "no random numbers");
    serial[0] = static_cast<unsigned char>((serial[0] & 0x7f) | 0x40);
    BIGNUM* number = BN_bin2bn(serial.data(), serial.size(), nullptr);
    BN_to_ASN1_INTEGER(number, X509_get_serialNumber(paper.get()));
    BN_free(number);
    // A headset's clock may be slow.
    X509_gmtime_adj(X509_getm_notBefore(paper.get()), -kSecondsADay);
    X509_gmtime_adj(X509_getm_notAfter(paper.get()), (kDaysValid - 1) * kSecondsADay);
    X509_NAME* subject = X509_get_subject_name(paper.get());
    const std::string title = names.host.empty() ? "Feelem" : "Feelem on " + names.host.substr(0, 50);
    const auto* bytes = reinterpret_cast<const unsigned char*>(title.c_str());
    X509_NAME_add_entry_by_NID(subject, NID_commonName, MBSTRING_UTF8, bytes, -1, -1, 0);
    X509_set_issuer_name(paper.get(), subject);
    X509_set_pubkey(paper.get(), &key);
    std::vector<std::string> alternatives;
    for (const std::string& name : dns_names(names)) alternatives.push_back("DNS:" + name);
    for (const std::string& address : ip_addresses(names)) alternatives.push_back("IP:" + address);
    add_extension(*paper, NID_subject_alt_name, fmt::format("{}", fmt::join(alternatives, ",")));
    add_extension(*paper, NID_basic_constraints, "critical,CA:FALSE");
    add_extension(*paper, NID_key_usage, "critical,digitalSignature");
    add_extension(*paper, NID_ext_key_usage, "serverAuth");
    if (X509_sign(paper.get(), &key, EVP_sha256()) == 0) fail("certificate", "cannot be signed");
    return paper;
}

/// Only its owner may read it, from its first byte on; whole or not at all.
void keep(const std::string& path, EVP_PKEY& key, X509& paper) {
    const Bio memory(BIO_new(BIO_s_mem()));
    if (!memory) throw std::bad_alloc();
    PEM_write_bio_PrivateKey(memory.get(), &key, nullptr, nullptr, 0, nullptr, nullptr);
    PEM_write_bio_X509(memory.get(), &paper);
    char* text = nullptr;
    const auto size = static_cast<std::size_t>(BIO_get_mem_data(memory.get(), &text));
    const std::string fresh = fmt::format("{}.{}", path, getpid());
    unlink(fresh.c_str());
    const int file = open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const bool is_written = file >= 0 && write(file, text, size) == static_cast<ssize_t>(size);
    const int error = errno;
    if (file >= 0) close(file);
    if (is_written && rename(fresh.c_str(), path.c_str()) == 0) return;
    unlink(fresh.c_str());
    fail(path, std::string("the certificate cannot be kept: ") + std::strerror(error));
}

struct Kept {
    Key key;
    Paper paper;
};

/// Empty when it is not there, not whole, or when others could have read the key.
Kept find_kept(const std::string& path) {
    struct stat status {};
    if (lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    if ((status.st_mode & 077) != 0 || status.st_uid != geteuid()) return {};
    const Bio file(BIO_new_file(path.c_str(), "r"));
    if (!file) return {};
    Kept kept;
    kept.key.reset(PEM_read_bio_PrivateKey(file.get(), nullptr, nullptr, nullptr));
    kept.paper.reset(PEM_read_bio_X509(file.get(), nullptr, nullptr, nullptr));
    const bool is_whole =
        kept.key && kept.paper && X509_check_private_key(kept.paper.get(), kept.key.get()) == 1;
    return is_whole ? std::move(kept) : Kept{};
}

bool serves(X509& paper, const LanNames& names) {
    std::time_t soon = std::time(nullptr) + kDaysLeft * kSecondsADay;
    if (X509_cmp_time(X509_get0_notAfter(&paper), &soon) <= 0) return false;
    if (X509_cmp_current_time(X509_get0_notBefore(&paper)) >= 0) return false;
    const auto is_named = [&](const std::string& name) {
        return X509_check_host(&paper, name.c_str(), name.size(), 0, nullptr) == 1;
    };
    const auto is_addressed = [&](const std::string& address) {
        return X509_check_ip_asc(&paper, address.c_str(), 0) == 1;
    };
    return std::ranges::all_of(dns_names(names), is_named) &&
           std::ranges::all_of(ip_addresses(names), is_addressed);
}

std::string fingerprint_of(const X509& paper) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    X509_digest(&paper, EVP_sha256(), digest.data(), &size);
    return fmt::format("{:02X}", fmt::join(digest.begin(), digest.begin() + size, ":"));
}

std::vector<std::string> names_of(const X509& paper) {
    std::vector<std::string> found;
    const Names names(
        static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(&paper, NID_subject_alt_name, nullptr, nullptr))
    );
    for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
        const GENERAL_NAME* name = sk_GENERAL_NAME_value(names.get(), i);
        if (name->type != GEN_DNS) continue;
        const ASN1_STRING* text = name->d.dNSName;
        const auto* bytes = reinterpret_cast<const char*>(ASN1_STRING_get0_data(text));
        found.emplace_back(bytes, static_cast<std::size_t>(ASN1_STRING_length(text)));
    }
    return found;
}

int choose_protocol(SSL*, const unsigned char** out, unsigned char* size, const unsigned char* in, unsigned in_size, void*) {
    static constexpr std::array<unsigned char, 9> kOurs{8, 'h', 't', 't', 'p', '/', '1', '.', '1'};
    unsigned char* chosen = nullptr;
    const int found = SSL_select_next_proto(&chosen, size, kOurs.data(), kOurs.size(), in, in_size);
    *out = chosen;
    return found == OPENSSL_NPN_NEGOTIATED ? SSL_TLSEXT_ERR_OK : SSL_TLSEXT_ERR_NOACK;
}

/// Nothing is kept of a connection that has ended: no sessions, no tickets.
TlsContext make_context() {
    TlsContext context(SSL_CTX_new(TLS_server_method()));
    if (!context) throw std::bad_alloc();
    SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
    SSL_CTX_set_options(
        context.get(),
        SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION | SSL_OP_NO_TICKET | SSL_OP_CIPHER_SERVER_PREFERENCE
    );
    SSL_CTX_set_num_tickets(context.get(), 0);
    SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
    SSL_CTX_set_mode(
        context.get(),
        SSL_MODE_RELEASE_BUFFERS | SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER
    );
    SSL_CTX_set_cipher_list(context.get(), "ECDHE+AESGCM:ECDHE+CHACHA20");
    SSL_CTX_set_alpn_select_cb(context.get(), choose_protocol, nullptr);
    return context;
}

}  // namespace

std::string data_folder() {
    const char* data = std::getenv("XDG_DATA_HOME");
    if (data != nullptr && data[0] == '/') return (fs::path(data) / "feelem").string();
    const char* home = std::getenv("HOME");
    if (home != nullptr && home[0] == '/') return (fs::path(home) / ".local/share/feelem").string();
    return {};
}

Certificate own_certificate(const std::string& folder, const LanNames& names) {
    if (folder.empty()) {
        fail("certificate", "neither XDG_DATA_HOME nor HOME says where it can be kept; --cert and --key?");
    }
    std::error_code error;
    if (fs::create_directories(folder, error)) fs::permissions(folder, fs::perms::owner_all, error);
    const std::string path = (fs::path(folder) / "lan.pem").string();
    Kept kept = find_kept(path);
    Certificate made;
    made.is_own = true;
    if (!kept.paper || !serves(*kept.paper, names)) {
        kept.key.reset(EVP_EC_gen("P-256"));
        if (!kept.key) fail(path, "no key could be made");
        kept.paper = make_paper(*kept.key, names);
        keep(path, *kept.key, *kept.paper);
        made.is_new = true;
    }
    made.context = make_context();
    if (SSL_CTX_use_certificate(made.context.get(), kept.paper.get()) != 1 ||
        SSL_CTX_use_PrivateKey(made.context.get(), kept.key.get()) != 1) {
        fail(path, "the certificate cannot be used");
    }
    made.fingerprint = fingerprint_of(*kept.paper);
    made.names = names_of(*kept.paper);
    return made;
}

Certificate given_certificate(const std::string& certificate_file, const std::string& key_file) {
    Certificate given;
    given.context = make_context();
    if (SSL_CTX_use_certificate_chain_file(given.context.get(), certificate_file.c_str()) != 1) {
        throw Error(Code::FileUnreadable, certificate_file, "no certificate in PEM form can be read from it");
    }
    if (SSL_CTX_use_PrivateKey_file(given.context.get(), key_file.c_str(), SSL_FILETYPE_PEM) != 1 ||
        SSL_CTX_check_private_key(given.context.get()) != 1) {
        throw Error(Code::FileUnreadable, key_file, "no key in PEM form that belongs to the certificate");
    }
    const X509* paper = SSL_CTX_get0_certificate(given.context.get());
    given.fingerprint = fingerprint_of(*paper);
    given.names = names_of(*paper);
    return given;
}

}  // namespace feelem::server
