// SPDX-License-Identifier: Apache-2.0
// The key table: complete, without doubles, and the same as its page says.
#include "support/paths.hpp"
#include "viewer/desktop/keys.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

namespace feelem::viewer {
namespace {

TEST(Keys, each_command_has_a_key) {
    std::set<Command> found;
    for (const KeyBinding& binding : key_bindings())
        if (binding.command) found.insert(*binding.command);
    for (int i = 0; i <= static_cast<int>(Command::Leave); ++i)
        EXPECT_TRUE(found.contains(static_cast<Command>(i)))
            << "command " << i << " of core/input.hpp has no key";
}

TEST(Keys, each_action_of_the_desk_has_a_key) {
    std::set<DeskAction> found;
    for (const KeyBinding& binding : key_bindings())
        if (binding.action) found.insert(*binding.action);
    for (int i = 0; i <= static_cast<int>(DeskAction::FullScreen); ++i)
        EXPECT_TRUE(found.contains(static_cast<DeskAction>(i))) << "action " << i;
}

TEST(Keys, no_key_means_two_things_and_none_means_nothing) {
    std::set<std::tuple<std::string_view, bool, bool>> chords;
    std::set<std::string_view> shown;
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_TRUE(chords.emplace(binding.key, binding.shift, binding.control).second) << binding.shown;
        EXPECT_TRUE(shown.insert(binding.shown).second) << binding.shown;
        EXPECT_NE(binding.command.has_value(), binding.action.has_value()) << binding.shown;
        EXPECT_FALSE(binding.text.empty()) << binding.shown;
    }
}

TEST(Keys, shift_and_control_are_part_of_the_key) {
    ASSERT_NE(find_binding("P", false, false), nullptr);
    EXPECT_EQ(find_binding("P", false, false)->command, Command::PlaceMarker);
    EXPECT_EQ(find_binding("P", true, false)->command, Command::RemoveMarkers);
    EXPECT_EQ(find_binding("P", false, true), nullptr);
    EXPECT_EQ(find_binding("F9", false, false), nullptr);
}

TEST(Keys, the_page_of_keys_lists_them_all_and_no_others) {
    std::string expected;
    for (const KeyBinding& binding : key_bindings())
        expected += fmt::format("| `{}` | {} |\n", binding.shown, binding.text);
    const std::string page = test::read_file(test::project_file("docs/native-viewer-keys.md"));
    const std::string head = "| key | what it does |\n|---|---|\n";
    const std::size_t from = page.find(head);
    ASSERT_NE(from, std::string::npos);
    const std::size_t to = page.find("\n\n", from);
    EXPECT_EQ(page.substr(from + head.size(), to + 1 - from - head.size()), expected)
        << "docs/native-viewer-keys.md must hold these rows";
}

}  // namespace
}  // namespace feelem::viewer
