// SPDX-License-Identifier: Apache-2.0
// The geometry of cyclic symmetry: the axis, the turn from a sector to the next, and which nodes they share.
#pragma once

#include "model/rotation.hpp"
#include "read/ansys/rst_header.hpp"

#include "feelem/mesh.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::rst {

class Sectors {
public:
    /// Empty, with a reason, when the file does not say how its sector is repeated.
    static std::optional<Sectors> find(
        const Records& records, const ResultHeader& header, const Mesh& mesh, std::string& reason
    );

    std::size_t count() const noexcept { return turns_.size(); }
    /// Turns vectors of the sector in the file into those of sector s.
    const Matrix3& turn(std::size_t s) const { return turns_[s]; }
    Point3 place(std::size_t s, const Point3& point) const;

    /// Nodes of the file's sector that are no copies of others.
    bool is_own(NodeIndex node) const { return is_own_[raw(node)]; }
    /// Where the next sector begins: the node of this sector that the next one has at the place of `node`, or
    /// kNoNode.
    NodeIndex low_of(NodeIndex node) const { return low_of_[raw(node)]; }
    /// The sector and node that stand for a node: those of the next sector where two meet.
    std::pair<std::size_t, NodeIndex> standing_for(std::size_t s, NodeIndex node) const;

private:
    bool read_frame(const Records& records, const ResultHeader& header);
    bool match_nodes(const Mesh& mesh);

    Point3 origin_{};
    Matrix3 axes_{};  ///< Rows: the axes of the coordinate system; the last one is that of symmetry.
    std::vector<Matrix3> turns_;
    std::vector<bool> is_own_;
    std::vector<NodeIndex> low_of_;
};

/// Cosine and sine of k turns of a sector, exact at quarters.
std::pair<double, double> phase_of(std::size_t s, std::int64_t harmonic, std::size_t sectors);

}  // namespace feelem::rst
