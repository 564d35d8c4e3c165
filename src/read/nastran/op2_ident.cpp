// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_ident.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace feelem::op2 {
namespace {

enum Approach {
    kStatics = 1,
    kModes = 2,
    kFrequency = 5,
    kTransient = 6,
    kPreBuckling = 7,
    kBuckling = 8,
    kComplexModes = 9,
    kNonlinear = 10,
    kOldNonlinear = 11,
    kContinued = 12,
};

double cycles(double radians_a_second) {
    return std::abs(radians_a_second) / (2 * std::numbers::pi);
}

/// Times and frequencies key a step by value, modes by number.
StepKey keyed(const Ident& ident, std::int64_t number, double value) {
    StepKey key{ident.subcase, kind_of(ident), 0, 0};
    switch (ident.approach) {
    case kModes:
    case kBuckling:
    case kComplexModes: key.number = number; break;
    case kFrequency:
    case kTransient:
    case kNonlinear: key.value = std::isfinite(value) ? value : 0; break;
    default: break;
    }
    return key;
}

}  // namespace

std::optional<Ident> read_ident(const Words& words) {
    if (words.count() != kIdentWords) return {};
    constexpr std::int64_t kMostApproach = 12;
    constexpr std::int64_t kMostCode = 9999;
    constexpr std::int64_t kMostRow = 100000;
    const std::int64_t approach = words.integer(0) / 10;
    const std::int64_t code = words.integer(1);
    const std::int64_t subcase = words.integer(3);
    const std::int64_t row = words.integer(9);
    if (approach < 1 || approach > kMostApproach || code < 1 || code > kMostCode) return {};
    if (row < 0 || row > kMostRow || subcase < 0 || subcase > std::numeric_limits<std::int32_t>::max())
        return {};
    Ident ident;
    ident.approach = static_cast<int>(approach);
    ident.table_code = static_cast<int>(code % 1000);
    ident.is_complex = (code / 1000 & 1) != 0;
    ident.sort2 = (code / 1000 & 2) != 0;
    ident.random = (code / 1000 & 4) != 0;
    ident.element_type = words.integer(2);
    ident.subcase = static_cast<std::int32_t>(subcase);
    ident.integer5 = words.integer(4);
    ident.real5 = words.real(4);
    ident.real6 = words.real(5);
    ident.real7 = words.real(6);
    ident.format = static_cast<int>(words.integer(8));
    ident.row_words = static_cast<std::size_t>(row);
    ident.stress_bits = static_cast<int>(words.integer(10));
    ident.output_system = static_cast<int>(words.integer(11));
    ident.thermal = static_cast<int>(words.integer(22));
    return ident;
}

StepKind kind_of(const Ident& ident) {
    switch (ident.approach) {
    case kModes:
    case kComplexModes: return StepKind::Mode;
    case kFrequency: return StepKind::Frequency;
    case kTransient: return StepKind::Time;
    case kBuckling: return StepKind::Buckling;
    case kStatics:
    case kPreBuckling:
    case kNonlinear:
    case kOldNonlinear:
    case kContinued: return StepKind::Static;
    default: return StepKind::Other;
    }
}

StepKey step_of(const Ident& ident) {
    return keyed(ident, ident.integer5, ident.real5);
}

StepKey step_of_row(const Ident& ident, const Words& row) {
    return keyed(ident, row.integer(0), row.real(0));
}

std::optional<std::size_t> row_of_step(
    const Ident& ident, const Words& rows, std::size_t width, std::size_t expected, const StepKey& step
) {
    const auto fits = [&](std::size_t at) {
        return at + width <= rows.count() && step_of_row(ident, rows.part(at, width)) == step;
    };
    if (fits(expected)) return expected;
    for (std::size_t at = 0; at < rows.count(); at += width) {
        if (fits(at)) return at;
    }
    return {};
}

double value_of(const Ident& ident, const StepKey& key) {
    switch (ident.approach) {
    case kModes: return cycles(std::sqrt(std::abs(ident.real6)));
    case kComplexModes: return cycles(ident.real7);
    case kBuckling: return ident.real6;
    default: return key.value;
    }
}

Texts read_texts(const Words& ident) {
    constexpr std::size_t kTextWords = 32;
    return {ident.text(50, kTextWords), ident.text(82, kTextWords), ident.text(114, kTextWords)};
}

}  // namespace feelem::op2
