// SPDX-License-Identifier: Apache-2.0
#include "review_file.hpp"

#include "base/atomic_file.hpp"
#include "base/input.hpp"
#include "base/sha256.hpp"
#include "gzip.hpp"
#include "page_assets.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::server {
namespace {

namespace fs = std::filesystem;

std::string base64(std::string_view bytes) {
    std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
    const int size = EVP_EncodeBlock(
        reinterpret_cast<unsigned char*>(text.data()),
        reinterpret_cast<const unsigned char*>(bytes.data()),
        static_cast<int>(bytes.size())
    );
    text.resize(static_cast<std::size_t>(size));
    return text;
}

/// As a Content-Security-Policy names a script: "'sha256-…'".
std::string policy_hash(std::string_view text) {
    const std::string hex = sha256_hex(std::as_bytes(std::span(text)));
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    }
    return "'sha256-" + base64(bytes) + "'";
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// The page's files by the names they call each other: "index-1a2b.js".
struct PageFiles {
    std::string index;
    std::vector<std::pair<std::string, std::string>> others;
};

PageFiles page_files() {
    PageFiles files;
    for (const PageAsset& asset : page_assets()) {
        const std::string name = fs::path(asset.path).filename().string();
        if (name == "index.html") {
            files.index = unpack(asset.gzip);
        } else {
            files.others.emplace_back(name, unpack(asset.gzip));
        }
    }
    return files;
}

/// Takes the tag that begins and ends so and names one of our files out of the page; gives that file.
std::string take_out(
    std::string& index, std::string_view begin, std::string_view end, const PageFiles& files
) {
    for (std::size_t at = index.find(begin); at != std::string::npos; at = index.find(begin, at + 1)) {
        const std::size_t last = index.find(end, at);
        if (last == std::string::npos) break;
        const std::string tag = index.substr(at, last + end.size() - at);
        for (const auto& [name, content] : files.others) {
            if (tag.find("/" + name + "\"") == std::string::npos) continue;
            index.erase(at, tag.size());
            return content;
        }
    }
    return {};
}

std::string_view media_type(std::string_view name) {
    if (name.ends_with(".js")) return "text/javascript";
    return name.ends_with(".svg") ? "image/svg+xml" : "application/octet-stream";
}

/// What comes before the scene, and what after it.
struct Shell {
    std::string before, after;
};

/// Scripts and styles stand in the page; what they name (the worker) becomes an address that holds the file.
Shell shell_of(const std::string& output) {
    const PageFiles files = page_files();
    std::string index = files.index;
    std::string script = take_out(index, "<script type=\"module\"", "</script>", files);
    const std::string style = take_out(index, "<link rel=\"stylesheet\"", ">", files);
    if (script.empty() || style.empty()) {
        throw Error(
            Code::BadOption, output, "this program was built without its page: ./dev build makes both"
        );
    }
    for (const auto& [name, content] : files.others) {
        const std::string address = fmt::format("data:{};base64,{}", media_type(name), base64(content));
        replace_all(script, name, address);
        replace_all(index, "./assets/" + name, address);
    }
    replace_all(script, "</script", "<\\/script");
    const std::string policy = fmt::format(
        "default-src 'none'; script-src {} 'wasm-unsafe-eval'; style-src {}; img-src data: blob:; "
        "connect-src data: blob:; worker-src data: blob:; object-src 'none'; base-uri 'none'; form-action "
        "'none'",
        policy_hash(script),
        policy_hash(style)
    );
    constexpr std::string_view kPolicy = "content=\"default-src";
    const std::size_t at = index.find(kPolicy);
    const std::size_t head = index.find("</head>"), body = index.find("</body>");
    if (at == std::string::npos || head == std::string::npos || body == std::string::npos) {
        throw Error(Code::BadOption, output, "the page in this program has an unknown form");
    }
    Shell shell{index.substr(0, body), index.substr(body)};
    shell.before.insert(
        head, "<style>" + style + "</style>\n<script type=\"module\">" + script + "</script>\n"
    );
    const std::size_t from = at + kPolicy.size() - std::string_view("default-src").size();
    shell.before.replace(from, shell.before.find('"', from) - from, policy);
    return shell;
}

/// Side files have names as the converter makes them; a name of anything else would end the element.
bool is_plain_name(std::string_view name) {
    return std::ranges::none_of(name, [](char c) { return c == '"' || c == '<' || c == '&' || c == '>'; });
}

void carry(AtomicFile& file, const std::string& path, const std::string& name) {
    constexpr std::size_t kPiece = 3 << 20;
    const Input input = Input::from_file(path);
    file.write(fmt::format("<script type=\"application/gzip\" data-file=\"{}\">", name));
    GzipPacker packer;
    std::string packed;
    std::string_view rest = input.text();
    do {
        const std::string_view piece = rest.substr(0, kPiece);
        rest.remove_prefix(piece.size());
        packed += packer.add(piece, rest.empty());
        const std::size_t whole = rest.empty() ? packed.size() : packed.size() / 3 * 3;
        file.write(base64(std::string_view(packed).substr(0, whole)));
        packed.erase(0, whole);
        input.release(0, input.size() - rest.size());
    } while (!rest.empty());
    file.write("</script>\n");
}

}  // namespace

void write_review_file(const std::string& scene_path, const std::string& output) {
    const Shell shell = shell_of(output);
    AtomicFile file(output);
    file.write(shell.before);
    carry(file, scene_path, "scene.glb");
    const fs::path folder = fs::path(scene_path).replace_extension(".d");
    std::vector<fs::path> side;
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none)) {
        if (entry->is_regular_file() && is_plain_name(entry->path().filename().string())) {
            side.push_back(entry->path());
        }
    }
    std::ranges::sort(side);
    for (const fs::path& path : side) {
        carry(file, path.string(), folder.filename().string() + "/" + path.filename().string());
    }
    file.write(shell.after);
    file.commit();
}

}  // namespace feelem::server
