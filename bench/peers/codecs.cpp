// SPDX-License-Identifier: Apache-2.0
// Draco and zfp on what bench_wire packs: the same positions, triangles and result within the same bounds.
// Usage: bench_codecs sheet SIDE | MODEL.frd
#include "wire_model.hpp"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <fmt/format.h>
#include <zfp.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

namespace {

using namespace feelem;
using bench::Drawn;
using bench::least_time;

constexpr int kPositionBits = 16;

int add_attribute(
    draco::Mesh& mesh, draco::GeometryAttribute::Type type, std::uint8_t width, const float* values
) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, width, draco::DT_FLOAT32, false, 4 * width, 0);
    const int id = mesh.AddAttribute(attribute, true, mesh.num_points());
    for (std::uint32_t v = 0; v < mesh.num_points(); ++v)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), values + v * width);
    return id;
}

std::unique_ptr<draco::Mesh> mesh_of(const Drawn& model) {
    auto mesh = std::make_unique<draco::Mesh>();
    mesh->set_num_points(static_cast<std::uint32_t>(model.positions.size()));
    add_attribute(*mesh, draco::GeometryAttribute::POSITION, 3, model.positions.front().data());
    add_attribute(*mesh, draco::GeometryAttribute::GENERIC, 1, model.values.data());
    mesh->SetNumFaces(model.indices.size() / 3);
    for (std::size_t t = 0; t < model.indices.size() / 3; ++t) {
        draco::Mesh::Face face;
        for (std::size_t corner = 0; corner < 3; ++corner)
            face[corner] = draco::PointIndex(model.indices[3 * t + corner]);
        mesh->SetFace(draco::FaceIndex(static_cast<std::uint32_t>(t)), face);
    }
    return mesh;
}

/// Not a number when Draco gives another number of vertices back. It orders them anew: the sorted values can
/// differ by no more than the values of the vertices do.
double worst_of(const Drawn& model, const draco::Mesh& mesh) {
    const draco::PointAttribute* attribute = mesh.GetNamedAttribute(draco::GeometryAttribute::GENERIC);
    std::vector<float> found, wanted = model.values;
    for (std::uint32_t p = 0; p < mesh.num_points(); ++p) {
        float value = 0;
        attribute->GetMappedValue(draco::PointIndex(p), &value);
        found.push_back(value);
    }
    if (found.size() != wanted.size()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(found);
    std::ranges::sort(wanted);
    double worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(found[i]) - static_cast<double>(wanted[i])));
    return worst / (static_cast<double>(model.range[1]) - static_cast<double>(model.range[0]));
}

void measure_draco(const Drawn& model, int speed) {
    constexpr double kBound = 1e-4;
    const auto mesh = mesh_of(model);
    draco::Encoder encoder;
    encoder.SetSpeedOptions(speed, speed);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, kPositionBits);
    encoder.SetAttributeQuantization(
        draco::GeometryAttribute::GENERIC, static_cast<int>(std::ceil(std::log2(0.5 / kBound + 1)))
    );
    draco::EncoderBuffer packed;
    if (!encoder.EncodeMeshToBuffer(*mesh, &packed).ok()) throw std::runtime_error("Draco cannot pack it");
    std::unique_ptr<draco::Mesh> unpacked;
    const double seconds = least_time([&] {
        draco::DecoderBuffer bytes;
        bytes.Init(packed.data(), packed.size());
        draco::Decoder decoder;
        unpacked = decoder.DecodeMeshFromBuffer(&bytes).value();
    });
    const auto triangles = static_cast<double>(model.indices.size() / 3);
    const double worst = worst_of(model, *unpacked);
    fmt::print(
        "{{\"what\": \"Draco 1.5.5, speed {}\", \"bound\": {:g}, \"triangles\": {}, \"bytes_a_triangle\": "
        "{:.3f}, "
        "\"value_off\": {}, \"decode_mtri_s\": {:.2f}}}\n",
        speed,
        kBound,
        model.indices.size() / 3,
        static_cast<double>(packed.size()) / triangles,
        std::isnan(worst) ? "null" : fmt::format("{:.3g}", worst),
        1e-6 * triangles / seconds
    );
}

struct ZfpField {
    zfp_field* field;
    explicit ZfpField(std::vector<float>& values)
        : field(zfp_field_1d(values.data(), zfp_type_float, values.size())) {}
    ~ZfpField() { zfp_field_free(field); }
};

void measure_zfp(const Drawn& model, double bound) {
    const double width = static_cast<double>(model.range[1]) - static_cast<double>(model.range[0]);
    std::vector<float> values = model.values, found(values.size());
    zfp_stream* stream = zfp_stream_open(nullptr);
    zfp_stream_set_accuracy(stream, bound * width);
    const ZfpField from(values), to(found);
    std::vector<char> room(zfp_stream_maximum_size(stream, from.field));
    bitstream* bits = stream_open(room.data(), room.size());
    zfp_stream_set_bit_stream(stream, bits);
    const std::size_t size = zfp_compress(stream, from.field);
    const double seconds = least_time([&] {
        zfp_stream_rewind(stream);
        if (zfp_decompress(stream, to.field) == 0) throw std::runtime_error("zfp cannot unpack it");
    });
    stream_close(bits);
    zfp_stream_close(stream);
    double worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        worst =
            std::max(worst, std::abs(static_cast<double>(found[i]) - static_cast<double>(values[i])) / width);
    fmt::print(
        "{{\"what\": \"zfp 1.0, one dimension, a step\", \"bound\": {:g}, \"bytes_a_vertex\": {:.3f}, "
        "\"value_off\": {:.3g}, \"decode_mvertices_s\": {:.1f}}}\n",
        bound,
        static_cast<double>(size) / static_cast<double>(values.size()),
        worst,
        1e-6 * static_cast<double>(values.size()) / seconds
    );
}

}  // namespace

int main(int count, char** arguments) {
    const auto model = bench::drawn_model({arguments + 1, arguments + count});
    if (!model) {
        fmt::print(stderr, "usage: bench_codecs sheet SIDE | MODEL.frd\n");
        return 2;
    }
    for (const int speed : {5, 0}) measure_draco(*model, speed);
    for (const double bound : {1e-2, 1e-3, 1e-4}) measure_zfp(*model, bound);
}
