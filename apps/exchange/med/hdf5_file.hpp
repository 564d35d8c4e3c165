// SPDX-License-Identifier: Apache-2.0
// The little of HDF5 that MED files need: groups, attributes, arrays; every handle closed, every size
// bounded.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::exchange {

class Hdf5File {
public:
    explicit Hdf5File(const std::string& path);
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    bool exists(const std::string& path) const;
    /// Names of what is in a group, by name; empty when there is no such group.
    std::vector<std::string> names_in(const std::string& group) const;
    std::optional<std::int64_t> integer(const std::string& object, const char* attribute) const;
    std::optional<double> real(const std::string& object, const char* attribute) const;
    std::string text(const std::string& object, const char* attribute) const;
    std::vector<std::int64_t> integers(const std::string& dataset) const;
    std::vector<double> reals(const std::string& dataset) const;
    /// Rows of fixed width, blanks at their ends taken off.
    std::vector<std::string> texts(const std::string& dataset, std::size_t width) const;

private:
    template <class T>
    std::vector<T> read(const std::string& dataset, hid_t type) const;

    hid_t file_;
};

}  // namespace feelem::exchange
