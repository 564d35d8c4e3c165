// SPDX-License-Identifier: Apache-2.0
// SHA-256 as lower-case hex, for inputs and for every array of a scene.
#pragma once

#include "base/input.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace feelem {

class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(std::span<const std::byte> bytes);
    std::string hex();  ///< Ends it.

private:
    struct State;
    std::unique_ptr<State> state_;
};

std::string sha256_hex(std::span<const std::byte> bytes);
/// Of a whole input, releasing its pages behind itself.
std::string sha256_hex(const Input& input);

}  // namespace feelem
