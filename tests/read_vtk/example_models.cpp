// SPDX-License-Identifier: Apache-2.0
#include "example_models.hpp"

#include "feelem/element_type.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace feelem::test {
namespace {

constexpr std::size_t kMissingNode = 4;
constexpr double kTimes[]{0.5, 2.0};

using Row = std::vector<double>;

// The script's formulas, from tests/data/exchange/make/models.py.
Row temperature(double id, double step) {
    return {id * 0.25 * (step + 1)};
}
Row displacement(double id, double step) {
    return {id * (step + 1) / 8, -id / 2, step + 0.125};
}
Row density(double id, double step) {
    return {id * (step + 1) / 8};
}
Row damage(double id, double step) {
    return {step - id / 16};
}
Row stress(double id, double step) {
    Row row;
    for (int k = 0; k < 6; ++k) row.push_back(id * (step + 1) + k / 4.0);
    return row;
}

class Comparison {
public:
    Comparison(ModelSource& model, const Example& example, const Kept& kept)
        : model_(model), mesh_(model.mesh()), example_(example), kept_(kept) {}

    void expect_all() {
        expect_mesh();
        if (testing::Test::HasFailure()) return;
        expect_steps();
        expect_results();
    }

private:
    bool is_read(const ExampleElement& element) const {
        return std::ranges::find(kept_.unread, element.type) == kept_.unread.end();
    }

    std::string part_of(const ExampleElement& element) const {
        switch (kept_.parts) {
        case Kept::Parts::Named: return element.part;
        case Kept::Parts::OnePerType:
            return fmt::format("{}_{}", element.part, element_row(element.type).name);
        case Kept::Parts::None: break;
        }
        return "mesh";
    }

    /// Each type stands once in a model: it tells which element is which whatever its id.
    const ExampleElement* twin_of(ElementType type) const {
        for (const ExampleElement& one : example_.elements) {
            if (one.type == type && is_read(one)) return &one;
        }
        return nullptr;
    }

    void expect_mesh() {
        std::size_t read = 0;
        for (const ExampleElement& one : example_.elements) read += is_read(one) ? 1U : 0U;
        ASSERT_EQ(mesh_.element_count(), read);
        std::size_t index = 0;
        for (const ElementBlock& block : mesh_.blocks) {
            const ExampleElement* const twin = twin_of(block.type);
            ASSERT_NE(twin, nullptr) << element_row(block.type).name;
            SCOPED_TRACE(element_row(block.type).name);
            ASSERT_EQ(block.ids.size(), 1U);
            twins_[index++] = twin;
            if (kept_.element_ids) {
                EXPECT_EQ(raw(block.ids[0]), twin->id);
            }
            EXPECT_EQ(mesh_.parts[raw(block.parts[0])].name, part_of(*twin));
            for (std::size_t i = 0; i < twin->nodes.size(); ++i)
                EXPECT_EQ(mesh_.coordinates[raw(block.nodes[i])], example_.points[twin->nodes[i]]) << i;
        }
        expect_nodes();
    }

    void expect_nodes() {
        std::set<Point3> places;
        for (std::size_t i = 0; i < mesh_.node_count(); ++i) {
            const auto at = std::ranges::find(example_.points, mesh_.coordinates[i]);
            ASSERT_NE(at, example_.points.end());
            const auto twin = static_cast<std::size_t>(at - example_.points.begin());
            points_.push_back(twin);
            places.insert(*at);
            if (kept_.node_ids)
                EXPECT_EQ(raw(mesh_.node_ids[i]), example_.node_ids[twin]);
            else
                EXPECT_EQ(raw(mesh_.node_ids[i]), static_cast<std::int64_t>(i) + 1);
        }
        EXPECT_EQ(places.size(), example_.points.size());
        if (kept_.one_node_a_point) {
            EXPECT_EQ(mesh_.node_count(), example_.points.size());
        }
    }

    void expect_steps() {
        ASSERT_EQ(model_.steps().size(), kept_.steps.size());
        for (std::size_t s = 0; s < kept_.steps.size(); ++s) {
            const Step& step = model_.steps()[s];
            EXPECT_EQ(step.step, static_cast<int>(s) + 1);
            EXPECT_EQ(step.value, kept_.times ? kTimes[kept_.steps[s]] : 0);
        }
    }

    void expect_results() {
        std::map<std::string, Row (*)(double, double)> formulas{
            {"temperature", temperature}, {"displacement", displacement}, {"density", density}};
        if (kept_.damage) formulas["damage"] = damage;
        if (kept_.stress) formulas["stress"] = stress;
        EXPECT_EQ(model_.results().size(), formulas.size() * kept_.steps.size());
        std::set<std::pair<std::string, std::uint32_t>> seen;
        for (std::size_t i = 0; i < model_.results().size(); ++i) {
            const ResultInfo info = model_.results()[i];
            SCOPED_TRACE(fmt::format("{} at step {}", info.name, info.step));
            ASSERT_TRUE(formulas.contains(info.name));
            EXPECT_TRUE(seen.emplace(info.name, info.step).second);
            const bool nodal = info.name == "temperature" || info.name == "displacement";
            EXPECT_EQ(info.location, nodal ? Location::Nodal : Location::Elemental);
            expect_values(model_.load(i), formulas[info.name]);
        }
    }

    void expect_values(const Result& result, Row (*formula)(double, double)) {
        const bool nodal = result.info.location == Location::Nodal;
        const std::size_t step = kept_.steps[result.info.step], width = result.component_count();
        ASSERT_EQ(result.row_count(), nodal ? mesh_.node_count() : mesh_.element_count());
        for (std::size_t i = 0; i < result.row_count(); ++i) {
            const std::int64_t id = nodal ? example_.node_ids[points_[i]] : twins_[i]->id;
            const Row right = formula(static_cast<double>(id), static_cast<double>(step));
            ASSERT_EQ(width, right.size());
            for (std::size_t c = 0; c < width; ++c) {
                const float value = result.values[i * width + c];
                if (is_missing(result.info.name, i, step))
                    EXPECT_TRUE(std::isnan(value)) << id;
                else
                    EXPECT_EQ(value, static_cast<float>(right[c])) << id << " component " << c;
            }
        }
    }

    bool is_missing(const std::string& name, std::size_t row, std::size_t step) {
        if (name == "damage") return twins_[row]->part != "lower";
        return name == "temperature" && kept_.missing_node && step == 1 && points_[row] == kMissingNode;
    }

    ModelSource& model_;
    const Mesh& mesh_;
    const Example& example_;
    const Kept& kept_;
    std::map<std::size_t, const ExampleElement*> twins_;  ///< By index of the element.
    std::vector<std::size_t> points_;                     ///< By index of the node.
};

}  // namespace

Example stack_example() {
    Example example;
    example.points = {
        {0, 0, 0},
        {1, 0, 0},
        {1, 1, 0},
        {0, 1, 0},
        {0, 0, 1},
        {1, 0, 1},
        {1, 1, 1},
        {0, 1, 1},
        {2, 0, 0},
        {2, 0, 1},
        {0, 0, 2},
        {1, 0, 2},
        {3, 0, 0},
        {3, 0, 1}};
    for (std::int64_t i = 0; i < 14; ++i) example.node_ids.push_back(100 + 7 * i);
    example.elements = {
        {ElementType::Hex8, "lower", 1009, {0, 1, 2, 3, 4, 5, 6, 7}},
        {ElementType::Wedge6, "lower", 1006, {1, 8, 2, 5, 9, 6}},
        {ElementType::Pyramid5, "upper", 2003, {4, 5, 6, 7, 10}},
        {ElementType::Tet4, "upper", 2000, {5, 9, 6, 11}},
        {ElementType::Quad4, "upper", 3000, {8, 12, 13, 9}}};
    return example;
}

Example curved_example() {
    const std::vector<std::pair<ElementType, std::vector<Point3>>> corners{
        {ElementType::Hex20,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
        {ElementType::Wedge15, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}}},
        {ElementType::Pyramid13, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1.5}}},
        {ElementType::Tet10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {ElementType::Quad8, {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}},
        {ElementType::Tri6, {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}}};
    Example example;
    for (const auto& [type, own] : corners) {
        const auto place = static_cast<std::int64_t>(example.elements.size());
        const std::size_t first = example.points.size();
        ExampleElement element{type, place < 2 ? "lower" : "upper", 50 - 3 * place, {}};
        std::vector<Point3> all = own;
        for (const EdgeRow& edge : edges_of(type)) {
            all.resize(std::max<std::size_t>(all.size(), edge.middle + 1U));
            for (std::size_t k = 0; k < 3; ++k)
                all[edge.middle][k] = (own[edge.first][k] + own[edge.second][k]) / 2;
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            element.nodes.push_back(first + i);
            example.node_ids.push_back(static_cast<std::int64_t>(3 * (first + i) + 2));
            example.points.push_back({all[i][0] + 3 * static_cast<double>(place), all[i][1], all[i][2]});
        }
        example.elements.push_back(std::move(element));
    }
    return example;
}

void expect_example(ModelSource& model, const Example& example, const Kept& kept) {
    Comparison(model, example, kept).expect_all();
}

}  // namespace feelem::test
