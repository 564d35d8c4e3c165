// SPDX-License-Identifier: Apache-2.0
#include "vtk/netcdf_file.hpp"

#include <netcdf.h>

#include <algorithm>

namespace feelem::exchange {
namespace {

constexpr std::size_t kMostEntries = std::size_t{1} << 31;
constexpr std::size_t kMostNames = 100'000;
constexpr std::size_t kMostWidth = 1000;
constexpr int kMostDimensions = 3;

}  // namespace

NetcdfFile::NetcdfFile(const std::string& path) {
    if (nc_open(path.c_str(), NC_NOWRITE, &file_) != NC_NOERR) file_ = -1;
}

NetcdfFile::~NetcdfFile() {
    if (file_ >= 0) nc_close(file_);
}

std::optional<int> NetcdfFile::variable(const std::string& name) const {
    int id = 0;
    if (file_ < 0 || nc_inq_varid(file_, name.c_str(), &id) != NC_NOERR) return {};
    return id;
}

bool NetcdfFile::has_global_integer(const char* attribute) const {
    int value = 0;
    std::size_t length = 0;
    return file_ >= 0 && nc_inq_attlen(file_, NC_GLOBAL, attribute, &length) == NC_NOERR && length == 1 &&
           nc_get_att_int(file_, NC_GLOBAL, attribute, &value) == NC_NOERR;
}

std::size_t NetcdfFile::dimension(const char* name) const {
    int id = 0;
    std::size_t length = 0;
    if (file_ < 0 || nc_inq_dimid(file_, name, &id) != NC_NOERR) return 0;
    return nc_inq_dimlen(file_, id, &length) == NC_NOERR ? length : 0;
}

std::vector<std::size_t> NetcdfFile::extents(const std::string& name) const {
    const auto id = variable(name);
    int dimensions[NC_MAX_VAR_DIMS];
    int count = 0;
    if (!id || nc_inq_varndims(file_, *id, &count) != NC_NOERR || count > kMostDimensions) return {};
    if (nc_inq_vardimid(file_, *id, dimensions) != NC_NOERR) return {};
    std::vector<std::size_t> extents(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < extents.size(); ++i) {
        if (nc_inq_dimlen(file_, dimensions[i], &extents[i]) != NC_NOERR) return {};
    }
    return extents;
}

std::vector<std::int64_t> NetcdfFile::integers(const std::string& name) const {
    const auto all = extents(name);
    if (all.size() != 1 || all[0] > kMostEntries) return {};
    std::vector<long long> values(all[0]);
    if (nc_get_var_longlong(file_, *variable(name), values.data()) != NC_NOERR) return {};
    return {values.begin(), values.end()};
}

std::vector<std::string> NetcdfFile::texts(const std::string& name) const {
    const auto all = extents(name);
    if (all.size() != 2 || all[0] > kMostNames || all[1] > kMostWidth) return {};
    std::string text(all[0] * all[1], '\0');
    if (nc_get_var_text(file_, *variable(name), text.data()) != NC_NOERR) return {};
    std::vector<std::string> out;
    for (std::size_t i = 0; i < all[0]; ++i) {
        std::string row = text.substr(i * all[1], all[1]);
        row.resize(std::min(row.find('\0'), row.size()));
        while (!row.empty() && row.back() == ' ') row.pop_back();
        out.push_back(std::move(row));
    }
    return out;
}

std::vector<double> NetcdfFile::reals_of_step(const std::string& name, std::size_t step) const {
    const auto all = extents(name);
    if (all.size() < 2 || step >= all[0]) return {};
    const std::size_t width = all.size() == 3 ? all[2] : 1;
    if (width < 1 || all[1] > kMostEntries / width) return {};
    std::vector<double> values(all[1] * width);
    const std::size_t start[kMostDimensions]{step, 0, 0}, count[kMostDimensions]{1, all[1], width};
    if (nc_get_vara_double(file_, *variable(name), start, count, values.data()) != NC_NOERR) return {};
    return values;
}

}  // namespace feelem::exchange
