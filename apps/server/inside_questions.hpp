// SPDX-License-Identifier: Apache-2.0
// "/inside/section", "/inside/surface" and "/inside/point": questions to the volume behind the scene
// (docs/serving.md).
#pragma once

#include "answers.hpp"
#include "question_pool.hpp"

#include "feelem/interior.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace feelem::server {

struct InsideLimits {
    PoolLimits pool{};
    std::size_t most_triangles = std::size_t{1} << 20U;
    std::size_t answers = 16;  ///< Being made or on their way.
    InteriorOptions model{};
};

class InsideQuestions {
public:
    InsideQuestions(const Job& job, const InsideLimits& limits);

    /// `address`: of who asks. `is_gone`: whether the other side still waits.
    void answer(const Exchange& exchange, const std::string& address, const std::function<bool()>& is_gone);

private:
    using Make = std::function<std::string(const QuestionPool::IsCancelled&)>;
    struct Kind {
        std::string_view path, type;
        Make (InsideQuestions::*make)(const httplib::Params&);
    };
    Make section(const httplib::Params& params);
    Make surface(const httplib::Params& params);
    Make point(const httplib::Params& params);
    SectionLimits limits_for(const QuestionPool::IsCancelled& is_cancelled) const;

    InsideLimits limits_;
    std::shared_ptr<std::atomic<std::size_t>> answers_;
    InteriorModel model_;
    QuestionPool pool_;
};

/// A section as bytes: the header and arrays of docs/serving.md.
std::string packed_section(const Section& section, const std::vector<SectionOwner>& owners);

/// The page is told that it may ask.
std::string with_inside_hint(std::string index);

}  // namespace feelem::server
