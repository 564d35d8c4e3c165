// SPDX-License-Identifier: Apache-2.0
// Answers with bytes: types, versions, ranges, compression, and the headers that close the page to others.
#pragma once

#include "request_head.hpp"
#include "side_files.hpp"

#include <httplib.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace feelem::server {

/// A question and the answer being made. The library's own view of the question knows neither ranges nor
/// encodings, so that it leaves both to us.
struct Exchange {
    const RequestHead& head;
    httplib::Request& request;
    httplib::Response& response;
    bool is_private = false;  ///< Nobody on the way may keep it.
};

/// A file of the page, compressed once.
struct Asset {
    std::string path;  ///< "/index.html"
    std::span<const std::byte> gzip;
    std::string hash;
    std::shared_ptr<const std::string> owner;  ///< Of the bytes, when they are not the program's own.
};
Asset packed_asset(const std::string& path, const std::string& content);

void add_common_headers(httplib::Response& response);
void answer_text(httplib::Response& response, int status, const std::string& text);
void answer_asset(const Exchange& exchange, const Asset& asset);
void answer_file(const Exchange& exchange, const std::shared_ptr<const ServedFile>& file);

}  // namespace feelem::server
