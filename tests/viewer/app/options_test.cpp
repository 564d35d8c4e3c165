// SPDX-License-Identifier: Apache-2.0
// The command line of feelem-xr.
#include "viewer/app/options.hpp"

#include <gmock/gmock.h>

namespace feelem::viewer {
namespace {

std::string refusal(std::vector<std::string> arguments) {
    try {
        (void)parse_command_line(std::move(arguments));
    } catch (const UsageError& error) {
        return error.what();
    }
    return "taken";
}

TEST(Options, a_scene_alone_is_enough) {
    const Options options = parse_command_line({"boiler.glb"}).options;
    EXPECT_EQ(options.inputs, std::vector<std::string>{"boiler.glb"});
    EXPECT_EQ(options.headset, UseHeadset::Auto);
    EXPECT_EQ(options.size, (std::array{1280, 800}));
    EXPECT_FALSE(options.is_doctor);
}

TEST(Options, every_option_is_taken_with_and_without_equals_sign) {
    const Options options = parse_command_line({"a.frd",
                                                "b.dat",
                                                "--xr=require",
                                                "--record",
                                                "out",
                                                "--size",
                                                "640",
                                                "480",
                                                "--seconds=2.5",
                                                "--dark"})
                                .options;
    EXPECT_EQ(options.inputs, (std::vector<std::string>{"a.frd", "b.dat"}));
    EXPECT_EQ(options.headset, UseHeadset::Require);
    EXPECT_EQ(options.record, "out");
    EXPECT_EQ(options.size, (std::array{640, 480}));
    EXPECT_EQ(options.seconds, 2.5);
    EXPECT_TRUE(options.dark);
}

TEST(Options, doctor_help_and_version_need_no_scene) {
    EXPECT_TRUE(parse_command_line({"doctor"}).options.is_doctor);
    EXPECT_THAT(parse_command_line({"--help"}).text.value_or(""), testing::HasSubstr("--screenshot"));
    EXPECT_THAT(parse_command_line({"--version"}).text.value_or(""), testing::StartsWith("feelem-xr "));
}

TEST(Options, a_mistake_is_answered_with_what_was_meant) {
    EXPECT_THAT(refusal({}), testing::HasSubstr("Usage: feelem-xr SCENE"));
    EXPECT_THAT(refusal({"a.glb", "--recrod", "x"}), testing::HasSubstr("\"--record\""));
    EXPECT_THAT(refusal({"a.glb", "--xr=never"}), testing::HasSubstr("--xr"));
    EXPECT_THAT(refusal({"a.glb", "--size", "0", "9"}), testing::HasSubstr("--size"));
}

}  // namespace
}  // namespace feelem::viewer
