// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/nastran/coordinate_systems.hpp"
#include "read/nastran/nastran_elements.hpp"
#include "read/nastran/op2_element_cards.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace feelem::op2 {
namespace {

using nastran::CoordinateSystems;
using nastran::SystemKind;

constexpr std::size_t kHeadWords = 3;
/// Third words of heads are above this where reals are float64.
constexpr std::int64_t kDoubleHead = 1000000;
constexpr std::int64_t kGridKey = 4501;
constexpr std::int64_t kScalarPointKey = 5551;
constexpr std::int64_t kPlotKey = 5201;
constexpr std::int64_t kEndKey = 65535;
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

struct Grid {
    std::int64_t id = 0;
    std::int64_t place_system = 0;
    Point3 place{};
    std::int64_t motion_system = 0;
};

struct SystemRecord {
    std::int64_t key;
    SystemKind kind;
    bool by_grids;
};
constexpr SystemRecord kSystems[]{
    {1701, SystemKind::Cylindrical, true},
    {1801, SystemKind::Rectangular, true},
    {1901, SystemKind::Spherical, true},
    {2001, SystemKind::Cylindrical, false},
    {2101, SystemKind::Rectangular, false},
    {2201, SystemKind::Spherical, false},
};

/// Reals of a card: one word each, or two where they are float64 in words of four bytes.
struct Reals {
    const Words& words;
    bool wide;

    std::size_t width() const { return wide ? 2 : 1; }
    double at(std::size_t first, std::size_t i) const {
        const std::size_t word = first + i * width();
        return wide ? words.wide_real(word) : words.real(word);
    }
    Point3 point(std::size_t first, std::size_t i) const {
        return {at(first, 3 * i), at(first, 3 * i + 1), at(first, 3 * i + 2)};
    }
};

class GeometryReader {
public:
    GeometryReader(const Input& input, const Layout& layout, Diagnostics& diagnostics)
        : input_(input), layout_(layout), diagnostics_(diagnostics), builder_(diagnostics) {}

    Mesh read() {
        for_each_card([&](const Table& table, std::size_t, const Words& words) { read_places(table, words); }
        );
        if (grids_.empty()) grids_ = grids_of_tables();
        if (grids_.empty()) return {};
        add_nodes();
        // A PLOTEL may carry the number of an element: then it is left out, whichever comes first.
        for (const bool plots : {false, true}) {
            std::ranges::sort(used_ids_);
            for_each_card([&](const Table& table, std::size_t record, const Words& words) {
                if ((words.integer(0) == kPlotKey) == plots) read_elements(table, record, words);
            });
        }
        return builder_.finish();
    }

private:
    template <class Each>
    void for_each_card(const Each& each) {
        for (const Table& table : layout_.tables) {
            if (!table.name.starts_with("GEOM") || table.matrix) continue;
            for (std::size_t i = table.first_record; i < table.last_record; ++i) {
                const Words words = record_words(input_, layout_, i, scratch_);
                if (words.count() > kHeadWords) each(table, i, words);
            }
        }
    }

    /// The same cards may stand in GEOM1 and GEOM1S: those of the first table count.
    bool is_first(const Table& table, std::int64_t key) {
        return first_tables_.try_emplace(key, table.first_record).first->second == table.first_record;
    }

    std::string where(std::size_t record) const {
        const auto segments = layout_.record(record);
        return input_.where_byte(segments.empty() ? 0 : segments.front().first);
    }

    void read_places(const Table& table, const Words& words) {
        const std::int64_t key = words.integer(0);
        const bool wide = words.integer(2) >= kDoubleHead && layout_.form.size == 4;
        const Words entries = words.part(kHeadWords, words.count() - kHeadWords);
        if (key == kGridKey && is_first(table, key)) read_grids(entries, wide);
        if (key == kScalarPointKey && is_first(table, key)) {
            for (std::size_t i = 0; i < entries.count(); ++i) {
                if (entries.integer(i) > 0) scalar_points_.insert(entries.integer(i));
            }
        }
        for (const SystemRecord& record : kSystems) {
            if (record.key == key && is_first(table, key)) read_systems(record, entries, wide);
        }
    }

    void read_grids(const Words& entries, bool wide) {
        const Reals reals{entries, wide};
        const std::size_t width = 5 + 3 * reals.width();
        if (entries.count() % width != 0) report_card("GRID");
        for (std::size_t at = 0; at + width <= entries.count(); at += width) {
            const Point3 place = reals.point(at + 2, 0);
            const std::size_t motion = at + 2 + 3 * reals.width();
            grids_.push_back({entries.integer(at), entries.integer(at + 1), place, entries.integer(motion)});
        }
    }

    void read_systems(const SystemRecord& record, const Words& entries, bool wide) {
        const Reals reals{entries, wide};
        const std::size_t width = record.by_grids ? 6 : 4 + 9 * reals.width();
        if (entries.count() % width != 0) report_card("CORD");
        for (std::size_t at = 0; at + width <= entries.count(); at += width) {
            nastran::SystemCard card;
            card.id = entries.integer(at);
            card.kind = record.kind;
            card.by_grids = record.by_grids;
            if (record.by_grids) {
                for (std::size_t i = 0; i < 3; ++i) card.grids[i] = entries.integer(at + 3 + i);
            } else {
                card.reference = entries.integer(at + 3);
                for (std::size_t i = 0; i < 3; ++i) card.points[i] = reals.point(at + 4, i);
            }
            systems_.add(std::move(card));
        }
    }

    void report_card(const std::string& name) {
        diagnostics_.add(
            Code::UnknownBlock,
            input_.name(),
            fmt::format("{} stands in the geometry tables in a form that Feelem does not know", name)
        );
    }

    const Table* find_table(std::string_view start) const {
        const auto found = std::ranges::find_if(layout_.tables, [&](const Table& table) {
            return table.name.starts_with(start) && table.last_record > table.first_record;
        });
        return found == layout_.tables.end() ? nullptr : &*found;
    }

    /// GPL lists the ids; BGPDT, in the same order, systems of motion and places, GPDT places in any system.
    std::vector<Grid> grids_of_tables() {
        constexpr std::size_t kBasicWords = 4;
        constexpr std::size_t kPlaceWords = 7;
        if (const Table* list = find_table("GPL")) {
            std::vector<std::byte> other;
            const Words ids = record_words(input_, layout_, list->first_record, scratch_);
            for (const auto& [name, width] :
                 {std::pair("BGPDT", kBasicWords), std::pair("GPDT", kPlaceWords)}) {
                const Table* places = find_table(name);
                if (places == nullptr) continue;
                const Words rows = record_words(input_, layout_, places->first_record, other);
                if (rows.count() == width * ids.count()) return grids_of(ids, rows, width);
                report_card(name);
            }
        }
        return {};
    }

    std::vector<Grid> grids_of(const Words& ids, const Words& rows, std::size_t width) {
        constexpr std::size_t kPlaceWords = 7;
        std::vector<Grid> grids;
        for (std::size_t i = 0; i < ids.count(); ++i) {
            const std::size_t at = i * width;
            const bool has_system = width == kPlaceWords;
            const std::size_t first = at + (has_system ? 2 : 1);
            const std::int64_t motion = rows.integer(has_system ? at + 5 : at);
            const std::int64_t system = has_system ? rows.integer(at + 1) : 0;
            if ((has_system ? system : motion) < 0) {
                scalar_points_.insert(ids.integer(i));
            } else {
                const Point3 place{rows.real(first), rows.real(first + 1), rows.real(first + 2)};
                grids.push_back({ids.integer(i), system, place, motion});
            }
        }
        return grids;
    }

    void add_nodes() {
        std::map<std::int64_t, std::size_t> by_id;
        if (systems_.count() > 0) {
            for (std::size_t i = 0; i < grids_.size(); ++i) by_id[grids_[i].id] = i;
        }
        const auto find_grid = [&](std::int64_t id) -> std::optional<nastran::GridPlace> {
            const auto found = by_id.find(id);
            if (found == by_id.end()) return {};
            return nastran::GridPlace{grids_[found->second].place_system, grids_[found->second].place};
        };
        systems_.resolve(find_grid, diagnostics_);
        builder_.reserve_nodes(grids_.size() + scalar_points_.size());
        for (const Grid& grid : grids_) add_grid(grid);
        for (const std::int64_t id : scalar_points_)
            builder_.add_node(NodeId{id}, {kNowhere, kNowhere, kNowhere});
        builder_.seal_nodes();
    }

    void add_grid(const Grid& grid) {
        Point3 place = grid.place;
        if (grid.place_system > 0) place = systems_.to_basic(grid.place_system, grid.place);
        const bool is_finite = std::ranges::all_of(place, [](double x) { return std::isfinite(x); });
        if (!is_finite) {
            diagnostics_.add(Code::NonFiniteValue, input_.name(), "grids have no finite place");
            place = {kNowhere, kNowhere, kNowhere};
        }
        scalar_points_.erase(grid.id);
        const bool turned = grid.motion_system > 0 && is_finite;
        if (turned && !systems_.known(grid.motion_system)) report_motion(grid.motion_system);
        builder_.add_node(
            NodeId{grid.id}, place, turned ? systems_.angles_at(grid.motion_system, place) : NodalAngles{}
        );
    }

    void report_motion(std::int64_t system) {
        diagnostics_.add(
            Code::CoordinateSystem,
            input_.name(),
            fmt::format("grids move in system {}, which the file does not define: taken as global", system)
        );
    }

    void read_elements(const Table& table, std::size_t record, const Words& words) {
        const std::int64_t key = words.integer(0);
        if (!table.name.starts_with("GEOM2") && table.name != "GEOM") return;
        if (key == kEndKey || key == kGridKey || !is_first(table, key)) return;
        const CardRecord* card = find_card_record(key, words.integer(1));
        if (card == nullptr) {
            report_card(fmt::format("card ({}, {}, {})", key, words.integer(1), words.integer(2)));
            return;
        }
        if (card->name.empty()) return;
        const Words entries = words.part(kHeadWords, words.count() - kHeadWords);
        const std::size_t width = entry_words(*card, entries);
        if (width == 0) {
            report_card(std::string(card->name));
            return;
        }
        for (std::size_t at = 0; at < entries.count(); at += width)
            add_element(*card, entries.part(at, width), record);
    }

    void add_element(const CardRecord& record, const Words& entry, std::size_t at) {
        if (record.node_words == 0) {
            builder_.skip_element(record.name);
            return;
        }
        const std::int64_t id = entry.integer(0);
        if (record.key == kPlotKey && std::ranges::binary_search(used_ids_, id)) {
            builder_.skip_element(record.name);
            return;
        }
        if (record.key != kPlotKey) used_ids_.push_back(id);
        const nastran::ElementCard* card = nastran::find_element_card(record.name);
        if (card == nullptr) return;
        std::array<std::int64_t, kMaxElementNodes> nodes{};
        for (std::size_t i = 0; i < record.node_words; ++i) nodes[i] = entry.integer(record.first_node + i);
        const auto arranged = nastran::arrange_nodes(*card, std::span(nodes).first(record.node_words));
        if (!arranged) {
            report_card(fmt::format("{} without a corner", record.name));
            return;
        }
        builder_.add_element(
            ElementId{id},
            arranged->type,
            std::span(arranged->nodes).first(arranged->count),
            part_of(record, entry),
            [&] { return where(at); }
        );
    }

    PartIndex part_of(const CardRecord& record, const Words& entry) {
        constexpr std::uint8_t kNodesAfterProperty = 2;
        if (record.first_node < kNodesAfterProperty) return builder_.part(record.name);
        return builder_.part(fmt::format("property {}", entry.integer(1)));
    }

    const Input& input_;
    const Layout& layout_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    CoordinateSystems systems_;
    std::vector<Grid> grids_;
    std::set<std::int64_t> scalar_points_;
    std::map<std::int64_t, std::size_t> first_tables_;
    std::vector<std::int64_t> used_ids_;  ///< Of elements that are no PLOTELs.
    std::vector<std::byte> scratch_;
};

}  // namespace

Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics) {
    return GeometryReader(input, layout, diagnostics).read();
}

}  // namespace feelem::op2
