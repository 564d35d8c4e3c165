// SPDX-License-Identifier: Apache-2.0
// .ply and .vtu as text and bytes; and files for the VTK oracle (vtk_oracle.py), with the facts it must find.
#include "support/meshes.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"
#include "feelem/write.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>

namespace feelem {
namespace {

using testing::HasSubstr;

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

Result nodal(const Mesh& mesh, std::string name, std::vector<std::string> components) {
    Result result;
    result.info.name = std::move(name);
    result.info.components = std::move(components);
    // Thirds: not exact in decimal, so that a lost bit would show.
    for (std::size_t i = 0; i < mesh.node_count() * result.component_count(); ++i)
        result.values.push_back(static_cast<float>(i + 1) / 3.0F);
    return result;
}

Result elemental(const Mesh& mesh) {
    Result result;
    result.info.name = "energy";
    result.info.location = Location::Elemental;
    result.info.components = {"value"};
    for (std::size_t i = 0; i < mesh.element_count(); ++i)
        result.values.push_back(static_cast<float>(i) + 0.1F);
    return result;
}

std::string raw_bytes(const std::vector<float>& values) {
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// The first `count` numbers of type T of the raw array whose head carries this name.
template <class T>
std::vector<T> vtu_array(const std::string& file, const std::string& name, std::size_t count) {
    const std::size_t head = file.find("Name=\"" + name + "\"");
    const std::size_t offset_at = file.find("offset=\"", head) + 8;
    const std::size_t offset = std::stoul(file.substr(offset_at));
    const std::size_t start = file.find("encoding=\"raw\">\n_") + 17 + offset;
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, &file[start], sizeof bytes);
    EXPECT_EQ(bytes, count * sizeof(T)) << name;
    std::vector<T> values(count);
    std::memcpy(values.data(), &file[start + 8], count * sizeof(T));
    return values;
}

TEST(Vtu, missing_values_stay_nan_and_names_are_escaped) {
    const Mesh mesh = test::one_element(ElementType::Tet4);
    Result result = nodal(mesh, "a<b", {"value"});
    result.values[2] = kGap;
    const std::string path = test::scratch_folder("write_gap") + "/gap.vtu";

    write_vtu(path, mesh, {{result}});

    const std::string file = test::read_file(path);
    const auto values = vtu_array<float>(file, "a&lt;b", 4);
    EXPECT_EQ(values[1], result.values[1]);
    EXPECT_TRUE(std::isnan(values[2]));
}

TEST(Vtu, element_without_one_midside_node_is_written_by_its_corners) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.5, 0, 0}, {.5, .5, 0}}, {{ElementType::Tri6, {1, 2, 3, 4, 5, 0}}}
    );
    const std::string path = test::scratch_folder("write_midside") + "/tri.vtu";

    write_vtu(path, mesh, {});

    const std::string file = test::read_file(path);
    EXPECT_EQ(vtu_array<std::uint8_t>(file, "types", 1)[0], 5);
    EXPECT_EQ(vtu_array<std::int64_t>(file, "connectivity", 3), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(Vtu, values_of_a_node_in_two_parts_become_one_array_a_part) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
        {{ElementType::Tri3, {1, 2, 3}, "steel"}, {ElementType::Tri3, {2, 4, 3}, "brass"}}
    );
    Result result;
    result.info.name = "stress";
    result.info.components = {"value"};
    result.info.location = Location::PartNodal;
    result.row_owner = {0, 0, 0, 1, 1, 1};
    result.row_node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}};
    result.values = {1, 2, 3, 4, 5, 6};
    const std::string path = test::scratch_folder("write_parts") + "/parts.vtu";

    write_vtu(path, mesh, {{result}});

    const std::string file = test::read_file(path);
    const auto steel = vtu_array<float>(file, "stress@steel", 4);
    const auto brass = vtu_array<float>(file, "stress@brass", 4);
    EXPECT_EQ(steel[1], 2);
    EXPECT_EQ(brass[1], 4);
    EXPECT_TRUE(std::isnan(steel[3]));
    EXPECT_TRUE(std::isnan(brass[0]));
}

TEST(Vtu, unaveraged_values_go_to_their_place_in_the_cell) {
    const Mesh mesh = test::one_element(ElementType::Wedge6);
    Result result;
    result.info.name = "stress";
    result.info.components = {"value"};
    result.info.location = Location::ElementNodal;
    for (std::uint32_t i = 0; i < 6; ++i) {
        result.row_owner.push_back(0);
        result.row_node.push_back(NodeIndex{i});
        result.values.push_back(static_cast<float>(i));
    }
    const std::string path = test::scratch_folder("write_unaveraged") + "/wedge.vtu";

    write_vtu(path, mesh, {{result}});

    // VTK's wedge goes round the other way: its second node is our third.
    const auto values = vtu_array<float>(test::read_file(path), "stress_at_nodes", 6);
    EXPECT_EQ(values, (std::vector<float>{0, 2, 1, 3, 5, 4}));
}

TEST(Ply, has_one_property_a_component_and_reads_back_to_the_same_bits) {
    const Mesh mesh = test::one_element(ElementType::Tet4);
    Diagnostics diagnostics;
    const Surface surface = make_skin(mesh, {}, diagnostics);
    const Result result = nodal(mesh, "displacement", {"x", "y", "z"});
    const SurfaceField field = carry(mesh, surface, result);
    const std::string path = test::scratch_folder("write_ply") + "/tet.ply";

    write_ply(path, mesh, surface, {{{"displacement", {"x", "y", "z"}, field}}});

    std::istringstream file(test::read_file(path));
    std::string line;
    std::string head;
    while (std::getline(file, line) && line != "end_header") head += line + "\n";
    EXPECT_THAT(head, HasSubstr("property float displacement_x\nproperty float displacement_y\n"));
    EXPECT_THAT(head, HasSubstr("property int node_id\nelement face 4\n"));
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        std::string x, y, z, dx, dy, dz;
        std::int64_t id = 0;
        file >> x >> y >> z >> dx >> dy >> dz >> id;
        EXPECT_EQ(std::stod(y), surface.positions[v][1]);
        EXPECT_EQ(std::stof(dz), field.values[v * 3 + 2]);
        EXPECT_EQ(id, raw(mesh.node_ids[raw(surface.vertex_node[v])]));
    }
    int corners = 0, a = 0, b = 0, c = 0, element = 0;
    file >> corners >> a >> b >> c >> element;
    EXPECT_EQ(corners, 3);
    EXPECT_EQ(element, 1);
}

TEST(Ply, says_its_step_but_not_a_label_that_could_end_the_line) {
    const Mesh mesh = test::one_element(ElementType::Tri3);
    Diagnostics diagnostics;
    const Surface surface = make_skin(mesh, {}, diagnostics);
    const std::string path = test::scratch_folder("write_ply_step") + "/tri.ply";
    const Step step{0, 2, 3, StepKind::Time, 720.5, "x\nend_header"};

    write_ply(path, mesh, surface, {}, &step);

    const std::string file = test::read_file(path);
    EXPECT_THAT(file, HasSubstr("\ncomment step 2.3, time, value 720.5\nelement vertex"));
    EXPECT_EQ(file.find("end_header"), file.rfind("end_header"));
}

TEST(Ply, an_id_beyond_32_bits_is_a_double) {
    Mesh mesh = test::one_element(ElementType::Tri3);
    mesh.blocks[0].ids[0] = ElementId{5'000'000'000};
    Diagnostics diagnostics;
    const Surface surface = make_skin(mesh, {}, diagnostics);
    const std::string path = test::scratch_folder("write_ply_ids") + "/tri.ply";

    write_ply(path, mesh, surface, {});

    const std::string file = test::read_file(path);
    EXPECT_THAT(file, HasSubstr("property double element_id\n"));
    EXPECT_THAT(file, HasSubstr(" 5000000000\n"));
}

TEST(WriteFormats, a_folder_that_is_not_there_is_an_error_with_its_path) {
    const Mesh mesh = test::one_element(ElementType::Tet4);
    try {
        write_vtu("/nowhere/at/all.vtu", mesh, {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::WriteFailed);
        EXPECT_EQ(error.where(), "/nowhere/at/all.vtu");
    }
}

/// Writes NAME.vtu, NAME.ply, the values as raw bytes, and NAME.facts for the oracle.
void write_case(
    const std::string& folder, const std::string& name, const Mesh& mesh, const std::vector<Result>& results
) {
    Diagnostics diagnostics;
    const Surface surface = make_skin(mesh, {}, diagnostics);
    const std::string base = folder + "/" + name;
    const Step step{0, 2, 3, StepKind::Time, 720.5, ""};
    write_vtu(base + ".vtu", mesh, results, &step);
    std::string facts = fmt::format(
        "points {}\ncells {}\nvolume {}\nfacets {}\nlinear {}\nvertices {}\ntriangles {}\n",
        mesh.node_count(),
        mesh.element_count(),
        surface.report.volume,
        surface.report.solid_facets_kept + surface.report.shell_tri + surface.report.shell_quad,
        std::ranges::all_of(
            mesh.blocks, [](const auto& block) { return element_row(block.type).order == 1; }
        ),
        surface.positions.size(),
        surface.triangles.size()
    );
    std::vector<NamedField> fields;
    for (const Result& result : results) {
        const bool at_points = result.info.location == Location::Nodal;
        facts += fmt::format("{} {}\n", at_points ? "point_array" : "cell_array", result.info.name);
        test::write_file(base + "." + result.info.name, raw_bytes(result.values));
        if (at_points)
            fields.push_back({result.info.name, result.info.components, carry(mesh, surface, result)});
    }
    write_ply(base + ".ply", mesh, surface, fields, &step);
    std::string ids;
    for (const NodeId id : mesh.node_ids) ids += fmt::format("{} ", raw(id));
    test::write_file(base + ".facts", facts + "node_ids " + ids + "\n");
}

TEST(VtkOracle, writes_every_element_type_and_the_shipped_boilers) {
    const std::string folder = test::scratch_folder("vtk_oracle");
    for (std::size_t type = 0; type < kElementTypeCount; ++type) {
        const auto element = static_cast<ElementType>(type);
        if (element_row(element).dimension < 2) continue;
        const Mesh mesh = test::one_element(element);
        write_case(
            folder,
            std::string(element_row(element).name),
            mesh,
            {nodal(mesh, "displacement", {"x", "y", "z"}),
             nodal(mesh, "stress", {"xx", "yy", "zz", "xy", "yz", "zx"}),
             elemental(mesh)}
        );
    }
    for (const std::string model : {"hex_linear", "small"}) {
        Diagnostics diagnostics;
        const std::string path = test::project_file("examples/boiler/" + model + "/static.frd");
        const auto source = open_model(std::vector<std::string>{path}, {}, diagnostics);
        std::vector<Result> results;
        for (std::size_t i = 0; i < source->results().size(); ++i) results.push_back(source->load(i));
        write_case(folder, "boiler_" + model, source->mesh(), results);
    }
}

}  // namespace
}  // namespace feelem
