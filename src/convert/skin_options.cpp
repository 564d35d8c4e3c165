// SPDX-License-Identifier: Apache-2.0
#include "convert/skin_options.hpp"

#include "base/input.hpp"
#include "base/number.hpp"
#include "base/sha256.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace feelem {
namespace {

/// The leading id of a row of numbers; nothing for heads, blank lines and page titles.
std::optional<NodeId> id_of_row(std::string_view line) {
    line = trim(line);
    const std::size_t end = line.find_first_of(" \t,");
    const auto id = parse_integer(line.substr(0, end));
    if (!id || *id <= 0) return std::nullopt;
    const bool is_numeric = line.find_first_not_of("0123456789+-.,eEdD \t") == std::string_view::npos;
    return is_numeric ? std::optional(NodeId{*id}) : std::nullopt;
}

}  // namespace

std::vector<NodeId> read_surface_nodes(std::string_view text, std::string_view name) {
    std::vector<NodeId> ids;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        if (const auto id = id_of_row(text.substr(0, end))) ids.push_back(*id);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (ids.empty()) {
        throw Error(
            Code::NoNodes,
            std::string(name),
            "no row begins with a node number. Expected an Ansys node list (NLIST) of the surface nodes."
        );
    }
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

std::optional<InputRecord> surface_nodes_record(const Job& job) {
    if (job.skin.method != SkinMethod::NodeList || job.surface_nodes_file.empty()) return std::nullopt;
    const Input input = Input::from_file(job.surface_nodes_file);
    std::string digest = job.read.hash_inputs ? sha256_hex(input) : std::string();
    return InputRecord{input.name(), std::string(kSurfaceNodesFormat), input.size(), std::move(digest)};
}

SkinOptions skin_options(const Job& job) {
    SkinOptions options = job.skin;
    if (options.method == SkinMethod::NodeList && !job.surface_nodes_file.empty()) {
        const Input input = Input::from_file(job.surface_nodes_file);
        options.surface_nodes = read_surface_nodes(input.text(), input.name());
    }
    if (options.method == SkinMethod::NodeList && options.surface_nodes.empty()) {
        throw Error(
            Code::BadOption,
            "--skin node-list",
            "the node map needs the list of surface nodes: --surface-nodes FILE"
        );
    }
    return options;
}

}  // namespace feelem
