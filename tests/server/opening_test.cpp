// SPDX-License-Identifier: Apache-2.0
// A scene that is still being made, as the server has it: its shape, how far it is, and who waits for it.
#include "client.hpp"
#include "opening.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <thread>
#include <vector>

namespace feelem::test {
namespace {

using namespace std::chrono_literals;
using server::Opening;
using server::PageServer;
using testing::HasSubstr;
using testing::Not;

class ServedOpening : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = scratch_folder(std::string("stand_ins/opening_") + test->name());
        std::filesystem::remove(folder_ + "/boiler.glb");
        write_file(folder_ + "/boiler.glb.shape.glb", "glTF the shape");
        opening_ = std::make_shared<Opening>(folder_ + "/boiler.glb.shape.glb");
        serve();
    }
    void serve(bool lan = false) {
        server::ServeOptions options{folder_ + "/boiler.glb", 0, false, lan};
        options.certificate_folder = folder_ + "/kept";
        options.opening = opening_;
        server_ = std::make_unique<PageServer>(options);
        server_->start();
    }
    std::string get(const std::string& path) { return ask(server_->port(), false, path); }
    std::future<std::string> get_later(const std::string& path) {
        return std::async(std::launch::async, [this, path] { return get(path); });
    }
    void finish() {
        write_file(folder_ + "/boiler.glb", "glTF the scene");
        opening_->finish();
    }
    static bool is_waiting(const std::future<std::string>& answer) {
        return answer.wait_for(150ms) == std::future_status::timeout;
    }

    std::string folder_;
    std::shared_ptr<Opening> opening_;
    std::unique_ptr<PageServer> server_;
};

TEST_F(ServedOpening, page_is_told_that_the_scene_may_not_be_there) {
    EXPECT_THAT(body_of(get("/")), HasSubstr("<meta name=\"feelem-opening\" content=\"opening\" />"));
}

TEST_F(ServedOpening, who_asks_for_the_page_is_a_guest_who_must_be_told_of_the_end) {
    EXPECT_FALSE(opening_->has_guests());
    get("/absent");
    EXPECT_FALSE(opening_->has_guests());
    get("/");
    EXPECT_TRUE(opening_->has_guests());
}

TEST_F(ServedOpening, shape_is_served_and_then_the_scene_in_its_place) {
    const std::string shape = get("/shape.glb");
    EXPECT_EQ(body_of(shape), "glTF the shape");
    EXPECT_EQ(header_of(shape, "Content-Type"), "model/gltf-binary");
    EXPECT_EQ(header_of(shape, "Cache-Control"), "no-cache");
    finish();
    EXPECT_EQ(body_of(get("/shape.glb")), "glTF the scene");
    EXPECT_EQ(body_of(get("/scene.glb")), "glTF the scene");
    EXPECT_EQ(status_of(get("/boiler.glb.shape.glb")), 404);
}

TEST_F(ServedOpening, who_asks_for_the_scene_waits_for_it_and_never_gets_the_shape) {
    auto scene = get_later("/scene.glb"), by_name = get_later("/boiler.glb");
    ASSERT_TRUE(is_waiting(scene) && is_waiting(by_name));
    finish();
    EXPECT_EQ(body_of(scene.get()), "glTF the scene");
    EXPECT_EQ(body_of(by_name.get()), "glTF the scene");
}

TEST_F(ServedOpening, progress_is_told_at_once_and_then_when_there_is_news) {
    opening_->progress("results", 0.25);
    const std::string first = get("/opening?after=0");
    EXPECT_EQ(header_of(first, "Content-Type"), "application/json");
    EXPECT_EQ(body_of(first), R"({"state":"reading","version":2,"stage":"results","percent":25,"text":""})");
    auto news = get_later("/opening?after=2");
    ASSERT_TRUE(is_waiting(news));
    opening_->progress("results", 0.2501);
    ASSERT_TRUE(is_waiting(news)) << "the same percent is no news";
    opening_->progress("write", 0.5);
    EXPECT_THAT(body_of(news.get()), HasSubstr(R"("version":3,"stage":"write","percent":50)"));
    finish();
    EXPECT_THAT(body_of(get("/opening?after=4")), HasSubstr(R"("state":"ready")"))
        << "nothing more will come";
}

TEST_F(ServedOpening, odd_versions_are_answered_at_once) {
    for (const std::string query :
         {"", "?after=", "?after=-1", "?after=1e9", "?after=99999999999999999999", "?x"})
        EXPECT_THAT(body_of(get("/opening" + query)), HasSubstr(R"("version":1)")) << query;
}

TEST_F(ServedOpening, failure_is_told_to_all_who_wait) {
    auto news = get_later("/opening?after=1"), scene = get_later("/scene.glb");
    ASSERT_TRUE(is_waiting(news) && is_waiting(scene));
    EXPECT_FALSE(opening_->wait_until_told(1ms));
    opening_->fail("a.frd:7: \"x\" is no number");
    EXPECT_THAT(body_of(news.get()), HasSubstr(R"("state":"failed")"));
    EXPECT_THAT(body_of(get("/opening")), HasSubstr(R"("text":"a.frd:7: \"x\" is no number")"));
    const std::string answer = scene.get();
    EXPECT_EQ(status_of(answer), 500);
    EXPECT_THAT(body_of(answer), HasSubstr("is no number"));
    EXPECT_TRUE(opening_->wait_until_told(1s));
}

TEST_F(ServedOpening, questions_to_the_inside_and_side_files_wait_too) {
    auto side = get_later("/scene.d/temperature.bin"), inside = get_later("/inside/point?at=0,0,0");
    ASSERT_TRUE(is_waiting(side) && is_waiting(inside));
    finish();
    EXPECT_EQ(status_of(side.get()), 404);
    EXPECT_EQ(status_of(inside.get()), 404) << "this one has no model";
}

TEST_F(ServedOpening, server_ends_while_somebody_waits) {
    auto news = get_later("/opening?after=1"), scene = get_later("/scene.glb");
    ASSERT_TRUE(is_waiting(news) && is_waiting(scene));
    const auto began = std::chrono::steady_clock::now();
    server_->stop();
    EXPECT_LT(std::chrono::steady_clock::now() - began, 3s);
    news.get();
    scene.get();
}

TEST_F(ServedOpening, progress_by_one_thread_and_questions_by_many_fit_together) {
    std::atomic<int> ready = 0;
    std::vector<std::thread> pages;
    for (int i = 0; i < 8; ++i) {
        pages.emplace_back([this, &ready] {
            for (std::string after = "0";;) {
                const std::string body = body_of(get("/opening?after=" + after));
                if (body.find(R"("ready")") != std::string::npos) break;
                const std::size_t at = body.find("version\":") + 9;
                after = body.substr(at, body.find(',', at) - at);
            }
            if (body_of(get("/scene.glb")) == "glTF the scene") ++ready;
        });
    }
    for (int i = 0; i <= 200; ++i) {
        opening_->progress("results", i / 200.0);
        std::this_thread::sleep_for(1ms);
    }
    finish();
    for (std::thread& page : pages) page.join();
    EXPECT_EQ(ready, 8);
}

TEST_F(ServedOpening, strangers_learn_nothing_of_it) {
    serve(true);
    for (const std::string path : {"/opening", "/shape.glb", "/opening?after=1"}) {
        const std::string answer = ask(server_->port(), true, path);
        EXPECT_EQ(status_of(answer), 403) << path;
        EXPECT_THAT(answer, Not(HasSubstr("reading\",\"version")));
        EXPECT_THAT(answer, Not(HasSubstr("the shape")));
    }
    EXPECT_EQ(body_of(ask(server_->port(), true, prefix_of(*server_) + "shape.glb")), "glTF the shape");
}

TEST(ServedScenes, that_are_there_have_no_opening) {
    const std::string folder = scratch_folder("stand_ins/opening_none");
    write_file(folder + "/boiler.glb", "glTF");
    PageServer server({folder + "/boiler.glb", 0, false});
    server.start();
    EXPECT_EQ(status_of(ask(server.port(), false, "/opening")), 404);
    EXPECT_EQ(status_of(ask(server.port(), false, "/shape.glb")), 404);
    EXPECT_THAT(body_of(ask(server.port(), false, "/")), Not(HasSubstr("feelem-opening")));
}

}  // namespace
}  // namespace feelem::test
