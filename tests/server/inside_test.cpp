// SPDX-License-Identifier: Apache-2.0
// Questions to the inside of the boiler, by the real server: right ones, wrong ones, hostile ones.
#include "client.hpp"
#include "inside_questions.hpp"
#include "support/memory.hpp"
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"
#include "feelem/scene.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <future>

namespace feelem::test {
namespace {

using server::PageServer;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string kSection = "inside/section?result=stress_von_mises&step=1&plane=0,0,1,";

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
    T value{};
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

class ServedInside : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder() = scratch_folder(fmt::format("stand_ins/inside_{}", getpid()));
        std::filesystem::copy_file(
            project_file("examples/boiler/hex_linear/static.frd"), folder() + "/static.frd"
        );
        job().inputs = {folder() + "/static.frd"};
        job().output = folder() + "/boiler.glb";
        Diagnostics diagnostics;
        convert(job(), diagnostics, {});
        shared() = serve(true);
        ask(shared()->port(), true, "/");
    }
    static void TearDownTestSuite() {
        shared().reset();
        std::filesystem::remove_all(folder());
    }

    static std::string& folder() {
        static std::string path;
        return path;
    }
    static Job& job() {
        static Job made;
        return made;
    }
    static std::unique_ptr<PageServer>& shared() {
        static std::unique_ptr<PageServer> server;
        return server;
    }

    static std::unique_ptr<PageServer> serve(
        bool lan, const server::InsideLimits& limits = {}, bool model = true
    ) {
        server::ServeOptions options{folder() + "/boiler.glb", 0, false, lan};
        options.certificate_folder = folder() + "/kept";
        if (model) options.model = job();
        options.inside = limits;
        auto server = std::make_unique<PageServer>(options);
        server->start();
        return server;
    }
    static std::string asked(const std::string& target, const Asked& how = {}) {
        return ask(shared()->port(), true, prefix_of(*shared()) + target, how);
    }
};

TEST_F(ServedInside, section_is_what_the_library_makes_of_the_model) {
    const std::string answer = asked(kSection + "310");
    ASSERT_EQ(status_of(answer), 200);
    EXPECT_EQ(header_of(answer, "Content-Type"), "application/octet-stream");
    EXPECT_EQ(header_of(answer, "Cache-Control"), "no-store");
    const std::string body = body_of(answer);
    InteriorModel model(job());
    const Section section = model.section({{"stress_von_mises"}, {{0, 0, 1}, 310}}, {}).value();
    ASSERT_GT(section.triangles.size(), 500U);
    EXPECT_EQ(body, server::packed_section(section, model.owners(section)));

    EXPECT_EQ(body.substr(0, 4), "FLIN");
    EXPECT_EQ(number_at<std::uint32_t>(body, 4), 1U);
    const auto vertices = number_at<std::uint32_t>(body, 8), triangles = number_at<std::uint32_t>(body, 12);
    EXPECT_EQ(vertices, section.positions.size());
    EXPECT_EQ(triangles, section.triangles.size());
    ASSERT_EQ(body.size(), 64 + triangles * 8U + vertices * 16U + triangles * 16U);
    EXPECT_EQ(number_at<double>(body, 16), section.area);
    EXPECT_EQ(number_at<std::uint64_t>(body, 24), section.elements);
    const std::size_t positions = 64 + triangles * 8U, values = positions + vertices * 12U;
    for (std::size_t v = 0; v < vertices; v += 97) {
        EXPECT_EQ(number_at<float>(body, values + 4 * v), section.values[v]);
        EXPECT_EQ(number_at<double>(body, 56) + double(number_at<float>(body, positions + 12 * v + 8)), 310);
        EXPECT_NEAR(
            number_at<double>(body, 40) + double(number_at<float>(body, positions + 12 * v)),
            section.positions[v][0],
            1e-4
        );
    }
    Diagnostics diagnostics;
    const auto opened = open_job(job(), diagnostics, {});
    for (std::size_t t = 0; t < triangles; t += 101) {
        const auto id = static_cast<std::int64_t>(number_at<double>(body, 64 + 8 * t));
        EXPECT_EQ(id, raw(element_at(opened->mesh(), section.triangle_element[t]).id()));
    }
}

TEST_F(ServedInside, point_at_a_node_has_the_file_s_value_and_elsewhere_the_element_with_its_nodes) {
    Diagnostics diagnostics;
    const auto opened = open_job(job(), diagnostics, {});
    const Point3 at = opened->mesh().coordinates[100];
    std::size_t displacement = 0;
    while (opened->results()[displacement].name != "displacement") ++displacement;
    const float expected = opened->load(displacement).values[100 * 3 + 1];
    const std::string answer = asked(fmt::format(
        "inside/point?at={},{},{}&step=1&results=displacement:1,stress_von_mises", at[0], at[1], at[2]
    ));
    ASSERT_EQ(status_of(answer), 200) << answer;
    EXPECT_EQ(header_of(answer, "Content-Type"), "application/json");
    EXPECT_THAT(
        body_of(answer), HasSubstr(fmt::format("\"component\":\"y\",\"unit\":null,\"value\":{}", expected))
    );
    EXPECT_THAT(body_of(answer), HasSubstr("\"type\":\"hex8\""));
    EXPECT_THAT(body_of(answer), HasSubstr(fmt::format("{}", raw(opened->mesh().node_ids[100]))));
    const std::string outside = asked("inside/point?at=0,0,1e9&step=1&results=stress_von_mises");
    EXPECT_EQ(status_of(outside), 200);
    EXPECT_THAT(body_of(outside), HasSubstr("\"element\":null"));
    EXPECT_THAT(body_of(outside), HasSubstr("\"value\":null"));
}

TEST_F(ServedInside, surface_and_deformed_section_are_answered) {
    const std::string surface =
        asked("inside/surface?result=stress_von_mises&step=1&value=20&colour=displacement:2");
    ASSERT_EQ(status_of(surface), 200) << surface;
    EXPECT_GT(number_at<std::uint32_t>(body_of(surface), 12), 100U);
    const std::string still = body_of(asked(kSection + "310"));
    const std::string moved = body_of(asked(kSection + "310&shape=displacement,500"));
    EXPECT_GT(number_at<std::uint32_t>(moved, 12), 300U);
    EXPECT_NE(number_at<double>(moved, 16), number_at<double>(still, 16));
    EXPECT_EQ(body_of(asked(kSection + "310&shape=displacement,0")), still);
}

TEST_F(ServedInside, page_is_told_that_it_may_ask) {
    EXPECT_THAT(body_of(asked("")), HasSubstr("<meta name=\"feelem-inside\" content=\"inside/\" />"));
}

TEST_F(ServedInside, without_a_model_says_that_there_are_no_volume_elements) {
    const auto server = serve(false, {}, false);
    const std::string answer = ask(server->port(), false, "/" + kSection + "310");
    EXPECT_EQ(status_of(answer), 404);
    EXPECT_EQ(body_of(answer), "this scene has no volume elements: open the model file\n");
    EXPECT_THAT(body_of(ask(server->port(), false, "/")), Not(HasSubstr("feelem-inside")));
}

TEST_F(ServedInside, wrong_questions_are_refused_with_a_reason) {
    const std::string plane = "inside/section?result=stress_von_mises&step=1&plane=";
    const std::string point = "inside/point?step=1&results=stress_von_mises&at=";
    const std::string level = "inside/surface?result=stress_von_mises&step=1&value=";
    const std::vector<std::pair<std::string, std::string>> cases{
        {plane + "nan,0,0,1", "'plane' is not a finite number"},
        {plane + "inf,0,0,1", "'plane' is not a finite number"},
        {plane + "1e999,0,0,1", "'plane' is not a finite number"},
        {plane + "1,0,0,-1e999", "'plane' is not a finite number"},
        {plane + "1e308,1e308,1e308,0", "direction of some length"},
        {plane + "0,0,0,1", "'plane' has no direction"},
        {plane + "1e-320,0,0,1", "direction of some length"},
        {plane + "1,0,0", "'plane' has 4 numbers"},
        {plane + "1,0,0,1,1", "'plane' has 4 numbers"},
        {plane + "1,0,,1", "'plane' is not a finite number"},
        {plane + "1,0,0x10,1", "'plane' is not a finite number"},
        {plane + "1,0,0,1;rm", "'plane' is not a finite number"},
        {plane + "%00,0,0,1", "'plane' is not a finite number"},
        {plane, "'plane' has 4 numbers"},
        {plane + "0,0,1,310&plane=0,0,1,311", "twice"},
        {plane + "0,0,1,310&other=1", "not known"},
        {plane + "0,0,1,310&client=../../etc", "'client' is made of"},
        {plane + "0,0,1,310&shape=displacement", "'shape' is a result and a factor"},
        {plane + "0,0,1,310&shape=displacement,nan", "'shape' is not a finite number"},
        {plane + "0,0,1,310&shape=nothing,2", "no such result"},
        {plane + "0,0,1,310&shape=stress_von_mises,2", "deformed by a nodal result"},
        {"inside/section?result=nothing&step=1&plane=0,0,1,310", "no such result"},
        {"inside/section?result=STRESS&step=1&plane=0,0,1,310", "not the id of a result"},
        {"inside/section?result=" + std::string(300, 'a') + "&step=1&plane=0,0,1,310",
         "not the id of a result"},
        {"inside/section?result=stress_von_mises:7&step=1&plane=0,0,1,310", "has 1 components"},
        {"inside/section?result=stress_von_mises:-1&step=1&plane=0,0,1,310", "small whole number"},
        {"inside/section?result=stress_von_mises&step=0&plane=0,0,1,310", "no values at such a step"},
        {"inside/section?result=stress_von_mises&step=99&plane=0,0,1,310", "no values at such a step"},
        {"inside/section?result=stress_von_mises&step=-1&plane=0,0,1,310", "small whole number"},
        {"inside/section?result=stress_von_mises&step=18446744073709551616&plane=0,0,1,310",
         "small whole number"},
        {"inside/section?result=stress_von_mises&step=1", "needs 'plane'"},
        {"inside/section", "needs 'plane'"},
        {level + "nan", "'value' is not a finite number"},
        {level + "1e999", "'value' is not a finite number"},
        {level + "1&colour=nothing", "no such result"},
        {point + "1,2", "'at' has 3 numbers"},
        {point + "1,2,inf", "'at' is not a finite number"},
        {"inside/point?step=1&at=1,2,3&results=", "not the id of a result"},
        {"inside/point?step=1&at=1,2,3&results=a,a,a,a,a,a,a,a,a,a,a,a,a,a,a,a,a,a", "more than 16"}};
    for (const auto& [target, reason] : cases) {
        const std::string answer = asked(target);
        EXPECT_EQ(status_of(answer), 400) << target;
        EXPECT_THAT(body_of(answer), HasSubstr(reason)) << target;
        EXPECT_LT(body_of(answer).size(), 200U) << target;
    }
    EXPECT_EQ(status_of(asked("inside/")), 404);
    EXPECT_EQ(status_of(asked("inside/../boiler.frd")), 404);
    EXPECT_EQ(status_of(asked("inside/section/x?plane=0,0,1,310")), 404);
    EXPECT_EQ(status_of(asked(kSection + "310", {"HEAD"})), 405);
    EXPECT_EQ(status_of(asked(kSection + "310", {"POST"})), 405);
    EXPECT_EQ(status_of(asked(kSection + std::string(4000, '1'))), 414);
    EXPECT_EQ(status_of(asked(kSection + "310")), 200);
}

TEST_F(ServedInside, huge_numbers_that_are_numbers_are_answered_with_nothing) {
    for (const char* end : {"1e300", "-1e300", "1e17"}) {
        const std::string answer = asked(kSection + end);
        ASSERT_EQ(status_of(answer), 200) << end;
        EXPECT_EQ(body_of(answer).size(), 64U) << end;
    }
    EXPECT_THAT(
        body_of(asked("inside/point?step=1&results=stress_von_mises&at=1e300,1e300,1e300")),
        HasSubstr("\"element\":null")
    );
}

TEST_F(ServedInside, without_the_link_not_one_byte_is_given) {
    const int port = shared()->port();
    for (const std::string& target :
         {"/" + kSection + "310",
          "/wrong/" + kSection + "310",
          std::string("/inside/point?at=0,0,0&step=1&results=x")}) {
        for (const bool tls : {true, false}) {
            const std::string answer = ask(port, tls, target);
            EXPECT_EQ(status_of(answer), 403) << target;
            EXPECT_EQ(body_of(answer), "the whole link is needed, as it was printed\n");
            EXPECT_THAT(answer, Not(AnyOf(HasSubstr("FLIN"), HasSubstr("element"), HasSubstr("stress"))));
        }
    }
    const std::string target = prefix_of(*shared()) + kSection + "310";
    EXPECT_EQ(status_of(ask(port, true, target, {"GET", "Origin: https://evil.example\r\n"})), 403);
    EXPECT_EQ(status_of(ask(port, true, target, {"GET", "Sec-Fetch-Site: cross-site\r\n"})), 403);
    EXPECT_EQ(status_of(ask(port, true, target, {"GET", "", "evil.example"})), 421);
}

TEST_F(ServedInside, a_hundred_questions_at_once_leave_it_answering) {
    ASSERT_EQ(status_of(asked(kSection + "310")), 200);
    reset_peak_memory();
    const std::uint64_t before = peak_memory();
    std::vector<std::future<std::string>> answers;
    for (int i = 0; i < 100; ++i) {
        answers.push_back(std::async(std::launch::async, [i] {
            return asked(fmt::format("inside/surface?result=stress_von_mises&step=1&value={}", 5 + i % 40));
        }));
    }
    int good = 0, busy = 0;
    for (auto& one : answers) {
        const std::string answer = one.get();
        good += status_of(answer) == 200 ? 1 : 0;
        if (status_of(answer) != 503) continue;
        ++busy;
        EXPECT_EQ(header_of(answer, "Retry-After"), "1");
    }
    EXPECT_GT(good, 0);
    EXPECT_LE(good + busy, 100);  // The front door may have sent some away, too.
    EXPECT_EQ(status_of(asked(kSection + "310")), 200);
    if (!kSanitized) {
        EXPECT_LT(peak_memory(), before + (128 << 20));
    }
}

TEST_F(ServedInside, who_goes_away_in_the_middle_harms_nobody) {
    for (int i = 0; i < 40; ++i) {
        Client client(shared()->port(), true);
        client.send(fmt::format(
            "GET {}inside/surface?result=stress_von_mises&step=1&value=20 HTTP/1.1\r\nHost: "
            "127.0.0.1:{}\r\n\r\n",
            prefix_of(*shared()),
            shared()->port()
        ));
        client.cut();
    }
    std::string answer;
    for (int tries = 0; tries < 50 && status_of(answer) != 200; ++tries) answer = asked(kSection + "310");
    EXPECT_EQ(status_of(answer), 200);
}

TEST_F(ServedInside, limits_of_triangles_and_time_are_said) {
    server::InsideLimits limits;
    limits.most_triangles = 100;
    auto server = serve(false, limits);
    const std::string large = ask(server->port(), false, "/" + kSection + "310");
    EXPECT_EQ(status_of(large), 422);
    EXPECT_EQ(body_of(large), "the section has more than 100 triangles\n");
    limits = {};
    limits.pool.time = std::chrono::milliseconds(0);
    server = serve(false, limits);
    const std::string late = ask(server->port(), false, "/" + kSection + "310");
    EXPECT_EQ(status_of(late), 503);
    EXPECT_EQ(body_of(late), "the answer takes too long\n");
}

TEST_F(ServedInside, results_beyond_the_memory_kept_for_them_are_read_again) {
    server::InsideLimits limits;
    limits.model.kept_bytes = 1;
    const auto server = serve(false, limits);
    for (int round = 0; round < 2; ++round) {
        for (const char* result : {"stress_von_mises", "displacement:0", "displacement:2"}) {
            const std::string target = fmt::format("inside/section?result={}&step=1&plane=0,0,1,310", result);
            EXPECT_EQ(body_of(ask(server->port(), false, "/" + target)), body_of(asked(target))) << result;
        }
    }
}

TEST_F(ServedInside, a_file_that_is_no_longer_the_same_is_not_asked) {
    const auto server = serve(false);
    ASSERT_EQ(status_of(ask(server->port(), false, "/" + kSection + "310")), 200);
    const std::string path = folder() + "/static.frd";
    const auto time = std::filesystem::last_write_time(path);
    std::filesystem::last_write_time(path, time + std::chrono::seconds(5));
    const std::string answer = ask(server->port(), false, "/" + kSection + "310");
    std::filesystem::last_write_time(path, time);
    EXPECT_EQ(status_of(answer), 410);
    EXPECT_THAT(body_of(answer), HasSubstr("static.frd: the file is no longer the one"));
    EXPECT_THAT(body_of(answer), Not(HasSubstr(folder())));
}

}  // namespace
}  // namespace feelem::test
