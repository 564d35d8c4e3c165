// SPDX-License-Identifier: Apache-2.0
// The little of netCDF that Exodus files need beside the Exodus library: whole variables, every size bounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::exchange {

class NetcdfFile {
public:
    /// A file that netCDF cannot open has no variables.
    explicit NetcdfFile(const std::string& path);
    ~NetcdfFile();
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;

    bool has_variable(const std::string& name) const { return variable(name).has_value(); }
    bool has_global_integer(const char* attribute) const;
    std::size_t dimension(const char* name) const;  ///< 0: there is none of that name.
    /// Empty when there is no variable of that name, or it has more than three dimensions.
    std::vector<std::size_t> extents(const std::string& name) const;
    /// Of a variable of one dimension; empty when there is none, or it cannot be read.
    std::vector<std::int64_t> integers(const std::string& name) const;
    /// Rows of characters, each up to its first zero.
    std::vector<std::string> texts(const std::string& name) const;
    /// All numbers of one step of a variable whose first dimension is time; empty when it cannot be read.
    std::vector<double> reals_of_step(const std::string& name, std::size_t step) const;

private:
    std::optional<int> variable(const std::string& name) const;

    int file_ = -1;
};

}  // namespace feelem::exchange
