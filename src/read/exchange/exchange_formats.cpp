// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/exchange_formats.hpp"

#include "base/byte_reader.hpp"
#include "base/number.hpp"
#include "read/exchange/ensight_case.hpp"
#include "read/exchange/exchange_source.hpp"
#include "read/exchange/family_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace feelem {
namespace exchange {
namespace {

Likelihood sure_if(bool condition) {
    return condition ? Likelihood::Sure : Likelihood::No;
}

bool is_vtk_xml(std::string_view head) {
    return trim(head.substr(0, 200)).starts_with("<") &&
           head.substr(0, 2000).find("<VTKFile") != std::string_view::npos;
}

bool is_collection(std::string_view head) {
    const std::size_t at = head.find("<VTKFile");
    if (at == std::string_view::npos) return false;
    const std::string_view tag = head.substr(at, std::min(head.find('>', at), head.size()) - at);
    return tag.find("\"Collection\"") != std::string_view::npos;
}

bool is_hdf5(std::string_view head) {
    return head.starts_with("\x89HDF\r\n\x1a\n");
}

bool has(std::string_view head, std::string_view word) {
    return head.find(word) != std::string_view::npos;
}

Likelihood recognise_legacy(const Input& input) {
    return sure_if(head_of(input).starts_with("# vtk DataFile Version"));
}
Likelihood recognise_xml(const Input& input) {
    return sure_if(is_vtk_xml(head_of(input)) && !is_collection(head_of(input)));
}
Likelihood recognise_pvd(const Input& input) {
    return sure_if(is_vtk_xml(head_of(input)) && is_collection(head_of(input)));
}
Likelihood recognise_exodus(const Input& input) {
    const std::string_view head = head_of(input);
    const bool classic =
        head.starts_with("CDF\x01") || head.starts_with("CDF\x02") || head.starts_with("CDF\x05");
    return sure_if((classic || is_hdf5(head)) && has(head, "num_dim") && has(head, "num_nod"));
}
Likelihood recognise_med(const Input& input) {
    const std::string_view head = head_of(input);
    return sure_if(is_hdf5(head) && (has(head, "INFOS_GENERALES") || has(head, "ENS_MAA")));
}
Likelihood recognise_cgns(const Input& input) {
    const std::string_view head = head_of(input);
    return sure_if(
        (is_hdf5(head) || has(head.substr(0, 64), "ADF Database")) && has(head, "CGNSLibraryVersion")
    );
}
Likelihood recognise_ensight(const Input& input) {
    const std::string_view head = head_of(input).substr(0, 2000);
    return sure_if(has(head, "FORMAT") && has(head, "ensight") && has(head, "GEOMETRY"));
}

/// Ten characters of title, then control words: dimensions, nodes, and a code that is always 2 or 6.
template <class Word>
bool is_d3plot_of(const Input& input, bool swap) {
    if (input.size() < 64 * sizeof(Word)) return false;
    const auto word = [&](std::size_t i) { return ByteReader(input, i * sizeof(Word), swap).read<Word>(); };
    const auto dimensions = word(15), nodes = word(16), code = word(17);
    return dimensions >= 2 && dimensions <= 8 && (code == 2 || code == 6) && nodes > 0 &&
           static_cast<std::uint64_t>(nodes) < (std::uint64_t{1} << 31);
}
Likelihood recognise_d3plot(const Input& input) {
    const std::string_view title = head_of(input).substr(0, 40);
    const bool text = std::ranges::all_of(title, [](char c) { return c == 0 || (c >= 32 && c < 127); });
    if (!text || title.size() < 40) return Likelihood::No;
    for (const bool swap : {false, true}) {
        if (is_d3plot_of<std::int32_t>(input, swap) || is_d3plot_of<std::int64_t>(input, swap))
            return Likelihood::Maybe;
    }
    return Likelihood::No;
}

using Names = std::vector<std::string>;

Names no_others(const Input&, IncludeFiles*) {
    return {};
}
Names xml_others(const Input& input, IncludeFiles*) {
    Names names = attribute_values(input.text().substr(0, 1u << 20), "Piece", "Source");
    for (std::string& name : attribute_values(input.text().substr(0, 1u << 20), "DataSet", "file"))
        names.push_back(std::move(name));
    return names;
}
Names pvd_others(const Input& input, IncludeFiles*) {
    Names names;
    for (PvdEntry& entry : read_pvd(input.text(), input.name())) names.push_back(std::move(entry.file));
    return names;
}
Names ensight_others(const Input& input, IncludeFiles*) {
    return files_of(read_ensight_case(input.text()));
}
/// d3plot01, d3plot02 ... as far as they go.
Names d3plot_others(const Input& input, IncludeFiles* includes) {
    constexpr int kMostFiles = 10000;
    Names names;
    const std::size_t slash = input.name().find_last_of('/');
    const std::string base = slash == std::string::npos ? input.name() : input.name().substr(slash + 1);
    for (int i = 1; includes != nullptr && i < kMostFiles; ++i) {
        std::string name = fmt::format("{}{:02}", base, i);
        if (!includes->find(name, input)) break;
        names.push_back(std::move(name));
    }
    return names;
}

struct Kind {
    ReadFormatInfo info;
    Likelihood (*recognise)(const Input& input);
    const char* helpers_word;
    Names (*others)(const Input& input, IncludeFiles* includes);
};

constexpr Kind kLegacy{
    {"vtk", "VTK legacy files, text and binary", ".vtk", true, true}, recognise_legacy, "vtk", no_others};
constexpr Kind kXml{
    {"vtu", "VTK XML files and their pieces", ".vtu .pvtu .vtp", true, true},
    recognise_xml,
    "vtu",
    xml_others};
constexpr Kind kPvd{
    {"pvd", "ParaView collections in time", ".pvd", true, true}, recognise_pvd, "pvd", pvd_others};
constexpr Kind kExodus{
    {"exodus", "Exodus II", ".exo .e .g .ex2", true, true}, recognise_exodus, "exodus", no_others};
constexpr Kind kEnsight{
    {"ensight", "EnSight Gold and 6", ".case .encas", true, true},
    recognise_ensight,
    "ensight",
    ensight_others};
constexpr Kind kCgns{{"cgns", "CGNS", ".cgns", true, true}, recognise_cgns, "cgns", no_others};
constexpr Kind kD3plot{
    {"lsdyna-d3plot", "LS-DYNA results", "d3plot", true, true}, recognise_d3plot, "d3plot", d3plot_others};
constexpr Kind kMed{
    {"med", "MED of Salome and code_aster", ".med .rmed", true, true}, recognise_med, "med", no_others};

template <const Kind& kind>
ReadFormat format_of() {
    const auto open = [](std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
                      ) {
        const Input& input = inputs.front();
        return open_exchange(
            kind.helpers_word, input, kind.others(input, context.includes), context, diagnostics
        );
    };
    return {kind.info, false, kind.recognise, open};
}

}  // namespace
}  // namespace exchange

ReadFormat vtk_legacy_format() {
    return exchange::format_of<exchange::kLegacy>();
}
ReadFormat vtk_xml_format() {
    return exchange::format_of<exchange::kXml>();
}
ReadFormat pvd_format() {
    return exchange::format_of<exchange::kPvd>();
}
ReadFormat exodus_format() {
    return exchange::format_of<exchange::kExodus>();
}
ReadFormat ensight_format() {
    return exchange::format_of<exchange::kEnsight>();
}
ReadFormat cgns_format() {
    return exchange::format_of<exchange::kCgns>();
}
ReadFormat lsdyna_d3plot_format() {
    return exchange::format_of<exchange::kD3plot>();
}
ReadFormat med_format() {
    return exchange::format_of<exchange::kMed>();
}

}  // namespace feelem
