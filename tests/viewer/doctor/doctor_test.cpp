// SPDX-License-Identifier: Apache-2.0
// What the doctor says of machines that are made up, fault by fault.
#include "support/paths.hpp"
#include "viewer/doctor/doctor.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace feelem::viewer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kMonado = R"({
    "file_format_version": "1.0.0",
    "runtime": { "name": "Monado", "library_path": "libopenxr_monado.so" }
})";

/// A workstation on which all is well; the tests take parts away.
class Doctor : public testing::Test {
protected:
    Doctor() {
        machine.root = test::scratch_folder(
            std::string("doctor_") + testing::UnitTest::GetInstance()->current_test_info()->name()
        );
        machine.environment = [this](const std::string& name) { return variables[name]; };
        machine.can_use = [this](const fs::path& path) { return !closed.contains(path.filename().string()); };
        put("/usr/share/openxr/1/openxr_monado.json", kMonado);
        put("/usr/lib/x86_64-linux-gnu/libopenxr_monado.so", "");
        put("/etc/xdg/openxr/1/active_runtime.json", kMonado);
        put("/run/user/1000/pipewire-0", "");
        put("/proc/asound/cards",
            " 0 [PCH            ]: HDA-Intel - HDA Intel PCH\n                      at 0xdf\n");
        put("/proc/bus/input/devices",
            "I: Bus=0011 Vendor=0001\nN: Name=\"AT keyboard\"\nH: Handlers=sysrq kbd event0 leds\n\n"
            "I: Bus=0003 Vendor=054c\nN: Name=\"Wireless Controller\"\nH: Handlers=event7 js0 \n");
        put("/dev/dri/renderD128", "");
    }

    void put(const fs::path& path, const std::string& text) const {
        fs::create_directories(machine.at(path).parent_path());
        test::write_file(machine.at(path).string(), text);
    }
    void remove(const fs::path& path) const { fs::remove_all(machine.at(path)); }
    void link(const fs::path& path, const fs::path& target) const {
        fs::create_directories(machine.at(path).parent_path());
        fs::remove(machine.at(path));
        fs::create_symlink(target, machine.at(path));
    }

    std::string report() const {
        return report_of(examine(machine, graphics, is_tried ? &headset : nullptr));
    }
    Verdict verdict() const { return verdict_on(examine(machine, graphics, is_tried ? &headset : nullptr)); }
    /// The line of a finding, without its name.
    std::string line(const std::string& what) const {
        const std::string text = '\n' + report();
        const std::size_t at = text.find('\n' + what + ' ');
        if (at == std::string::npos) return "";
        return text.substr(at + 12, text.find('\n', at + 1) - at - 12);
    }
    std::string to_do() const {
        const std::string text = report();
        const std::size_t at = text.find("To do first");
        return at == std::string::npos ? "" : text.substr(at);
    }

    Machine machine;
    mutable std::map<std::string, std::string> variables{
        {"HOME", "/home/ann"}, {"DISPLAY", ":0"}, {"XDG_RUNTIME_DIR", "/run/user/1000"}};
    std::set<std::string> closed;
    TriedGraphics graphics{"4.6 (Core Profile) Mesa 22.3.6", "AMD Radeon RX 7900 XT", "", ""};
    bool is_tried = true;
    XrStatus headset = [] {
        XrStatus status;
        status.runtime = "Monado(XRT) by Collabora et al '25.0.0'";
        status.headset = "Valve Index";
        return status;
    }();
};

TEST_F(Doctor, finds_nothing_to_do_where_all_is_well) {
    EXPECT_EQ(
        report(),
        "graphics   yes   OpenGL 4.6, AMD Radeon RX 7900 XT\n"
        "screen     yes   :0\n"
        "runtime    yes   Monado, chosen by /etc/xdg/openxr/1/active_runtime.json\n"
        "service    yes   Monado(XRT) by Collabora et al '25.0.0'\n"
        "headset    yes   Valve Index\n"
        "sound      yes   PipeWire, HDA-Intel - HDA Intel PCH\n"
        "gamepad    yes   Wireless Controller\n"
        "\n"
        "On the desk: yes. In a headset: yes.\n"
    );
}

TEST_F(Doctor, names_the_runtimes_to_choose_from_where_none_is_installed) {
    remove("/usr/share/openxr");
    remove("/etc/xdg/openxr");
    headset = {};
    headset.state = XrState::NoRuntime;
    EXPECT_EQ(
        report(),
        "graphics   yes   OpenGL 4.6, AMD Radeon RX 7900 XT\n"
        "screen     yes   :0\n"
        "runtime    no    no OpenXR runtime is installed\n"
        "sound      yes   PipeWire, HDA-Intel - HDA Intel PCH\n"
        "gamepad    yes   Wireless Controller\n"
        "\n"
        "On the desk: yes. In a headset: no.\n"
        "To do first (runtime): For a headset, install its runtime: SteamVR (Index, Vive), WiVRn (Quest, "
        "Pico), "
        "Monado (many others).\n"
    );
}

TEST_F(Doctor, says_how_to_choose_a_runtime_that_is_only_installed) {
    remove("/etc/xdg/openxr");
    EXPECT_EQ(
        line("runtime"), "no    /usr/share/openxr/1/openxr_monado.json is installed, but no runtime is chosen"
    );
    EXPECT_EQ(
        to_do(),
        "To do first (runtime): Choose it: mkdir -p ~/.config/openxr/1 && ln -sf "
        "/usr/share/openxr/1/openxr_monado.json ~/.config/openxr/1/active_runtime.json\n"
    );
}

TEST_F(Doctor, finds_steamvr_in_the_home_of_its_user) {
    remove("/etc/xdg/openxr");
    remove("/usr/share/openxr");
    put("/home/ann/.local/share/Steam/steamapps/common/SteamVR/steamxr_linux64.json", "{}");
    EXPECT_THAT(
        line("runtime"), HasSubstr("SteamVR/steamxr_linux64.json is installed, but no runtime is chosen")
    );
}

TEST_F(Doctor, takes_the_choice_of_the_user_before_that_of_the_machine) {
    put("/home/ann/.config/openxr/1/active_runtime.json",
        R"({"runtime": {"library_path": "./bin/linux64/vrclient.so"}})");
    put("/home/ann/.config/openxr/1/bin/linux64/vrclient.so", "");
    EXPECT_EQ(line("runtime"), "yes   SteamVR, chosen by /home/ann/.config/openxr/1/active_runtime.json");
    variables["XDG_CONFIG_HOME"] = "/elsewhere";
    EXPECT_EQ(line("runtime"), "yes   Monado, chosen by /etc/xdg/openxr/1/active_runtime.json");
}

TEST_F(Doctor, takes_the_runtime_of_the_environment_before_all) {
    variables["XR_RUNTIME_JSON"] = "/opt/wivrn.json";
    put("/opt/wivrn.json", R"({"runtime": {"library_path": "/opt/libopenxr_wivrn.so"}})");
    put("/opt/libopenxr_wivrn.so", "");
    EXPECT_EQ(line("runtime"), "yes   WiVRn, chosen by XR_RUNTIME_JSON");
    remove("/opt/wivrn.json");
    EXPECT_EQ(line("runtime"), "no    XR_RUNTIME_JSON names /opt/wivrn.json, which is not there");
    EXPECT_EQ(to_do(), "To do first (runtime): Correct XR_RUNTIME_JSON, or unset it.\n");
}

TEST_F(Doctor, passes_over_a_broken_link_as_the_loader_does) {
    link("/home/ann/.config/openxr/1/active_runtime.json", "/nowhere/wivrn.json");
    EXPECT_EQ(line("runtime"), "yes   Monado, chosen by /etc/xdg/openxr/1/active_runtime.json");
    remove("/etc/xdg/openxr");
    EXPECT_EQ(
        line("runtime"),
        "no    /home/ann/.config/openxr/1/active_runtime.json points to /nowhere/wivrn.json, which is not "
        "there"
    );
    EXPECT_EQ(
        to_do(),
        "To do first (runtime): Choose what is there: ln -sf /usr/share/openxr/1/openxr_monado.json "
        "/home/ann/.config/openxr/1/active_runtime.json\n"
    );
}

TEST_F(Doctor, does_not_believe_a_file_that_describes_no_runtime) {
    for (const char* text :
         {"", "\"library_path\"", "{\"library_path\": 7}", "{\"library_path\": \"", "\xff\xfe"}) {
        put("/etc/xdg/openxr/1/active_runtime.json", text);
        EXPECT_EQ(
            line("runtime"),
            "no    /etc/xdg/openxr/1/active_runtime.json describes no OpenXR runtime (no \"library_path\")"
        ) << text;
    }
}

TEST_F(Doctor, misses_the_library_of_a_runtime_that_was_removed_by_half) {
    remove("/usr/lib/x86_64-linux-gnu/libopenxr_monado.so");
    EXPECT_EQ(
        line("runtime"),
        "no    /etc/xdg/openxr/1/active_runtime.json names the library libopenxr_monado.so, which is not "
        "there"
    );
    EXPECT_EQ(to_do(), "To do first (runtime): Install Monado again.\n");
    EXPECT_FALSE(verdict().headset);
}

TEST_F(Doctor, says_how_to_start_a_service_that_does_not_run) {
    headset.state = XrState::NoService;
    EXPECT_EQ(
        report(),
        "graphics   yes   OpenGL 4.6, AMD Radeon RX 7900 XT\n"
        "screen     yes   :0\n"
        "runtime    yes   Monado, chosen by /etc/xdg/openxr/1/active_runtime.json\n"
        "service    no    Monado is chosen, but it does not run\n"
        "headset    no    not asked\n"
        "sound      yes   PipeWire, HDA-Intel - HDA Intel PCH\n"
        "gamepad    yes   Wireless Controller\n"
        "\n"
        "On the desk: yes. In a headset: no.\n"
        "To do first (service): Start Monado's service: systemctl --user start monado.service, or "
        "monado-service "
        "in a terminal.\n"
    );
}

TEST_F(Doctor, tells_a_crashed_service_by_the_socket_it_left) {
    headset.state = XrState::NoService;
    put("/run/user/1000/monado_comp_ipc", "");
    EXPECT_EQ(
        line("service"),
        "no    /run/user/1000/monado_comp_ipc is there, but nobody answers: the service has crashed or hangs"
    );
}

TEST_F(Doctor, knows_that_another_user_does_not_see_the_service) {
    headset.state = XrState::NoService;
    variables.erase("XDG_RUNTIME_DIR");
    EXPECT_EQ(line("service"), "no    XDG_RUNTIME_DIR is not set, so the service cannot be found");
    EXPECT_EQ(to_do(), "To do first (service): Start feelem-xr from your own session, without sudo or su.\n");
}

TEST_F(Doctor, asks_for_the_headset_when_only_that_is_missing) {
    headset.state = XrState::NoHeadset;
    EXPECT_EQ(line("headset"), "no    Monado finds none");
    EXPECT_EQ(
        to_do(),
        "To do first (headset): Connect the headset and switch it on; the package xr-hardware lets you use "
        "it "
        "without being root.\n"
    );
}

TEST_F(Doctor, passes_on_why_a_headset_cannot_be_used) {
    headset.state = XrState::Unusable;
    headset.why = "it takes no pictures from OpenGL";
    headset.hint = "Use another runtime.";
    EXPECT_EQ(line("headset"), "no    it takes no pictures from OpenGL");
    EXPECT_EQ(to_do(), "To do first (headset): Use another runtime.\n");
    EXPECT_FALSE(verdict().headset);
}

TEST_F(Doctor, says_when_the_loader_cannot_use_a_runtime_whose_files_are_there) {
    headset.state = XrState::NoRuntime;
    EXPECT_EQ(line("service"), "no    not asked: its library cannot be used");
    EXPECT_EQ(to_do(), "To do first (service): Install Monado again.\n");
}

TEST_F(Doctor, needs_opengl_before_all_else) {
    graphics = {"", "", "OpenGL 4.5 is needed, there is 3.3", ""};
    is_tried = false;
    remove("/etc/xdg/openxr");
    EXPECT_EQ(line("graphics"), "no    OpenGL 4.5 is needed, there is 3.3");
    EXPECT_THAT(to_do(), HasSubstr("To do first (graphics): Install an OpenGL 4.5 driver"));
    EXPECT_FALSE(verdict().desk);
    EXPECT_FALSE(verdict().headset);
}

TEST_F(Doctor, tells_why_the_processor_draws) {
    graphics.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    graphics.version = "4.5 (Core Profile) Mesa 22.3.6";
    EXPECT_THAT(line("graphics"), HasSubstr("The graphics card /dev/dri/renderD128 has no OpenGL driver"));
    closed.insert("renderD128");
    EXPECT_EQ(
        line("graphics"),
        "poor  OpenGL 4.5, llvmpipe (LLVM 15.0.6, 256 bits): slow. The graphics card /dev/dri/renderD128 is "
        "not open to you"
    );
    EXPECT_THAT(to_do(), HasSubstr("sudo usermod -aG render"));
    remove("/dev/dri");
    EXPECT_THAT(line("graphics"), HasSubstr("No graphics card is to be seen here"));
    EXPECT_EQ(to_do(), "");  // Nothing can be done about it.
    EXPECT_TRUE(verdict().desk);
}

TEST_F(Doctor, tells_a_session_without_a_screen_and_one_over_ssh) {
    variables.erase("DISPLAY");
    EXPECT_EQ(to_do(), "To do first (screen): Start it in a desktop session.\n");
    variables["SSH_CONNECTION"] = "10.0.0.1 22";
    EXPECT_EQ(to_do(), "To do first (screen): Start it at the machine itself, not over ssh.\n");
    EXPECT_FALSE(verdict().desk);
    EXPECT_TRUE(verdict().headset);
}

TEST_F(Doctor, passes_on_why_a_screen_cannot_be_used) {
    graphics.screen_trouble =
        "no screen to open a window on (x11. not available). Start it elsewhere, or not at all.";
    EXPECT_EQ(line("screen"), "no    no screen to open a window on (x11. not available)");
    EXPECT_EQ(to_do(), "To do first (screen): Start it elsewhere, or not at all.\n");
    graphics.screen_trouble = "it is broken";
    EXPECT_EQ(line("screen"), "no    it is broken");
    EXPECT_EQ(to_do(), "");
}

TEST_F(Doctor, misses_sound_without_card_and_server) {
    remove("/run/user/1000/pipewire-0");
    put("/proc/asound/cards", "--- no soundcards ---\n");
    EXPECT_EQ(
        line("sound"), "no    no sound card and no sound server: values can be seen and felt, not heard"
    );
}

TEST_F(Doctor, sees_a_gamepad_that_is_not_open_to_the_user) {
    closed.insert("event7");
    EXPECT_EQ(line("gamepad"), "poor  Wireless Controller, but /dev/input/event7 is not open to you");
    EXPECT_THAT(to_do(), HasSubstr("sudo usermod -aG input"));
    remove("/proc/bus/input/devices");
    EXPECT_EQ(line("gamepad"), "no    none here; at the desk, one would let the hand feel");
}

TEST_F(Doctor, survives_a_machine_with_nothing) {
    machine.root = "/nowhere/at/all";
    variables.clear();
    headset.state = XrState::NoRuntime;
    EXPECT_THAT(report(), HasSubstr("runtime    no    no OpenXR runtime is installed\n"));
    EXPECT_THAT(report(), Not(HasSubstr("yes   \n")));
}

}  // namespace
}  // namespace feelem::viewer
