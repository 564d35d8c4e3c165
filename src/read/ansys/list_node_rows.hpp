// SPDX-License-Identifier: Apache-2.0
// Rows of node lists that look as solvers print them.
#pragma once

#include "read/ansys/list_plain_rows.hpp"
#include "read/ansys/list_rows.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace feelem::ansys {

/// Rows one after the other, with the same angles.
struct NodeRows {
    static constexpr std::size_t kMost = AlikeRows<double>::kAtOnce;
    std::array<std::int64_t, kMost> ids;  // NOLINT: all that are used are written
    std::array<Point3, kMost> places;     // NOLINT
    NodalAngles angles{};
};

/// Place and angles of plain rows.
class PlainNodeRows {
public:
    explicit PlainNodeRows(bool has_angles) : columns_(has_angles ? 6 : 3), reals_(has_angles ? 6 : 3) {}

    /// The next rows, one or more; moves behind them. `length`: of each. 0: the next one is none of them.
    std::size_t read(RowCursor& cursor, NodeRows& rows, std::size_t& length) {
        if (const std::size_t count = alike_.read(cursor, rows.ids, rows.places.front().data())) {
            length = alike_.length();
            rows.angles = angles_;
            return count;
        }
        const std::string_view rest = cursor.rest();
        const char* at = cursor.plain_row(reals_.size());
        if (at == nullptr || !scan_plain_id(at, cursor.text_end(), rows.ids[0]) ||
            !columns_.scan(at, cursor.text_end(), reals_))
            return 0;
        if (!cursor.finish_row(at, length)) return 0;
        std::copy_n(reals_.begin(), 3, rows.places[0].begin());
        if (reals_.size() == 6)
            std::copy_n(reals_.begin() + 3, 3, rows.angles.begin());
        else
            rows.angles = {};
        if (alike_.learn(rest, cursor.line_end())) angles_ = rows.angles;
        return 1;
    }

private:
    static constexpr std::size_t kCoordinates = 3;

    AlikeRows<double> alike_{kCoordinates};
    NodalAngles angles_{};  ///< Of the row that others are like: theirs are printed alike.
    PlainColumns<double> columns_;
    std::vector<double> reals_;
};

}  // namespace feelem::ansys
