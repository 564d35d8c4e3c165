// SPDX-License-Identifier: Apache-2.0
// Heads of result datasets -> steps and results.
#include "read/result_names.hpp"
#include "read/text_lines.hpp"
#include "read/unv/unv_results.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

namespace feelem::unv {
namespace {

/// What both kinds of heads say.
struct Head {
    std::string label;
    std::int64_t location = 0;  ///< 1 nodes, 2 elements, 3 nodes on elements.
    std::int64_t analysis = 0, characteristic = 0, quantity = 0, data = 0, count = 0;
    std::int64_t load_case = 0, number = 0;
    double value = 0;
    std::size_t first = 0;  ///< The first record.
};

std::vector<std::int64_t> integers_of(std::string_view line) {
    std::vector<std::int64_t> out;
    while (const auto value = take_integer(line)) out.push_back(*value);
    return out;
}

std::vector<double> reals_of(std::string_view line) {
    std::vector<double> out;
    while (const auto value = parse_double(take_word(line))) out.push_back(*value);
    return out;
}

template <class T>
T at_or_zero(const std::vector<T>& values, std::size_t i) {
    return i < values.size() ? values[i] : T{};
}

bool read_definition(Head& head, std::string_view line) {
    const auto fields = integers_of(line);
    if (fields.size() < 6) return false;
    head.analysis = fields[1];
    head.characteristic = fields[2];
    head.quantity = fields[3];
    head.data = fields[4];
    head.count = fields[5];
    return head.count > 0 && head.count <= 100;
}

std::optional<Head> read_2414(TextLines& lines) {
    Head head;
    const auto next = [&] { return lines.next().value_or(std::string_view{}); };
    next();  // Label
    head.label = trim(next());
    const auto location = integers_of(next());
    head.location = at_or_zero(location, 0);
    for (int i = 0; i < 5; ++i) next();
    if (!read_definition(head, next())) return {};
    const auto numbers = integers_of(next());
    next();  // Creation option
    const auto reals = reals_of(next());
    next();
    head.load_case = at_or_zero(numbers, 4);
    const bool modes = head.analysis == 2 || head.analysis == 3 || head.analysis == 6 || head.analysis == 7;
    head.number = at_or_zero(numbers, modes ? 5 : head.analysis == 5 ? 7 : 6);
    head.value = at_or_zero(reals, head.analysis == 6 ? 2 : modes || head.analysis == 5 ? 1 : 0);
    head.first = lines.offset();
    return head;
}

std::optional<Head> read_older(TextLines& lines, int dataset) {
    Head head;
    const auto next = [&] { return lines.next().value_or(std::string_view{}); };
    head.label = trim(next());
    for (int i = 0; i < 4; ++i) next();
    head.location = dataset - 54;
    if (!read_definition(head, next())) return {};
    auto integers = integers_of(next());
    std::vector<double> reals;
    const std::int64_t whole = at_or_zero(integers, 0), real = at_or_zero(integers, 1);
    if (whole < 0 || whole > 12 || real < 0 || real > 12) return {};
    // Both may run on over further lines: eight integers, six reals a line.
    while (std::ssize(integers) < whole + 2) {
        const auto more = integers_of(next());
        if (more.empty()) return {};
        integers.insert(integers.end(), more.begin(), more.end());
    }
    do {
        const auto more = reals_of(next());
        if (more.empty() && real > 0) return {};
        reals.insert(reals.end(), more.begin(), more.end());
    } while (std::ssize(reals) < real);
    head.load_case = at_or_zero(integers, 2);
    head.number = whole >= 2 ? at_or_zero(integers, 3) : 0;
    head.value = head.analysis == 0 || head.analysis == 1 ? 0 : at_or_zero(reals, 0);
    // Complex eigenvalues come as real and imaginary part: the imaginary one is the frequency.
    if (head.analysis == 3 || head.analysis == 7) head.value = at_or_zero(reals, 1);
    head.first = lines.offset();
    return head;
}

StepKind kind_of(std::int64_t analysis) {
    switch (analysis) {
    case 1:
    case 9: return StepKind::Static;
    case 2:
    case 3:
    case 7: return StepKind::Mode;
    case 4: return StepKind::Time;
    case 5: return StepKind::Frequency;
    case 6: return StepKind::Buckling;
    default: return StepKind::Other;
    }
}

struct Quantity {
    std::int64_t number;
    std::string_view ours;
};
constexpr Quantity kQuantities[]{
    {2, "stress"},
    {3, "strain"},
    {4, "element_force"},
    {5, "temperature"},
    {6, "heat_flux"},
    {7, "strain_energy"},
    {8, "displacement"},
    {9, "reaction_force"},
    {10, "kinetic_energy"},
    {11, "velocity"},
    {12, "acceleration"},
    {13, "strain_energy_density"},
    {14, "kinetic_energy_density"},
    {15, "pressure"},
    {16, "heat_gradient"},
    {28, "thickness"},
    {32, "constraint_force"},
    {34, "plastic_strain"},
    {35, "creep_strain"},
    {38, "heat_transfer_coefficient"},
    {39, "temperature_gradient"},
};

/// What the numbers of a row are: components by their places.
struct Piece {
    std::string_view suffix;  ///< "_rotation" of a displacement is "rotation".
    std::uint32_t first = 0, count = 0;
};
std::vector<Piece> pieces_of(const Head& head) {
    const auto count = static_cast<std::uint32_t>(head.count);
    if (head.characteristic == 3 && count == 6) return {{"", 0, 3}, {"rotation", 3, 3}};
    return {{"", 0, count}};
}

class Lister {
public:
    Lister(const Input& input, Diagnostics& diagnostics) : input_(input), diagnostics_(diagnostics) {}

    Contents list(std::span<const Dataset> datasets) {
        for (const Dataset& dataset : datasets) {
            const bool older = dataset.number >= 55 && dataset.number <= 57;
            if (!older && dataset.number != 2414) continue;
            TextLines lines(input_, dataset.first, dataset.last);
            const auto head = older ? read_older(lines, dataset.number) : read_2414(lines);
            if (!head || head->location < 1 || head->location > 3 || !is_real_or_complex(head->data)) {
                diagnostics_.add(
                    Code::UnknownBlock,
                    [&] { return input_.where_line(dataset.first); },
                    fmt::format(
                        "a dataset {} is left out: its head is damaged or of a kind not read", dataset.number
                    )
                );
                continue;
            }
            add(*head, dataset.last);
        }
        return std::move(contents_);
    }

private:
    static bool is_real_or_complex(std::int64_t data) {
        return data == 2 || data == 4 || data == 5 || data == 6;
    }

    std::uint32_t step_of(const Head& head) {
        const StepKind kind = kind_of(head.analysis);
        const auto small = [](std::int64_t x) {
            return static_cast<std::int32_t>(std::clamp<std::int64_t>(x, 0, INT32_MAX));
        };
        const std::int32_t number =
            small(head.number > 0 ? head.number : std::max<std::int64_t>(head.load_case, 1));
        const auto [known, is_new] = steps_.try_emplace(
            std::tuple{kind, number, head.load_case, head.value},
            static_cast<std::uint32_t>(contents_.steps.size())
        );
        if (is_new) {
            const std::int32_t substep = ++substeps_[number];
            std::string label = kind == StepKind::Mode ? fmt::format("mode {}", number) : "";
            contents_.steps.push_back({0, number, substep, kind, head.value, std::move(label)});
        }
        return known->second;
    }

    void add(const Head& head, std::size_t last) {
        const bool complex = head.data == 5 || head.data == 6;
        const std::uint32_t step = step_of(head);
        for (const Piece& piece : pieces_of(head)) {
            for (const bool imaginary : {false, true}) {
                if (imaginary && !complex) continue;
                Listed listed;
                listed.first = head.first;
                listed.last = last;
                listed.numbers_a_row = static_cast<std::uint32_t>(head.count) * (complex ? 2 : 1);
                listed.info = info_of(head, piece);
                listed.info.step = step;
                if (complex) listed.info.complex = imaginary ? Complex::Imaginary : Complex::Real;
                const bool tensor = head.characteristic == 4 || head.characteristic == 5;
                listed.places = places_of(listed.info, piece.count, tensor);
                for (std::uint32_t& place : listed.places)
                    place = (piece.first + place) * (complex ? 2 : 1) + (imaginary ? 1 : 0);
                names_.make_unique(listed.info);
                contents_.results.push_back(std::move(listed));
            }
        }
    }

    static ResultInfo info_of(const Head& head, const Piece& piece) {
        ResultInfo info;
        const auto known = std::ranges::find(kQuantities, head.quantity, &Quantity::number);
        info.name = known != std::end(kQuantities)
                        ? std::string(known->ours)
                        : common_name(head.label, static_cast<std::size_t>(piece.count));
        if (!piece.suffix.empty())
            info.name =
                info.name == "displacement" ? "rotation" : info.name + "_" + std::string(piece.suffix);
        info.solver_name = head.label.empty() ? info.name : head.label;
        switch (head.location) {
        case 1: info.location = Location::Nodal; break;
        case 2: info.location = Location::Elemental; break;
        default: info.location = Location::ElementNodal; break;
        }
        constexpr std::array<std::int64_t, 7> kAveraged{2, 3, 6, 13, 34, 35, 16};
        if (head.location == 3) info.averaging = Averaging::None;
        if (head.location == 1 && std::ranges::find(kAveraged, head.quantity) != kAveraged.end())
            info.averaging = Averaging::Solver;
        return info;
    }

    /// Six numbers are a tensor only where the head says so.
    static std::vector<std::uint32_t> places_of(ResultInfo& info, std::uint32_t count, bool tensor) {
        if (!tensor && (count == 6 || count == 9)) {
            info.shape = Shape::Other;
            std::vector<std::uint32_t> places;
            for (std::uint32_t i = 0; i < count; ++i) {
                info.components.push_back(fmt::format("c{}", i + 1));
                places.push_back(i);
            }
            return places;
        }
        return name_components(info, count, TensorOrder::Ideas);
    }

    const Input& input_;
    Diagnostics& diagnostics_;
    Contents contents_;
    std::map<std::tuple<StepKind, std::int32_t, std::int64_t, double>, std::uint32_t> steps_;
    std::map<std::int32_t, std::int32_t> substeps_;
    ResultNames names_;
};

}  // namespace

Contents list_contents(const Input& input, std::span<const Dataset> datasets, Diagnostics& diagnostics) {
    return Lister(input, diagnostics).list(datasets);
}

}  // namespace feelem::unv
