// SPDX-License-Identifier: Apache-2.0
#include "med/med_mesh.hpp"

#include "med/med_elements.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_set>
#include <utility>

namespace feelem::exchange {
namespace {

constexpr std::size_t kGroupName = 80;

using Point = std::array<double, 3>;

/// Six times the volume of the corners, by fans of their facets.
double volume_of(ElementType type, const std::array<Point, 8>& at) {
    double sum = 0;
    for (const FacetRow& facet : facets_of(type)) {
        const auto corners = facet_corners(facet);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            Point a, b, c;
            for (std::size_t k = 0; k < 3; ++k) {
                a[k] = at[corners[0]][k] - at[0][k];
                b[k] = at[corners[i]][k] - at[0][k];
                c[k] = at[corners[i + 1]][k] - at[0][k];
            }
            sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return sum;
}

class MeshReader {
public:
    MeshReader(const Hdf5File& file, NeutralModel& model) : file_(file), model_(model) {}

    MedMesh read() {
        const auto meshes = file_.names_in("/ENS_MAA");
        if (meshes.empty()) throw std::runtime_error("the MED file holds no mesh");
        mesh_.name = meshes.front();
        base_ = "/ENS_MAA/" + mesh_.name;
        // From version 3 on a mesh has calculation steps; the first is the undeformed one.
        if (!file_.exists(base_ + "/NOE")) {
            const auto steps = file_.names_in(base_);
            if (steps.empty()) throw std::runtime_error("the mesh of the MED file is empty");
            base_ += "/" + steps.front();
        }
        read_nodes();
        model_.parts.push_back("mesh");
        read_families("ELEME", element_groups_);
        read_families("NOEUD", node_groups_);
        add_node_sets();
        for (const MedType& type : med_types()) read_block(type);
        model_.element_sets.assign(element_sets_.begin(), element_sets_.end());
        name_unknown_types();
        number_elements();
        return std::move(mesh_);
    }

private:
    void read_nodes() {
        const std::string path = base_ + "/NOE/COO";
        if (!file_.exists(path)) throw std::runtime_error("the mesh of the MED file has no nodes");
        const std::vector<double> all = file_.reals(path);
        const std::int64_t dimensions =
            file_.integer("/ENS_MAA/" + mesh_.name, "ESP")
                .value_or(file_.integer("/ENS_MAA/" + mesh_.name, "DIM").value_or(3));
        if (dimensions < 1 || dimensions > 3)
            throw std::runtime_error("a mesh of other than one to three dimensions");
        const auto width = static_cast<std::size_t>(dimensions);
        mesh_.nodes = all.size() / width;
        coordinates_.resize(mesh_.nodes);
        // All x, then all y, then all z.
        for (std::size_t i = 0; i < mesh_.nodes; ++i) {
            for (std::size_t k = 0; k < width; ++k) coordinates_[i][k] = all[k * mesh_.nodes + i];
        }
        for (const Point& point : coordinates_)
            model_.coordinates.insert(model_.coordinates.end(), point.begin(), point.end());
        model_.node_ids = numbers_of(base_ + "/NOE/NUM", mesh_.nodes);
        if (model_.node_ids.empty()) {
            for (std::size_t i = 1; i <= mesh_.nodes; ++i)
                model_.node_ids.push_back(static_cast<std::int64_t>(i));
        }
    }

    /// The file's own numbers, when it has good ones.
    std::vector<std::int64_t> numbers_of(const std::string& path, std::size_t count) const {
        if (!file_.exists(path)) return {};
        std::vector<std::int64_t> numbers = file_.integers(path);
        std::unordered_set<std::int64_t> seen;
        const bool good = numbers.size() == count && std::ranges::all_of(numbers, [&](std::int64_t number) {
                              return number > 0 && seen.insert(number).second;
                          });
        return good ? numbers : std::vector<std::int64_t>{};
    }

    void read_families(const std::string& kind, std::map<std::int64_t, std::vector<std::string>>& groups)
        const {
        const std::string folder = "/FAS/" + mesh_.name + "/" + kind;
        for (const std::string& family : file_.names_in(folder)) {
            const std::string path = folder + "/" + family;
            const auto number = file_.integer(path, "NUM");
            const std::string names = path + "/GRO/NOM";
            if (number && file_.exists(names)) groups[*number] = file_.texts(names, kGroupName);
        }
    }

    void add_node_sets() {
        const std::string path = base_ + "/NOE/FAM";
        if (node_groups_.empty() || !file_.exists(path)) return;
        const std::vector<std::int64_t> families = file_.integers(path);
        std::map<std::string, std::vector<std::uint32_t>> sets;
        for (std::size_t i = 0; i < families.size() && i < mesh_.nodes; ++i) {
            const auto groups = node_groups_.find(families[i]);
            if (groups == node_groups_.end()) continue;
            for (const std::string& group : groups->second)
                sets[group].push_back(static_cast<std::uint32_t>(i));
        }
        model_.node_sets.assign(sets.begin(), sets.end());
    }

    void read_block(const MedType& med) {
        const std::string path = base_ + "/MAI/" + std::string(med.name);
        if (!file_.exists(path + "/NOD")) return;
        const std::vector<std::int64_t> all = file_.integers(path + "/NOD");
        const std::size_t count = all.size() / med.nodes;
        mesh_.blocks[std::string(med.name)] = {mesh_.elements, count};
        mesh_.elements += count;
        // All first nodes, then all second ones; counted from 1.
        const std::size_t width = element_row(med.type).node_count;
        std::vector<std::uint32_t> rows(count * width);
        for (std::size_t e = 0; e < count; ++e) {
            for (std::size_t i = 0; i < width; ++i) {
                const std::int64_t node = all[i * count + e] - 1;
                if (node < 0 || node >= static_cast<std::int64_t>(mesh_.nodes))
                    throw std::runtime_error("an element names a node that the file does not have");
                rows[e * width + i] = static_cast<std::uint32_t>(node);
            }
        }
        if (is_mirrored(med.type, rows)) mirror(med.type, rows);
        model_.types.insert(model_.types.end(), count, med.type);
        model_.element_nodes.insert(model_.element_nodes.end(), rows.begin(), rows.end());
        add_parts(path + "/FAM", count);
        numbers_.push_back(numbers_of(path + "/NUM", count));
    }

    /// MED's manual has solids the other way round than every other format; not every program follows it.
    bool is_mirrored(ElementType type, const std::vector<std::uint32_t>& rows) const {
        const ElementRow& row = element_row(type);
        if (row.dimension != 3) return false;
        std::ptrdiff_t balance = 0;
        for (std::size_t first = 0; first < rows.size(); first += row.node_count) {
            std::array<Point, 8> at{};
            for (std::size_t i = 0; i < row.corner_count; ++i) at[i] = coordinates_[rows[first + i]];
            const double volume = volume_of(type, at);
            balance += volume > 0 ? 1 : volume < 0 ? -1 : 0;
        }
        return balance < 0;
    }

    static void mirror(ElementType type, std::vector<std::uint32_t>& rows) {
        const auto order = mirrored_order(type);
        std::array<std::uint32_t, kMaxElementNodes> row{};
        for (std::size_t first = 0; first < rows.size(); first += order.size()) {
            std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(first), order.size(), row.begin());
            for (std::size_t i = 0; i < order.size(); ++i) rows[first + i] = row[order[i]];
        }
    }

    /// The first group of an element's family names its part; it is in the sets of the further ones.
    void add_parts(const std::string& path, std::size_t count) {
        const std::vector<std::int64_t> families =
            file_.exists(path) ? file_.integers(path) : std::vector<std::int64_t>{};
        for (std::size_t e = 0; e < count; ++e) {
            const auto groups =
                e < families.size() ? element_groups_.find(families[e]) : element_groups_.end();
            const bool named =
                groups != element_groups_.end() && !groups->second.empty() && !groups->second.front().empty();
            if (groups != element_groups_.end()) {
                for (std::size_t g = 1; g < groups->second.size(); ++g)
                    element_sets_[groups->second[g]].push_back(
                        static_cast<std::uint32_t>(model_.element_parts.size())
                    );
            }
            model_.element_parts.push_back(named ? part(groups->second.front()) : 0);
        }
    }

    std::uint32_t part(const std::string& name) {
        const auto [at, is_new] = parts_.try_emplace(name, static_cast<std::uint32_t>(model_.parts.size()));
        if (is_new) model_.parts.push_back(name);
        return at->second;
    }

    void name_unknown_types() {
        for (const std::string& name : file_.names_in(base_ + "/MAI")) {
            if (mesh_.blocks.contains(name)) continue;
            const auto count = file_.integer(base_ + "/MAI/" + name + "/NOD", "NBR");
            model_.skipped.emplace_back(
                "MED type " + name, static_cast<std::uint64_t>(std::max<std::int64_t>(count.value_or(1), 1))
            );
        }
    }

    /// The file's numbers where all blocks have them and none occurs twice, else 1, 2, 3 ...
    void number_elements() {
        std::unordered_set<std::int64_t> seen;
        bool good = true;
        for (const auto& block : numbers_) {
            for (const std::int64_t number : block) {
                good = good && seen.insert(number).second;
                model_.element_ids.push_back(number);
            }
        }
        if (good && model_.element_ids.size() == mesh_.elements) return;
        model_.element_ids.clear();
        for (std::size_t e = 1; e <= mesh_.elements; ++e)
            model_.element_ids.push_back(static_cast<std::int64_t>(e));
    }

    const Hdf5File& file_;
    NeutralModel& model_;
    MedMesh mesh_;
    std::string base_;
    std::vector<Point> coordinates_;
    std::map<std::int64_t, std::vector<std::string>> element_groups_, node_groups_;
    std::map<std::string, std::uint32_t> parts_;
    std::map<std::string, std::vector<std::uint32_t>> element_sets_;
    std::vector<std::vector<std::int64_t>> numbers_;
};

}  // namespace

MedMesh read_med_mesh(const Hdf5File& file, NeutralModel& model) {
    return MeshReader(file, model).read();
}

}  // namespace feelem::exchange
