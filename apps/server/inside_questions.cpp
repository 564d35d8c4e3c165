// SPDX-License-Identifier: Apache-2.0
#include "inside_questions.hpp"

#include "base/number.hpp"
#include "inside_query.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace feelem::server {
namespace {

constexpr std::uint32_t kSectionVersion = 1;
constexpr std::size_t kHeaderSize = 64;
constexpr std::size_t kPiece = 256 << 10;
static_assert(std::endian::native == std::endian::little, "sections are written as they lie in memory");

template <class T>
void put(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

int status_of(const Error& error) {
    switch (error.code()) {
    case Code::BadOption:
    case Code::UnknownName: return 400;
    case Code::TooLarge: return 422;
    case Code::SourcesDisagree: return 410;
    default: return 500;
    }
}

void answer_end(httplib::Response& response, QuestionPool::End end) {
    using enum QuestionPool::End;
    response.set_header("Retry-After", "1");
    switch (end) {
    case Busy: return answer_text(response, 503, "too many questions at once\n");
    case TooLong: return answer_text(response, 503, "the answer takes too long\n");
    case Superseded: return answer_text(response, 409, "you have asked something newer\n");
    default: return answer_text(response, 503, "given up\n");
    }
}

/// Sent piece by piece; `slot` is free when the last has gone.
void answer_whole(
    httplib::Response& response, std::string_view type, std::string body, std::shared_ptr<void> slot
) {
    response.status = 200;
    response.set_header("Cache-Control", "no-store");
    const auto bytes = std::make_shared<const std::string>(std::move(body));
    response.set_content_provider(
        bytes->size(),
        std::string(type).c_str(),
        [bytes, slot = std::move(slot)](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            return sink.write(bytes->data() + offset, std::min(length, kPiece));
        }
    );
}

}  // namespace

std::string packed_section(const Section& section, const std::vector<SectionOwner>& owners) {
    const Point3 origin = section.positions.empty() ? Point3{} : section.positions.front();
    std::string out;
    out.reserve(kHeaderSize + section.positions.size() * 16 + section.triangles.size() * 24);
    out += "FLIN";
    put(out, kSectionVersion);
    put(out, static_cast<std::uint32_t>(section.positions.size()));
    put(out, static_cast<std::uint32_t>(section.triangles.size()));
    put(out, section.area);
    put(out, static_cast<std::uint64_t>(section.elements));
    put(out, static_cast<std::uint64_t>(section.elements_without_place));
    put(out, origin);
    for (const SectionOwner& owner : owners) put(out, static_cast<double>(owner.element));
    for (const Point3& place : section.positions) {
        for (std::size_t axis = 0; axis < 3; ++axis) put(out, static_cast<float>(place[axis] - origin[axis]));
    }
    for (const float value : section.values) put(out, value);
    for (const auto& triangle : section.triangles) put(out, triangle);
    for (const SectionOwner& owner : owners) put(out, owner.part);
    return out;
}

InsideQuestions::InsideQuestions(const Job& job, const InsideLimits& limits)
    : limits_(limits), answers_(std::make_shared<std::atomic<std::size_t>>(0)), model_(job, limits.model),
      pool_(limits.pool) {}

SectionLimits InsideQuestions::limits_for(const QuestionPool::IsCancelled& is_cancelled) const {
    return {limits_.most_triangles, is_cancelled};
}

InsideQuestions::Make InsideQuestions::section(const httplib::Params& params) {
    const PlaneQuestion question = plane_question(params);
    return [this, question](const QuestionPool::IsCancelled& is_cancelled) -> std::string {
        const auto made = model_.section(question, limits_for(is_cancelled));
        return made ? packed_section(*made, model_.owners(*made)) : std::string();
    };
}

InsideQuestions::Make InsideQuestions::surface(const httplib::Params& params) {
    const LevelQuestion question = level_question(params);
    return [this, question](const QuestionPool::IsCancelled& is_cancelled) -> std::string {
        const auto made = model_.surface(question, limits_for(is_cancelled));
        return made ? packed_section(*made, model_.owners(*made)) : std::string();
    };
}

InsideQuestions::Make InsideQuestions::point(const httplib::Params& params) {
    const PlaceQuestion question = place_question(params);
    return [this, question](const QuestionPool::IsCancelled& is_cancelled) {
        return model_.place(question, limits_for(is_cancelled)).value_or("");
    };
}

void InsideQuestions::answer(
    const Exchange& exchange, const std::string& address, const std::function<bool()>& is_gone
) {
    static constexpr std::array kKinds{
        Kind{"/inside/section", "application/octet-stream", &InsideQuestions::section},
        Kind{"/inside/surface", "application/octet-stream", &InsideQuestions::surface},
        Kind{"/inside/point", "application/json", &InsideQuestions::point}};
    httplib::Response& response = exchange.response;
    const auto kind = std::ranges::find(kKinds, exchange.request.path, &Kind::path);
    if (kind == kKinds.end()) return answer_text(response, 404, "there is no such question\n");
    if (exchange.head.method != "GET") {
        response.set_header("Allow", "GET");
        return answer_text(response, 405, "only GET\n");
    }
    const std::shared_ptr<void> slot(nullptr, [answers = answers_](void*) { --*answers; });
    if (++*answers_ > limits_.answers) return answer_end(response, QuestionPool::End::Busy);
    try {
        const Make make = (this->*kind->make)(exchange.request.params);
        const std::string client = client_of(exchange.request.params);
        std::string body;
        const auto end = pool_.ask(
            client.empty() ? client : address + " " + client,
            [&](const QuestionPool::IsCancelled& is_cancelled) { body = make(is_cancelled); },
            is_gone
        );
        if (end != QuestionPool::End::Done) return answer_end(response, end);
        answer_whole(response, kind->type, std::move(body), slot);
    } catch (const Error& error) {
        // Of a fault in the files the text may name folders of this machine.
        const int status = status_of(error);
        answer_text(
            response, status, status == 500 ? "the model cannot be read\n" : std::string(error.what()) + "\n"
        );
    }
}

std::string with_inside_hint(std::string index) {
    constexpr std::string_view kEnd = "</title>";
    const std::size_t at = index.find(kEnd);
    if (at != std::string::npos)
        index.insert(at + kEnd.size(), "\n    <meta name=\"feelem-inside\" content=\"inside/\" />");
    return index;
}

}  // namespace feelem::server
