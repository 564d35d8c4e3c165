// SPDX-License-Identifier: Apache-2.0
// A model that was opened, and what was said of it.
#pragma once

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace feelem::test {

struct OpenedModel {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;
};

inline std::unique_ptr<OpenedModel> open_path(const std::string& path) {
    auto opened = std::make_unique<OpenedModel>();
    opened->model = open_model(std::vector<std::string>{path}, {}, opened->diagnostics);
    return opened;
}

inline std::unique_ptr<OpenedModel> open_bytes(std::vector<NamedBytes> files) {
    auto opened = std::make_unique<OpenedModel>();
    opened->model = open_model(std::move(files), {}, opened->diagnostics);
    return opened;
}

/// Code::BadScene when they open without an error.
inline Error error_of(std::vector<NamedBytes> files) {
    try {
        open_bytes(std::move(files));
    } catch (const Error& error) {
        return error;
    }
    return Error(Code::BadScene, "", "no error");
}

}  // namespace feelem::test
