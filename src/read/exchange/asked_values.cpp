// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/asked_values.hpp"

#include "feelem/error.hpp"

#include <utility>

namespace feelem::exchange {
namespace {

constexpr std::uint64_t kMostBytes = 64u << 20;
constexpr std::size_t kMostAtOnce = 1000;

}  // namespace

void AskedValues::list(std::vector<NeutralResult> results, std::size_t nodes, std::size_t elements) {
    results_ = std::move(results);
    nodes_ = nodes;
    elements_ = elements;
}

std::uint64_t AskedValues::bytes_of(std::size_t index) const {
    const NeutralResult& result = results_[index];
    const std::uint64_t rows = result.location == Location::Nodal ? nodes_ : elements_;
    return rows * result.components * sizeof(float);
}

void AskedValues::ask_from(std::size_t index, std::size_t most) {
    std::vector<std::string> requests;
    std::uint64_t bytes = 0;
    for (std::size_t i = index; i < results_.size() && requests.size() < most; ++i) {
        bytes += bytes_of(i);
        if (i > index && bytes > kMostBytes) break;
        requests.push_back(write_request(results_[i]));
    }
    kept_.clear();
    answer_ = ask_(requests);
    const auto values = read_values(answer_, requests.size(), name_);
    for (std::size_t i = 0; i < values.size(); ++i) kept_[index + i] = values[i];
}

NeutralValues AskedValues::get(std::size_t index) {
    const auto at = kept_.find(index);
    if (at != kept_.end()) return at->second;
    if (!one_by_one_) {
        try {
            ask_from(index, kMostAtOnce);
            return kept_.at(index);
        } catch (const Error&) {
            // Another of them may be the damaged one.
            one_by_one_ = true;
        }
    }
    ask_from(index, 1);
    return kept_.at(index);
}

}  // namespace feelem::exchange
