// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/neutral_form.hpp"

#include "base/byte_reader.hpp"
#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace feelem::exchange {
namespace {

class Reader {
public:
    Reader(const Input& input, const std::string& name) : bytes_(input, 0), name_(name) {}

    template <class T>
    T get() {
        return bytes_.read<T>();
    }
    std::size_t count(std::size_t size) {
        const auto count = get<std::uint64_t>();
        if (count > bytes_.remaining() / size) bad("more entries than bytes");
        return static_cast<std::size_t>(count);
    }
    std::string text() {
        const auto bytes = bytes_.take(count(1));
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    template <class T>
    std::vector<T> array() {
        const std::size_t size = count(sizeof(T));
        const auto bytes = bytes_.take(size * sizeof(T));
        std::vector<T> values(size);
        if (size > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    [[noreturn]] void bad(std::string_view what) const {
        throw Error(
            Code::BadStructure,
            name_,
            fmt::format("the helper program gave {}: the file must be damaged", what)
        );
    }

private:
    ByteReader bytes_;
    const std::string& name_;
};

void check(const NeutralModel& model, const Reader& reader) {
    const std::size_t nodes = model.node_ids.size(), elements = model.types.size();
    if (model.coordinates.size() != 3 * nodes) reader.bad("another number of coordinates than of nodes");
    if (model.element_ids.size() != elements || model.element_parts.size() != elements)
        reader.bad("lists of elements that differ in length");
    std::size_t used = 0;
    for (const ElementType type : model.types) {
        if (static_cast<std::size_t>(type) >= kElementTypeCount) reader.bad("an element of no type");
        used += element_row(type).node_count;
    }
    if (used != model.element_nodes.size()) reader.bad("elements without all their nodes");
    for (const std::uint32_t node : model.element_nodes) {
        if (node >= nodes) reader.bad("an element of nodes that do not exist");
    }
    for (const std::uint32_t part : model.element_parts) {
        if (part >= model.parts.size()) reader.bad("an element of no part");
    }
    for (const NeutralResult& result : model.results) {
        if (result.step >= model.steps.size() || result.components == 0) reader.bad("a result of no step");
    }
}

}  // namespace

std::string write_model(const NeutralModel& model) {
    NeutralWriter to(Answer::Model);
    to.put(model.node_ids);
    to.put(model.coordinates);
    to.put(std::uint64_t{model.parts.size()});
    for (const std::string& part : model.parts) to.put(std::string_view(part));
    to.put(model.types);
    to.put(model.element_ids);
    to.put(model.element_parts);
    to.put(model.element_nodes);
    to.put(std::uint64_t{model.skipped.size()});
    for (const auto& [name, count] : model.skipped) {
        to.put(std::string_view(name));
        to.put(count);
    }
    for (const auto* sets : {&model.node_sets, &model.element_sets}) {
        to.put(std::uint64_t{sets->size()});
        for (const auto& [name, members] : *sets) {
            to.put(std::string_view(name));
            to.put(members);
        }
    }
    to.put(std::uint64_t{model.steps.size()});
    for (const Step& step : model.steps) {
        to.put(step.step);
        to.put(step.substep);
        to.put(step.kind);
        to.put(step.value);
    }
    to.put(std::uint64_t{model.results.size()});
    for (const NeutralResult& result : model.results) {
        to.put(std::string_view(result.name));
        to.put(result.components);
        to.put(result.location);
        to.put(result.step);
        to.put(std::uint64_t{result.component_names.size()});
        for (const std::string& name : result.component_names) to.put(std::string_view(name));
    }
    to.put(std::string_view(model.length_unit));
    return to.take();
}

std::uint64_t mesh_digest(const NeutralModel& model) {
    std::uint64_t digest = 0xCBF29CE484222325;
    const auto mix = [&](const auto& numbers) {
        for (const auto number : numbers) {
            digest = (digest ^ static_cast<std::uint64_t>(number)) * 0x100000001B3;
            digest ^= digest >> 29;
        }
    };
    mix(model.node_ids);
    mix(model.types);
    mix(model.element_ids);
    mix(model.element_nodes);
    return digest;
}

void write_values(NeutralWriter& to, std::uint64_t mesh_digest, const std::vector<float>& values) {
    to.put(mesh_digest);
    to.put(values);
}

std::vector<NeutralValues> read_values(std::string_view answer, std::size_t count, const std::string& name) {
    const auto take = [&](std::size_t size) {
        if (size > answer.size())
            throw Error(
                Code::BadStructure, name, "the helper program gave too few values: the file must be damaged"
            );
        const std::string_view bytes = answer.substr(0, size);
        answer.remove_prefix(size);
        return bytes;
    };
    const auto number = [&] {
        std::uint64_t value = 0;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    };
    std::vector<NeutralValues> all;
    if (take(1)[0] != static_cast<char>(Answer::Values)) answer = {};
    while (all.size() < count) {
        NeutralValues& values = all.emplace_back();
        values.mesh_digest = number();
        const std::uint64_t floats = number();
        const std::string_view bytes =
            take(floats > answer.size() ? SIZE_MAX : static_cast<std::size_t>(floats) * sizeof(float));
        values.bytes = std::span(bytes.data(), bytes.size());
    }
    return all;
}

std::string write_request(const NeutralResult& result) {
    return fmt::format(
        "{}:{}:{}:{}", result.step, static_cast<int>(result.location), result.components, result.name
    );
}

NeutralResult read_request(std::string_view word) {
    NeutralResult result;
    std::uint32_t numbers[3];
    for (std::uint32_t& number : numbers) {
        const std::size_t end = word.find(':');
        const auto value = parse_integer(word.substr(0, end));
        if (end == std::string_view::npos || !value || *value < 0 || *value > UINT32_MAX)
            throw std::runtime_error("not a request");
        number = static_cast<std::uint32_t>(*value);
        word.remove_prefix(end + 1);
    }
    result.step = numbers[0];
    result.location =
        numbers[1] == static_cast<std::uint32_t>(Location::Elemental) ? Location::Elemental : Location::Nodal;
    result.components = numbers[2];
    result.name = word;
    return result;
}

NeutralModel read_model(std::string bytes, const std::string& name) {
    const Input input = Input::from_memory(name, std::move(bytes));
    Reader from(input, name);
    if (from.get<std::uint8_t>() != static_cast<std::uint8_t>(Answer::Model)) from.bad("no model");
    NeutralModel model;
    model.node_ids = from.array<std::int64_t>();
    model.coordinates = from.array<double>();
    for (std::size_t left = from.count(8); left > 0; --left) model.parts.push_back(from.text());
    model.types = from.array<ElementType>();
    model.element_ids = from.array<std::int64_t>();
    model.element_parts = from.array<std::uint32_t>();
    model.element_nodes = from.array<std::uint32_t>();
    for (std::size_t left = from.count(16); left > 0; --left) {
        std::string kind = from.text();
        model.skipped.emplace_back(std::move(kind), from.get<std::uint64_t>());
    }
    for (auto* sets : {&model.node_sets, &model.element_sets}) {
        for (std::size_t left = from.count(16); left > 0; --left) {
            std::string set = from.text();
            sets->emplace_back(std::move(set), from.array<std::uint32_t>());
        }
    }
    for (std::size_t left = from.count(17); left > 0; --left) {
        Step step;
        step.step = from.get<std::int32_t>();
        step.substep = from.get<std::int32_t>();
        const auto kind = from.get<std::uint8_t>();
        step.kind = kind <= static_cast<std::uint8_t>(StepKind::Other) ? static_cast<StepKind>(kind)
                                                                       : StepKind::Other;
        step.value = from.get<double>();
        model.steps.push_back(std::move(step));
    }
    for (std::size_t left = from.count(17); left > 0; --left) {
        NeutralResult result;
        result.name = from.text();
        result.components = from.get<std::uint32_t>();
        result.location = from.get<std::uint8_t>() == static_cast<std::uint8_t>(Location::Elemental)
                              ? Location::Elemental
                              : Location::Nodal;
        result.step = from.get<std::uint32_t>();
        for (std::size_t names = from.count(8); names > 0; --names)
            result.component_names.push_back(from.text());
        model.results.push_back(std::move(result));
    }
    model.length_unit = from.text();
    check(model, from);
    return model;
}

}  // namespace feelem::exchange
