// SPDX-License-Identifier: Apache-2.0
#include "connect_page.hpp"

#include "qr_code.hpp"

#include <fmt/format.h>

namespace feelem::server {
namespace {

constexpr const char* kWarning =
    "<li>The browser warns once, because this computer made its certificate itself. Compare the fingerprint\n"
    "below if you want to be sure, then go on (Advanced, Proceed).</li>\n";

/// Names and addresses are ours, yet a host name is somebody's word.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '"') {
            out += "&quot;";
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace

std::string connect_page(const ConnectFacts& facts) {
    std::string others;
    for (std::size_t i = 1; i < facts.links.size(); ++i) {
        others += fmt::format("<li><code>{}</code></li>", escaped(facts.links[i]));
    }
    if (!others.empty()) others = "<h2>The same by other names</h2><ul>" + others + "</ul>";
    const std::string link = facts.links.empty() ? facts.usb_link : facts.links.front();
    return fmt::format(
        R"(<!doctype html>
<html lang="en">
<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark"><title>Feelem on a headset or phone</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="connect.css">
<main>
<h1>Open this model on a headset or phone</h1>
<div class="way">{code}
<ol>
<li>Join the same network as this computer.</li>
<li>Scan the code, or type the link:<br><code class="link">{link}</code></li>
{warning}<li>Press Enter VR.</li>
</ol></div>
<p>Who has the link sees the model; nobody else does. It ends with the program.</p>
<h2>Fingerprint of the certificate (SHA-256)</h2>
<p><code>{fingerprint}</code></p>
{others}
<h2>By USB cable, without any warning</h2>
<p>With a headset in developer mode: <code>adb reverse tcp:{port} tcp:{port}</code>, then open
<code>{usb}</code> in its browser.</p>
<p><a href="./">Back to the model</a></p>
</main>
</html>
)",
        fmt::arg("code", qr_for_page(link)),
        fmt::arg("link", escaped(link)),
        fmt::arg("warning", facts.is_own_certificate ? kWarning : ""),
        fmt::arg("fingerprint", escaped(facts.fingerprint)),
        fmt::arg("others", others),
        fmt::arg("port", facts.port),
        fmt::arg("usb", escaped(facts.usb_link))
    );
}

std::string connect_style() {
    return R"(:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
body { margin: 0; background: Canvas; color: CanvasText; }
main { max-width: 46rem; margin: 0 auto; padding: 1.5rem 1rem 3rem; }
h1 { font-size: 1.5rem; line-height: 1.25; }
h2 { font-size: 1.05rem; margin-top: 2rem; }
.way { display: flex; flex-wrap: wrap; gap: 1.5rem; align-items: center; }
.way ol { flex: 1 1 18rem; margin: 0; padding-left: 1.25rem; }
.way li + li { margin-top: 0.5rem; }
.code { width: min(17rem, 100%); border-radius: 6px; }
code { overflow-wrap: anywhere; font-size: 0.95em; }
.link { font-weight: 600; }
)";
}

std::string with_connect_hint(std::string index) {
    const std::size_t at = index.find("</title>");
    constexpr std::string_view kEnd = "</title>";
    if (at != std::string::npos) {
        index.insert(at + kEnd.size(), "\n    <meta name=\"feelem-connect\" content=\"connect.html\" />");
    }
    return index;
}

}  // namespace feelem::server
