// SPDX-License-Identifier: Apache-2.0
#include "med/hdf5_file.hpp"

#include <algorithm>
#include <stdexcept>

namespace feelem::exchange {
namespace {

/// Closes a handle at the end of a scope.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    explicit operator bool() const { return id_ >= 0; }
    hid_t id() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

constexpr hssize_t kMostEntries = hssize_t{1} << 32;

template <class T>
std::optional<T> read_attribute(hid_t file, const std::string& object, const char* name, hid_t type) {
    const Handle at(H5Aopen_by_name(file, object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!at) return {};
    const Handle space(H5Aget_space(at.id()), H5Sclose);
    if (!space || H5Sget_simple_extent_npoints(space.id()) != 1) return {};
    const Handle own(H5Aget_type(at.id()), H5Tclose);
    const H5T_class_t kind = H5Tget_class(own.id());
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return {};
    T value{};
    if (H5Aread(at.id(), type, &value) < 0) return {};
    return value;
}

std::string without_blanks(std::string text) {
    text.resize(std::min(text.find('\0'), text.size()));
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

}  // namespace

Hdf5File::Hdf5File(const std::string& path) : file_(-1) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0)
        throw std::runtime_error("HDF5 cannot open the file: it is damaged or was not copied whole");
}

Hdf5File::~Hdf5File() {
    H5Fclose(file_);
}

bool Hdf5File::exists(const std::string& path) const {
    // Each group on the way must be there: HDF5 does not answer for those below.
    for (std::size_t at = path.find('/', 1); at != std::string::npos; at = path.find('/', at + 1)) {
        if (H5Lexists(file_, path.substr(0, at).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::names_in(const std::string& group) const {
    std::vector<std::string> names;
    if (!exists(group)) return names;
    const Handle at(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t info{};
    if (!at || H5Gget_info(at.id(), &info) < 0) return names;
    for (hsize_t i = 0; i < info.nlinks && i < 1'000'000; ++i) {
        char name[512];
        const ssize_t length =
            H5Lget_name_by_idx(at.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name, H5P_DEFAULT);
        if (length < 0) throw std::runtime_error("a group of the file is damaged: " + group);
        names.emplace_back(name);
    }
    return names;
}

std::optional<std::int64_t> Hdf5File::integer(const std::string& object, const char* attribute) const {
    return read_attribute<std::int64_t>(file_, object, attribute, H5T_NATIVE_INT64);
}

std::optional<double> Hdf5File::real(const std::string& object, const char* attribute) const {
    return read_attribute<double>(file_, object, attribute, H5T_NATIVE_DOUBLE);
}

std::string Hdf5File::text(const std::string& object, const char* attribute) const {
    const Handle at(H5Aopen_by_name(file_, object.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!at) return {};
    const Handle type(H5Aget_type(at.id()), H5Tclose);
    const std::size_t size = H5Tget_size(type.id());
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 || size > (1u << 20))
        return {};
    std::string out(size, '\0');
    if (H5Aread(at.id(), type.id(), out.data()) < 0) return {};
    out.resize(std::min(out.find('\0'), out.size()));
    return out;
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& dataset, hid_t type) const {
    const Handle at(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (!at) throw std::runtime_error("the file has no " + dataset);
    const Handle space(H5Dget_space(at.id()), H5Sclose);
    const hssize_t count = space ? H5Sget_simple_extent_npoints(space.id()) : -1;
    if (count < 0 || count > kMostEntries) throw std::runtime_error("the size of " + dataset + " is no size");
    std::vector<T> values(static_cast<std::size_t>(count));
    if (count > 0 && H5Dread(at.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        throw std::runtime_error("HDF5 cannot read " + dataset + ": the file is damaged");
    return values;
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& dataset) const {
    return read<std::int64_t>(dataset, H5T_NATIVE_INT64);
}

std::vector<double> Hdf5File::reals(const std::string& dataset) const {
    return read<double>(dataset, H5T_NATIVE_DOUBLE);
}

std::vector<std::string> Hdf5File::texts(const std::string& dataset, std::size_t width) const {
    const Handle at(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (!at) return {};
    const Handle type(H5Dget_type(at.id()), H5Tclose), space(H5Dget_space(at.id()), H5Sclose);
    const std::size_t size = H5Tget_size(type.id());
    const hssize_t rows = H5Sget_simple_extent_npoints(space.id());
    if (size == 0 || size > (1u << 16) || rows <= 0 || rows > (1 << 20)) return {};
    std::string bytes(size * static_cast<std::size_t>(rows), '\0');
    if (H5Dread(at.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) return {};
    std::vector<std::string> out;
    for (std::size_t first = 0; first < bytes.size(); first += width)
        out.push_back(without_blanks(bytes.substr(first, width)));
    return out;
}

}  // namespace feelem::exchange
