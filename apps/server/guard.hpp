// SPDX-License-Identifier: Apache-2.0
// Who may ask: by our own names, from our own page, with the link's token.
#pragma once

#include "request_head.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace feelem::server {

/// 130 random bits as 26 letters and digits that nobody mistakes for another.
std::string make_token();

/// The same time for every wrong one.
bool is_same_secret(std::string_view given, std::string_view secret);

/// How a request came.
struct Way {
    bool is_tls = false;
    std::string own_address;  ///< At which it reached us.
};

class Guard {
public:
    /// `names`: hosts as they stand in an address, without port. `token`: empty when none is needed.
    Guard(std::vector<std::string> names, int port, std::string token);

    struct Verdict {
        int status = 0;            ///< 0: come in.
        std::string target;        ///< What is asked for, the token taken off.
        bool lacks_slash = false;  ///< "/TOKEN" alone: the page's relative addresses need "/TOKEN/".
    };
    Verdict judge(const RequestHead& head, const Way& way) const;

private:
    bool is_for_us(const RequestHead& head, const Way& way) const;
    static bool is_from_us(const RequestHead& head, const Way& way);

    std::vector<std::string> names_;
    int port_;
    std::string token_;
};

}  // namespace feelem::server
