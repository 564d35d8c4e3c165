// SPDX-License-Identifier: Apache-2.0
// The table of Ansys' element types.
#include "read/ansys/ansys_elements.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace feelem {
namespace {

using ansys::ElementKind;
using ansys::find_element;
using ansys::shape_of_row;

TEST(AnsysElements, a_number_or_a_name_in_any_case_finds_the_type) {
    EXPECT_EQ(find_element(186)->name, "SOLID186");
    EXPECT_EQ(find_element("solid186.")->number, 186);
    EXPECT_EQ(find_element(" 186 ")->type, ElementType::Hex20);
    EXPECT_EQ(find_element("TARGE170")->kind, ElementKind::Contact);
    EXPECT_FALSE(find_element("SOLID"));
    EXPECT_FALSE(find_element(9999));
    EXPECT_FALSE(find_element("6"));
    EXPECT_FALSE(find_element("PLANE186"));
    EXPECT_FALSE(find_element("P186"));
    EXPECT_EQ(find_element("COMBIN214")->name, "COMBI214");
}

TEST(AnsysElements, numbers_are_unique) {
    std::set<std::string> names;
    for (int number = 1; number <= 300; ++number) {
        const auto element = find_element(number);
        if (!element) continue;
        EXPECT_EQ(element->number, number);
        EXPECT_TRUE(names.insert(std::string(element->name)).second);
    }
    EXPECT_GT(names.size(), 200u);
}

void expect_shape(const char* name, std::size_t count, ElementType type, std::size_t nodes, int keyopt1 = 0) {
    const auto shape = shape_of_row(*find_element(name), count, keyopt1);
    ASSERT_TRUE(shape) << name << " " << count;
    EXPECT_EQ(shape->type, type) << name << " " << count;
    EXPECT_EQ(shape->nodes, nodes) << name << " " << count;
}

TEST(AnsysElements, rows_of_any_length_have_their_shape) {
    expect_shape("SOLID186", 20, ElementType::Hex20, 20);
    expect_shape("SOLID226", 8, ElementType::Hex20, 8);
    expect_shape("SOLID92", 7, ElementType::Tet10, 7);
    expect_shape("SHELL281", 8, ElementType::Quad8, 8);
    expect_shape("SHELL181", 4, ElementType::Quad4, 4);
    expect_shape("SHELL181", 3, ElementType::Tri3, 3);
    expect_shape("PLANE183", 8, ElementType::Quad8, 8);
    expect_shape("PLANE183", 6, ElementType::Tri6, 6, 1);
    expect_shape("PLANE2", 6, ElementType::Tri6, 6);
    expect_shape("BEAM188", 3, ElementType::Line2, 2);
    expect_shape("BEAM189", 4, ElementType::Line3, 3);
    expect_shape("BEAM44", 4, ElementType::Line2, 2);
    expect_shape("MESH200", 20, ElementType::Hex20, 20, 11);
    expect_shape("SHELL209", 3, ElementType::Line3, 3);
}

TEST(AnsysElements, rows_that_are_no_such_element_have_none) {
    EXPECT_FALSE(shape_of_row(*find_element("SOLID185"), 4, 0));
    EXPECT_FALSE(shape_of_row(*find_element("CONTA174"), 8, 0));
    EXPECT_FALSE(shape_of_row(*find_element("MASS21"), 1, 0));
    EXPECT_FALSE(shape_of_row(*find_element("MESH200"), 20, 77));
}

}  // namespace
}  // namespace feelem
