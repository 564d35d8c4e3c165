// SPDX-License-Identifier: Apache-2.0
// Rows of node lists that look as solvers print them.
#pragma once

#include "read/ansys/list_plain_rows.hpp"
#include "read/ansys/list_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace feelem::ansys {

/// Place and angles of plain rows.
class PlainNodeRows {
public:
    explicit PlainNodeRows(bool has_angles) : columns_(has_angles ? 6 : 3), reals_(has_angles ? 6 : 3) {}

    bool read(RowCursor& cursor, NodeRow& row, std::size_t& length) {
        if (alike_.read(cursor, row.id, row.position)) {
            length = alike_.length();
            row.angles = angles_;
            return true;
        }
        const std::string_view rest = cursor.rest();
        const char* at = cursor.plain_row(reals_.size());
        if (at == nullptr || !scan_plain_id(at, cursor.text_end(), row.id) ||
            !columns_.scan(at, cursor.text_end(), reals_))
            return false;
        if (!cursor.finish_row(at, length)) return false;
        std::copy_n(reals_.begin(), 3, row.position.begin());
        if (reals_.size() == 6)
            std::copy_n(reals_.begin() + 3, 3, row.angles.begin());
        else
            row.angles = {};
        if (alike_.learn(rest, cursor.line_end())) angles_ = row.angles;
        return true;
    }

private:
    static constexpr std::size_t kCoordinates = 3;

    AlikeRows<double> alike_{kCoordinates};
    NodalAngles angles_{};  ///< Of the row that others are like: theirs are printed alike.
    PlainColumns<double> columns_;
    std::vector<double> reals_;
};

}  // namespace feelem::ansys
