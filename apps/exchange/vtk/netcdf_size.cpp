// SPDX-License-Identifier: Apache-2.0
// After the file format specification of netCDF (CDF-1, CDF-2, CDF-5): numbers are big-endian.
#include "vtk/netcdf_size.hpp"

#include "base/byte_reader.hpp"
#include "base/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

namespace feelem::exchange {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > kMost / b ? kMost : a * b;
}
std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return a > kMost - std::min(b, kMost) ? kMost : a + b;
}
std::uint64_t padded(std::uint64_t bytes) {
    return sum(bytes, 3) / 4 * 4;
}

struct Variable {
    std::uint64_t begin = 0, bytes = 0;  ///< `bytes` of one record, where it has records.
    bool has_records = false;
};

class Head {
public:
    explicit Head(const Input& input) : version_(input.text()[3]), from_(input, 4, true) {}

    std::uint64_t needed_bytes() {
        const std::uint64_t records = count();
        read_dimensions();
        skip_attributes();
        const std::vector<Variable> variables = read_variables();
        std::uint64_t record = 0, with_records = 0, last_bytes = 0;
        for (const Variable& variable : variables) {
            if (!variable.has_records) continue;
            record = sum(record, padded(variable.bytes));
            last_bytes = variable.bytes;
            ++with_records;
        }
        // A single variable with records is not padded.
        if (with_records == 1) record = last_bytes;
        std::uint64_t needed = 0;
        for (const Variable& variable : variables) {
            std::uint64_t end = sum(variable.begin, variable.bytes);
            if (variable.has_records) {
                // Records are counted by the file's length where the head says so.
                if (records == 0 || records == streaming()) continue;
                end = sum(end, product(records - 1, record));
            }
            needed = std::max(needed, end);
        }
        return needed;
    }

private:
    std::uint64_t streaming() const { return version_ == 5 ? ~std::uint64_t{0} : 0xFFFFFFFFU; }
    std::uint64_t count() {
        return version_ == 5 ? from_.read<std::uint64_t>() : from_.read<std::uint32_t>();
    }
    std::uint64_t list() {
        from_.read<std::uint32_t>();
        return count();
    }
    void skip(std::uint64_t bytes) {
        if (bytes > from_.remaining())
            throw std::runtime_error("the head of the netCDF file is damaged or was cut");
        from_.take(static_cast<std::size_t>(bytes));
    }
    void skip_name() { skip(padded(count())); }

    static std::uint64_t bytes_of(std::uint32_t type) {
        constexpr std::uint64_t kBytes[]{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        if (type < 1 || type > 11)
            throw std::runtime_error("the head of the netCDF file is damaged or was cut");
        return kBytes[type];
    }

    void read_dimensions() {
        for (std::uint64_t left = list(); left > 0; --left) {
            skip_name();
            dimensions_.push_back(count());
        }
    }

    void skip_attributes() {
        for (std::uint64_t left = list(); left > 0; --left) {
            skip_name();
            const std::uint64_t bytes = bytes_of(from_.read<std::uint32_t>());
            skip(padded(product(count(), bytes)));
        }
    }

    std::vector<Variable> read_variables() {
        std::vector<Variable> variables;
        for (std::uint64_t left = list(); left > 0; --left) {
            skip_name();
            Variable variable;
            variable.bytes = 1;
            bool first = true;
            for (std::uint64_t ids = count(); ids > 0; --ids, first = false) {
                const std::uint64_t id = count();
                if (id >= dimensions_.size())
                    throw std::runtime_error("the head of the netCDF file is damaged or was cut");
                const std::uint64_t extent = dimensions_[static_cast<std::size_t>(id)];
                if (first && extent == 0)
                    variable.has_records = true;
                else
                    variable.bytes = product(variable.bytes, extent);
            }
            skip_attributes();
            variable.bytes = product(variable.bytes, bytes_of(from_.read<std::uint32_t>()));
            count();
            variable.begin = version_ == 1 ? from_.read<std::uint32_t>() : from_.read<std::uint64_t>();
            variables.push_back(variable);
        }
        return variables;
    }

    int version_;
    ByteReader from_;
    std::vector<std::uint64_t> dimensions_;
};

}  // namespace

void check_netcdf_size(const std::string& path) {
    const Input input = Input::from_file(path);
    if (!input.text().starts_with("CDF") || input.size() < 4) return;
    const std::uint64_t needed = Head(input).needed_bytes();
    if (needed > input.size())
        throw std::runtime_error(fmt::format(
            "the file has {} bytes where its head needs {}: it was cut, or is still being written",
            input.size(),
            needed
        ));
}

}  // namespace feelem::exchange
