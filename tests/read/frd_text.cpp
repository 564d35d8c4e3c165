// SPDX-License-Identifier: Apache-2.0
#include "read/frd_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace feelem::test {
namespace {

template <class T>
void put(std::string& out, T value, bool swapped) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (swapped) std::reverse(bytes, bytes + sizeof(T));
    out.append(bytes, sizeof(T));
}

std::string mesh_head(const char* key, std::size_t count, int digit) {
    return fmt::format("    {}{:18}{:12}{:37}{}\n", key, "", count, "", digit);
}

std::string result_head(std::size_t count, int step, double value, int analysis, int digit) {
    return fmt::format(
        "  100CL  101{:12.5E}{:12}{:20}{:2}{:5}{:10} {}\n", value, count, "", analysis, step, "", digit
    );
}

}  // namespace

FrdText& FrdText::node(std::int64_t id, double x, double y, double z) {
    nodes_ += fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", id, x, y, z);
    ++node_count_;
    return *this;
}

FrdText& FrdText::result(
    const std::string& name,
    const std::vector<std::string>& components,
    std::size_t count,
    int step,
    double value,
    int analysis
) {
    results_ += result_head(count, step, value, analysis, 1);
    results_ += fmt::format(" -4  {:8}{:5}{:5}\n", name, components.size(), 1);
    for (const std::string& component : components) results_ += " -5  " + component + "\n";
    return *this;
}

FrdText& FrdText::line(const std::string& text) {
    results_ += text + "\n";
    return *this;
}

FrdText& FrdText::record(std::int64_t id, const std::vector<double>& values) {
    results_ += fmt::format(" -1{:10}", id);
    for (const double value : values) results_ += fmt::format("{:12.5E}", value);
    results_ += "\n";
    return *this;
}

std::string FrdText::text() const {
    std::string out = "    1C\n    1Ua small model\n    1UPGM               CalculiX\n";
    out += "    1UVERSION           Version 2.20\n";
    if (node_count_ == 0) {
        FrdText tet;
        tet.node(1, 0, 0, 0).node(2, 1, 0, 0).node(3, 0, 1, 0).node(4, 0, 0, 1);
        out += mesh_head("2C", 4, 1) + tet.nodes_;
    } else {
        out += mesh_head("2C", node_count_, 1) + nodes_;
    }
    out += " -3\n" + mesh_head("3C", 1, 1);
    out += " -1         1    3    0    1\n -2         1         2         3         4\n -3\n";
    return out + results_ + " 9999\n";
}

std::string scalar(const std::string& name) {
    return fmt::format("{:8}{:5}{:5}{:5}{:5}", name, 1, 1, 0, 0);
}

std::vector<std::string> vector_with_all(const std::string& letter) {
    std::vector<std::string> lines;
    for (int i = 1; i <= 3; ++i)
        lines.push_back(fmt::format("{:8}{:5}{:5}{:5}{:5}{:5}", letter + std::to_string(i), 1, 2, i, 0, 0));
    lines.push_back(fmt::format("{:8}{:5}{:5}{:5}{:5}{:5}ALL", "ALL", 1, 2, 0, 0, 1));
    return lines;
}

std::string binary_frd(bool swapped) {
    std::string out = "    1C\n" + mesh_head("2C", 4, 3);
    const double nodes[4][3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::int32_t i = 0; i < 4; ++i) {
        put(out, i + 1, swapped);
        for (const double x : nodes[i]) put(out, x, swapped);
    }
    out += mesh_head("3C", 1, 2);
    for (const std::int32_t word : {1, 3, 0, 7, 1, 2, 3, 4}) put(out, word, swapped);
    out += result_head(4, 1, 1, 0, 2) + " -4  NDTEMP      1    1\n -5  T           1    1    0    0\n";
    for (std::int32_t i = 1; i <= 4; ++i) {
        put(out, i, swapped);
        put(out, 10.0F * static_cast<float>(i), swapped);
    }
    return out + " 9999\n";
}

}  // namespace feelem::test
