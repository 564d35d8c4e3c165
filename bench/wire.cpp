// SPDX-License-Identifier: Apache-2.0
// What a surface with a result costs on its way to the page: bytes a triangle with and without zstd, time of
// one core to unpack, and bytes a vertex of each further step. Packs with the arrays and bounds that scenes
// use. Usage: bench_wire sheet SIDE | MODEL.frd | zstd FILE (its size when sent)
#include "base/input.hpp"
#include "scene/packed_arrays.hpp"
#include "scene/steps.hpp"
#include "wire_model.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace feelem;
using bench::Drawn;
using bench::least_time;
using Bytes = std::vector<std::byte>;

constexpr int kLevel = 3;  // As the server sends it.

Bytes zstd_of(const Bytes& bytes) {
    Bytes out(ZSTD_compressBound(bytes.size()));
    out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel));
    return out;
}

struct Packed {
    Bytes bytes, sent;
    PackedView view;
};

Packed finish(Bytes bytes, std::size_t count, std::size_t stride, Packing mode, PackingFilter filter) {
    PackedView view{0, 0, bytes.size(), count, stride, mode, filter};
    Bytes sent = zstd_of(bytes);
    return {std::move(bytes), std::move(sent), view};
}

template <class T>
Packed pack_numbers(
    std::span<const T> numbers, std::size_t width, PackingFilter filter = PackingFilter::None
) {
    const std::size_t stride = width * sizeof(T);
    return finish(
        pack_rows(std::as_bytes(numbers), stride), numbers.size() / width, stride, Packing::Attributes, filter
    );
}

double unpack_seconds(const Packed& packed) {
    return least_time([&] {
        if (!unpack(packed.bytes, packed.view)) throw std::runtime_error("does not unpack");
    });
}

double unsend_seconds(const Packed& packed) {
    Bytes room(packed.bytes.size());
    return least_time([&] {
        if (ZSTD_decompress(room.data(), room.size(), packed.sent.data(), packed.sent.size()) != room.size())
            throw std::runtime_error("zstd lost something");
    });
}

Packed positions_on_grid(const Drawn& model, double& bound) {
    Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (const auto& at : model.positions) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], static_cast<double>(at[axis]));
            high[axis] = std::max(high[axis], static_cast<double>(at[axis]));
        }
    }
    const double largest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const float grid = gltf::grid_of(largest);
    std::vector<float> rounded;
    bound = 0;
    for (const auto& at : model.positions) {
        for (const float coordinate : at) {
            rounded.push_back(gltf::on_grid(static_cast<double>(coordinate), grid));
            bound = std::max(bound, std::abs(static_cast<double>(rounded.back() - coordinate)) / largest);
        }
    }
    const std::vector<std::uint32_t> numbers = with_one_exponent(rounded, grid);
    return pack_numbers<std::uint32_t>(numbers, 3, PackingFilter::Exponential);
}

/// `worst`: how far a value moved at most, as a part of the range.
Packed values_on_steps(const Drawn& model, double bound, double& worst) {
    const auto steps = gltf::steps_within(model.range, bound);
    if (!steps) throw std::runtime_error("no steps within this bound");
    std::vector<std::int32_t> numbers;
    worst = 0;
    const double width = static_cast<double>(model.range[1]) - static_cast<double>(model.range[0]);
    for (const float value : model.values) {
        numbers.push_back(static_cast<std::int32_t>(steps->number(static_cast<double>(value))));
        const double found = static_cast<double>(steps->value(numbers.back()));
        worst = std::max(worst, std::abs(found - static_cast<double>(value)) / width);
    }
    if (worst > bound) throw std::runtime_error("a value moved by more than its bound");
    return pack_numbers<std::int32_t>(numbers, 1);
}

double a_piece(std::size_t bytes, std::size_t pieces) {
    return static_cast<double>(bytes) / static_cast<double>(pieces);
}

void say_whole(
    const char* what,
    const Drawn& model,
    const std::vector<const Packed*>& arrays,
    double values_worst,
    double position_worst
) {
    const std::size_t triangles = model.indices.size() / 3;
    std::size_t bytes = 0, sent = 0;
    double unpacking = 0, unsending = 0;
    for (const Packed* array : arrays) {
        bytes += array->bytes.size();
        sent += array->sent.size();
        unpacking += unpack_seconds(*array);
        unsending += unsend_seconds(*array);
    }
    const double millions = static_cast<double>(triangles) / 1e6;
    fmt::print(
        "{{\"what\": \"{}\", \"triangles\": {}, \"bytes_a_triangle\": {:.3f}, \"with_zstd\": {:.3f}, "
        "\"indices\": {:.3f}, \"positions_a_vertex\": {:.3f}, \"values_a_vertex\": {:.3f}, "
        "\"value_off\": {:.3g}, \"position_off\": {:.3g}, \"unpack_mtri_s\": {:.1f}, \"zstd_mtri_s\": "
        "{:.1f}, "
        "\"decode_mtri_s\": {:.1f}}}\n",
        what,
        triangles,
        a_piece(bytes, triangles),
        a_piece(sent, triangles),
        a_piece(arrays[0]->sent.size(), triangles),
        a_piece(arrays[1]->sent.size(), model.positions.size()),
        a_piece(arrays[2]->sent.size(), model.positions.size()),
        values_worst,
        position_worst,
        millions / unpacking,
        millions / unsending,
        millions / (unpacking + unsending)
    );
}

void measure(const Drawn& model) {
    const Packed indices = finish(
        pack_indices(model.indices, Packing::Triangles),
        model.indices.size(),
        4,
        Packing::Triangles,
        PackingFilter::None
    );
    std::vector<float> flat;
    for (const auto& at : model.positions) flat.insert(flat.end(), at.begin(), at.end());
    const Packed exact_positions = pack_numbers<float>(flat, 3);
    const Packed exact_values = pack_numbers<float>(model.values, 1);
    double position_off = 0, value_off = 0;
    const Packed positions = positions_on_grid(model, position_off);
    const Packed values = values_on_steps(model, 1e-4, value_off);
    say_whole("bounded, 1e-4 of range", model, {&indices, &positions, &values}, value_off, position_off);
    say_whole("lossless", model, {&indices, &exact_positions, &exact_values}, 0, 0);
    for (const double bound : {1e-2, 1e-3, 1e-4}) {
        const Packed step = values_on_steps(model, bound, value_off);
        fmt::print(
            "{{\"what\": \"a further step\", \"bound\": {:g}, \"bytes_a_vertex\": {:.3f}, \"with_zstd\": "
            "{:.3f}, "
            "\"value_off\": {:.3g}}}\n",
            bound,
            a_piece(step.bytes.size(), model.values.size()),
            a_piece(step.sent.size(), model.values.size()),
            value_off
        );
    }
    fmt::print(
        "{{\"what\": \"a further step, lossless\", \"bytes_a_vertex\": {:.3f}, \"with_zstd\": {:.3f}}}\n",
        a_piece(exact_values.bytes.size(), model.values.size()),
        a_piece(exact_values.sent.size(), model.values.size())
    );
}

}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> given(arguments + 1, arguments + count);
    if (given.size() == 2 && given[0] == "zstd") {
        const Input file = Input::from_file(given[1]);
        fmt::print("{}\n", zstd_of({file.bytes().begin(), file.bytes().end()}).size());
    } else if (given.size() == 2 && given[0] == "zstd") {
        const Input file = Input::from_file(given[1]);
        fmt::print("{}\n", zstd_of({file.bytes().begin(), file.bytes().end()}).size());
    } else if (const auto model = bench::drawn_model(given)) {
        measure(*model);
    } else {
        fmt::print(stderr, "usage: bench_wire sheet SIDE | MODEL.frd | zstd FILE\n");
        return 2;
    }
}
