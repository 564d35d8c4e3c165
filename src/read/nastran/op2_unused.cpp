// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_unused.hpp"

#include "read/nastran/element_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace feelem::op2 {
namespace {

constexpr int kForceCode = 4;
constexpr int kElementStressCode = 5;
constexpr int kFailureCode = 25;

/// What tables list beside displacements and their kin.
constexpr std::pair<int, std::string_view> kTableKinds[]{
    {4, "forces of elements"},
    {18, "strain energies of elements"},
    {19, "balances of forces at grid points"},
    {20, "stresses at grid points"},
    {21, "strains at grid points"},
    {22, "internal forces of elements"},
    {24, "pressures of elements"},
    {25, "failure indices of plies"},
    {26, "stresses of surfaces at grid points"},
    {27, "stresses of volumes at grid points"},
    {28, "principal stresses of volumes at grid points"},
    {36, "kinetic energies of elements"},
    {37, "energy losses of elements"},
    {40, "kinetic energies of grid points"},
};

std::string kind_text(const std::string& table, const Ident& ident) {
    std::string text = fmt::format("blocks of kind {}", ident.table_code);
    if (ident.table_code == kElementStressCode)
        text = table.find("STR") != std::string::npos ? "strains of elements" : "stresses of elements";
    for (const auto& [code, name] : kTableKinds) {
        if (code == ident.table_code) text = name;
    }
    if (ident.random) text += ", of a random response,";
    if (ident.sort2) text += ", sorted by element or grid,";
    if (ident.is_complex) text += ", complex,";
    return text;
}

bool has_element_type(const Ident& ident) {
    return ident.table_code == kForceCode || ident.table_code == kElementStressCode ||
           ident.table_code == kFailureCode;
}

}  // namespace

void UnusedBlocks::add(const std::string& table, const Ident& ident) {
    constexpr std::size_t kMostKinds = 1000;
    if (blocks_.size() >= kMostKinds) return;
    Blocks& blocks = blocks_[{table, kind_text(table, ident)}];
    ++blocks.count;
    if (has_element_type(ident) && blocks.types.size() < kMostKinds) blocks.types.insert(ident.element_type);
}

void UnusedBlocks::report(const std::string& where, Diagnostics& diagnostics) const {
    for (const auto& [key, blocks] : blocks_) {
        std::string text = fmt::format("{}: {} are not used", key.first, key.second);
        const char* before = ": ";
        for (const std::int64_t type : blocks.types) {
            text += before + element_name(type);
            before = ", ";
        }
        diagnostics.add(Code::UnknownBlock, where, std::move(text), blocks.count);
    }
}

}  // namespace feelem::op2
