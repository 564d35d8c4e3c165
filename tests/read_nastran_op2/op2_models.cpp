// SPDX-License-Identifier: Apache-2.0
#include "read_nastran_op2/op2_models.hpp"

#include <utility>

namespace feelem::test {

Op2Word whole(std::int64_t value) {
    return value;
}

/// A GRID of eight words.
Op2Words grid(std::int64_t id, double x, double y, double z, std::int64_t motion) {
    return {whole(id), whole(0), x, y, z, whole(motion), whole(0), whole(0)};
}

/// A tetrahedron 7 of grids 1 to 4 with unit edges, property 3; grid 4 moves in cylindrical system 5.
void write_geometry(Op2Writer& writer, std::int64_t motion) {
    writer.begin_table("GEOM1S");
    if (motion != 0) {
        writer.record(
            {whole(2001),
             whole(20),
             whole(9),
             whole(motion),
             whole(2),
             whole(2),
             whole(0),
             0.,
             0.,
             0.,
             0.,
             0.,
             1.,
             1.,
             0.,
             0.}
        );
    }
    writer.record(joined(
        {{whole(4501), whole(45), whole(1)},
         grid(1, 0, 0, 0),
         grid(2, 1, 0, 0),
         grid(3, 0, 1, 0, motion),
         grid(4, 0, 0, 1)}
    ));
    writer.record({whole(65535), whole(65535), whole(65535)});
    writer.end_table();
    writer.begin_table("GEOM2S");
    writer.record(
        {whole(5508),
         whole(55),
         whole(217),
         whole(7),
         whole(3),
         whole(1),
         whole(2),
         whole(3),
         whole(4),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0)}
    );
    writer.record(joined(
        {{whole(601), whole(6), whole(73)}, {whole(8), whole(1), whole(1), whole(2), whole(1), whole(1)}}
    ));
    writer.end_table();
}

/// A row of a nodal table: translations id + 0.1, 0.2, 0.3 times scale, rotations the same negated.
Op2Words row(std::int64_t id, double scale) {
    const double base = static_cast<double>(id);
    return {
        whole(id * 10 + 1),
        whole(1),
        (base + 0.1) * scale,
        (base + 0.2) * scale,
        (base + 0.3) * scale,
        -(base + 0.1) * scale,
        -(base + 0.2) * scale,
        -(base + 0.3) * scale};
}

Op2Words rows(double scale) {
    return joined({row(1, scale), row(2, scale), row(3, scale), row(4, scale)});
}

/// Two halves of six numbers after the id.
Op2Words complex_row(std::int64_t id) {
    Op2Words out{whole(id * 10), whole(1)};
    for (int i = 1; i <= 12; ++i) out.emplace_back(static_cast<double>(i));
    return out;
}

/// A point of a solid: xx yy zz are base + 1, 2, 3, shears base + 4, 5, 6, von Mises base + 7.
Op2Words solid_point(std::int64_t node, double base) {
    return {whole(node), base + 1, base + 4, 0., 0.,       0.,       0., 0., base + 7, base + 2, base + 5,
            0.,          0.,       0.,       0., base + 3, base + 6, 0., 0., 0.,       0.};
}

Op2Words solid_element(std::int64_t system) {
    Op2Words words = joined({{whole(71), whole(system), std::string("GRID"), whole(4)}, solid_point(0, 0)});
    for (const std::int64_t node : {4, 3, 2, 1})
        words = joined({words, solid_point(node, static_cast<double>(10 * node))});
    return words;
}

std::unique_ptr<ModelSource> open(std::string bytes, Diagnostics& diagnostics) {
    std::vector<NamedBytes> files{{"model.op2", std::move(bytes)}};
    return open_model(std::move(files), {}, diagnostics);
}

std::vector<std::string> names_of(const ModelSource& model) {
    std::vector<std::string> names;
    for (const ResultInfo& info : model.results()) names.push_back(info.name);
    return names;
}

std::string static_file(Op2Form form) {
    Op2Writer writer(form);
    writer.head("NX12");
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({}, rows(1));
    writer.end_table();
    return writer.finish();
}

}  // namespace feelem::test
