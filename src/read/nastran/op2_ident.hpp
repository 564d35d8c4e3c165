// SPDX-License-Identifier: Apache-2.0
// The ident record in front of every block of results: what the block holds.
#pragma once

#include "read/nastran/op2_records.hpp"

#include "feelem/result.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace feelem::op2 {

inline constexpr std::size_t kIdentWords = 146;

/// Words of the ident, one based as the manuals count them.
struct Ident {
    int approach = 0;         ///< 1: of eleven kinds of analysis.
    int table_code = 0;       ///< 2: what is listed (1 displacement, 5 stress ...), without the next two.
    bool sort2 = false;       ///< Rows are steps and the block is one node or element; else the other way.
    bool is_complex = false;  ///< Two numbers each.
    bool random = false;      ///< Densities and root mean squares of random responses.
    std::int64_t element_type = 0;  ///< 3
    std::int32_t subcase = 0;       ///< 4
    std::int64_t integer5 = 0;      ///< 5: mode, load step or, sorted the other way, node * 10 + device.
    double real5 = 0;               ///< The same word as a number: time or frequency.
    double real6 = 0, real7 = 0;    ///< 6, 7: eigenvalue; its imaginary part.
    int format = 0;                 ///< 9: 1 real, 2 real and imaginary, 3 magnitude and phase.
    std::size_t row_words = 0;      ///< 10
    int stress_bits = 0;            ///< 11
    int output_system = 0;          ///< 12, grid point stresses: 3 the basic one.
    int thermal = 0;                ///< 23: 1 heat transfer; more: response spectra.
};

/// Nothing when the words are no ident.
std::optional<Ident> read_ident(const Words& words);

/// A step as one block knows it; blocks with equal keys are of one step.
struct StepKey {
    std::int32_t subcase = 0;
    StepKind kind = StepKind::Static;
    std::int64_t number = 0;  ///< Mode; 0 where value says which.
    double value = 0;

    friend bool operator==(const StepKey&, const StepKey&) = default;
    friend auto operator<=>(const StepKey&, const StepKey&) = default;
};

StepKind kind_of(const Ident& ident);
/// Of a block that is sorted by step.
StepKey step_of(const Ident& ident);
/// Hz, load factor or time of a step, from a block that is sorted by step.
double value_of(const Ident& ident, const StepKey& key);
/// Of a row of a block that is sorted by node or element: its first word.
StepKey step_of_row(const Ident& ident, const Words& row);

/// The word where that step's row starts among the rows of one node or element: `expected`, as a rule.
std::optional<std::size_t> row_of_step(
    const Ident& ident, const Words& rows, std::size_t width, std::size_t expected, const StepKey& step
);

/// Title, subtitle and label as the deck gives them.
struct Texts {
    std::string title, subtitle, label;
};
Texts read_texts(const Words& ident);

}  // namespace feelem::op2
