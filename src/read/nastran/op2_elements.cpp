// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_elements.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <vector>

namespace feelem::op2 {
namespace {

constexpr int kStressCode = 5;

void check_length(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    std::size_t record,
    std::size_t width
) {
    const std::size_t words = layout.record_bytes(record) / layout.form.size;
    if (words % width == 0) return;
    const auto segments = layout.record(record);
    throw Error(
        Code::BadStructure,
        input.where_byte(segments.empty() ? 0 : segments.front().first),
        fmt::format("{} has {} words of data where each element needs {}", result.table, words, width)
    );
}

}  // namespace

const ElementLayout* element_layout(const Ident& ident) {
    if (ident.table_code != kStressCode || ident.random || !stress_kind(ident)) return nullptr;
    const ElementLayout* layout = find_layout(ident.element_type, ident.row_words, ident.is_complex);
    const bool is_ply = layout != nullptr && layout->shape == RowShape::Ply;
    // A step has several rows of an element's plies: not looked for where rows are steps.
    if (is_ply && ident.sort2) return nullptr;
    constexpr int kPlyVonMises = 5;
    return ident.stress_bits == kPlyVonMises && !is_ply ? nullptr : layout;
}

std::optional<StressKind> stress_kind(const Ident& ident) {
    switch (ident.stress_bits) {
    case 0: return StressKind{};
    case 1:
    case 5: return StressKind{false, true, false};
    case 10: return StressKind{true, false, true};
    case 11: return StressKind{true, true, true};
    case 14: return StressKind{true, false, false};
    case 15: return StressKind{true, true, false};
    default: return {};
    }
}

StressKind block_kind(const Ident& ident, const std::string& table, const std::string& version) {
    StressKind kind = stress_kind(ident).value_or(StressKind{});
    if (ident.stress_bits == 0 && version.starts_with("OS")) {
        kind.strain = table.starts_with("OSTR");
        kind.von_mises = true;
    }
    return kind;
}

ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
) {
    ElementRowReader reader(result, mesh, lookup);
    std::vector<std::byte> scratch;
    for (const ElementBlockRef& block : result.blocks) {
        const std::size_t width = block.layout->row_words;
        if (block.by_element == nullptr) {
            check_length(input, layout, result, block.record, width);
            for_each_row(input, layout, block.record, width, [&](const Words& row) {
                reader.read(row.integer(0) / 10, row, *block.layout);
            });
            continue;
        }
        for (const SortedRecord& one : block.by_element->records) {
            check_length(input, layout, result, one.record, width);
            const Words rows = record_words(input, layout, one.record, scratch);
            if (const auto at =
                    row_of_step(block.by_element->ident, rows, width, block.row * width, result.step))
                reader.read(one.id, rows.part(*at, width), *block.layout);
        }
    }
    return reader.finish();
}

}  // namespace feelem::op2
