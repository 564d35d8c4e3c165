// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_model.hpp"

#include "read/abaqus/deck_elements.hpp"
#include "read/abaqus/deck_generate.hpp"
#include "read/abaqus/keyword_rows.hpp"
#include "read/abaqus/plain_rows.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace feelem::abaqus {
namespace {

/// Goes through the keywords; knows in which scope it is.
class ModelReader {
public:
    ModelReader(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

    DeckModel read() {
        for (std::size_t i = 0; i < deck_.keywords.size(); ++i) {
            const Keyword& keyword = deck_.keywords[i];
            if (!enter_or_leave(keyword)) use(keyword, i);
        }
        for (Scope* scope : {&model_.model, &model_.assembly}) scope->index = {};
        for (auto& [name, part] : model_.parts) part.index = {};
        for (Instance& instance : model_.instances) instance.own.index = {};
        return std::move(model_);
    }

private:
    enum class Place : std::uint8_t {
        Model,
        Part,
        Assembly,
        Instance
    };

    /// Whether the keyword opens or closes a scope.
    bool enter_or_leave(const Keyword& keyword) {
        if (keyword.name == "PART") {
            place_ = Place::Part;
            part_ = folded(keyword.value("NAME"));
            model_.parts.try_emplace(part_);
        } else if (keyword.name == "ASSEMBLY" || keyword.name == "ENDINSTANCE") {
            place_ = Place::Assembly;
        } else if (keyword.name == "ENDPART" || keyword.name == "ENDASSEMBLY") {
            place_ = Place::Model;
        } else if (keyword.name == "INSTANCE") {
            place_ = Place::Instance;
            begin_instance(keyword);
        } else {
            return false;
        }
        system_ = {};
        return true;
    }

    void begin_instance(const Keyword& keyword) {
        Instance instance;
        instance.name = keyword.value("NAME");
        instance.part = folded(keyword.value("PART"));
        instance.placement = read_placement(keyword);
        model_.instances.push_back(std::move(instance));
        if (keyword.has("INSTANCE") || keyword.has("LIBRARY"))
            report(keyword, "*INSTANCE takes its mesh from the results of another job, which are not read");
    }

    /// Up to two lines: a translation, then a rotation about an axis by an angle.
    Placement read_placement(const Keyword& keyword) {
        DataLines lines(deck_, keyword);
        Placement placement;
        for (int at = 0; at < 2; ++at) {
            auto line = lines.next();
            if (!line) break;
            std::array<double, 7> values{};
            for (double& value : values) value = take_number(*line, 0, deck_, lines);
            const Placement move =
                at == 0 ? translation({values[0], values[1], values[2]})
                        : rotation(
                              {values[0], values[1], values[2]}, {values[3], values[4], values[5]}, values[6]
                          );
            placement = combined(move, placement);
        }
        return placement;
    }

    Scope& scope() {
        switch (place_) {
        case Place::Part: return model_.parts[part_];
        case Place::Assembly: return model_.assembly;
        case Place::Instance: return model_.instances.back().own;
        case Place::Model: break;
        }
        return model_.model;
    }

    void use(const Keyword& keyword, std::size_t index) {
        const std::string& name = keyword.name;
        if (name == "NODE") {
            read_nodes(keyword);
        } else if (name == "ELEMENT") {
            elements(keyword, index);
        } else if (name == "NSET") {
            read_set(keyword, scope().node_sets, keyword.value("NSET"));
            if (keyword.has("ELSET")) {
                Generation job = generation(keyword, index);
                add_nodes_of_elements(job);
            }
        } else if (name == "ELSET") {
            read_set(keyword, scope().element_sets, keyword.value("ELSET"));
        } else if (name == "SYSTEM") {
            read_system(keyword);
        } else if (name == "TRANSFORM") {
            read_transform(keyword);
        } else if (is_generator(name)) {
            Generation job = generation(keyword, index);
            generate(job);
        } else if (name.ends_with("SECTION")) {
            if (keyword.has("ELSET")) scope().sections.push_back(keyword.value("ELSET"));
        } else if (name != "USERELEMENT") {
            report(keyword, fmt::format("*{} is not carried out; what it makes is missing", name));
        }
    }

    void report(const Keyword& keyword, const std::string& text) {
        diagnostics_.add(
            Code::UnknownBlock, [&] { return deck_.where(keyword); }, text
        );
    }

    void read_nodes(const Keyword& keyword) {
        Scope& into = scope();
        const SystemKind kind = system_kind(keyword.value("SYSTEM"));
        DeckSet* set = keyword.has("NSET") ? &into.node_sets.get(keyword.value("NSET")) : nullptr;
        DataLines lines(deck_, keyword);
        const std::size_t before = into.node_ids.size();
        PlainNodes rows{std::move(into.node_ids), std::move(into.places)};
        read_rows(lines, rows, [&](std::string_view line) {
            const Label id = take_label(line, deck_, lines);
            if (id == 0) throw_bad_number("", "the number of a node", deck_, lines);
            Point3 place;
            for (double& x : place) x = take_number(line, 0, deck_, lines);
            rows.ids.push_back(id);
            rows.places.push_back(place);
            return true;
        });
        into.node_ids = std::move(rows.ids);
        into.places = std::move(rows.places);
        lines.release();
        for (Point3& place : std::span(into.places).subspan(before)) {
            if (kind != SystemKind::Rectangular) place = cartesian(kind, place);
            if (system_.moves) place = placed(system_, place);
        }
        if (set == nullptr) return;
        for (const Label id : std::span(into.node_ids).subspan(before)) add_label(*set, id);
    }

    void elements(const Keyword& keyword, std::size_t index) {
        ElementRun run = read_elements(deck_, keyword, diagnostics_);
        run.keyword = index;
        if (run.type.use == Use::Skip) skipped()[run.type_name] += run.ids.size();
        Scope& into = scope();
        if (!run.set.empty()) {
            DeckSet& set = into.element_sets.get(run.set);
            for (const Label id : run.ids) add_label(set, id);
        }
        (run.type.use == Use::Shape ? into.runs : into.others).push_back(std::move(run));
    }

    std::map<std::string, std::uint64_t>& skipped() {
        return place_ == Place::Part ? model_.skipped_in_parts[part_] : model_.skipped;
    }

    Generation generation(const Keyword& keyword, std::size_t index) {
        return {deck_, keyword, index, scope(), system_, skipped(), budget_, diagnostics_};
    }

    void read_set(const Keyword& keyword, SetTable& table, const std::string& name) {
        DeckSet& set = table.get(name);
        set.internal = set.internal || keyword.has("INTERNAL");
        const std::string instance = folded(keyword.value("INSTANCE"));
        const bool generate = keyword.has("GENERATE");
        set.unsorted = set.unsorted || keyword.has("UNSORTED");
        DataLines lines(deck_, keyword);
        while (auto line = lines.next()) {
            if (generate) {
                LabelRange range;
                range.first = take_label(*line, deck_, lines);
                range.last = take_label(*line, deck_, lines);
                range.step = std::max(take_label(*line, deck_, lines), 1);
                if (range.last >= range.first) add_range(set, instance, range);
                continue;
            }
            while (!line->empty()) add_member(set, instance, take_field(*line));
        }
        lines.release();
    }

    void add_member(DeckSet& set, const std::string& instance, std::string_view field) {
        if (field.empty()) return;
        if (const auto label = label_of(field)) {
            add_range(set, instance, {*label, *label, 1});
            return;
        }
        // "Part-1-1.12" or "Part-1-1.Set": in an assembly the instance may stand before the last point.
        const std::size_t point = field.rfind('.');
        if (instance.empty() && point != std::string_view::npos && place_ == Place::Assembly) {
            const std::string before = folded(field.substr(0, point));
            const auto named = [&](const Instance& one) { return folded(one.name) == before; };
            if (std::ranges::any_of(model_.instances, named)) {
                const std::string_view behind = field.substr(point + 1);
                if (const auto label = label_of(behind)) {
                    add_range(set, before, {*label, *label, 1});
                } else {
                    add_set(set, before, folded(behind));
                }
                return;
            }
        }
        add_set(set, instance, folded(field));
    }

    void read_system(const Keyword& keyword) {
        DataLines lines(deck_, keyword);
        system_ = {};
        auto line = lines.next();
        if (!line) return;
        const auto point = [&]() -> std::optional<Point3> {
            if (trim(*line).empty()) return {};
            Point3 out;
            for (double& x : out) x = take_number(*line, 0, deck_, lines);
            return out;
        };
        const Point3 origin = point().value_or(Point3{});
        const auto on_x = point();
        std::optional<Point3> in_plane;
        if ((line = lines.next())) in_plane = point();
        system_ = system_placement(origin, on_x, in_plane);
    }

    void read_transform(const Keyword& keyword) {
        DataLines lines(deck_, keyword);
        auto line = lines.next();
        NodeTransform transform;
        transform.set = folded(keyword.value("NSET"));
        transform.system.kind = system_kind(keyword.value("TYPE"));
        if (!line) return;
        for (Point3* point : {&transform.system.a, &transform.system.b}) {
            for (double& x : *point) x = take_number(*line, 0, deck_, lines);
        }
        scope().transforms.push_back(std::move(transform));
    }

    const Deck& deck_;
    Diagnostics& diagnostics_;
    DeckModel model_;
    Place place_ = Place::Model;
    std::string part_;
    Placement system_;
    GenerationBudget budget_;
};

/// The last piece, or a new one: sets of a piece stand behind its ranges.
SetPiece& piece_of(DeckSet& set, const std::string& instance, bool for_range) {
    if (set.pieces.empty() || set.pieces.back().instance != instance ||
        (for_range && set.unsorted && !set.pieces.back().sets.empty()))
        set.pieces.push_back({instance, {}, {}});
    return set.pieces.back();
}

}  // namespace

DeckSet& SetTable::get(const std::string& name) {
    const auto [found, is_new] = by_name_.try_emplace(folded(name), sets_.size());
    if (is_new) sets_.push_back({name, false, false, {}});
    return sets_[found->second];
}

const DeckSet* SetTable::find(const std::string& folded_name) const {
    const auto found = by_name_.find(folded_name);
    return found == by_name_.end() ? nullptr : &sets_[found->second];
}

void add_label(DeckSet& set, Label label) {
    add_range(set, {}, {label, label, 1});
}

void add_range(DeckSet& set, const std::string& instance, LabelRange range) {
    std::vector<LabelRange>& ranges = piece_of(set, instance, true).ranges;
    if (!ranges.empty()) {
        LabelRange& last = ranges.back();
        if (last.step == 1 && range.step == 1 && range.first == std::int64_t{last.last} + 1) {
            last.last = range.last;
            return;
        }
    }
    ranges.push_back(range);
}

void add_set(DeckSet& set, const std::string& instance, std::string folded_name) {
    piece_of(set, instance, false).sets.push_back(std::move(folded_name));
}

SystemKind system_kind(const std::string& letter) {
    const std::string word = folded(letter);
    if (word.starts_with('C')) return SystemKind::Cylindrical;
    if (word.starts_with('S')) return SystemKind::Spherical;
    return SystemKind::Rectangular;
}

DeckModel read_deck(const Deck& deck, Diagnostics& diagnostics) {
    return ModelReader(deck, diagnostics).read();
}

}  // namespace feelem::abaqus
