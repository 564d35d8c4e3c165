// SPDX-License-Identifier: Apache-2.0
// Values from the helper program, several results at a time: its start costs more than reading a small one.
#pragma once

#include "read/exchange/neutral_form.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace feelem::exchange {

class AskedValues {
public:
    /// Runs the helper with these requests and gives its answer; throws Error.
    using Ask = std::function<std::string(const std::vector<std::string>& requests)>;

    /// `name`: of the file, for messages.
    AskedValues(Ask ask, std::string name) : ask_(std::move(ask)), name_(std::move(name)) {}

    void list(std::vector<NeutralResult> results, std::size_t nodes, std::size_t elements);

    /// The values of a result; they can be viewed until the next call. Asks for those that follow in the list
    /// at the same time, as far as they fit into a small memory, and keeps them.
    NeutralValues get(std::size_t index);

private:
    std::uint64_t bytes_of(std::size_t index) const;
    void ask_from(std::size_t index, std::size_t most);

    Ask ask_;
    std::string name_;
    std::vector<NeutralResult> results_;
    std::size_t nodes_ = 0, elements_ = 0;
    std::string answer_;
    std::map<std::size_t, NeutralValues> kept_;  ///< Views of answer_.
    bool one_by_one_ = false;                    ///< Once the helper has failed on several.
};

}  // namespace feelem::exchange
