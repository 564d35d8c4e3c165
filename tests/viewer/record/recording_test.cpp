// SPDX-License-Identifier: Apache-2.0
// A recording is true to the bit, whole at every moment, and the same each time.
#include "support/paths.hpp"
#include "viewer/record/recording.hpp"

#include "feelem/error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>

namespace feelem::test {
namespace {

using nlohmann::json;
using viewer::FrameInput;
using viewer::Reading;
using viewer::Recording;
using viewer::SenseEvent;
using viewer::SentPulse;
using viewer::Snapshot;

/// A frame in which everything happens.
struct Moment {
    FrameInput input;
    Snapshot snapshot;
    std::vector<SentPulse> pulses;
};

Moment full_moment() {
    Moment m;
    m.input.is_headset = true;
    m.input.head.position = {0.1F, 1.6F, -0.30000001F};
    viewer::HandInput& hand = m.input.hands[1];
    hand.is_tracked = true;
    hand.is_bare = true;
    hand.trigger = 1.0F / 3;
    hand.fingertip = glm::vec3(1e-7F, 2, 3);
    m.input.pointer.ray = viewer::Ray{};
    m.snapshot.frame = 7;
    m.snapshot.time = 0.1 + 0.2;
    m.snapshot.pointer = viewer::Pointer::Right;
    m.snapshot.is_held = true;
    m.snapshot.probed.emplace();
    viewer::Probed& probed = *m.snapshot.probed;
    probed.weights = {1.0 / 3, 1.0 / 7, 1 - 1.0 / 3 - 1.0 / 7};
    probed.element_id = 9007199254740993;  // No double holds it.
    probed.node_id = 41;
    probed.readings.resize(2);
    Reading& there = probed.readings[0];
    there.key = "T\"\\\n\xC3\xA9";
    there.value = std::nextafter(187.3, 200);
    there.node_value = std::nextafter(187.3F, 200.0F);
    there.state = "solver";
    there.at.u = 0.7460000000000002;
    Reading& missing = probed.readings[1];
    missing.key = "S";
    missing.value = std::numeric_limits<double>::quiet_NaN();
    missing.state = "missing";
    missing.at.missing = true;
    m.snapshot.colour = Rgb{1, 2, 255};
    m.snapshot.sound = viewer::SoundFrame{.hz = 440.1, .gain = 0.3};
    m.snapshot.touch[1] = viewer::HapticFrame{.rate = 4.5, .amplitude = 0.2};
    m.snapshot.events = {SenseEvent::LimitUp, SenseEvent::Maximum};
    m.pulses = {
        {0.3, viewer::Side::Right, 0.2, 35, {}}, {0.3, viewer::Side::Left, 1, 60, SenseEvent::LimitUp}};
    return m;
}

std::vector<json> lines_of(const std::string& folder) {
    std::vector<json> lines;
    std::istringstream text(read_file(folder + "/session.jsonl"));
    for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
    return lines;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

TEST(FrameLine, every_number_reads_back_to_its_bits) {
    const Moment m = full_moment();
    const json line = json::parse(viewer::frame_line(m.input, m.snapshot, m.pulses));

    EXPECT_EQ(line.at("time").get<double>(), 0.1 + 0.2);
    EXPECT_EQ(line.at("head").at("position").at(2).get<float>(), -0.30000001F);
    EXPECT_EQ(line.at("head").at("orientation"), json({0, 0, 0, 1}));
    EXPECT_EQ(line.at("hands").size(), 1U);
    EXPECT_EQ(line.at("hands").at(0).at("trigger").get<float>(), 1.0F / 3);
    EXPECT_EQ(line.at("hands").at(0).at("fingertip").at(0).get<float>(), 1e-7F);
    const json& probed = line.at("probed");
    EXPECT_EQ(probed.at("weights").at(1).get<double>(), 1.0 / 7);
    EXPECT_EQ(probed.at("element").get<std::int64_t>(), 9007199254740993);
    const json& there = probed.at("readings").at(0);
    EXPECT_EQ(there.at("key"), "T\"\\\n\xC3\xA9");
    EXPECT_EQ(there.at("value").get<double>(), std::nextafter(187.3, 200));
    EXPECT_EQ(there.at("nodeValue").get<float>(), std::nextafter(187.3F, 200.0F));
    EXPECT_EQ(there.at("u").get<double>(), 0.7460000000000002);
}

TEST(FrameLine, what_is_missing_is_null_and_what_is_not_there_is_left_out) {
    const Moment m = full_moment();
    const json missing =
        json::parse(viewer::frame_line(m.input, m.snapshot, {})).at("probed").at("readings").at(1);
    EXPECT_TRUE(missing.at("value").is_null());
    EXPECT_TRUE(missing.at("u").is_null());
    EXPECT_FALSE(missing.contains("nodeValue"));

    const json empty = json::parse(viewer::frame_line({}, {}, {}));
    EXPECT_EQ(empty.size(), 5U) << empty;
    for (const char* key : {"frame", "time", "focused", "headset", "head"}) EXPECT_TRUE(empty.contains(key));
}

void collect_keys(const json& value, std::vector<std::string>& keys) {
    if (value.is_object()) {
        for (const auto& item : value.items()) keys.push_back(item.key());
    }
    if (value.is_structured()) {
        for (const auto& item : value) collect_keys(item, keys);
    }
}

TEST(FrameLine, the_page_about_recordings_explains_every_key) {
    const std::string page = read_file(project_file("docs/recording.md"));
    const std::string folder = scratch_folder("record_keys");
    const Moment m = full_moment();
    Recording(folder, "boiler.glb").add(m.input, m.snapshot, m.pulses, {});
    std::vector<std::string> keys;
    for (const json& line : lines_of(folder)) {
        if (!line.contains("format")) collect_keys(line, keys);
    }
    EXPECT_GT(keys.size(), 60U);
    for (const std::string& key : keys) EXPECT_NE(page.find('`' + key + '`'), std::string::npos) << key;
}

TEST(Recording, the_sound_file_can_be_played_at_every_moment_and_keeps_every_sample) {
    const std::string folder = scratch_folder("record_sound");
    Recording recording(folder, "boiler.glb");
    std::vector<float> all;
    const Moment m = full_moment();
    for (int i = 0; i < 5; ++i) {
        std::vector<float> sound;
        for (int k = 0; k < 2 * (600 + i); ++k) sound.push_back(std::sin(static_cast<float>(k * i)) * 0.1F);
        all.insert(all.end(), sound.begin(), sound.end());
        recording.add(m.input, m.snapshot, m.pulses, sound);

        const std::string bytes = read_file(folder + "/sound.wav");
        ASSERT_EQ(bytes.size(), 58 + 4 * all.size());
        EXPECT_EQ(
            bytes.substr(0, 4) + bytes.substr(8, 8) + bytes.substr(38, 4) + bytes.substr(50, 4),
            "RIFFWAVEfmt factdata"
        );
        EXPECT_EQ(number_at(bytes, 4), bytes.size() - 8);
        EXPECT_EQ(number_at(bytes, 20), 3U + (2U << 16U)) << "float, stereo";
        EXPECT_EQ(number_at(bytes, 24), 48000U);
        EXPECT_EQ(number_at(bytes, 46), all.size() / 2);
        EXPECT_EQ(number_at(bytes, 54), 4 * all.size());
        EXPECT_EQ(std::memcmp(bytes.data() + 58, all.data(), 4 * all.size()), 0);
    }
    const std::vector<json> lines = lines_of(folder);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0].at("format"), "feelem-recording");
    EXPECT_EQ(lines[0].at("scene"), "boiler.glb");
    EXPECT_EQ(lines[1].at("soundFrom"), 0);
    for (std::size_t i = 2; i < 6; ++i) EXPECT_EQ(lines[i].at("soundFrom"), lines[i - 1].at("soundTo"));
    EXPECT_EQ(lines[5].at("soundTo"), all.size() / 2);
    EXPECT_EQ(recording.trouble(), "");
}

TEST(Recording, the_same_session_is_the_same_bytes) {
    const auto run = [](const std::string& name) {
        const std::string folder = scratch_folder(name);
        Recording recording(folder, "boiler.glb");
        const Moment m = full_moment();
        for (int i = 0; i < 3; ++i)
            recording.add(m.input, m.snapshot, m.pulses, std::vector<float>(64, 0.5F));
        return read_file(folder + "/session.jsonl") + read_file(folder + "/sound.wav");
    };
    EXPECT_EQ(run("record_one"), run("record_two"));
}

TEST(RecordingDeathTest, a_program_that_is_killed_has_kept_every_frame) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const std::string folder = scratch_folder("record_killed");
    EXPECT_EXIT(
        {
            Recording recording(folder, "boiler.glb");
            const Moment m = full_moment();
            for (int i = 0; i < 20; ++i)
                recording.add(m.input, m.snapshot, m.pulses, std::vector<float>(1334, 0.5F));
            raise(SIGKILL);
        },
        testing::KilledBySignal(SIGKILL),
        ""
    );
    const std::vector<json> lines = lines_of(folder);
    ASSERT_EQ(lines.size(), 21U);
    EXPECT_EQ(lines[20].at("soundTo"), 20 * 667);
    const std::string wav = read_file(folder + "/sound.wav");
    EXPECT_EQ(wav.size(), 58U + 20 * 1334 * 4);
    EXPECT_EQ(number_at(wav, 54), wav.size() - 58);
}

TEST(Recording, a_folder_that_cannot_be_made_is_said_at_once) {
    const std::string file = scratch_folder("record_blocked") + "/file";
    write_file(file, "in the way");
    try {
        const Recording recording(file + "/session", "boiler.glb");
        FAIL() << "a file is no folder";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::WriteFailed);
        EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
    }
}

rlimit file_limit() {
    return {20000, 20000};
}

TEST(RecordingDeathTest, a_full_disk_is_said_once_and_harms_nothing) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const std::string folder = scratch_folder("record_full");
    // In a process of its own: no file may grow beyond 20 kB there, as if the disk were full.
    EXPECT_EXIT(
        {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit = file_limit();
            setrlimit(RLIMIT_FSIZE, &limit);
            Recording recording(folder, "boiler.glb");
            const Moment m = full_moment();
            std::string first;
            for (int i = 0; i < 50; ++i) {
                recording.add(m.input, m.snapshot, m.pulses, std::vector<float>(1334, 0.5F));
                if (first.empty()) first = recording.trouble();
            }
            _exit(!first.empty() && recording.trouble() == first ? 0 : 1);
        },
        testing::ExitedWithCode(0),
        ""
    );
    EXPECT_LE(read_file(folder + "/sound.wav").size(), 20000U);
    const std::string wav = read_file(folder + "/sound.wav");
    EXPECT_LE(number_at(wav, 54), wav.size() - 58) << "the header promises no more than there is";
}

}  // namespace
}  // namespace feelem::test
