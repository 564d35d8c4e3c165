// SPDX-License-Identifier: Apache-2.0
#include "guard.hpp"

#include "base/letter_case.hpp"
#include "lan.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <utility>

namespace feelem::server {
namespace {

constexpr std::size_t kTokenSize = 26;
constexpr std::string_view kLetters = "0123456789abcdefghjkmnpqrstvwxyz";

/// "*.example.org" stands for one label in its place.
bool fits(std::string_view pattern, std::string_view name) {
    if (!pattern.starts_with("*.")) return pattern == name;
    const std::size_t dot = name.find('.');
    return dot != std::string_view::npos && dot > 0 && name.substr(dot) == pattern.substr(1);
}

}  // namespace

std::string make_token() {
    std::array<unsigned char, kTokenSize> bytes{};
    if (RAND_bytes(bytes.data(), bytes.size()) != 1) {
        throw Error(Code::WriteFailed, "token", "the system gives no random numbers");
    }
    std::string token;
    for (const unsigned char byte : bytes) token += kLetters[byte % kLetters.size()];
    return token;
}

bool is_same_secret(std::string_view given, std::string_view secret) {
    std::string padded(secret.size(), '\0');
    std::copy_n(given.begin(), std::min(given.size(), secret.size()), padded.begin());
    const bool is_equal = CRYPTO_memcmp(padded.data(), secret.data(), secret.size()) == 0;
    return is_equal && given.size() == secret.size();
}

Guard::Guard(std::vector<std::string> names, int port, std::string token)
    : names_(std::move(names)), port_(port), token_(std::move(token)) {
    for (std::string& name : names_) name = lower_case(name);
}

/// Another name is a foreign page that made its name point here (DNS rebinding).
bool Guard::is_for_us(const RequestHead& head, const Way& way) const {
    if (head.count("host") != 1) return false;
    const std::string host = lower_case(head.header("host"));
    const std::string port = fmt::format(":{}", port_);
    std::string_view name = host;
    if (name.ends_with(port)) {
        name.remove_suffix(port.size());
    } else if (port_ != (way.is_tls ? 443 : 80)) {
        return false;
    }
    // An address cannot be made to point elsewhere, and ours may have changed since we started.
    if (name == in_url(way.own_address)) return true;
    return std::ranges::any_of(names_, [&](const std::string& ours) { return fits(ours, name); });
}

/// A page of another origin may send requests though it cannot read the answers: it gets none.
bool Guard::is_from_us(const RequestHead& head, const Way& way) {
    if (head.count("origin") > 1) return false;
    const std::string ours = fmt::format("{}://{}", way.is_tls ? "https" : "http", head.header("host"));
    if (head.count("origin") == 1 && lower_case(head.header("origin")) != lower_case(ours)) return false;
    const std::string_view site = head.header("sec-fetch-site");
    const bool is_foreign = site == "cross-site" || site == "same-site";
    // A link in a message is followed; a picture or a script of ours in a foreign page is not given.
    return !is_foreign ||
           (head.header("sec-fetch-mode") == "navigate" && head.header("sec-fetch-dest") == "document");
}

Guard::Verdict Guard::judge(const RequestHead& head, const Way& way) const {
    if (!is_for_us(head, way)) return {421, "", false};
    if (head.method != "GET" && head.method != "HEAD") return {405, "", false};
    if (!is_from_us(head, way)) return {403, "", false};
    if (token_.empty()) return {0, head.target, false};
    const std::string_view target = std::string_view(head.target).substr(1);
    const std::size_t end = target.find_first_of("/?");
    if (!is_same_secret(target.substr(0, end), token_)) return {403, "", false};
    if (end == std::string_view::npos || target[end] == '?') return {0, "", true};
    return {0, std::string(target.substr(end)), false};
}

}  // namespace feelem::server
