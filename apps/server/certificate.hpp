// SPDX-License-Identifier: Apache-2.0
// The certificate for the local network: our own, kept between runs, or one that the user gives.
#pragma once

#include "lan.hpp"

#include <openssl/ssl.h>

#include <memory>
#include <string>
#include <vector>

namespace feelem::server {

struct FreeContext {
    void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
};
using TlsContext = std::unique_ptr<SSL_CTX, FreeContext>;

struct Certificate {
    TlsContext context;
    std::string fingerprint;         ///< SHA-256, "AB:CD:…", as browsers show it.
    std::vector<std::string> names;  ///< DNS names that it is for.
    bool is_own = false;             ///< Nobody else has signed it.
    bool is_new = false;             ///< Made in this run.
};

/// "$XDG_DATA_HOME/feelem", else "~/.local/share/feelem"; empty when there is no home.
std::string data_folder();

/// The one in `folder` (lan.pem, readable by its owner only), or a new one when there is none, when it ends
/// within a month, or when it lacks one of `names`. Throws Error(WriteFailed).
Certificate own_certificate(const std::string& folder, const LanNames& names);
/// Throws Error(FileUnreadable) when they cannot be read or do not belong together.
Certificate given_certificate(const std::string& certificate_file, const std::string& key_file);

}  // namespace feelem::server
