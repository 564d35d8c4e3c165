// SPDX-License-Identifier: Apache-2.0
// The sample, its surfaces and its pictures.
#include "sample_ui.hpp"

#include "scene/picture.hpp"
#include "support/paths.hpp"
#include "viewer/ui/numbers.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace feelem::viewer::tests {
namespace {

UiLegend sample_legend() {
    UiLegend legend;
    legend.key = "T";
    legend.title = "temperature";
    legend.unit = "degC";
    legend.step = "Step 1.1 · static";
    legend.origin = "at nodes · averaged by the solver";
    legend.range = {31.2, 181.7, Scale::Linear};
    legend.limit = 160;
    legend.limit_label = "seal";
    legend.probed = 92.25;
    legend.within = "values within ±0.05 % (±0.076 °C)";
    legend.deformation = "deformation × 120";
    return legend;
}

UiCardRow row_named(const char* key, const char* label, const char* unit) {
    UiCardRow row;
    row.key = key;
    row.label = label;
    row.unit = unit;
    return row;
}

UiCard sample_card() {
    UiCard card;
    UiCardRow row = row_named("T", "temperature", "degC");
    row.value = 92.2513;
    row.node_value = 92.25F;
    row.senses = {Sense::Colour};
    row.limit = 160;
    card.rows.push_back(row);
    row = row_named("U", "displacement magnitude", "mm");
    row.value = 0.412345678;
    row.node_value = 0.4123F;
    row.state = "interpolated";
    row.senses = {Sense::Pitch, Sense::Shape};
    row.bound = 0.00031;
    card.rows.push_back(row);
    row = row_named("S", "von Mises stress", "MPa");
    row.value = 260.51;
    row.node_value = 262.125F;
    row.senses = {Sense::Pulses};
    row.limit = 250;
    row.limit_label = "yield";
    row.beyond = true;
    card.rows.push_back(row);
    row = row_named("P", "plastic strain", "");
    row.state = "missing";
    card.rows.push_back(row);
    card.node = 1834;
    card.element = 7211;
    card.place = {120.5, -33.25, 810.125};
    card.length_unit = "mm";
    card.sounding = "tone 440 Hz · 6.31 pulses/s";
    return card;
}

void add_results(UiModel& out) {
    out.results.push_back(
        {"T", "temperature", "degC", ValueRange{31.2, 181.7, Scale::Linear}, {Sense::Colour}, false, 160}
    );
    out.results.push_back(
        {"U",
         "displacement magnitude",
         "mm",
         ValueRange{0, 0.9123, Scale::Linear},
         {Sense::Pitch, Sense::Shape},
         true,
         {}}
    );
    out.results.push_back(
        {"S", "von Mises stress", "MPa", ValueRange{0.21, 287.4, Scale::Linear}, {Sense::Pulses}, false, 250}
    );
    out.results.push_back({"P", "plastic strain", "", std::nullopt, {}, false, {}});
}

void add_places(UiModel& out) {
    out.hot_spots = {
        {"von Mises stress", "MPa", 287.4, 1.1496, 1834, true},
        {"von Mises stress", "MPa", 244.02, 0.97608, 90211, false},
        {"temperature", "degC", 143.1, 0.894, 12, false}};
    UiMarker marker;
    marker.unit = "MPa";
    marker.value = 262.125;
    marker.node = 1834;
    marker.text = "weld toe";
    out.markers = {marker};
}

}  // namespace

UiModel boiler_ui() {
    UiModel out;
    out.title = "Boiler under pressure and heat";
    out.solver = "CalculiX 2.20";
    out.legend = sample_legend();
    out.card = sample_card();
    add_results(out);
    out.steps.names = {"Step 1.1 · static", "Mode 1 · 41.2 Hz", "Mode 2 · 76.66 Hz"};
    out.deformation = {true, 120, 120, true};
    out.parts = {{"shell", "solid", 1214880, PartLook::Shown}, {"saddle", "solid", 8120, PartLook::Clear}};
    out.cuts = {{CutPlane{{1, 0, 0}, 120.5F}, -400, 400, true}};
    out.length_unit = "mm";
    add_places(out);
    out.sound = {0.4, false, false, ""};
    out.touch = {1, false, "Nothing here can shake: ticks stand in."};
    out.headset = {
        "No headset",
        "OpenXR's loader found no runtime on this machine.",
        "Install one (package monado-service, or SteamVR), then look again.",
        false};
    out.certificate = {
        {"skin", "exact"}, {"facets kept", "2568 of 7608"}, {"closed", "yes"}, {"missing values", "0"}};
    out.keys = {{"F", "fit"}, {"Space", "play, pause"}, {"S", "hold: hear and feel"}};
    return out;
}

Rgb UiPicture::at(int x, int y) const {
    const auto from =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.x) + static_cast<std::size_t>(x));
    return {rgba.at(from), rgba.at(from + 1), rgba.at(from + 2)};
}

UiPicture read_framebuffer(std::uint32_t framebuffer, glm::ivec2 pixels) {
    UiPicture out{pixels, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(pixels.x);
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(pixels.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, pixels.x, pixels.y, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    for (std::size_t y = static_cast<std::size_t>(pixels.y); y-- > 0;)
        out.rgba.insert(out.rgba.end(), &upside_down[y * row], &upside_down[y * row] + row);
    return out;
}

Canvas::Canvas(glm::ivec2 pixels, const Rgb& background) : pixels_(pixels), background_(background) {
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 1, GL_RGBA8, pixels.x, pixels.y);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    clear();
}

Canvas::~Canvas() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void Canvas::clear() {
    const auto share = [&](std::size_t i) { return static_cast<float>(background_.at(i)) / 255.0F; };
    const std::array<float, 4> colour{share(0), share(1), share(2), 1};
    glClearNamedFramebufferfv(framebuffer_, GL_COLOR, 0, colour.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

UiPicture Canvas::read() const {
    return read_framebuffer(framebuffer_, pixels_);
}

void WithGl::SetUp() {
    try {
        context = std::make_unique<GlContext>();
    } catch (const std::exception& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
}

glm::vec2 middle_of(const std::vector<UiTarget>& targets, std::string_view name) {
    for (const UiTarget& target : targets)
        if (target.name == name) return (target.low + target.high) / 2.0F;
    ADD_FAILURE() << "nothing to press is called " << name;
    return glm::vec2(-1);
}

void compare_with_golden(const std::vector<int>& numbers, const std::string& name) {
    const std::string path = feelem::test::project_file("tests/viewer/ui/golden/" + name + ".txt");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        std::string text;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            text += fmt::format("{:02x}{}", numbers[i], i % 60 == 59 ? "\n" : "");
        feelem::test::write_file(path, text + "\n");
    }
    std::string text = feelem::test::read_file(path);
    std::erase(text, '\n');
    ASSERT_EQ(text.size(), 2 * numbers.size()) << name;
    std::size_t off = 0;
    int furthest = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const int expected = std::stoi(text.substr(2 * i, 2), nullptr, 16);
        const int apart = std::abs(expected - numbers[i]);
        furthest = std::max(furthest, apart);
        off += apart > 4 ? 1U : 0U;
    }
    // Drivers smooth edges each in their own way; a word more or less is far beyond this.
    EXPECT_LE(off, numbers.size() / 1000) << name << ": FEELEM_UI_PICTURES=folder keeps it to be looked at";
    EXPECT_LE(furthest, 24) << name;
}

void keep_for_people(const UiPicture& picture, const std::string& name) {
    const char* folder = std::getenv("FEELEM_UI_PICTURES");
    if (folder == nullptr || *folder == '\0') return;
    Picture png(picture.pixels.x, picture.pixels.y, {0, 0, 0});
    for (int y = 0; y < picture.pixels.y; ++y)
        for (int x = 0; x < picture.pixels.x; ++x) png.set(x, y, picture.at(x, y));
    feelem::test::write_file(std::string(folder) + "/" + name + ".png", png_bytes(png));
}

}  // namespace feelem::viewer::tests
