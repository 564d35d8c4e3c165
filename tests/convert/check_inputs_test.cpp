// SPDX-License-Identifier: Apache-2.0
// A scene against its inputs: what it holds is theirs, and a change is found although its digest was made
// anew.
#include "base/sha256.hpp"
#include "scene/scene_file.hpp"
#include "support/paths.hpp"

#include "feelem/convert.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace feelem::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Job job_of(const std::string& folder, std::initializer_list<const char*> files) {
    Job job;
    for (const char* file : files)
        job.inputs.push_back(project_file("examples/boiler/" + folder + "/" + file));
    job.length_unit = "mm";
    return job;
}

std::string converted(Job job, const std::string& name) {
    job.output = scratch_folder(name) + "/scene.glb";
    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));
    return job.output;
}

std::vector<std::string> broken_claims(const std::string& path, const Job& job) {
    Diagnostics diagnostics;
    std::vector<std::string> broken;
    const std::vector<Claim> claims = check_against_inputs(path, job, diagnostics, {});
    EXPECT_GE(claims.size(), 5u);
    for (const Claim& claim : claims) {
        if (!claim.holds) broken.push_back(claim.name + ": " + claim.found);
    }
    return broken;
}

/// A scene whose arrays can be changed; the certificate is told each time, so that its digests agree again.
struct Forged {
    std::string path, bytes;

    Forged(const Job& job, const std::string& name)
        : path(converted(job, "broken/" + name)), bytes(read_file(path)) {}
    template <class T>
    std::vector<T> get(const std::string& accessor) const {
        const SceneFile file(path);
        const std::vector<std::byte> packed = file.packed(file.find(accessor));
        std::vector<T> values(packed.size() / sizeof(T));
        std::memcpy(values.data(), packed.data(), packed.size());
        return values;
    }
    template <class T>
    void put(const std::string& accessor, const std::vector<T>& values) {
        const SceneFile file(path);
        const SceneDocument& document = file.document();
        const ReadAccessor& read = document.accessors[static_cast<std::size_t>(file.find(accessor))];
        const ReadView& view = document.views[static_cast<std::size_t>(read.accessor.view)];
        const std::size_t json_size = bytes.find(std::string("BIN\0", 4), 12) - 4;
        const std::size_t at = json_size + 8 + static_cast<std::size_t>(view.view.offset);
        std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(T));
        const std::string claim = "\"" + accessor + "\":\"";
        const std::size_t digest = bytes.find(claim);
        ASSERT_NE(digest, std::string::npos);
        bytes.replace(digest + claim.size(), 64, sha256_hex(std::as_bytes(std::span(values))));
        write_file(path, bytes);
    }
};

const Job kFrd = job_of("hex_linear", {"heat.frd", "static.frd"});

TEST(CheckInputs, scenes_of_the_boiler_agree_with_their_files) {
    for (const auto& [name, job] : std::initializer_list<std::pair<const char*, Job>>{
             {"agree_hex_linear", kFrd},
             {"agree_small", job_of("small", {"heat.frd", "static.frd"})},
         }) {
        EXPECT_THAT(broken_claims(converted(job, name), job), IsEmpty()) << name;
    }
}

TEST(CheckInputs, every_way_of_skinning_and_averaging_agrees) {
    for (const SkinMethod method : {SkinMethod::Exact, SkinMethod::All}) {
        for (const unsigned subdivide : {0u, 1u, 2u}) {
            Job job = job_of("small", {"static.frd"});
            job.skin.method = method;
            job.skin.subdivide = subdivide;
            EXPECT_THAT(broken_claims(converted(job, "agree_options"), job), IsEmpty()) << subdivide;
        }
    }
}

/// One quadratic shell facet with a temperature at each of its eight nodes.
std::string frd_of_one_shell(const std::array<double, 8>& temperatures) {
    constexpr std::array<std::array<int, 2>, 8> kPlaces{
        {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};
    std::string text = fmt::format("    1C\n    2C{:30}{:38}\n", 8, 1);
    for (std::size_t i = 0; i < 8; ++i) {
        const auto [x, y] = kPlaces[i];
        text += fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", i + 1, double(x), double(y), 0.0);
    }
    text += fmt::format(" -3\n    3C{:30}{:38}\n -1{:10}{:5}{:5}{:5}\n -2", 1, 1, 1, 10, 0, 1);
    for (int node = 1; node <= 8; ++node) text += fmt::format("{:10}", node);
    text += fmt::format("\n -3\n  100CL  101{:12.9f}{:12}{:20}{:2}{:5}{:10}{:2}\n", 1.0, 8, "", 0, 1, "", 1);
    text += " -4  NDTEMP      1    1\n -5  T           1    1    0    0\n";
    for (std::size_t i = 0; i < 8; ++i) text += fmt::format(" -1{:10}{:12.5E}\n", i + 1, temperatures[i]);
    return text + " -3\n 9999\n";
}

TEST(CheckInputs, centres_between_values_of_very_different_size_agree) {
    Job job;
    job.inputs = {scratch_folder("uneven_input") + "/shell.frd"};
    write_file(job.inputs[0], frd_of_one_shell({1, 1, 1, 1, 1, 1, 1.23457e-10, 3.33333e-11}));

    EXPECT_THAT(broken_claims(converted(job, "uneven"), job), IsEmpty());
}

TEST(CheckInputs, find_a_changed_centre_by_its_last_bit) {
    Job job;
    job.inputs = {scratch_folder("even_input") + "/shell.frd"};
    write_file(job.inputs[0], frd_of_one_shell({1, 2, 3, 4, 5, 6, 7, 9}));
    Forged scene(job, "forged_centre");
    const std::vector<float> ids = scene.get<float>("p0/_NODE_ID");
    const auto centre = std::ranges::find(ids, 0.0F) - ids.begin();
    std::vector<std::uint32_t> values = scene.get<std::uint32_t>("p0/_TEMPERATURE/1");
    values[static_cast<std::size_t>(centre)] ^= 1u;
    scene.put("p0/_TEMPERATURE/1", values);

    EXPECT_THAT(broken_claims(scene.path, job), Contains(HasSubstr("values of temperature at step 1")));
}

TEST(CheckInputs, know_an_input_without_digest_by_name_and_size) {
    Job job;
    job.inputs = {scratch_folder("no_digest_input") + "/shell.frd"};
    const std::string text = frd_of_one_shell({1, 2, 3, 4, 5, 6, 7, 9});
    write_file(job.inputs[0], text);
    job.read.hash_inputs = false;
    const std::string scene = converted(job, "no_digest");
    EXPECT_THAT(read_file(scene), HasSubstr(R"("name":"shell.frd","format":"calculix-frd","bytes":)"));
    EXPECT_THAT(read_file(scene), HasSubstr(R"("sha256":null)"));

    job.read.hash_inputs = true;
    EXPECT_THAT(broken_claims(scene, job), IsEmpty());
    write_file(job.inputs[0], text + "\n");
    EXPECT_THAT(broken_claims(scene, job), Contains("input shell.frd: another file"));
}

TEST(CheckInputs, find_a_changed_value_under_a_new_digest) {
    Forged scene(kFrd, "forged_value");
    std::vector<std::uint32_t> values = scene.get<std::uint32_t>("p0/_TEMPERATURE/1");
    values[100] ^= 1u;
    scene.put("p0/_TEMPERATURE/1", values);

    EXPECT_THAT(broken_claims(scene.path, kFrd), Contains(HasSubstr("values of temperature at step 1")));
}

TEST(CheckInputs, find_a_change_in_any_value_of_a_field) {
    Forged scene(kFrd, "forged_values");
    const std::vector<float> whole = scene.get<float>("p0/_TEMPERATURE/1");
    for (std::size_t i = 0; i < whole.size(); i += whole.size() / 11) {
        std::vector<float> values = whole;
        values[i] += 0.5F;
        scene.put("p0/_TEMPERATURE/1", values);
        EXPECT_THAT(broken_claims(scene.path, kFrd), Contains(HasSubstr("values of temperature"))) << i;
    }
}

TEST(CheckInputs, find_a_dropped_triangle_under_a_new_digest) {
    Forged scene(kFrd, "forged_triangle");
    std::vector<std::uint16_t> indices = scene.get<std::uint16_t>("p0/indices");
    for (std::size_t corner = 0; corner < 3; ++corner) indices[300 + corner] = indices[303 + corner];
    scene.put("p0/indices", indices);

    EXPECT_THAT(broken_claims(scene.path, kFrd), Contains(HasSubstr("triangles missing from the scene")));
}

TEST(CheckInputs, find_swapped_node_ids_under_a_new_digest) {
    Forged scene(kFrd, "forged_nodes");
    std::vector<float> ids = scene.get<float>("p0/_NODE_ID");
    const auto first = std::ranges::find_if(ids, [](float id) { return id != 0; });
    const auto second = std::find_if(first + 1, ids.end(), [&](float id) { return id != 0 && id != *first; });
    std::iter_swap(first, second);
    scene.put("p0/_NODE_ID", ids);

    EXPECT_THAT(broken_claims(scene.path, kFrd), Contains(HasSubstr("positions of the nodes")));
}

TEST(CheckInputs, find_swapped_element_ids_under_a_new_digest) {
    Forged scene(kFrd, "forged_elements");
    std::vector<std::uint32_t> ids = scene.get<std::uint32_t>("p0/elements");
    const auto other = std::ranges::find_if(ids, [&](std::uint32_t id) { return id != ids[0]; });
    std::iter_swap(ids.begin(), other);
    scene.put("p0/elements", ids);

    const std::vector<std::string> broken = broken_claims(scene.path, kFrd);
    EXPECT_THAT(broken, Contains(HasSubstr("triangles that the inputs do not have")));
}

TEST(CheckInputs, find_a_changed_range_over_the_model) {
    const std::string path = converted(kFrd, "broken/forged_range");
    const std::string whole = read_file(path);
    const std::size_t first = whole.find(R"("min":{"value":)", whole.find(R"("id":"temperature")"));
    for (const std::string word : {R"("missing":)", R"("min":{"value":)", R"("max":{"value":)"}) {
        const std::size_t before = word.starts_with(R"("mi)") ? whole.rfind(word, first) : std::string::npos;
        const std::size_t at = before == std::string::npos ? whole.find(word, first) : before;
        ASSERT_NE(at, std::string::npos) << word;
        std::string bytes = whole;
        char& digit = bytes[at + word.size()];
        digit = digit == '1' ? '2' : '1';
        write_file(path, bytes);
        EXPECT_THAT(broken_claims(path, kFrd), Contains(HasSubstr("values of temperature at step 1")))
            << word;
    }
}

TEST(CheckInputs, find_a_changed_number_of_the_certificate) {
    const std::string path = converted(kFrd, "broken/forged_number");
    const std::string whole = read_file(path);
    const std::size_t certificate = whole.find(R"("certificate":{)");
    for (const std::string word :
         {R"("nodes":)", R"("keptQuads":)", R"("duplicateElements":)", R"("inner":)"}) {
        std::string bytes = whole;
        const std::size_t at = bytes.find(word, certificate);
        ASSERT_NE(at, std::string::npos) << word;
        char& digit = bytes[at + word.size()];
        digit = digit == '1' ? '2' : '1';
        write_file(path, bytes);
        EXPECT_THAT(broken_claims(path, kFrd), Contains(HasSubstr("numbers of the certificate"))) << word;
    }
}

TEST(CheckInputs, say_when_the_files_are_others) {
    const std::string path = converted(kFrd, "agree_others");
    const Job others = job_of("small", {"heat.frd", "static.frd"});

    EXPECT_THAT(broken_claims(path, others), Contains(HasSubstr("input heat.frd: another file")));
}

}  // namespace
}  // namespace feelem::test
