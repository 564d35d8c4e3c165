// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_elements.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

namespace feelem::op2 {
namespace {

constexpr int kStressCode = 5;

}  // namespace

const ElementLayout* element_layout(const Ident& ident) {
    const bool plain = ident.table_code == kStressCode && !ident.sort2 && !ident.random;
    if (!plain || !stress_kind(ident)) return nullptr;
    return find_layout(ident.element_type, ident.row_words, ident.is_complex);
}

std::optional<StressKind> stress_kind(const Ident& ident) {
    switch (ident.stress_bits) {
    case 0: return StressKind{};
    case 1: return StressKind{false, true, false};
    case 10: return StressKind{true, false, true};
    case 11: return StressKind{true, true, true};
    case 14: return StressKind{true, false, false};
    case 15: return StressKind{true, true, false};
    default: return {};
    }
}

ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
) {
    ElementRowReader reader(result, mesh, lookup);
    for (const ElementBlockRef& block : result.blocks) {
        const std::size_t words = layout.record_bytes(block.record) / layout.form.size;
        const std::size_t width = block.layout->row_words;
        if (words % width != 0) {
            const auto segments = layout.record(block.record);
            throw Error(
                Code::BadStructure,
                input.where_byte(segments.empty() ? 0 : segments.front().first),
                fmt::format("{} has {} words of data where each element needs {}", result.table, words, width)
            );
        }
        for_each_row(input, layout, block.record, width, [&](const Words& row) {
            reader.read(row.integer(0) / 10, row, *block.layout);
        });
    }
    return reader.finish();
}

}  // namespace feelem::op2
