// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/gmsh/gmsh_elements.hpp"
#include "read/side_markers.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace feelem::gmsh {
namespace {

/// Dimension and tag of an entity or a physical group.
using Place = std::pair<int, std::int64_t>;

class MeshReader {
public:
    MeshReader(const Input& input, const Layout& layout, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics), builder_(diagnostics) {}

    Mesh read() {
        for_each("PhysicalNames", [&](const Section& section) { read_names(section); });
        if (layout_.coding.version >= 40)
            for_each("Entities", [&](const Section& section) { read_entities(section); });
        for_each("Nodes", [&](const Section& section) {
            each_node(input_, layout_.coding, section, [&](NodeId id, const Point3& place) {
                builder_.add_node(id, place);
            });
        });
        builder_.seal_nodes();
        find_sides();
        each([&](const ElementIn& element) { add(element); });
        for (auto& [place, nodes] : side_nodes_) {
            std::ranges::sort(nodes);
            nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
            builder_.add_node_set(group_name(place), nodes);
        }
        Mesh mesh = builder_.finish();
        if (!further_groups_.empty()) {
            const ElementLookup lookup(mesh);
            for (const auto& [place, ids] : further_groups_)
                add_element_set(mesh, lookup, group_name(place), ids);
        }
        return mesh;
    }

private:
    template <class Use>
    void for_each(std::string_view name, const Use& use) {
        for (const Section& section : layout_.sections) {
            if (section.name == name) use(section);
        }
    }
    void each(const UseElement& use) {
        for_each("Elements", [&](const Section& section) {
            each_element(input_, layout_.coding, section, use);
        });
    }

    void read_names(const Section& section) {
        TextLines lines(input_, section.first, section.last);
        lines.next();
        while (auto line = lines.next()) {
            const auto dimension = take_integer(*line);
            const auto tag = take_integer(*line);
            std::string_view name = trim(*line);
            if (!dimension || !tag || *dimension < 0 || *dimension > 3) continue;
            if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
                name = name.substr(1, name.size() - 2);
            names_[{static_cast<int>(*dimension), *tag}] = name;
        }
    }

    void read_entities(const Section& section) {
        Numbers numbers(input_, layout_.coding, section.first, section.last);
        std::size_t counts[4];
        for (std::size_t& count : counts) count = numbers.count(numbers.size(), 4);
        for (int dimension = 0; dimension < 4; ++dimension) {
            for (std::size_t i = 0; i < counts[dimension]; ++i) {
                const std::int64_t tag = numbers.integer();
                const int reals = dimension == 0 && layout_.coding.version == 41 ? 3 : 6;
                for (int k = 0; k < reals; ++k) numbers.real();
                const std::size_t groups = numbers.count(numbers.size(), 2);
                for (std::size_t k = 0; k < groups; ++k)
                    groups_of_[{dimension, tag}].push_back(std::abs(numbers.integer()));
                if (dimension == 0) continue;
                const std::size_t bounds = numbers.count(numbers.size(), 2);
                for (std::size_t k = 0; k < bounds; ++k) numbers.integer();
            }
        }
    }

    void find_sides() {
        each([&](const ElementIn& element) {
            if (!element.nodes.empty()) sides_.add_candidate(element.type->type, element.nodes);
        });
        if (sides_.empty()) return;
        each([&](const ElementIn& element) {
            if (!element.nodes.empty()) sides_.add_owner(element.type->type, element.nodes);
        });
    }

    /// Physical groups of an element; the first names its part.
    std::vector<std::int64_t> groups_of(const ElementIn& element, int dimension) const {
        if (layout_.coding.version < 40) {
            if (element.physical == 0) return {};
            return {element.physical};
        }
        const auto found = groups_of_.find({dimension, element.entity});
        return found != groups_of_.end() ? found->second : std::vector<std::int64_t>{};
    }

    std::string group_name(const Place& place) const {
        const auto named = names_.find(place);
        return named != names_.end() && !named->second.empty() ? named->second
                                                               : fmt::format("physical {}", place.second);
    }

    void add(const ElementIn& element) {
        const auto where = [&] {
            return layout_.coding.binary ? input_.where_byte(element.offset)
                                         : input_.where_line(element.offset);
        };
        if (element.nodes.empty()) {
            diagnostics_.add(
                Code::UnknownElementType,
                where,
                fmt::format(
                    "elements of type {} ({}) are left out: their order is above two",
                    element.type->number,
                    element.type->name
                )
            );
            return;
        }
        const ElementType type = element.type->type;
        const int dimension = element_row(type).dimension;
        const std::vector<std::int64_t> groups = groups_of(element, dimension);
        if (sides_.is_side(type, element.nodes)) {
            builder_.skip_element(fmt::format("{} on the side of another element", element.type->name));
            for (const std::int64_t group : groups) {
                std::vector<NodeId>& nodes = side_nodes_[{dimension, group}];
                nodes.insert(nodes.end(), element.nodes.begin(), element.nodes.end());
            }
            return;
        }
        for (std::size_t i = 1; i < groups.size(); ++i)
            further_groups_[{dimension, groups[i]}].push_back(ElementId{element.id});
        builder_.add_element(
            ElementId{element.id}, type, element.nodes, part_of(dimension, groups, element.entity), where
        );
    }

    PartIndex part_of(int dimension, const std::vector<std::int64_t>& groups, std::int64_t entity) {
        const std::tuple key{dimension, groups.empty(), groups.empty() ? entity : groups.front()};
        if (last_part_ && key == last_key_) return *last_part_;
        constexpr const char* kEntities[]{"point", "curve", "surface", "volume"};
        last_key_ = key;
        last_part_ = builder_.part(
            !groups.empty() ? group_name({dimension, groups.front()})
            : entity != 0   ? fmt::format("{} {}", kEntities[dimension], entity)
                            : "mesh"
        );
        return *last_part_;
    }

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    std::map<Place, std::string> names_;
    std::map<Place, std::vector<std::int64_t>> groups_of_;
    SideMarkers sides_;
    std::map<Place, std::vector<NodeId>> side_nodes_;
    std::map<Place, std::vector<ElementId>> further_groups_;
    std::optional<PartIndex> last_part_;
    std::tuple<int, bool, std::int64_t> last_key_;
};

}  // namespace

Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics) {
    return MeshReader(input, layout, diagnostics).read();
}

}  // namespace feelem::gmsh
