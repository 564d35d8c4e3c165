// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include "base/nearest_name.hpp"
#include "base/number.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace feelem::cli {
namespace {

std::string general_help() {
    std::string text = fmt::format(
        "Feelem {}: see, hear and feel finite-element results\n\nUsage: feelem COMMAND ... (feelem COMMAND "
        "--help says more)\n\n",
        version()
    );
    for (const Command& command : commands()) {
        text += fmt::format("  {:<9} {}\n", command.name, command.summary);
    }
    return text + "\nExit codes: 0 done, 1 the data cannot be used, 2 wrong usage.\n";
}

const Command& command_called(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Command& command : commands()) {
        if (command.name == name) return command;
        names.push_back(command.name);
    }
    throw UsageError(fmt::format(
        "there is no command \"{}\".{} The commands are: {}",
        name,
        did_you_mean(name, names),
        fmt::join(names, ", ")
    ));
}

/// Exactly `Count` finite numbers with commas between.
template <std::size_t Count>
std::array<double, Count> numbers(const std::string& option, const std::string& text) {
    std::array<double, Count> values{};
    std::string_view rest = text;
    for (std::size_t i = 0; i < Count; ++i) {
        const std::size_t comma = rest.find(',');
        const bool is_last = comma == std::string_view::npos;
        const auto value = parse_double(trim(rest.substr(0, comma)));
        if (!value || !std::isfinite(*value) || is_last != (i + 1 == Count)) {
            throw UsageError(fmt::format(
                "{} \"{}\": expected {} numbers with commas between, like {}",
                option,
                text,
                Count,
                Count == 3 ? "1.5,0,-2" : "0,0,100,0,0,-1"
            ));
        }
        values[i] = *value;
        rest.remove_prefix(is_last ? rest.size() : comma + 1);
    }
    return values;
}

/// Texts as they stand on the line, before they become options.
struct Texts {
    std::vector<std::string> units, averages;
    std::string point, ray, up = "z", bound;
    std::vector<const CLI::Option*> making;  ///< Those that say how a scene is made.
};

void add_reading_options(CLI::App& app, Job& job) {
    app.add_option("--surface-nodes", job.surface_nodes_file, "FILE: the second node list of the node map")
        ->option_text(" ");
    app.add_option(
           "--types", job.read.types, "LIST|FILE: element types, 1=SOLID92,2=SHELL63 or an ETLIST listing"
    )
        ->option_text(" ");
    app.add_option("--from", job.read.from, "FORMAT: force a reader")->option_text(" ");
    app.add_flag("--expand-cyclic", job.read.expand_cyclic, "Show all sectors of a cyclic Ansys model");
}

void add_model_options(CLI::App& app, Job& job, Texts& texts) {
    static const std::map<std::string, SkinMethod> skins{
        {"exact", SkinMethod::Exact}, {"node-list", SkinMethod::NodeList}, {"all", SkinMethod::All}};
    const auto one_of = [](const auto& words) { return CLI::CheckedTransformer(words).description(""); };
    app.add_option("--skin", job.skin.method, "exact | node-list | all: which facets are the skin (exact)")
        ->transform(one_of(skins))
        ->option_text(" ");
    app.add_option("--length-unit", job.length_unit, "m mm cm in ft um: unit of the coordinates")
        ->option_text(" ");
    app.add_option("--unit", texts.units, "NAME=UNIT: unit of a result, as stress=MPa; may be repeated")
        ->allow_extra_args(false)
        ->option_text(" ");
    app.add_option("--steps", job.steps, "last | all | LIST: as 2, 1.3 (step 1 substep 3), mode:2")
        ->option_text(" ");
    app.add_option("--up", texts.up, "x | y | z: the model's up axis (z)")->option_text(" ");
    app.add_option("--results", job.results, "all | LIST: which results, by name")->option_text(" ");
    app.add_option(
           "--average",
           texts.averages,
           "part | all | none, or several with commas: nodal averaging of element results (part)"
    )
        ->allow_extra_args(false)
        ->option_text(" ");
    app.add_option(
           "--result-system",
           job.result_systems,
           "cylindrical:OX,OY,OZ,AX,AY,AZ: radial, hoop and axial results too; may be repeated"
    )
        ->allow_extra_args(false)
        ->option_text(" ");
    app.add_option(
           "--envelope", job.envelopes, "max | min | absmax, or several with commas: extremes over the steps"
    )
        ->option_text(" ");
    app.add_option("--subdivide", job.skin.subdivide, "N: cut edges of quadratic facets into 2^N pieces (1)")
        ->check(CLI::Range(0, 5).description(""))
        ->option_text(" ");
    app.add_option("--present", job.presentation_file, "FILE: presentation")->option_text(" ");
}

void add_options(CLI::App& app, const Command& command, Options& options, Texts& texts) {
    const Takes takes = command.takes;
    if (has(takes, Takes::Inputs)) {
        app.add_option("INPUT", options.job.inputs, "Files or folders of one model, in any order")
            ->option_text("...");
    }
    if (has(takes, Takes::Output)) {
        app.add_option("-o,--output", options.job.output, "OUT: the suffix says the format")
            ->option_text(" ");
    }
    const std::size_t first_of_making = app.get_options().size();
    if (has(takes, Takes::Output) || has(takes, Takes::Serving)) {
        app.add_flag("--compress", options.job.compress, "A smaller scene, for Feelem's viewers alone");
        app.add_option(
               "--compress-bound",
               texts.bound,
               "P%: values may differ by this part of their result's range; smaller still"
        )
            ->option_text(" ");
    }
    if (has(takes, Takes::Output) || has(takes, Takes::Serving))
        app.add_flag_callback(
            "--no-input-digest",
            [&hash = options.job.read.hash_inputs] { hash = false; },
            "No SHA-256 of the inputs: faster for huge files, and the scene cannot prove them"
        );
    if (has(takes, Takes::Reading)) add_reading_options(app, options.job);
    if (has(takes, Takes::Model)) add_model_options(app, options.job, texts);
    if (has(takes, Takes::Levels))
        app.add_option(
               "--lod",
               options.job.levels,
               "auto | off | TRIANGLES | BOUND: levels of detail, as 200000 or 0.5% (auto: above 500,000 "
               "triangles)"
        )
            ->option_text(" ");
    const auto so_far = app.get_options();
    texts.making.assign(so_far.begin() + static_cast<std::ptrdiff_t>(first_of_making), so_far.end());
    if (has(takes, Takes::Brief))
        app.add_flag("--brief", options.job.brief, "Steps and names alone: reads no values, makes no skin");
    if (has(takes, Takes::Json)) app.add_flag("--json", options.json, "Machine-readable, stable");
    if (has(takes, Takes::Place)) {
        app.add_option("--node", options.node, "ID, a whole number: at a node")->option_text(" ");
        app.add_option("--point", texts.point, "X,Y,Z: at the place of the skin that is nearest")
            ->option_text(" ");
        app.add_option("--ray", texts.ray, "OX,OY,OZ,DX,DY,DZ: where a ray first meets the skin")
            ->option_text(" ");
    }
    if (has(takes, Takes::Serving)) {
        app.add_option("--port", options.port, "N (8322, or the next that is free)")
            ->check(CLI::Range(1, 65535).description(""))
            ->option_text(" ");
        app.add_flag(
            "--lan", options.lan, "Serve to headsets on the local network too: HTTPS, a secret link"
        );
        app.add_option(
               "--cert", options.certificate_file, "FILE: certificate in PEM form, instead of our own"
        )
            ->option_text(" ");
        app.add_option("--key", options.key_file, "FILE: its key")->option_text(" ");
        app.add_flag_callback(
            "--no-open", [&open = options.open_browser] { open = false; }, "Do not open a browser"
        );
    }
    app.add_option("--threads", options.threads, "N: threads at most; 0: all of them (0)")
        ->check(CLI::Range(0U, 65535U).description(""))
        ->option_text(" ");
    app.add_flag("--verbose", options.verbose, "A line a stage with seconds and peak memory");
}

std::vector<Averaging> averagings(const std::vector<std::string>& texts) {
    std::vector<Averaging> found;
    for (const std::string& text : texts) {
        std::string_view rest = text;
        while (true) {
            const std::size_t comma = rest.find(',');
            const std::string_view item = trim(rest.substr(0, comma));
            const bool known = item == "part" || item == "all" || item == "none";
            if (!known) throw UsageError(fmt::format("--average \"{}\": expected part, all or none", item));
            const Averaging averaging = item == "part"  ? Averaging::Part
                                        : item == "all" ? Averaging::All
                                                        : Averaging::None;
            if (std::ranges::find(found, averaging) == found.end()) found.push_back(averaging);
            if (comma == std::string_view::npos) break;
            rest.remove_prefix(comma + 1);
        }
    }
    return found;
}

/// "0.01%": the sign is asked for, since 0.01 alone could be either.
void read_bound(std::string_view text, Job& job) {
    const std::string_view number = trim(text.substr(0, text.ends_with('%') ? text.size() - 1 : 0));
    const std::optional<double> percent = parse_double(number);
    if (!percent || !(*percent > 0 && *percent <= 10))
        throw UsageError(fmt::format("--compress-bound \"{}\": expected 0.01% or the like, at most 10%", text)
        );
    job.compress = true;
    job.compress_bound = *percent / 100;
}

void finish_options(const CLI::App& app, const Command& command, Options& options, const Texts& texts) {
    for (const std::string& text : texts.units) {
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
            throw UsageError(fmt::format("--unit \"{}\": expected NAME=UNIT, like stress=MPa", text));
        }
        options.job.units[text.substr(0, equals)] = text.substr(equals + 1);
    }
    for (const CLI::Option* option : texts.making) {
        if (option->count() > 0) options.making.push_back(option->get_name());
    }
    if (!texts.averages.empty()) options.job.averages = averagings(texts.averages);
    if (texts.up != "x" && texts.up != "y" && texts.up != "z") {
        throw UsageError(fmt::format("--up \"{}\": expected x, y or z", texts.up));
    }
    options.job.up = texts.up.front();
    if (!texts.bound.empty()) read_bound(texts.bound, options.job);
    if (!texts.point.empty()) options.point = numbers<3>("--point", texts.point);
    if (!texts.ray.empty()) options.ray = numbers<6>("--ray", texts.ray);
    if (has(command.takes, Takes::Serving)) options.port_given = app.count("--port") > 0;
    if (options.certificate_file.empty() != options.key_file.empty()) {
        throw UsageError("--cert and --key belong together: one of them is missing");
    }
    if (!options.certificate_file.empty() && !options.lan) {
        throw UsageError("--cert and --key are for --lan: on this machine alone the page needs no certificate"
        );
    }
    if (has(command.takes, Takes::Inputs) && options.job.inputs.empty()) {
        throw UsageError(fmt::format("no input. Usage: feelem {} {}", command.name, command.usage));
    }
    if (has(command.takes, Takes::Output) && options.job.output.empty()) {
        throw UsageError(fmt::format("no output. Usage: feelem {} {}", command.name, command.usage));
    }
}

[[noreturn]] void refuse_extras(const CLI::App& app, const Command& command, const std::string& extra) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string name = extra.substr(0, extra.find('='));
    if (!name.starts_with("-")) {
        throw UsageError(fmt::format(
            "\"{}\" is one argument too many. Usage: feelem {} {}", extra, command.name, command.usage
        ));
    }
    throw UsageError(fmt::format(
        "{} has no option {}.{} feelem {} --help lists them",
        command.name,
        name,
        did_you_mean(name, views),
        command.name
    ));
}

/// CLI11's "--skin: Check x not in {...}" and its like, with what the option expects.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
    const std::string text = error.what();
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            // "--skin: Check failed", "--port requires a value", "Could not convert: --threads = -1"
            const bool is_meant = text.starts_with("--" + name + ":") ||
                                  text.starts_with("--" + name + " ") ||
                                  text.starts_with("Could not convert: --" + name + " ");
            if (!is_meant) continue;
            const auto given = option->results();
            return fmt::format(
                "--{}{} cannot be understood. It is --{} {}",
                name,
                given.empty() ? " without a value" : fmt::format(" \"{}\"", given.back()),
                name,
                option->get_description()
            );
        }
    }
    return text;
}

}  // namespace

ParsedLine parse_command_line(std::vector<std::string> arguments) {
    ParsedLine line;
    const std::string first = arguments.empty() ? "" : arguments.front();
    if (first.empty()) throw UsageError("no command.\n\n" + general_help());
    if (first == "--help" || first == "-h" || first == "help") {
        line.text = general_help();
        return line;
    }
    if (first == "--version") {
        line.text = fmt::format("feelem {}\n", version());
        return line;
    }
    line.command = &command_called(first);
    arguments.erase(arguments.begin());
    CLI::App app{std::string(line.command->summary), "feelem " + std::string(line.command->name)};
    app.allow_extras();
    Texts texts;
    add_options(app, *line.command, line.options, texts);
    std::ranges::reverse(arguments);  // CLI11 takes them from the back.
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        line.text = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw UsageError(explain(app, error));
    }
    if (const auto extras = app.remaining(); !extras.empty())
        refuse_extras(app, *line.command, extras.front());
    finish_options(app, *line.command, line.options, texts);
    return line;
}

}  // namespace feelem::cli
