// SPDX-License-Identifier: Apache-2.0
// The parts of check_against_inputs. Plain tables on purpose: nothing here is shared with skin or the writer.
#pragma once

#include "feelem/convert.hpp"
#include "feelem/model.hpp"
#include "feelem/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace feelem {

/// Counts comparisons of one kind and keeps the first that failed.
struct Tally {
    std::string name;
    std::uint64_t compared = 0, wrong = 0;
    std::string first_wrong{};

    void count(bool right, const auto& describe) {
        ++compared;
        if (right) return;
        if (wrong++ == 0) first_wrong = describe();
    }
    Claim claim() const;
};

/// Element id -> index, by search.
class ElementTable {
public:
    explicit ElementTable(const Mesh& mesh);
    /// kNoElement when there is none.
    ElementIndex operator()(std::int64_t id) const;

private:
    std::vector<std::pair<std::int64_t, std::uint32_t>> sorted_;
};

/// The certificate's numbers of the model and its facets against a skin made anew.
Claim check_counts(const Mesh& mesh, const Scene& scene, const Job& job);
/// Every triangle against the facets of the model, found by sorting all of them.
std::vector<Claim> check_triangles(const Mesh& mesh, const Scene& scene);
/// Range over the model, location, averaging and shear of one result at one step. `result` has its
/// components.
void count_statements(
    const Mesh& mesh, const Result& result, const SceneResult& scene, const SceneValues& values, Tally& tally
);
/// Every field against the model's results.
std::vector<Claim> check_values(ModelSource& source, const Scene& scene, const Progress& progress);

}  // namespace feelem
