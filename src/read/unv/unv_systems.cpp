// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_systems.hpp"

#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <cmath>
#include <numbers>

namespace feelem::unv {

Point3 System::to_part(const Point3& local) const {
    Point3 flat = local;
    const double second = local[1] * std::numbers::pi / 180, third = local[2] * std::numbers::pi / 180;
    if (type == 1) flat = {local[0] * std::cos(second), local[0] * std::sin(second), local[2]};
    if (type == 2) {
        const double across = local[0] * std::sin(second);
        flat = {across * std::cos(third), across * std::sin(third), local[0] * std::cos(second)};
    }
    Point3 out = rows[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i) out[i] += flat[axis] * rows[axis][i];
    }
    return out;
}

std::map<std::int64_t, System> read_systems(const Input& input, const Dataset& dataset) {
    std::map<std::int64_t, System> systems;
    TextLines lines(input, dataset.first, dataset.last);
    lines.next();  // Part number
    lines.next();  // Part name
    while (auto line = lines.next()) {
        const auto number = take_integer(*line);
        if (!number) break;
        System system;
        system.type = take_integer(*line).value_or(0);
        lines.next();  // Name
        for (Point3& row : system.rows) {
            auto numbers = lines.next().value_or(std::string_view{});
            for (double& number_of_row : row) {
                const auto value = parse_double(take_word(numbers));
                if (!value) {
                    throw Error(
                        Code::BadNumber,
                        lines.where(),
                        "a coordinate system (dataset 2420) needs four rows of three numbers"
                    );
                }
                number_of_row = *value;
            }
        }
        systems[*number] = system;
    }
    return systems;
}

}  // namespace feelem::unv
