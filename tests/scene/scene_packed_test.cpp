// SPDX-License-Identifier: Apache-2.0
// Compressed scenes: smaller, and either the same bit for bit or within the bound that they state.
#include "scene/packed_arrays.hpp"
#include "scene/sample_scenes.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

namespace feelem::test {
namespace {

SceneOptions packed(double bound = 0) {
    SceneOptions options;
    options.compress = true;
    options.bound = bound;
    return options;
}

/// The sample with the ranges that the converter would give it.
std::unique_ptr<Sample> sample_with_ranges(int side) {
    auto sample = brick_sample(side, side, 2);
    for (std::size_t r = 0; r < sample->fields.size(); ++r) {
        std::array<float, 2> range{INFINITY, -INFINITY};
        const SurfaceField& field = sample->fields[r][0];
        for (std::size_t v = 0; v < field.validity.size(); ++v) {
            for (std::size_t c = 0; c < field.component_count; ++c) {
                const float value = field.values[v * field.component_count + c];
                if (!std::isfinite(value) || sample->surface.vertex_node[v] == kNoNode) continue;
                range = {std::min(range[0], value), std::max(range[1], value)};
            }
        }
        sample->contents.results[r].range = range;
    }
    return sample;
}

void expect_same_bits(std::span<const float> a, std::span<const float> b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i])) << i;
}

void expect_all_claims_hold(const std::string& path) {
    for (const Claim& claim : check_scene(path))
        EXPECT_TRUE(claim.holds) << claim.name << ": " << claim.claimed << " but " << claim.found;
}

TEST(PackedScene, holds_the_same_numbers_in_fewer_bytes) {
    const auto sample = sample_with_ranges(12);
    const std::string plain = write_sample(*sample, "packed_plain");
    const std::string small = write_sample(*sample, "packed_lossless", packed());

    const Scene a = load_scene(plain), b = load_scene(small);

    EXPECT_LT(std::filesystem::file_size(small), std::filesystem::file_size(plain) * 3 / 4);
    ASSERT_EQ(a.fields.size(), b.fields.size());
    for (std::size_t f = 0; f < a.fields.size(); ++f) {
        expect_same_bits(a.fields[f].values, b.fields[f].values);
        EXPECT_EQ(a.fields[f].validity, b.fields[f].validity);
    }
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t p = 0; p < a.parts.size(); ++p) {
        EXPECT_EQ(a.parts[p].positions, b.parts[p].positions);
        EXPECT_EQ(a.parts[p].triangles, b.parts[p].triangles);
        EXPECT_EQ(a.parts[p].node_ids, b.parts[p].node_ids);
        EXPECT_EQ(a.parts[p].element_ids, b.parts[p].element_ids);
    }
    for (const SceneResult& result : b.results) EXPECT_EQ(result.bound, 0);
    expect_all_claims_hold(small);
}

TEST(PackedScene, with_a_bound_keeps_every_value_within_it_and_says_so) {
    const auto sample = sample_with_ranges(12);
    const double bound = 1e-3;
    const std::string path = write_sample(*sample, "packed_bounded", packed(bound));
    const Scene scene = load_scene(path);

    std::size_t changed = 0;
    for (const SceneField& field : scene.fields) {
        const SceneResult& result = scene.results[field.result];
        const std::array<float, 2> range = *sample->contents.results[field.result].range;
        const double width = static_cast<double>(range[1]) - static_cast<double>(range[0]);
        EXPECT_DOUBLE_EQ(result.bound, bound * width) << result.id;
        const std::vector<float>& wanted = sample->fields[field.result][0].values;
        ASSERT_EQ(field.values.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const double off =
                std::abs(static_cast<double>(field.values[i]) - static_cast<double>(wanted[i]));
            ASSERT_LE(off, result.bound) << result.id;
            changed += off > 0 ? 1u : 0u;
        }
    }
    EXPECT_GT(changed, 100u) << "a bound that loses nothing was not used";
    EXPECT_EQ(scene.parts[0].node_ids, load_scene(write_sample(*sample, "packed_plain2")).parts[0].node_ids);
    expect_all_claims_hold(path);
}

TEST(PackedScene, with_a_bound_keeps_the_ends_of_a_range_exact) {
    const auto sample = sample_with_ranges(8);
    const Scene scene = load_scene(write_sample(*sample, "packed_ends", packed(0.01)));
    for (const SceneField& field : scene.fields) {
        const std::array<float, 2> range = *sample->contents.results[field.result].range;
        const std::vector<float>& wanted = sample->fields[field.result][0].values;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (wanted[i] == range[0] || wanted[i] == range[1]) {
                EXPECT_EQ(field.values[i], wanted[i]);
            }
            if (wanted[i] >= range[0] && wanted[i] <= range[1]) {
                EXPECT_GE(field.values[i], range[0]);
                EXPECT_LE(field.values[i], range[1]);
            }
        }
    }
}

TEST(PackedScene, with_a_bound_moves_no_position_further_than_it_says) {
    const auto sample = sample_with_ranges(5);
    for (Point3& position : sample->surface.positions) {
        for (double& coordinate : position) coordinate = coordinate * 1.2345678 + 0.1;
    }
    const Scene scene = load_scene(write_sample(*sample, "packed_positions", packed(0.01)));
    ASSERT_GT(scene.position_bound, 0);
    double worst = 0;
    for (std::size_t v = 0; v < sample->surface.positions.size(); ++v) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double found = static_cast<double>(scene.parts[0].positions[v][axis]) + scene.origin[axis];
            worst = std::max(worst, std::abs(found - sample->surface.positions[v][axis]));
        }
    }
    EXPECT_LE(worst, scene.position_bound);
    EXPECT_GT(worst, 0);
    EXPECT_LT(scene.position_bound, 5 * 1.2345678 / 131072 * 1.01);
}

TEST(PackedScene, keeps_what_is_missing_missing) {
    auto sample = sample_with_ranges(4);
    add_result(*sample, {"flux"}, [](std::int64_t id, std::size_t, std::size_t) {
        return id == 5 ? NAN : static_cast<float>(id) + 0.1F;
    });
    sample->contents.results.back().range = {1.1F, 100.1F};
    const Scene scene = load_scene(write_sample(*sample, "packed_missing", packed(0.01)));
    std::size_t missing = 0;
    for (const SceneField& field : scene.fields) {
        if (scene.results[field.result].id != "flux") continue;
        for (std::size_t v = 0; v < field.values.size(); ++v) {
            const bool is_it = scene.parts[0].node_ids[v] == 5;
            EXPECT_EQ(field.validity[v] == Validity::Missing && scene.parts[0].node_ids[v] != 0, is_it);
            // The centre of a quad without one of its corners has no value either.
            if (scene.parts[0].node_ids[v] != 0) {
                EXPECT_EQ(std::isnan(field.values[v]), is_it);
            }
            missing += is_it ? 1u : 0u;
        }
    }
    EXPECT_GT(missing, 0u);
}

TEST(PackedScene, same_contents_give_the_same_bytes) {
    const auto sample = sample_with_ranges(6);
    EXPECT_EQ(
        read_file(write_sample(*sample, "packed_once", packed(0.001))),
        read_file(write_sample(*sample, "packed_again", packed(0.001)))
    );
}

TEST(PackedScene, damaged_bytes_are_refused_or_change_a_digest) {
    const auto sample = sample_with_ranges(16);
    const std::string whole = read_file(write_sample(*sample, "packed_hostile", packed(0.001)));
    std::uint32_t json_size = 0;
    std::memcpy(&json_size, whole.data() + 12, 4);
    const std::size_t first = 28 + json_size, pictures = whole.find("\x89PNG", first);
    ASSERT_NE(pictures, std::string::npos) << "arrays stand before the pictures";
    const std::string path = scratch_folder("packed_damaged/broken") + "/scene.glb";
    std::mt19937 random(1);
    std::size_t noticed = 0;
    for (int round = 0; round < 60; ++round) {
        std::string bytes = whole;
        const std::size_t at = first + random() % (pictures - first);
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        write_file(path, bytes);
        try {
            const std::vector<Claim> claims = check_scene(path);
            noticed += std::ranges::all_of(claims, &Claim::holds) ? 0u : 1u;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Code::BadScene);
            ++noticed;
        }
    }
    EXPECT_GT(noticed, 55u) << "padding between arrays may change unnoticed, arrays may not";
}

TEST(Packing, counts_that_the_bytes_cannot_hold_are_refused_before_memory_is_taken) {
    const std::vector<std::byte> few(100);
    PackedView view;
    view.bytes = few.size();
    view.stride = 4;
    for (const std::uint64_t count : {std::uint64_t{1} << 32, std::uint64_t{1} << 62, ~std::uint64_t{0}}) {
        view.count = count;
        for (const Packing mode : {Packing::Attributes, Packing::Triangles, Packing::Indices}) {
            view.mode = mode;
            EXPECT_EQ(unpack(few, view), std::nullopt);
        }
    }
    view.count = 3;
    view.mode = Packing::Attributes;
    for (const std::uint64_t stride : {0u, 3u, 260u, 1u << 20}) {
        view.stride = stride;
        EXPECT_EQ(unpack(few, view), std::nullopt);
    }
}

TEST(Packing, every_list_of_indices_comes_back) {
    std::mt19937 random(2);
    for (const std::size_t count : {3u, 300u, 3000u}) {
        std::vector<std::uint32_t> indices(count);
        for (std::uint32_t& index : indices) index = static_cast<std::uint32_t>(random() % 1000);
        const std::vector<std::byte> bytes = pack_indices(indices, Packing::Indices);
        PackedView view{0, 0, bytes.size(), count, 4, Packing::Indices, {}};
        const auto found = unpack(bytes, view);
        ASSERT_TRUE(found);
        EXPECT_EQ(std::memcmp(found->data(), indices.data(), 4 * count), 0);
    }
}

TEST(Packing, the_exponential_filter_keeps_what_stands_on_its_grid) {
    std::vector<float> values;
    for (int i = -5000; i < 5000; ++i) values.push_back(static_cast<float>(i) * 0x1p-11F);
    values.push_back(0x1p11F);
    const std::vector<std::uint32_t> numbers = with_one_exponent(values, 0x1p-11F);
    const std::vector<std::byte> bytes = pack_rows(std::as_bytes(std::span(numbers)), 4);
    const PackedView view{
        0, 0, bytes.size(), values.size(), 4, Packing::Attributes, PackingFilter::Exponential};
    const auto found = unpack(bytes, view);
    ASSERT_TRUE(found);
    EXPECT_EQ(std::memcmp(found->data(), values.data(), 4 * values.size()), 0);
    EXPECT_THROW(with_one_exponent(std::vector{0.3F}, 0x1p-11F), Error);
}

}  // namespace
}  // namespace feelem::test
