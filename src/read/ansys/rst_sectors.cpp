// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_sectors.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace feelem::rst {
namespace {

constexpr std::size_t kMostSectors = 1000;
/// Of the size of the model: how near nodes of two sectors are that are one.
constexpr double kSamePlace = 1e-5;

Point3 times(const Matrix3& matrix, const Point3& point) {
    return to_global(matrix, point);
}

Matrix3 transposed(const Matrix3& matrix) {
    Matrix3 out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) out[i][k] = matrix[k][i];
    }
    return out;
}

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Nodes by place, for the nearest one within a small distance.
class PlaceIndex {
public:
    PlaceIndex(const Mesh& mesh, const std::vector<bool>& wanted, double cell) : mesh_(mesh), cell_(cell) {
        for (std::uint32_t i = 0; i < mesh.node_count(); ++i) {
            if (wanted[i]) cells_[key(mesh.coordinates[i], 0, 0, 0)].push_back(NodeIndex{i});
        }
    }

    NodeIndex nearest(const Point3& point) const {
        NodeIndex best = kNoNode;
        double least = cell_;
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                for (int z = -1; z <= 1; ++z) {
                    const auto found = cells_.find(key(point, x, y, z));
                    if (found == cells_.end()) continue;
                    for (const NodeIndex node : found->second) {
                        const double apart = distance(mesh_.coordinates[raw(node)], point);
                        if (apart < least) {
                            least = apart;
                            best = node;
                        }
                    }
                }
            }
        }
        return best;
    }

private:
    using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
    Key key(const Point3& point, int x, int y, int z) const {
        const auto whole = [&](double value) {
            const double cells = std::floor(value / cell_);
            return std::abs(cells) < 1e15 ? static_cast<std::int64_t>(cells) : std::int64_t{0};
        };
        return {whole(point[0]) + x, whole(point[1]) + y, whole(point[2]) + z};
    }

    const Mesh& mesh_;
    double cell_;
    std::map<Key, std::vector<NodeIndex>> cells_;
};

}  // namespace

std::pair<double, double> phase_of(std::size_t s, std::int64_t harmonic, std::size_t sectors) {
    const auto n = static_cast<std::int64_t>(sectors);
    const std::int64_t part = static_cast<std::int64_t>(s) * (harmonic % n) % n;
    const Matrix3 turned = nodal_axes({360.0 * static_cast<double>(part) / static_cast<double>(n), 0, 0});
    return {turned[0][0], turned[1][0]};
}

std::optional<Sectors> Sectors::find(
    const Records& records, const ResultHeader& header, const Mesh& mesh, std::string& reason
) {
    Sectors sectors;
    const auto count = static_cast<std::size_t>(std::max(header.sectors, 1));
    if (count < 2 || count > kMostSectors) {
        reason = "its number of sectors makes no sense";
        return std::nullopt;
    }
    if (!sectors.read_frame(records, header)) {
        reason = "the cylindrical system of its axis is not in the file";
        return std::nullopt;
    }
    for (std::size_t s = 0; s < count; ++s) {
        const auto [cosine, sine] = phase_of(s, 1, count);
        const Matrix3 about_axis{{{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}}};
        sectors.turns_.push_back(product(transposed(sectors.axes_), product(about_axis, sectors.axes_)));
    }
    for (const NodeId id : mesh.node_ids)
        sectors.is_own_.push_back(header.sector_nodes <= 0 || raw(id) <= header.sector_nodes);
    if (!sectors.match_nodes(mesh)) {
        reason = "no nodes of one side of the sector lie on the other side of its neighbour";
        return std::nullopt;
    }
    return sectors;
}

bool Sectors::read_frame(const Records& records, const ResultHeader& header) {
    const std::vector<std::int32_t> geometry = records.integers(header.geometry);
    Word at = pointer(geometry, 25, 26);
    if (at == 0) at = wide(item(geometry, 10), 0);
    if (at == 0) return false;
    const Record index = records.find(at);
    std::vector<std::int32_t> places;
    records.unpack(item(geometry, 65) == 1 ? records.find(index.next) : index, kSmallRecord, places);
    for (const std::int32_t place : places) {
        if (place == 0) continue;
        const std::vector<double> system = records.reals(at + static_cast<std::uint32_t>(place), 64);
        if (system.size() < 22 || system[21] != header.sector_system || system[20] != 1) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) axes_[i][k] = system[3 * i + k];
            origin_[i] = system[9 + i];
        }
        // Rows of a rotation have the length one.
        return std::ranges::all_of(axes_, [](const std::array<double, 3>& row) {
            return std::abs(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] - 1) < 1e-6;
        });
    }
    return false;
}

Point3 Sectors::place(std::size_t s, const Point3& point) const {
    if (s == 0) return point;
    Point3 out = times(turns_[s], {point[0] - origin_[0], point[1] - origin_[1], point[2] - origin_[2]});
    for (std::size_t i = 0; i < 3; ++i) out[i] += origin_[i];
    return out;
}

bool Sectors::match_nodes(const Mesh& mesh) {
    double size = 0;
    for (const Point3& point : mesh.coordinates) {
        const double radius = distance(point, origin_);
        if (std::isfinite(radius)) size = std::max(size, radius);
    }
    low_of_.assign(mesh.node_count(), kNoNode);
    if (size == 0) return false;
    const PlaceIndex places(mesh, is_own_, kSamePlace * size);
    std::size_t matched = 0;
    for (std::uint32_t i = 0; i < mesh.node_count(); ++i) {
        if (!is_own_[i]) continue;
        const NodeIndex high = places.nearest(place(1, mesh.coordinates[i]));
        if (high == kNoNode) continue;
        // Two nodes at one place would each have the other sector's node.
        if (low_of_[raw(high)] != kNoNode) return false;
        low_of_[raw(high)] = NodeIndex{i};
        ++matched;
    }
    // A node on both sides, but not on the axis: with two sectors it is not clear which side is which.
    for (std::uint32_t i = 0; i < mesh.node_count(); ++i) {
        const NodeIndex low = low_of_[i];
        if (low != kNoNode && low != NodeIndex{i} && low_of_[raw(low)] != kNoNode) return false;
    }
    return matched > 0;
}

std::pair<std::size_t, NodeIndex> Sectors::standing_for(std::size_t s, NodeIndex node) const {
    const NodeIndex low = low_of_[raw(node)];
    if (low == kNoNode) return {s, node};
    if (low == node) return {0, node};  // On the axis.
    return {(s + 1) % count(), low};
}

}  // namespace feelem::rst
