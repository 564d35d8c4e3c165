// SPDX-License-Identifier: Apache-2.0
// `feelem info`: what is in the files, as tables for people or as version 1 of the JSON form.
#include "command.hpp"
#include "scene_info.hpp"
#include "scene_input.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace feelem::cli {
namespace {

/// 7670 -> "7,670".
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;) {
        at -= 3;
        digits.insert(at, 1, ',');
    }
    return digits;
}

std::string counts(const std::vector<std::pair<std::string, std::uint64_t>>& rows) {
    std::string text;
    for (const auto& [name, count] : rows) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(count), name);
    }
    return text;
}

void print_inputs(const ModelReport& report) {
    for (const InputRecord& input : report.inputs) {
        fmt::print("Input    {}  ({}, {} bytes)\n", input.path, input.format, grouped(input.bytes));
    }
}

/// The first sets by name; decks may have thousands.
void print_sets(const char* kind, const std::vector<std::pair<std::string, std::uint64_t>>& sets) {
    if (sets.empty()) return;
    constexpr std::size_t kMostNames = 8;
    const std::vector first(
        sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(std::min(sets.size(), kMostNames))
    );
    std::string text;
    for (const auto& [name, count] : first)
        text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name, grouped(count));
    if (sets.size() > kMostNames) text += fmt::format(" and {} more", sets.size() - kMostNames);
    fmt::print("Sets     {} {}{}: {}\n", grouped(sets.size()), kind, sets.size() == 1 ? "" : "s", text);
}

void print_model(const ModelReport& report) {
    const std::string unit = report.length_unit ? report.length_unit->name : "";
    fmt::print("Nodes    {}\n", grouped(report.nodes));
    fmt::print("Elements {}: {}", grouped(report.elements), counts(report.elements_by_type));
    if (!report.skipped_elements.empty()) fmt::print("; left out: {}", counts(report.skipped_elements));
    fmt::print("\n");
    constexpr std::size_t kMostParts = 12;
    for (std::size_t i = 0; i < report.parts.size() && i < kMostParts; ++i) {
        fmt::print("Part     {}: {} elements\n", report.parts[i].first, grouped(report.parts[i].second));
    }
    if (report.parts.size() > kMostParts) {
        fmt::print("         and {} parts more\n", report.parts.size() - kMostParts);
    }
    print_sets("node set", report.node_sets);
    print_sets("element set", report.element_sets);
    if (report.bounds) {
        const auto& [low, high] = *report.bounds;
        fmt::print(
            "Box      x {:g} .. {:g}, y {:g} .. {:g}, z {:g} .. {:g} ({})\n",
            low[0],
            high[0],
            low[1],
            high[1],
            low[2],
            high[2],
            unit.empty() ? "length unit unknown" : unit
        );
    }
}

std::uint64_t count_lines(const ModelReport& report) {
    std::uint64_t lines = 0;
    for (const auto& [name, count] : report.elements_by_type) lines += name.starts_with("line") ? count : 0;
    return lines;
}

void print_skin(const ModelReport& report) {
    if (report.is_brief) return;
    if (!report.skin) {
        fmt::print("Skin     none: nothing here can be drawn\n");
        return;
    }
    const SkinReport& skin = *report.skin;
    if (skin.has_solids) {
        fmt::print(
            "Skin     {} of {} facets of solids, {}; volume {:g}\n",
            grouped(skin.solid_facets_kept),
            grouped(skin.solid_facets_in),
            skin.closed ? "closed" : "not closed",
            skin.volume
        );
    }
    if (skin.shell_tri + skin.shell_quad > 0) {
        fmt::print("Shells   {} facets\n", grouped(skin.shell_tri + skin.shell_quad));
    }
    if (skin.triangles > 0) {
        fmt::print(
            "Drawn    {} triangles on {} vertices; area {:g}\n",
            grouped(skin.triangles),
            grouped(skin.vertices),
            skin.area
        );
    }
    if (const std::uint64_t lines = count_lines(report); lines > 0)
        fmt::print("Tubes    {} lines\n", grouped(lines));
}

void print_steps(const ModelReport& report) {
    if (report.steps.empty()) return;
    fmt::print("\n{:<10} {:<10} {:<14} {:<20} {}\n", "Step", "Kind", "Value", "Label", "Input");
    for (const Step& step : report.steps) {
        const bool known = step.input < report.inputs.size();
        fmt::print(
            "{:<10} {:<10} {:<14g} {:<20} {}\n",
            fmt::format("{}.{}", step.step, step.substep),
            word(step.kind),
            step.value,
            step.label,
            known ? report.inputs[step.input].path : ""
        );
    }
}

std::string extreme(const ComponentRange& range, float value, std::int64_t id, std::int64_t element) {
    if (range.valid == 0) return "-";
    if (element != 0) return fmt::format("{} @ {} of {}", value, id, element);
    return fmt::format("{} @ {}", value, id);
}

bool is_ours(Averaging averaging) {
    return averaging != Averaging::NotApplicable && averaging != Averaging::Solver;
}

std::string_view averaged(Averaging averaging) {
    if (averaging == Averaging::None) return "unaveraged";
    return averaging == Averaging::All ? "across parts" : "in parts";
}

bool has_several_averagings(const ModelReport& report) {
    std::set<Averaging> found;
    for (const ResultReport& result : report.results) {
        if (is_ours(result.info.averaging)) found.insert(result.info.averaging);
    }
    return found.size() > 1;
}

/// Sums of reactions, a line a result and step.
void print_reactions(const ModelReport& report) {
    if (report.reactions.empty()) return;
    fmt::print("\n{:<28} {:<8} {:<8} {:<10} {}\n", "Sum over all nodes", "Unit", "Step", "Nodes", "Sum");
    for (const ReactionSum& reaction : report.reactions) {
        const Step& step = report.steps.at(reaction.info.step);
        const std::string_view complex = word(reaction.info.complex);
        std::string sum;
        for (std::size_t c = 0; c < reaction.sum.size(); ++c) {
            const std::string& component = reaction.info.components[c];
            const std::string name = component == "value" ? "" : component + " ";
            sum += fmt::format("{}{}{:.7g}", c == 0 ? "" : ", ", name, reaction.sum[c]);
        }
        fmt::print(
            "{:<28} {:<8} {:<8} {:<10} {}\n",
            reaction.info.name + (complex.empty() ? "" : " ") + std::string(complex),
            reaction.info.unit.empty() ? "-" : reaction.info.unit,
            fmt::format("{}.{}", step.step, step.substep),
            grouped(reaction.nodes),
            sum
        );
    }
}

/// Each result once, with the number of steps that it stands at.
void print_names(const ModelReport& report) {
    std::vector<std::pair<std::string, std::size_t>> names;
    for (const ResultReport& result : report.results) {
        std::string name = result.info.name;
        for (const std::string_view note : {word(result.info.layer), word(result.info.complex)}) {
            if (!note.empty()) name += " " + std::string(note);
        }
        const auto known = std::ranges::find(names, name, &std::pair<std::string, std::size_t>::first);
        if (known == names.end())
            names.emplace_back(name, 1);
        else
            ++known->second;
    }
    fmt::print("\n");
    for (const auto& [name, steps] : names) fmt::print("Result   {} (at {} steps)\n", name, grouped(steps));
}

void print_results(const ModelReport& report) {
    if (report.results.empty()) return;
    if (report.is_brief) return print_names(report);
    fmt::print(
        "\n{:<28} {:<8} {:<8} {:<26} {:<26} {}\n",
        "Result",
        "Unit",
        "Step",
        "Minimum @ id",
        "Maximum @ id",
        "Missing"
    );
    const bool several = has_several_averagings(report);
    for (const ResultReport& result : report.results) {
        const Step& step = report.steps.at(result.info.step);
        std::string extra;
        for (const std::string_view note : {word(result.info.layer), word(result.info.complex)}) {
            if (!note.empty()) extra += " " + std::string(note);
        }
        if (several && is_ours(result.info.averaging)) {
            extra += fmt::format(" ({})", averaged(result.info.averaging));
        }
        for (const ComponentRange& range : result.ranges) {
            const std::string component = range.component == "value" ? "" : " " + range.component;
            fmt::print(
                "{:<28} {:<8} {:<8} {:<26} {:<26} {}\n",
                result.info.name + extra + component,
                result.info.unit.empty() ? "-" : result.info.unit,
                fmt::format("{}.{}", step.step, step.substep),
                extreme(range, range.min, range.min_id, range.min_element),
                extreme(range, range.max, range.max_id, range.max_element),
                range.missing == 0 ? "" : grouped(range.missing)
            );
        }
    }
}

}  // namespace

int run_info(const Options& options) {
    refuse_making_a_scene_again(options);
    if (options.job.inputs.size() == 1 && is_scene(options.job.inputs.front())) {
        print_scene_info(options.job.inputs.front(), options.json);
        return 0;
    }
    Terminal terminal(options.verbose);
    ToldDiagnostics diagnostics(terminal);
    const auto report = report_model(options.job, *diagnostics, terminal.progress());
    terminal.finish();
    if (!report) {
        fmt::print(stderr, "feelem: cancelled\n");
        return 1;
    }
    if (options.json) {
        fmt::print("{}", info_json(*report, *diagnostics));
        return 0;
    }
    print_inputs(*report);
    print_model(*report);
    print_skin(*report);
    print_steps(*report);
    print_results(*report);
    print_reactions(*report);
    diagnostics.print();
    return 0;
}

}  // namespace feelem::cli
