// SPDX-License-Identifier: Apache-2.0
#include "read_gmsh/msh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace feelem::test {
namespace {

class Writer {
public:
    explicit Writer(const MshForm& form) : form_(form) {}

    void line(const std::string& text) { out += text + "\n"; }
    void integer(int value) { put(std::int32_t{value}); }
    void size(int value) { form_.binary ? put(std::int64_t{value}) : put(std::int32_t{value}); }
    void real(double value) { put(value); }
    void end_row() {
        if (!form_.binary) out += '\n';
    }

    std::string out;

private:
    template <class T>
    void put(T value) {
        if (!form_.binary) {
            out += fmt::format("{} ", value);
            return;
        }
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        if (form_.big_endian) std::reverse(bytes, bytes + sizeof(T));
        out.append(bytes, sizeof(T));
    }

    MshForm form_;
};

void write_place(Writer& to, const std::vector<double>& place) {
    for (const double x : place) to.real(x);
    to.end_row();
}

void write_nodes(Writer& to, const MshForm& form, const std::vector<std::vector<double>>& places) {
    const int count = static_cast<int>(places.size());
    to.line("$Nodes");
    if (form.version == 22) {
        to.line(fmt::format("{}", count));
    } else {
        to.size(1);
        to.size(count);
        if (form.version == 41) to.size(1), to.size(count);
        to.end_row();
        for (const int value : {3, 3, 0}) to.integer(value);
        to.size(count);
        to.end_row();
        for (int i = 1; i <= count && form.version == 41; ++i) to.size(i), to.end_row();
    }
    for (int i = 1; i <= count; ++i) {
        if (form.version != 41) to.integer(i);
        write_place(to, places[static_cast<std::size_t>(i - 1)]);
    }
    to.end_row();
    to.line("$EndNodes");
}

void write_element(Writer& to, const MshForm& form, int type, int count) {
    to.line("$Elements");
    if (form.version == 22) {
        to.line("1");
        if (form.binary) {
            for (const int value : {type, 1, 2, 7}) to.integer(value);
        } else {
            for (const int value : {7, type, 2}) to.integer(value);
        }
        to.integer(4);
        to.integer(3);
        for (int i = 1; i <= count; ++i) to.integer(i);
    } else {
        to.size(1);
        to.size(1);
        if (form.version == 41) to.size(7), to.size(7);
        to.end_row();
        for (const int value : {3, 3, type}) to.integer(value);
        to.size(1);
        to.end_row();
        const auto tag = [&](int value) { form.version == 41 ? to.size(value) : to.integer(value); };
        tag(7);
        for (int i = 1; i <= count; ++i) tag(i);
    }
    to.end_row();
    to.line("$EndElements");
}

}  // namespace

std::string write_msh(const MshForm& form, int type, const std::vector<std::vector<double>>& places) {
    Writer to(form);
    to.line("$MeshFormat");
    to.line(fmt::format("{}.{} {} 8", form.version / 10, form.version % 10, form.binary ? 1 : 0));
    if (form.binary) {
        to.integer(1);
        to.line("");
    }
    to.line("$EndMeshFormat");
    write_nodes(to, form, places);
    write_element(to, form, type, static_cast<int>(places.size()));
    to.line(fmt::format("$NodeData\n1\n\"T\"\n1\n2.5\n3\n4\n1\n{}", places.size()));
    for (std::size_t i = 1; i <= places.size(); ++i) {
        to.integer(static_cast<int>(i));
        to.real(static_cast<double>(i) + 0.25);
        to.end_row();
    }
    to.end_row();
    to.line("$EndNodeData");
    return to.out;
}

}  // namespace feelem::test
