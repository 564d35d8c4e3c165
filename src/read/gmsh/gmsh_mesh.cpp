// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/gmsh/gmsh_elements.hpp"
#include "read/side_markers.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
        NodeRows all;
        for_each("Nodes", [&](const Section& section) {
            read_node_rows(input_, layout_.coding, section, all);
        });
        builder_.add_nodes(std::move(all.ids), std::move(all.places));
        builder_.seal_nodes();
        for_each("Elements", [&](const Section& section) {
            read_element_rows(input_, layout_.coding, section, rows_);
        });
        find_sides();
        builder_.expect_elements(rows_.ids.size());
        for (std::size_t i = 0; i < rows_.runs.size(); ++i) add_run(rows_.runs[i], rows_.end_of(i));
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
    /// use(type, nodes) for each element of a known type.
    template <class Use>
    void for_each_element(const Use& use) const {
        std::array<NodeId, kMaxElementNodes> room;
        for (std::size_t r = 0; r < rows_.runs.size(); ++r) {
            const ElementRows::Run& run = rows_.runs[r];
            if (run.width() == 0) continue;
            for (std::size_t i = run.first; i < rows_.end_of(r); ++i)
                use(run.type->type, rows_.row(run, i, room));
        }
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
        const bool has_candidates = std::ranges::any_of(rows_.runs, [](const ElementRows::Run& run) {
            return run.width() != 0 && element_row(run.type->type).dimension < 3;
        });
        if (!has_candidates) return;
        for_each_element([&](ElementType type, std::span<const NodeId> nodes) {
            sides_.add_candidate(type, nodes);
        });
        for_each_element([&](ElementType type, std::span<const NodeId> nodes) {
            sides_.add_owner(type, nodes);
        });
    }

    /// Physical groups of elements; the first names their part.
    std::vector<std::int64_t> groups_of(const ElementRows::Run& run, int dimension) const {
        if (layout_.coding.version < 40) {
            if (run.physical == 0) return {};
            return {run.physical};
        }
        const auto found = groups_of_.find({dimension, run.entity});
        return found != groups_of_.end() ? found->second : std::vector<std::int64_t>{};
    }

    std::string group_name(const Place& place) const {
        const auto named = names_.find(place);
        return named != names_.end() && !named->second.empty() ? named->second
                                                               : fmt::format("physical {}", place.second);
    }

    std::string where(std::size_t i) const {
        return layout_.coding.binary ? input_.where_byte(rows_.offsets[i])
                                     : input_.where_line(rows_.offsets[i]);
    }

    void report_unknown(const ElementRows::Run& run, std::size_t count) {
        diagnostics_.add(
            Code::UnknownElementType,
            [&] { return where(run.first); },
            fmt::format(
                "elements of type {} ({}) are left out: their order is above two",
                run.type->number,
                run.type->name
            ),
            count
        );
    }

    void add_run(const ElementRows::Run& run, std::size_t end) {
        const std::size_t count = end - run.first;
        if (run.width() == 0) {
            report_unknown(run, count);
            return;
        }
        const ElementType type = run.type->type;
        const int dimension = element_row(type).dimension;
        const std::vector<std::int64_t> groups = groups_of(run, dimension);
        const bool may_be_sides = !sides_.empty() && dimension < 3;
        std::array<NodeId, kMaxElementNodes> room;
        if (may_be_sides || run.is_wide) {
            for (std::size_t i = run.first; i < end; ++i) add(run, i, rows_.row(run, i, room), groups);
            return;
        }
        const auto ids = std::span(rows_.ids).subspan(run.first, count);
        for (std::size_t i = 1; i < groups.size(); ++i) {
            std::vector<ElementId>& members = further_groups_[{dimension, groups[i]}];
            members.insert(members.end(), ids.begin(), ids.end());
        }
        builder_.add_elements(
            type,
            part_of(dimension, groups, run.entity),
            ids,
            rows_.nodes_of(run, run.first, count),
            [&](std::size_t row) { return where(run.first + row); }
        );
    }

    void add(
        const ElementRows::Run& run,
        std::size_t i,
        std::span<const NodeId> nodes,
        const std::vector<std::int64_t>& groups
    ) {
        const ElementType type = run.type->type;
        const int dimension = element_row(type).dimension;
        if (sides_.is_side(type, nodes)) {
            builder_.skip_element(fmt::format("{} on the side of another element", run.type->name));
            for (const std::int64_t group : groups) {
                std::vector<NodeId>& members = side_nodes_[{dimension, group}];
                members.insert(members.end(), nodes.begin(), nodes.end());
            }
            return;
        }
        for (std::size_t g = 1; g < groups.size(); ++g)
            further_groups_[{dimension, groups[g]}].push_back(rows_.ids[i]);
        builder_.add_element(rows_.ids[i], type, nodes, part_of(dimension, groups, run.entity), [&] {
            return where(i);
        });
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
    ElementRows rows_;
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
