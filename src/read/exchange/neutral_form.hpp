// SPDX-License-Identifier: Apache-2.0
// What the helper program feelem-exchange tells: a mesh, the list of its results, and values, as bytes
// through a pipe. Both sides are of one build and one machine; the reading side trusts no count all the same.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/result.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::exchange {

struct NeutralResult {
    std::string name;
    std::uint32_t components = 0;
    Location location = Location::Nodal;         ///< Nodal or Elemental
    std::uint32_t step = 0;                      ///< Into NeutralModel::steps.
    std::vector<std::string> component_names{};  ///< Empty: the file names none.
};

struct NeutralModel {
    std::vector<std::int64_t> node_ids;  ///< As many as nodes, all different and positive.
    std::vector<double> coordinates;     ///< Three a node.
    std::vector<std::string> parts;
    std::vector<ElementType> types;         ///< One an element.
    std::vector<std::int64_t> element_ids;  ///< One an element, all different and positive.
    std::vector<std::uint32_t> element_parts;
    std::vector<std::uint32_t>
        element_nodes;  ///< Indexes of nodes in Feelem's order, as many as the type has.
    std::vector<std::pair<std::string, std::uint64_t>> skipped;                 ///< Kinds of cells left out.
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> node_sets;  ///< Indexes of nodes.
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> element_sets;  ///< Indexes of elements.
    std::vector<Step> steps;
    std::vector<NeutralResult> results;
    std::string length_unit;  ///< Empty: unknown.
};

/// First byte of an answer.
enum class Answer : std::uint8_t {
    Model = 'M',
    Values = 'V',       ///< A NeutralValues for each request.
    Error = 'E',        ///< Words for the user.
    Unsupported = 'U',  ///< The same: this build lacks the library.
};

/// Appends plain values; strings and arrays start with their length.
class NeutralWriter {
public:
    explicit NeutralWriter(Answer answer) { put(answer); }

    template <class T>
    void put(T value) {
        const char* const bytes = reinterpret_cast<const char*>(&value);
        out_.append(bytes, sizeof(T));
    }
    void put(std::string_view text) {
        put(std::uint64_t{text.size()});
        out_ += text;
    }
    template <class T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t{values.size()});
        out_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    std::string take() { return std::move(out_); }

private:
    std::string out_;
};

std::string write_model(const NeutralModel& model);

/// What tells whether two steps have the same nodes and elements, whatever places the nodes moved to.
std::uint64_t mesh_digest(const NeutralModel& model);

/// One result.
struct NeutralValues {
    std::uint64_t mesh_digest = 0;  ///< Of its step.
    std::span<const char> bytes;    ///< Of floats in the order of nodes or elements, missing ones NaN.
};
/// Appends one to an answer that was begun with Answer::Values.
void write_values(NeutralWriter& to, std::uint64_t mesh_digest, const std::vector<float>& values);
/// Views of the answer. Throws Error(BadStructure) on anything but `count` of what write_values() writes.
std::vector<NeutralValues> read_values(std::string_view answer, std::size_t count, const std::string& name);

/// A result as a word on the helper's command line, and back. Throws std::runtime_error.
std::string write_request(const NeutralResult& result);
NeutralResult read_request(std::string_view word);

/// Throws Error(BadStructure) on anything that write_model() cannot have written.
NeutralModel read_model(std::string bytes, const std::string& name);

}  // namespace feelem::exchange
