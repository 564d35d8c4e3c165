// SPDX-License-Identifier: Apache-2.0
// Lines of the script and what they do to the world.
#include "script.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace feelem::xr_runtime {

namespace {

float number(const Line& line, std::size_t at, float otherwise) {
    return at < line.words.size() ? std::stof(line.words[at]) : otherwise;
}

const std::string& word_at(const Line& line, std::size_t at) {
    static const std::string nothing;
    return at < line.words.size() ? line.words[at] : nothing;
}

Place place_in(const Line& line, std::size_t at) {
    Place place;
    place.position = {number(line, at, 0), number(line, at + 1, 0), number(line, at + 2, 0)};
    place.orientation = glm::normalize(glm::quat(
        number(line, at + 6, 1), number(line, at + 3, 0), number(line, at + 4, 0), number(line, at + 5, 0)
    ));
    return place;
}

Hand* hand_named(World& world, const std::string& name) {
    if (name == "left") return &world.hands[0];
    return name == "right" ? &world.hands[1] : nullptr;
}

void set_pose(World& world, const Line& line) {
    if (Hand* hand = hand_named(world, word_at(line, 1)))
        hand->place = place_in(line, 2);
    else
        world.head = place_in(line, 2);
}

void set_tracking(World& world, const Line& line) {
    const bool on = word_at(line, 2) != "0";
    if (Hand* hand = hand_named(world, word_at(line, 1)))
        hand->is_tracked = on;
    else
        world.is_head_tracked = on;
}

void set_hand(Hand& hand, const Line& line) {
    hand.is_bare = word_at(line, 2) != "off";
    hand.pinch = hand.is_bare ? number(line, 2, 0) : 0;
    hand.fist = hand.is_bare ? number(line, 3, 0) : 0;
}

}  // namespace

std::vector<Line> read_script(const std::string& path) {
    std::vector<Line> lines;
    std::ifstream file(path);
    for (std::string text; std::getline(file, text);) {
        std::istringstream words(text.substr(0, text.find('#')));
        Line line;
        if (!(words >> line.frame)) continue;
        for (std::string word; words >> word;) line.words.push_back(word);
        if (!line.words.empty()) lines.push_back(line);
    }
    std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
        return a.frame < b.frame;
    });
    return lines;
}

bool change(World& world, const Line& line) {
    const std::string& verb = line.words[0];
    Hand* hand = hand_named(world, word_at(line, 1));
    if (verb == "pose")
        set_pose(world, line);
    else if (verb == "tracking")
        set_tracking(world, line);
    else if (verb == "input" && hand)
        hand->inputs[word_at(line, 2)] = number(line, 3, 1);
    else if (verb == "profile" && hand)
        hand->profile = word_at(line, 2);
    else if (verb == "hand" && hand)
        set_hand(*hand, line);
    else if (verb == "render")
        world.renders = word_at(line, 1) != "0";
    else if (verb == "haptics")
        world.refuses_haptics = word_at(line, 1) == "refused";
    else
        return false;
    return true;
}

}  // namespace feelem::xr_runtime
