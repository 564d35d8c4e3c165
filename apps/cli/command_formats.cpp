// SPDX-License-Identifier: Apache-2.0
// `feelem formats`: readers and writers, from the tables that the program itself uses.
#include "command.hpp"

#include "feelem/read.hpp"
#include "feelem/write.hpp"

#include <fmt/format.h>

namespace feelem::cli {
namespace {

/// The scene is written by its own stage, so it stands in no table of plain formats.
std::vector<WriteFormatInfo> all_write_formats() {
    std::vector<WriteFormatInfo> formats{
        {"glb", "Feelem scene (glTF 2.0, one file)", ".glb"},
        {"gltf", "Feelem scene (glTF 2.0, buffers beside it)", ".gltf"}};
    for (const WriteFormatInfo& format : write_formats()) formats.push_back(format);
    formats.push_back({"html", "Page and scene in one file, for a browser without network", ".html"});
    return formats;
}

std::string_view holds(const ReadFormatInfo& format) {
    if (format.has_mesh && format.has_results) return "mesh, results";
    return format.has_mesh ? "mesh" : "results";
}

void print_json() {
    // Ids, titles and suffixes are our own words: nothing in them needs escaping.
    std::string text = "{\n \"version\": 1,\n \"read\": [";
    const char* comma = "";
    for (const ReadFormatInfo& format : read_formats()) {
        text += fmt::format(
            "{}\n  {{\"id\": \"{}\", \"title\": \"{}\", \"suffixes\": \"{}\", \"mesh\": {}, \"results\": "
            "{}}}",
            comma,
            format.id,
            format.title,
            format.suffixes,
            format.has_mesh,
            format.has_results
        );
        comma = ",";
    }
    text += "\n ],\n \"write\": [";
    comma = "";
    for (const WriteFormatInfo& format : all_write_formats()) {
        text += fmt::format(
            "{}\n  {{\"id\": \"{}\", \"title\": \"{}\", \"suffix\": \"{}\"}}",
            comma,
            format.id,
            format.title,
            format.suffix
        );
        comma = ",";
    }
    fmt::print("{}\n ]\n}}\n", text);
}

}  // namespace

int run_formats(const Options& options) {
    if (options.json) {
        print_json();
        return 0;
    }
    fmt::print("Reads (recognised by content)\n");
    for (const ReadFormatInfo& format : read_formats()) {
        fmt::print("  {:<15} {:<18} {:<14} {}\n", format.id, format.suffixes, holds(format), format.title);
    }
    fmt::print("Writes (chosen by the suffix of -o)\n");
    for (const WriteFormatInfo& format : all_write_formats()) {
        fmt::print("  {:<15} {:<18} {}\n", format.id, format.suffix, format.title);
    }
    return 0;
}

}  // namespace feelem::cli
