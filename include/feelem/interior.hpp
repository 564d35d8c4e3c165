// SPDX-License-Identifier: Apache-2.0
// A model kept for questions about its inside, by the names that its scene uses.
#pragma once

#include "feelem/convert.hpp"
#include "feelem/inside.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// A component of one of the scene's results (extras.feelem.results[].id), at one of its steps (steps[].id).
struct InteriorField {
    std::string result;
    std::size_t component = 0;
    std::size_t step = 1;
};
/// The shape that is cut: places moved by a displacement of the scene times a factor.
struct InteriorShape {
    std::string result;
    std::size_t step = 1;
    double factor = 0;
};

struct PlaneQuestion {
    InteriorField field;
    Plane plane;
    std::optional<InteriorShape> shape{};
};
struct LevelQuestion {
    InteriorField field;
    double level = 0;
    std::optional<InteriorField> colour{};
    std::optional<InteriorShape> shape{};
};
struct PlaceQuestion {
    Point3 place{};  ///< Of the shape that is asked for.
    std::vector<InteriorField> fields;
    std::optional<InteriorShape> shape{};
};

/// Whose a triangle is: the solver's number of the element, and its part in the model.
struct SectionOwner {
    std::int64_t element = 0;
    std::uint32_t part = 0;
};

struct InteriorOptions {
    std::size_t kept_bytes = std::size_t{512}
                             << 20U;  ///< Of results that were read; the last one stays anyway.
};

/// Opens the job's inputs at the first question, not before: nobody may ask. Holds the mesh, an index of 12
/// bytes an element, two deformed shapes at most, and results up to `kept_bytes`. May be asked by several
/// threads. Questions throw Error(UnknownName) for what the scene does not have, Error(BadOption) for what
/// cannot be asked, Error(TooLarge), and Error(SourcesDisagree) once an input is no longer the file that the
/// scene was made of. Empty when cancelled.
class InteriorModel {
public:
    /// The job of the scene, whose inputs are as they are now.
    explicit InteriorModel(Job job, const InteriorOptions& options = {});
    ~InteriorModel();
    InteriorModel(const InteriorModel&) = delete;
    InteriorModel& operator=(const InteriorModel&) = delete;

    std::optional<Section> section(const PlaneQuestion& question, const SectionLimits& limits);
    std::optional<Section> surface(const LevelQuestion& question, const SectionLimits& limits);
    /// JSON (docs/serving.md); "element" is null where there is no solid.
    std::optional<std::string> place(const PlaceQuestion& question, const SectionLimits& limits);
    /// Of each triangle of a section.
    std::vector<SectionOwner> owners(const Section& section);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem
