// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/nastran_f06.hpp"

#include "read/nastran/f06_elements.hpp"
#include "read/nastran/f06_pages.hpp"
#include "read/nastran/f06_rows.hpp"
#include "read/nastran/printed_tables.hpp"
#include "read/text_lines.hpp"

#include <memory>

namespace feelem {
namespace {

Likelihood recognise_f06(const Input& input) {
    TextLines lines(input, 0, head_of(input).size());
    while (const auto line = lines.next()) {
        if (nastran::is_page_head(*line)) return Likelihood::Sure;
    }
    return Likelihood::No;
}

std::unique_ptr<ModelSource> open_f06(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    const Input& input = inputs.front();
    return nastran::open_printed(
        input,
        nastran::find_pages(input, diagnostics),
        nastran::read_f06_row,
        nastran::read_f06_elements,
        context,
        diagnostics
    );
}

}  // namespace

ReadFormat nastran_f06_format() {
    return {{"nastran-f06", "Nastran results, printed", ".f06", false, true}, false, recognise_f06, open_f06};
}

}  // namespace feelem
