// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_mesh.hpp"

#include "base/huge_pages.hpp"
#include "model/mesh_builder.hpp"
#include "read/abaqus/flat_scopes.hpp"
#include "read/element_lookup.hpp"
#include "read/nodal_angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace feelem::abaqus {
namespace {

constexpr const char* kWithoutSection = "without section";

/// Positions of labels, most often asked for in their order.
class PositionFinder {
public:
    explicit PositionFinder(const std::vector<Label>& sorted) : sorted_(sorted) {}
    std::size_t operator()(Label label) const {
        if (next_ >= sorted_.size() || sorted_[next_] != label)
            next_ = static_cast<std::size_t>(std::ranges::lower_bound(sorted_, label) - sorted_.begin());
        return next_++;
    }

private:
    const std::vector<Label>& sorted_;
    mutable std::size_t next_ = 0;
};

/// Ascending, each once.
template <class Id>
void sort_and_unite(std::vector<Id>& ids) {
    if (std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) == ids.end()) return;
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// The part of each element of a scope: the set that its section is given to, else the set it was defined in.
class SectionParts {
public:
    SectionParts(const std::vector<FlatScope>& scopes, std::size_t at, SetMembers& members)
        : position_(scopes[at].element_ids), section_(scopes[at].element_ids.size(), 0) {
        for (const Scope* table : scopes[at].tables) {
            for (const std::string& name : table->sections) {
                names_.push_back(name);
                const DeckSet* set = table->element_sets.find(folded(name));
                if (set == nullptr) continue;
                members.for_each(at, *set, [&](std::size_t where, Label label) {
                    if (where == at) section_[position_(label)] = static_cast<std::uint32_t>(names_.size());
                });
            }
        }
    }
    const std::string& name_of(Label label, const ElementRun& run) const {
        return name(section_of(label), run);
    }
    /// How many elements of a run from row `first` on are of one part with it.
    std::size_t alike_from(std::size_t first, const ElementRun& run) const {
        const std::uint32_t section = section_of(run.ids[first]);
        std::size_t last = first + 1;
        while (last < run.ids.size() && section_of(run.ids[last]) == section) ++last;
        return last - first;
    }

private:
    std::uint32_t section_of(Label label) const { return section_[position_(label)]; }
    const std::string& name(std::uint32_t section, const ElementRun& run) const {
        if (section > 0) return names_[section - 1];
        return run.set.empty() ? nothing_ : run.set;
    }

    PositionFinder position_;
    std::vector<std::uint32_t> section_;  ///< Of element_ids; 0: none, else its place in names_ + 1.
    std::vector<std::string> names_;
    const std::string nothing_ = kWithoutSection;
};

class MeshMaker {
public:
    MeshMaker(const Deck& deck, DeckModel& model, Diagnostics& diagnostics)
        : deck_(deck), model_(model), diagnostics_(diagnostics), scopes_(flatten(deck, model, diagnostics)),
          builder_(diagnostics), node_members_(scopes_, true), element_members_(scopes_, false) {
        offset_ids(scopes_, diagnostics);
    }

    Mesh make() {
        add_nodes();
        const auto has_elements = [](const FlatScope& scope) { return !scope.element_ids.empty(); };
        by_section_ = std::ranges::count_if(scopes_, has_elements) <= 1;
        std::size_t elements = 0;
        for (const FlatScope& scope : scopes_) elements += scope.element_ids.size();
        builder_.expect_elements(elements);
        for (std::size_t at = 0; at < scopes_.size(); ++at) add_elements(at);
        count_skipped();
        add_node_sets();
        Mesh mesh = builder_.finish();
        add_element_sets(mesh);
        if (node_members_.exhausted() || element_members_.exhausted()) {
            diagnostics_.add(
                Code::UnknownBlock,
                deck_.files.front().name(),
                "sets have too many members; some are left out"
            );
        }
        return mesh;
    }

private:
    /// The definitions of the one scope that there is, when nothing but the mesh needs its places any more.
    Scope* sole_table() {
        if (scopes_.size() != 1 || scopes_[0].tables.size() != 1) return nullptr;
        const Scope* const table = scopes_[0].tables[0];
        if (scopes_[0].placement.moves || scopes_[0].offset != 0 || !table->transforms.empty())
            return nullptr;
        if (table == &model_.model) return &model_.model;
        for (auto& [name, part] : model_.parts) {
            if (table == &part) return &part;
        }
        return nullptr;
    }

    void add_nodes() {
        if (Scope* const table = sole_table(); table != nullptr && model_.assembly.transforms.empty()) {
            std::vector<NodeId> ids;
            reserve_big(ids, table->node_ids.size());
            for (const Label label : table->node_ids) ids.push_back(NodeId{label});
            builder_.add_nodes(std::move(ids), std::move(table->places));
            builder_.seal_nodes();
            return;
        }
        std::size_t count = 0;
        for (const FlatScope& scope : scopes_) count += scope.node_ids.size();
        builder_.reserve_nodes(count);
        for (std::size_t at = 0; at < scopes_.size(); ++at) {
            const FlatScope& scope = scopes_[at];
            const auto angles = angles_at(at);
            for (const Scope* table : scope.tables) add_nodes_of(scope, *table, angles);
        }
        builder_.seal_nodes();
    }

    void add_nodes_of(
        const FlatScope& scope, const Scope& table, const std::map<Label, NodalAngles>& angles
    ) {
        std::vector<NodeId> ids;
        for (const Label label : table.node_ids) ids.push_back(scope.node(label));
        if (angles.empty() && !scope.placement.moves) {
            builder_.add_nodes(std::span<const NodeId>(ids), table.places);
            return;
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Point3 place =
                scope.placement.moves ? placed(scope.placement, table.places[i]) : table.places[i];
            const auto turned = angles.find(table.node_ids[i]);
            if (turned == angles.end()) {
                builder_.add_node(ids[i], place);
            } else {
                builder_.add_node(ids[i], place, turned->second);
            }
        }
    }

    /// Nodal systems of a scope's nodes by their labels. Those of the assembly may be for any scope's.
    std::map<Label, NodalAngles> angles_at(std::size_t wanted) {
        std::map<Label, NodalAngles> angles;
        for (std::size_t at = 0; at < scopes_.size(); ++at) {
            for (const Scope* table : scopes_[at].tables) {
                for (const NodeTransform& transform : table->transforms) {
                    const DeckSet* set = table->node_sets.find(transform.set);
                    if (set == nullptr) continue;
                    std::vector<Label> labels;
                    node_members_.for_each(at, *set, [&](std::size_t where, Label label) {
                        if (where == wanted) labels.push_back(label);
                    });
                    // Directions of a part turn with its instance; those of the assembly are global.
                    add_angles(scopes_[wanted], transform, at == wanted, labels, angles);
                }
            }
        }
        return angles;
    }

    static void add_angles(
        const FlatScope& scope,
        const NodeTransform& transform,
        bool of_instance,
        const std::vector<Label>& labels,
        std::map<Label, NodalAngles>& angles
    ) {
        if (labels.empty()) return;
        const std::set<Label> wanted(labels.begin(), labels.end());
        for (const Scope* table : scope.tables) {
            for (std::size_t i = 0; i < table->node_ids.size(); ++i) {
                if (!wanted.contains(table->node_ids[i])) continue;
                const Point3& place = table->places[i];
                auto axes = axes_at(transform.system, of_instance ? place : placed(scope.placement, place));
                if (axes && of_instance) axes = product(scope.placement.axes, *axes);
                if (axes) angles[table->node_ids[i]] = nodal_angles_of(*axes);
            }
        }
    }

    void add_elements(std::size_t at) {
        const FlatScope& scope = scopes_[at];
        if (scope.element_ids.empty()) return;
        const SectionParts parts(scopes_, at, element_members_);
        const std::map<Label, std::size_t> last_of = repeated_elements(scope);
        std::size_t row = 0;
        for (const Scope* table : scope.tables) {
            for (const ElementRun& run : table->runs) {
                if (last_of.empty() && scope.offset == 0 && !may_be_bare(run.type.shape)) {
                    add_run(scope, run, parts);
                    continue;
                }
                for (std::size_t i = 0; i < run.ids.size(); ++i, ++row) {
                    const auto repeated = last_of.find(run.ids[i]);
                    if (repeated != last_of.end() && repeated->second != row) continue;
                    add_element(
                        scope, run, i, by_section_ ? parts.name_of(run.ids[i], run) : part_name(scope)
                    );
                }
            }
        }
    }

    /// Types that are smaller ones without nodes on their faces.
    static bool may_be_bare(ElementType type) {
        return type == ElementType::Hex27 || type == ElementType::Wedge18;
    }

    /// Elements whose labels are their ids, each defined once.
    void add_run(const FlatScope& scope, const ElementRun& run, const SectionParts& parts) {
        constexpr std::size_t kMostAtOnce = std::size_t{1} << 16U;
        const std::size_t width = run.type.most_nodes;
        std::vector<ElementId> ids;
        for (std::size_t first = 0; first < run.ids.size();) {
            const std::size_t alike = by_section_ ? parts.alike_from(first, run) : run.ids.size() - first;
            const std::string& part = by_section_ ? parts.name_of(run.ids[first], run) : part_name(scope);
            for (const std::size_t end = first + alike; first < end;) {
                const std::size_t count = std::min(end - first, kMostAtOnce);
                ids.clear();
                for (const Label id : std::span(run.ids).subspan(first, count)) ids.push_back(ElementId{id});
                // Labels are not negative.
                const auto* const nodes =
                    reinterpret_cast<const std::uint32_t*>(run.nodes.data() + first * width);
                builder_.add_elements(
                    run.type.shape,
                    part_called(part),
                    ids,
                    {nodes, count * width},
                    [&](std::size_t) { return deck_.where(deck_.keywords[run.keyword]); }
                );
                first += count;
            }
        }
    }

    static const std::string& part_name(const FlatScope& scope) {
        static const std::string assembly = "assembly";
        return scope.name.empty() ? assembly : scope.name;
    }

    /// Ids that are defined more than once -> the row of the last definition, which counts.
    std::map<Label, std::size_t> repeated_elements(const FlatScope& scope) {
        std::map<Label, std::size_t> last;
        std::size_t rows = 0;
        for (const Scope* table : scope.tables) {
            for (const ElementRun& run : table->runs) rows += run.ids.size();
        }
        if (rows == scope.element_ids.size()) return last;
        std::size_t row = 0;
        for (const Scope* table : scope.tables) {
            for (const ElementRun& run : table->runs) {
                for (const Label id : run.ids) last[id] = row++;
            }
        }
        diagnostics_.add(
            Code::DuplicateElement,
            deck_.files.front().name(),
            "elements are defined more than once; the last definition counts",
            rows - last.size()
        );
        return last;
    }

    void add_element(
        const FlatScope& scope, const ElementRun& run, std::size_t row, const std::string& part
    ) {
        const std::size_t width = run.type.most_nodes;
        std::array<NodeId, kMaxElementNodes> nodes{};
        for (std::size_t i = 0; i < width; ++i) {
            const Label label = run.nodes[row * width + i];
            nodes[i] = label == 0 ? NodeId{0} : scope.node(label);
        }
        ElementType type = run.type.shape;
        std::size_t count = width;
        // Without nodes on its faces it is the smaller element.
        const auto bare = [&](std::size_t first) {
            return std::all_of(&nodes[first], &nodes[width - 1] + 1, [](NodeId id) {
                return id == NodeId{0};
            });
        };
        if (type == ElementType::Hex27 && bare(20)) type = ElementType::Hex20, count = 20;
        if (type == ElementType::Wedge18 && bare(15)) type = ElementType::Wedge15, count = 15;
        builder_.add_element(
            scope.element(run.ids[row]),
            type,
            std::span(nodes).first(count),
            part_called(part),
            [&] { return deck_.where(deck_.keywords[run.keyword]); }
        );
    }

    /// Elements of a part follow each other: its name is looked up once.
    PartIndex part_called(const std::string& name) {
        if (!last_part_ || name != last_part_name_) {
            last_part_ = builder_.part(name);
            last_part_name_ = name;
        }
        return *last_part_;
    }

    void count_skipped() {
        for (const auto& [name, count] : model_.skipped) builder_.skip_element(name, count);
        if (model_.instances.empty()) {
            for (const auto& [part, skipped] : model_.skipped_in_parts) {
                for (const auto& [name, count] : skipped) builder_.skip_element(name, count);
            }
        }
        for (const Instance& instance : model_.instances) {
            const auto found = model_.skipped_in_parts.find(instance.part);
            if (found == model_.skipped_in_parts.end()) continue;
            for (const auto& [name, count] : found->second) builder_.skip_element(name, count);
        }
    }

    /// "Set", or "Instance.Set" where several instances may have it.
    std::string set_name(const FlatScope& scope, const DeckSet& set) const {
        const std::size_t named = model_.instances.empty() ? model_.parts.size() : model_.instances.size();
        return scope.name.empty() || named < 2 ? set.name : scope.name + "." + set.name;
    }

    void add_node_sets() {
        for (std::size_t at = 0; at < scopes_.size(); ++at) {
            for (const Scope* table : scopes_[at].tables) {
                for (const DeckSet& set : table->node_sets.all()) {
                    if (set.internal) continue;
                    std::vector<NodeId> ids;
                    node_members_.for_each(at, set, [&](std::size_t where, Label label) {
                        ids.push_back(scopes_[where].node(label));
                    });
                    sort_and_unite(ids);
                    builder_.add_node_set(set_name(scopes_[at], set), ids);
                }
            }
        }
    }

    void add_element_sets(Mesh& mesh) {
        const ElementLookup lookup(mesh);
        for (std::size_t at = 0; at < scopes_.size(); ++at) {
            for (const Scope* table : scopes_[at].tables) {
                for (const DeckSet& set : table->element_sets.all()) {
                    if (set.internal) continue;
                    std::vector<ElementId> ids;
                    element_members_.for_each(at, set, [&](std::size_t where, Label label) {
                        ids.push_back(scopes_[where].element(label));
                    });
                    sort_and_unite(ids);
                    add_element_set(mesh, lookup, set_name(scopes_[at], set), ids);
                }
            }
        }
    }

    const Deck& deck_;
    DeckModel& model_;
    Diagnostics& diagnostics_;
    std::vector<FlatScope> scopes_;
    MeshBuilder builder_;
    SetMembers node_members_, element_members_;
    bool by_section_ = true;
    std::optional<PartIndex> last_part_;
    std::string last_part_name_;
};

}  // namespace

Mesh build_mesh(const Deck& deck, DeckModel& model, Diagnostics& diagnostics) {
    return MeshMaker(deck, model, diagnostics).make();
}

}  // namespace feelem::abaqus
