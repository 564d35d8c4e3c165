// SPDX-License-Identifier: Apache-2.0
// The table of codes, and the bounded list.
#include "feelem/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace feelem {
namespace {

constexpr std::array kTable{
    CodeInfo{Code::FileNotFound, "file_not_found", Severity::Error, "A file or folder does not exist."},
    CodeInfo{Code::FileUnreadable, "file_unreadable", Severity::Error, "A file exists but cannot be read."},
    CodeInfo{
        Code::UnknownFormat, "unknown_format", Severity::Error, "No reader recognises the file's content."},
    CodeInfo{Code::BadNumber, "bad_number", Severity::Error, "Something else stands where a number must be."},
    CodeInfo{
        Code::Truncated, "truncated", Severity::Error, "The file ends in the middle of something needed."},
    CodeInfo{Code::BadStructure, "bad_structure", Severity::Error, "The file contradicts its own format."},
    CodeInfo{Code::NoNodes, "no_nodes", Severity::Error, "The inputs define no node."},
    CodeInfo{
        Code::NoElements, "no_elements", Severity::Error, "The inputs define no element that has a surface."},
    CodeInfo{Code::NotAMesh, "not_a_mesh", Severity::Error, "The list has elements but not their nodes."},
    CodeInfo{Code::TooLarge, "too_large", Severity::Error, "A number exceeds what the program can hold."},
    CodeInfo{
        Code::WriteFailed,
        "write_failed",
        Severity::Error,
        "The output could not be written; the old file is still there."},
    CodeInfo{Code::BadOption, "bad_option", Severity::Error, "An option's value cannot be understood."},
    CodeInfo{
        Code::UnknownName,
        "unknown_name",
        Severity::Error,
        "No result, step, format or option has that name."},
    CodeInfo{
        Code::BadScene,
        "bad_scene",
        Severity::Error,
        "The file is not a scene that Feelem wrote, or is damaged."},
    CodeInfo{
        Code::BadPresentation,
        "bad_presentation",
        Severity::Error,
        "The presentation does not follow its schema."},
    CodeInfo{
        Code::MeshesDiffer,
        "meshes_differ",
        Severity::Error,
        "Two inputs hold different meshes under the same ids."},
    CodeInfo{
        Code::UnsupportedFormat,
        "unsupported_format",
        Severity::Error,
        "The file is of a known kind that Feelem does not read, or not in this build; the message says what "
        "to do."},
    CodeInfo{
        Code::UnknownNode,
        "unknown_node",
        Severity::Warning,
        "An element uses a node that no input defines; it is left out."},
    CodeInfo{
        Code::DuplicateNode,
        "duplicate_node",
        Severity::Warning,
        "A node is defined twice; the later one counts."},
    CodeInfo{
        Code::DuplicateElement,
        "duplicate_element",
        Severity::Warning,
        "A solid has the same corners as an earlier one, or an id occurs twice; it is set aside."},
    CodeInfo{
        Code::InvertedElement,
        "inverted_element",
        Severity::Warning,
        "A solid has negative volume: its nodes are in mirrored order."},
    CodeInfo{
        Code::DegenerateElement,
        "degenerate_element",
        Severity::Note,
        "An element repeats nodes and was read as the simpler shape it is."},
    CodeInfo{
        Code::UnknownElementType,
        "unknown_element_type",
        Severity::Warning,
        "Elements of a type that Feelem does not know are left out."},
    CodeInfo{
        Code::GuessedElementType,
        "guessed_element_type",
        Severity::Warning,
        "No type table was given, or it does not fit: the shape was concluded from node count and geometry."},
    CodeInfo{
        Code::SkippedElement,
        "skipped_element",
        Severity::Note,
        "Elements without a surface of their own (contact, springs) are left out."},
    CodeInfo{
        Code::MissingMidside,
        "missing_midside",
        Severity::Note,
        "An element leaves out mid-side nodes; its edge is straight there."},
    CodeInfo{
        Code::MidsideInterpolated,
        "midside_interpolated",
        Severity::Note,
        "A result lists corner nodes only; mid-side nodes show the mean of their edge, marked with ~."},
    CodeInfo{
        Code::FacetWithManyOwners,
        "facet_with_many_owners",
        Severity::Warning,
        "A facet has three or more owners; it is taken as inner."},
    CodeInfo{
        Code::UnmatchedFacets,
        "unmatched_facets",
        Severity::Warning,
        "Facets with the same corners differ in mid-side nodes, or a quad faces two triangles; both are "
        "kept."},
    CodeInfo{
        Code::ResultWithoutNode,
        "result_without_node",
        Severity::Warning,
        "A result lists a node or element that the mesh does not have."},
    CodeInfo{
        Code::ResultForPartOfModel,
        "result_for_part_of_model",
        Severity::Note,
        "A result has values for a part of the nodes or elements only."},
    CodeInfo{
        Code::EmptyResult, "empty_result", Severity::Note, "A result block holds no value; it is left out."},
    CodeInfo{
        Code::NonFiniteValue,
        "non_finite_value",
        Severity::Warning,
        "NaN, infinity or *** in the file; treated as missing."},
    CodeInfo{
        Code::CoordinateSystem,
        "coordinate_system",
        Severity::Warning,
        "Values or coordinates are not in the global Cartesian system."},
    CodeInfo{
        Code::NodalSystemRotated,
        "nodal_system_rotated",
        Severity::Note,
        "Values in rotated nodal systems were turned into the global one."},
    CodeInfo{
        Code::LowPrecision,
        "low_precision",
        Severity::Note,
        "Coordinates have so few digits that edges may not meet exactly."},
    CodeInfo{
        Code::UnknownBlock,
        "unknown_block",
        Severity::Note,
        "A block of the file is of a kind that Feelem does not use."},
    CodeInfo{
        Code::UnitsUnknown,
        "units_unknown",
        Severity::Note,
        "The inputs do not say in which unit lengths are."},
    CodeInfo{
        Code::StepsLeftOut,
        "steps_left_out",
        Severity::Note,
        "More steps than are shown by default; --steps all takes them all."},
    CodeInfo{
        Code::SeveralValuesAtNode,
        "several_values_at_node",
        Severity::Note,
        "A node has several values (one a body, material or layer); they are kept apart."},
    CodeInfo{
        Code::TruncatedInput,
        "truncated_input",
        Severity::Warning,
        "The file ends early; what came before it is used."},
    CodeInfo{
        Code::LargeRounding,
        "large_rounding",
        Severity::Note,
        "Coordinates are far from the origin; they were shifted before rounding to float."},
    CodeInfo{
        Code::IdsOffset,
        "ids_offset",
        Severity::Note,
        "Instances repeat ids; an offset, which is stated, was added to those of the later ones."},
    CodeInfo{
        Code::SourcesDisagree,
        "sources_disagree",
        Severity::Warning,
        "Two inputs of one model differ in some nodes, places or elements; one mesh is shown."},
    CodeInfo{
        Code::ValuesDisagree,
        "values_disagree",
        Severity::Warning,
        "A table's own extremes are not those of its values."},
    CodeInfo{
        Code::InputLeftOut,
        "input_left_out",
        Severity::Warning,
        "A file that was found in a folder cannot be read."},
    CodeInfo{
        Code::LevelOfDetail,
        "level_of_detail",
        Severity::Note,
        "A reduced level was not made, or has more triangles than was asked for; the message says why."},
};

constexpr std::size_t kMostTextsOfACode = 200;

constexpr bool table_is_in_order() {
    for (std::size_t i = 0; i < kTable.size(); ++i) {
        if (static_cast<std::size_t>(kTable[i].code) != i) return false;
    }
    return true;
}
static_assert(table_is_in_order(), "a row for each Code, in the order of the enum");

}  // namespace

std::span<const CodeInfo> code_table() {
    return kTable;
}

const CodeInfo& code_info(Code code) {
    assert(static_cast<std::size_t>(code) < kTable.size());
    return kTable[static_cast<std::size_t>(code)];
}

void Diagnostics::add(
    Code code, const std::function<std::string()>& where, std::string text, std::uint64_t count
) {
    std::size_t texts = 0;
    Diagnostic* last = nullptr;
    for (Diagnostic& entry : entries_) {
        if (entry.code != code) continue;
        if (entry.text == text) {
            entry.count += count;
            return;
        }
        ++texts;
        last = &entry;
    }
    if (texts >= kMostTextsOfACode) {
        last->count += count;
        return;
    }
    entries_.push_back({code, where(), std::move(text), count});
}

void Diagnostics::add(Code code, std::string where, std::string text, std::uint64_t count) {
    add(
        code, [&] { return std::move(where); }, std::move(text), count
    );
}

bool Diagnostics::has(Code code) const noexcept {
    return count(code) > 0;
}

std::uint64_t Diagnostics::count(Code code) const noexcept {
    std::uint64_t sum = 0;
    for (const Diagnostic& entry : entries_) {
        if (entry.code == code) sum += entry.count;
    }
    return sum;
}

}  // namespace feelem
