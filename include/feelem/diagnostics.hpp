// SPDX-License-Identifier: Apache-2.0
// What the user should know although the work went on: stable word codes, places, counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// Every error and diagnostic the library can give. Each has a row in src/base/diagnostics.cpp, in the same
/// order, and a test that provokes it. Add new codes at the end of their group.
enum class Code : std::uint16_t {
    // Input that cannot be used (thrown as Error).
    FileNotFound,
    FileUnreadable,
    UnknownFormat,
    BadNumber,
    Truncated,
    BadStructure,
    NoNodes,
    NoElements,
    NotAMesh,
    TooLarge,
    WriteFailed,
    BadOption,
    UnknownName,
    BadScene,
    BadPresentation,
    MeshesDiffer,
    UnsupportedFormat,
    // Input that was used, but not all of it or not as it stands (Diagnostics).
    UnknownNode,
    DuplicateNode,
    DuplicateElement,
    InvertedElement,
    DegenerateElement,
    UnknownElementType,
    GuessedElementType,
    SkippedElement,
    MissingMidside,
    MidsideInterpolated,
    FacetWithManyOwners,
    UnmatchedFacets,
    ResultWithoutNode,
    ResultForPartOfModel,
    EmptyResult,
    NonFiniteValue,
    CoordinateSystem,
    NodalSystemRotated,
    LowPrecision,
    UnknownBlock,
    UnitsUnknown,
    StepsLeftOut,
    SeveralValuesAtNode,
    TruncatedInput,
    LargeRounding,
    IdsOffset,
    SourcesDisagree,
    ValuesDisagree,
    InputLeftOut,
    LevelOfDetail,
};

enum class Severity : std::uint8_t {
    Note,
    Warning,
    Error
};

struct CodeInfo {
    Code code;
    std::string_view word;     ///< "unknown_node": what scripts match on; never changes.
    Severity severity;         ///< What it is when it appears in Diagnostics.
    std::string_view meaning;  ///< One sentence for docs/diagnostics.md.
};

/// All codes, in the order of the enum.
std::span<const CodeInfo> code_table();
const CodeInfo& code_info(Code code);

struct Diagnostic {
    Code code;
    std::string where;  ///< Place of the first occurrence: "file:line", "file:byte 123" or "".
    std::string text;
    std::uint64_t count = 1;
};

/// A list that readers and stages append to. Equal (code, text) pairs are counted, not repeated.
/// Bounded: a hostile file with a million different texts keeps the first 200 of each code and counts the
/// rest.
class Diagnostics {
public:
    /// `where` is called only for the first occurrence: finding a line number costs a pass over the file.
    void add(Code code, const std::function<std::string()>& where, std::string text, std::uint64_t count = 1);
    void add(Code code, std::string where, std::string text, std::uint64_t count = 1);

    std::span<const Diagnostic> entries() const noexcept { return entries_; }
    bool has(Code code) const noexcept;
    std::uint64_t count(Code code) const noexcept;

private:
    std::vector<Diagnostic> entries_;
};

}  // namespace feelem
