// SPDX-License-Identifier: Apache-2.0
// Our own small file of every exchange format (tests/data/exchange): all that the script wrote comes out, or
// the page of the format says what does not.
#include "example_models.hpp"
#include "support/exchange_checks.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::curved_example;
using test::expect_example;
using test::Kept;
using test::stack_example;
using testing::ElementsAre;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

/// Skips what this build has no library for.
class ExchangeExamples : public testing::Test {
protected:
    ModelSource* open(const std::string& file) {
        try {
            model_ = open_model(
                std::vector<std::string>{test::project_file("tests/data/exchange/" + file)}, {}, diagnostics_
            );
        } catch (const Error& error) {
            if (error.code() != Code::UnsupportedFormat) throw;
            return nullptr;
        }
        EXPECT_EQ(test::wrong_node_order(model_->mesh()), "");
        return model_.get();
    }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    Diagnostics diagnostics_;
    std::unique_ptr<ModelSource> model_;
};

#define OPEN_OR_SKIP(model, file)                                                                            \
    ModelSource* const model = open(file);                                                                   \
    if (model == nullptr) GTEST_SKIP() << "this build has no library for it"

TEST_F(ExchangeExamples, exodus_has_everything) {
    OPEN_OR_SKIP(model, "exodus/stack.exo");
    expect_example(*model, stack_example(), {.parts = Kept::Parts::OnePerType});
    EXPECT_TRUE(diagnostics().entries().empty());
}

TEST_F(ExchangeExamples, exodus_of_second_order_has_everything) {
    OPEN_OR_SKIP(model, "exodus/curved.exo");
    expect_example(*model, curved_example(), {.parts = Kept::Parts::OnePerType, .steps = {0}});
}

/// Places of the nodes of a set.
std::vector<Point3> places_of(const Mesh& mesh, const std::string& set) {
    std::vector<Point3> places;
    for (const NodeSet& one : mesh.node_sets) {
        if (one.name != set) continue;
        for (const NodeIndex node : one.nodes) places.push_back(mesh.coordinates[raw(node)]);
    }
    return places;
}

std::vector<std::string> set_names(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const NodeSet& one : mesh.node_sets) names.push_back(one.name);
    return names;
}

TEST_F(ExchangeExamples, node_and_side_sets_of_exodus_are_sets_of_nodes) {
    OPEN_OR_SKIP(model, "exodus/stack.exo");
    const Mesh& mesh = model->mesh();
    EXPECT_THAT(set_names(mesh), ElementsAre("clamped", "node set 3", "some sides"));
    const Point3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0};
    EXPECT_THAT(places_of(mesh, "clamped"), ElementsAre(a, b, c, d));
    EXPECT_THAT(places_of(mesh, "node set 3"), ElementsAre(Point3{0, 0, 2}));
    EXPECT_THAT(
        places_of(mesh, "some sides"),
        UnorderedElementsAre(a, b, c, d, Point3{1, 0, 1}, Point3{2, 0, 1}, Point3{1, 1, 1})
    );
}

TEST_F(ExchangeExamples, sides_of_second_order_have_their_middle_nodes) {
    OPEN_OR_SKIP(model, "exodus/curved.exo");
    // On the side of the element that begins at x = 3 i.
    const auto is_on = [](const Point3& at) {
        const auto i = static_cast<int>(std::floor(at[0] / 3));
        const double x = at[0] - 3 * i, y = at[1], z = at[2];
        switch (i) {
        case 0: return y == 0;
        case 1: return x == 0;
        case 2: return z == 0;
        case 3: return x + y + z == 1;
        case 4: return true;
        default: return 2 * x + y == 2;
        }
    };
    std::vector<Point3> right;
    for (const Point3& at : curved_example().points) {
        if (is_on(at)) right.push_back(at);
    }
    EXPECT_THAT(places_of(model->mesh(), "some sides"), UnorderedElementsAreArray(right));
    EXPECT_EQ(right.size(), 8U + 8U + 8U + 6U + 8U + 3U);
}

TEST_F(ExchangeExamples, med_has_everything) {
    OPEN_OR_SKIP(model, "med/stack.med");
    expect_example(*model, stack_example(), {});
    EXPECT_THAT(set_names(model->mesh()), ElementsAre("clamped"));
    EXPECT_EQ(places_of(model->mesh(), "clamped").size(), 4U);
    ASSERT_EQ(model->mesh().element_sets.size(), 1U);
    EXPECT_EQ(model->mesh().element_sets[0].name, "all");
    EXPECT_EQ(model->mesh().element_sets[0].elements.size(), 5U);
    EXPECT_TRUE(diagnostics().entries().empty());
}

TEST_F(ExchangeExamples, med_of_second_order_has_everything) {
    OPEN_OR_SKIP(model, "med/curved.med");
    expect_example(*model, curved_example(), {.steps = {0}});
}

TEST_F(ExchangeExamples, cgns_has_everything_but_ids) {
    OPEN_OR_SKIP(model, "cgns/stack.cgns");
    expect_example(
        *model,
        stack_example(),
        {.node_ids = false, .element_ids = false, .one_node_a_point = false, .missing_node = false}
    );
    EXPECT_TRUE(diagnostics().entries().empty());
}

TEST_F(ExchangeExamples, cgns_of_second_order_lacks_pyramids_and_says_so) {
    OPEN_OR_SKIP(model, "cgns/curved.cgns");
    EXPECT_EQ(diagnostics().count(Code::UnknownElementType), 1U);
    expect_example(
        *model,
        curved_example(),
        {.node_ids = false, .element_ids = false, .steps = {0}, .unread = {ElementType::Pyramid13}}
    );
}

TEST_F(ExchangeExamples, ensight_has_everything_but_ids) {
    OPEN_OR_SKIP(model, "ensight/stack.case");
    expect_example(
        *model, stack_example(), {.node_ids = false, .element_ids = false, .one_node_a_point = false}
    );
    EXPECT_TRUE(diagnostics().entries().empty());
    EXPECT_EQ(model->inputs().size(), 12U);
}

TEST_F(ExchangeExamples, ensight_of_second_order_has_everything_but_ids) {
    OPEN_OR_SKIP(model, "ensight/curved.case");
    expect_example(*model, curved_example(), {.node_ids = false, .element_ids = false, .steps = {0}});
}

TEST_F(ExchangeExamples, legacy_vtk_has_everything_of_a_step) {
    OPEN_OR_SKIP(model, "vtk/stack.vtk");
    expect_example(*model, stack_example(), {.parts = Kept::Parts::None, .steps = {1}, .times = false});
    EXPECT_EQ(model->steps()[0].kind, StepKind::Other);
}

TEST_F(ExchangeExamples, legacy_vtk_of_second_order_has_everything) {
    OPEN_OR_SKIP(model, "vtk/curved.vtk");
    expect_example(
        *model,
        curved_example(),
        {.parts = Kept::Parts::None, .steps = {1}, .times = false, .missing_node = true}
    );
}

TEST_F(ExchangeExamples, vtu_of_second_order_has_everything) {
    OPEN_OR_SKIP(model, "vtk/curved.vtu");
    expect_example(*model, curved_example(), {.parts = Kept::Parts::None, .steps = {0}, .times = false});
    EXPECT_TRUE(diagnostics().entries().empty());
}

TEST_F(ExchangeExamples, pvd_has_everything_and_its_parts_their_names) {
    OPEN_OR_SKIP(model, "vtk/stack.pvd");
    EXPECT_EQ(model->inputs().size(), 5U);
    expect_example(*model, stack_example(), {});
    EXPECT_TRUE(diagnostics().entries().empty());
}

TEST_F(ExchangeExamples, pieces_of_a_pvtu_are_joined_where_their_ids_are_the_same) {
    OPEN_OR_SKIP(model, "vtk/stack.pvtu");
    EXPECT_EQ(model->inputs().size(), 3U);
    // A piece without an array takes it from all others: VTK reads what all pieces have.
    expect_example(
        *model, stack_example(), {.parts = Kept::Parts::None, .steps = {0}, .times = false, .damage = false}
    );
}

/// Every value of `cut` that is none of `whole`, by the result's name; empty when there is none.
std::string invented_by(ModelSource& cut, ModelSource& whole) {
    if (cut.mesh().coordinates != whole.mesh().coordinates) return "other nodes";
    if (cut.mesh().element_count() != whole.mesh().element_count()) return "other elements";
    for (std::size_t i = 0; i < cut.results().size(); ++i) {
        const ResultInfo& info = cut.results()[i];
        for (std::size_t k = 0; k < whole.results().size(); ++k) {
            const ResultInfo& right = whole.results()[k];
            if (info.name != right.name || cut.steps()[info.step].value != whole.steps()[right.step].value)
                continue;
            const Result all = whole.load(k);
            Result some;
            try {
                some = cut.load(i);
            } catch (const Error&) {
                continue;
            }
            for (std::size_t v = 0; v < some.values.size(); ++v) {
                if (!std::isnan(some.values[v]) && some.values[v] != all.values.at(v)) return info.name;
            }
        }
    }
    return {};
}

TEST_F(ExchangeExamples, cut_file_gives_no_value_that_the_whole_one_does_not) {
    const struct {
        const char *folder, *main, *cut;
    } kFiles[]{
        {"exodus", "stack.exo", "stack.exo"},
        {"vtk", "stack.vtk", "stack.vtk"},
        {"vtk", "curved.vtu", "curved.vtu"},
        {"vtk", "stack.pvd", "stack.pvd"},
        {"med", "stack.med", "stack.med"},
        {"cgns", "curved.cgns", "curved.cgns"},
        {"ensight", "stack.case", "stack.geo"},
        {"ensight", "stack.case", "stack.heat02"},
        {"ensight", "stack.case", "stack.stre01"}};
    const std::string scratch = test::scratch_folder("cut_examples");
    for (const auto& [folder, main, cut] : kFiles) {
        SCOPED_TRACE(cut);
        OPEN_OR_SKIP(whole, std::string(folder) + "/" + main);
        const std::string from = test::project_file(std::string("tests/data/exchange/") + folder);
        const std::string bytes = test::read_file(from + "/" + cut);
        for (const std::size_t length :
             {bytes.size() / 3, bytes.size() * 2 / 3, bytes.size() - 30, bytes.size() - 4}) {
            std::filesystem::copy(from, scratch, std::filesystem::copy_options::overwrite_existing);
            test::write_file(scratch + "/" + cut, bytes.substr(0, length));
            Diagnostics notes;
            try {
                const auto model = open_model(std::vector<std::string>{scratch + "/" + main}, {}, notes);
                EXPECT_EQ(invented_by(*model, *whole), "") << "cut at " << length;
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()), "");
            }
        }
    }
}

}  // namespace
}  // namespace feelem
