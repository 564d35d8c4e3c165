// SPDX-License-Identifier: Apache-2.0
// Which part of which controller does what.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace feelem::viewer::xr {

enum class Part : std::uint8_t {
    Aim,
    Grip,
    Trigger,
    Squeeze,
    Stick,
    StickPressed,
    LowerButton,
    UpperButton,
    Menu,
    Shake,
};
inline constexpr std::size_t kParts = 10;

struct PartPath {
    Part part;
    std::string_view path;  ///< After /user/hand/left/ or right/; empty at the end of a shorter list.
};

struct Profile {
    std::string_view path, name;  ///< As people call it.
    std::span<const PartPath> both, left, right;
    /// Its pad counts as a stick only while it is pressed, and as pressed only in its middle: a thumb rests
    /// on it.
    bool has_pad_for_stick = false;
};

std::span<const Profile> profiles();
/// Null: none of ours.
const Profile* find_profile(std::string_view path);

}  // namespace feelem::viewer::xr
