// SPDX-License-Identifier: Apache-2.0
// Values of a field at the nodes of an element, as the skin has them there.
#pragma once

#include "skin/result_rows.hpp"

#include "feelem/inside.hpp"

#include <cstddef>
#include <span>

namespace feelem {

/// A solid of a mesh, by block and position.
struct SolidRef {
    const ElementBlock* block = nullptr;
    std::size_t position = 0;
    ElementIndex index = kNoElement;

    std::span<const NodeIndex> nodes() const;
};

class ElementValues {
public:
    ElementValues(const Mesh& mesh, const FieldOf& field);

    /// `out` has one value a node of the element; NaN: missing.
    void gather(const SolidRef& solid, std::span<double> out) const;
    bool is_elemental() const noexcept;

private:
    double value_of(NodeIndex node, const ResultPlace& place) const;

    const Result& result_;
    std::size_t component_;
    ResultRows rows_;
};

}  // namespace feelem
