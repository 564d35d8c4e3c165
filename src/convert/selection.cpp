// SPDX-License-Identifier: Apache-2.0
#include "convert/selection.hpp"

#include "base/nearest_name.hpp"
#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace feelem {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> items;
    while (true) {
        const std::size_t end = text.find(separator);
        items.push_back(trim(text.substr(0, end)));
        if (end == std::string_view::npos) return items;
        text.remove_prefix(end + 1);
    }
}

std::vector<std::size_t> all_of(std::size_t count) {
    std::vector<std::size_t> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = i;
    return all;
}

std::vector<std::size_t> last_of_each_input(std::span<const Step> steps) {
    std::vector<std::size_t> last;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool again =
            std::any_of(steps.begin() + static_cast<std::ptrdiff_t>(i) + 1, steps.end(), [&](const Step& s) {
                return s.input == steps[i].input;
            });
        if (!again) last.push_back(i);
    }
    return last;
}

/// The last substep of each load step of each input, and every mode.
std::vector<std::size_t> telling_steps(std::span<const Step> steps) {
    std::set<std::pair<std::uint32_t, std::int32_t>> seen;
    std::vector<std::size_t> kept;
    for (std::size_t i = steps.size(); i-- > 0;) {
        const bool is_mode = steps[i].kind == StepKind::Mode || steps[i].kind == StepKind::Buckling;
        const bool is_last = seen.emplace(steps[i].input, steps[i].step).second;
        if (is_mode || is_last) kept.push_back(i);
    }
    std::ranges::reverse(kept);
    return kept;
}

std::vector<std::size_t> default_steps(
    std::span<const Step> steps, DefaultSteps otherwise, Diagnostics& diagnostics
) {
    constexpr std::size_t kMostSteps = 20;
    if (otherwise == DefaultSteps::Last) return last_of_each_input(steps);
    if (otherwise == DefaultSteps::All || steps.size() <= kMostSteps) return all_of(steps.size());
    std::vector<std::size_t> kept = telling_steps(steps);
    if (kept.size() < steps.size()) {
        diagnostics.add(
            Code::StepsLeftOut,
            "",
            fmt::format(
                "{} of {} steps are taken: the last of each load step, and every mode. --steps all takes "
                "them all",
                kept.size(),
                steps.size()
            )
        );
    }
    return kept;
}

/// The steps that one item of --steps names: "2", "1.3", "mode:2", "last".
std::vector<std::size_t> steps_named(std::span<const Step> steps, std::string_view item) {
    std::vector<std::size_t> found;
    if (item == "last") return last_of_each_input(steps);
    if (item.starts_with("mode:")) {
        const auto number = parse_integer(item.substr(5));
        if (!number) throw Error(Code::BadOption, "--steps", fmt::format("\"{}\": a mode is mode:2", item));
        std::map<std::uint32_t, std::int64_t> modes;  // counted within each input
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const bool is_mode = steps[i].kind == StepKind::Mode || steps[i].kind == StepKind::Buckling;
            if (is_mode && ++modes[steps[i].input] == *number) found.push_back(i);
        }
        return found;
    }
    const std::size_t dot = item.find('.');
    const auto step = parse_integer(item.substr(0, dot));
    const auto substep = dot == std::string_view::npos ? step : parse_integer(item.substr(dot + 1));
    if (!step || !substep) {
        throw Error(
            Code::BadOption,
            "--steps",
            fmt::format(
                "\"{}\" names no step: write last, all, 2 (load step 2), 1.3 (load step 1, substep 3) or "
                "mode:2",
                item
            )
        );
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool substep_fits = dot == std::string_view::npos || steps[i].substep == *substep;
        if (steps[i].step == *step && substep_fits) found.push_back(i);
    }
    return found;
}

std::string known_steps(std::span<const Step> steps) {
    constexpr std::size_t kMostListed = 12;
    std::string text;
    for (std::size_t i = 0; i < steps.size() && i < kMostListed; ++i) {
        text += (i == 0 ? "" : ", ") + fmt::format("{}.{}", steps[i].step, steps[i].substep);
    }
    return steps.size() > kMostListed ? text + ", ..." : text;
}

/// "stress", "stress@static.frd", "stress@top", "stress@top@static.rst".
bool is_called(const ModelSource& source, const ResultInfo& info, std::string_view name) {
    const std::vector<std::string_view> words = split(name, '@');
    if (words.front() != info.name) return false;
    const std::uint32_t input = source.steps()[info.step].input;
    const auto inputs = source.inputs();
    return std::all_of(words.begin() + 1, words.end(), [&](std::string_view of) {
        const bool is_file = input < inputs.size() && file_name(inputs[input].path) == file_name(of);
        return is_file || (!of.empty() && word(info.layer) == of);
    });
}

}  // namespace

std::string_view file_name(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string step_name(const Step& step) {
    const bool is_mode = step.kind == StepKind::Mode || step.kind == StepKind::Buckling;
    return fmt::format("{}{}.{}", is_mode ? "mode " : "", step.step, step.substep);
}

std::vector<std::size_t> select_steps(
    std::span<const Step> steps, std::string_view text, DefaultSteps otherwise, Diagnostics& diagnostics
) {
    if (text.empty()) return default_steps(steps, otherwise, diagnostics);
    if (text == "all") return all_of(steps.size());
    std::set<std::size_t> chosen;
    for (const std::string_view item : split(text, ',')) {
        const std::vector<std::size_t> found = steps_named(steps, item);
        if (found.empty()) {
            throw Error(
                Code::UnknownName,
                "--steps",
                steps.empty()
                    ? "the inputs hold no step"
                    : fmt::format("there is no step \"{}\". The steps are: {}", item, known_steps(steps))
            );
        }
        chosen.insert(found.begin(), found.end());
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<std::size_t> select_results(
    const ModelSource& source, const std::vector<std::size_t>& steps, std::string_view text
) {
    const std::span<const ResultInfo> results = source.results();
    const bool all = text.empty() || text == "all";
    const std::vector<std::string_view> wanted = all ? std::vector<std::string_view>{} : split(text, ',');
    std::set<std::size_t> chosen;
    for (std::size_t i = 0; all && i < results.size(); ++i) {
        if (!results[i].on_request || !text.empty()) chosen.insert(i);
    }
    for (const std::string_view name : wanted) {
        bool known = false;
        for (std::size_t i = 0; i < results.size(); ++i) {
            if (!is_called(source, results[i], name)) continue;
            known = true;
            chosen.insert(i);
        }
        if (known) continue;
        std::vector<std::string_view> names;
        for (const ResultInfo& info : results) {
            if (std::ranges::find(names, info.name) == names.end()) names.emplace_back(info.name);
        }
        throw Error(
            Code::UnknownName,
            "--results",
            fmt::format(
                "there is no result \"{}\".{} The results are: {}",
                name,
                did_you_mean(name, names),
                names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))
            )
        );
    }
    std::erase_if(chosen, [&](std::size_t i) {
        return !std::ranges::binary_search(steps, static_cast<std::size_t>(results[i].step));
    });
    return {chosen.begin(), chosen.end()};
}

}  // namespace feelem
