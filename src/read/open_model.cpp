// SPDX-License-Identifier: Apache-2.0
// Files and folders in, one model out: each file goes to the reader that is surest of its content.
#include "base/nearest_name.hpp"
#include "base/parallel.hpp"
#include "base/text_encoding.hpp"
#include "read/merged_model.hpp"
#include "read/read_format.hpp"
#include "read/strangers.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>

namespace feelem {
namespace {

namespace fs = std::filesystem;

/// A file of the model.
struct NamedInput {
    Input input;
    bool was_named = false;  ///< By the user; else it was found in a folder, and may be of no use.
};

/// Files as given; of a folder its files, one level, by name, without hidden ones.
std::vector<NamedInput> files_of(std::span<const std::string> paths) {
    std::vector<NamedInput> files;
    for (const std::string& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back({Input::from_file(path), true});
            continue;
        }
        std::vector<std::string> inside;
        for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
            std::error_code unreadable;
            const bool hidden = entry->path().filename().string().starts_with('.');
            if (!hidden && entry->is_regular_file(unreadable)) inside.push_back(entry->path().string());
        }
        if (error) throw Error(Code::FileUnreadable, path, "cannot read the folder: " + error.message());
        std::ranges::sort(inside);
        for (const std::string& file : inside) files.push_back({Input::from_file(file), false});
    }
    return files;
}

std::string known_formats() {
    std::string text;
    for (const ReadFormat& format : read_format_list()) {
        text += (text.empty() ? "" : ", ") + std::string(format.info.id);
    }
    return text;
}

const ReadFormat* surest_format(const Input& input) {
    const ReadFormat* best = nullptr;
    Likelihood likelihood = Likelihood::No;
    for (const ReadFormat& format : read_format_list()) {
        const Likelihood found = format.recognise(input);
        if (found > likelihood) {
            best = &format;
            likelihood = found;
        }
    }
    return best;
}

const ReadFormat* forced_format(const std::string& id) {
    for (const ReadFormat& format : read_format_list()) {
        if (format.info.id == id) return &format;
    }
    std::vector<std::string_view> ids;
    for (const ReadFormat& format : read_format_list()) ids.push_back(format.info.id);
    throw Error(
        Code::UnknownName,
        "",
        fmt::format(
            "there is no reader called \"{}\".{} The readers are: {}.",
            id,
            did_you_mean(id, ids),
            known_formats()
        )
    );
}

/// Inputs that have a reader, as readers see them and as they were given.
struct Sorted {
    std::vector<Input> texts;
    std::vector<const ReadFormat*> formats;
    std::vector<UsedInput> used;
    std::vector<bool> was_named;
    std::vector<Input> unknown;
};

/// One note for all of them.
void tell_left_out(std::span<const Input> unknown, Diagnostics& diagnostics) {
    constexpr std::size_t kMostStrangersNamed = 8;
    if (unknown.empty()) return;
    std::vector<std::string> names;
    for (const Input& input : unknown.first(std::min(unknown.size(), kMostStrangersNamed))) {
        names.push_back(fs::path(input.name()).filename().string());
    }
    diagnostics.add(
        Code::UnknownBlock,
        unknown.front().name(),
        fmt::format(
            "left out, no reader recognises {}: {}{}",
            unknown.size() == 1 ? "it" : "them",
            fmt::join(names, ", "),
            unknown.size() > names.size() ? " ..." : ""
        ),
        unknown.size()
    );
}

Sorted sort_by_format(std::span<const NamedInput> inputs, const ReadOptions& options) {
    const ReadFormat* forced = options.from.empty() ? nullptr : forced_format(options.from);
    Sorted sorted;
    for (const auto& [input, was_named] : inputs) {
        Input text = without_encoding(input);
        const ReadFormat* format = forced != nullptr ? forced : surest_format(text);
        if (format == nullptr) {
            sorted.unknown.push_back(input);
            continue;
        }
        sorted.texts.push_back(std::move(text));
        sorted.formats.push_back(format);
        sorted.used.push_back({input, std::string(format->info.id)});
        sorted.was_named.push_back(was_named);
    }
    if (sorted.texts.empty()) {
        for (const Input& input : sorted.unknown) {
            const std::string_view advice = advice_for(without_encoding(input));
            if (!advice.empty()) throw Error(Code::UnsupportedFormat, input.name(), std::string(advice));
        }
        throw Error(
            Code::UnknownFormat,
            sorted.unknown.empty() ? "" : sorted.unknown.front().name(),
            inputs.empty()
                ? "there are no files to read: folders are searched for files, not for further folders"
                : fmt::format(
                      "no reader recognises the content of {}. Readers: {}; --from forces one.",
                      inputs.size() == 1 ? "this file" : "any of the files",
                      known_formats()
                  )
        );
    }
    return sorted;
}

/// Opens inputs, those that bring a mesh first. Files that cannot be read by themselves wait until all others
/// are open: then a deck may have included them, or brought the mesh that they lack.
class Opener {
public:
    Opener(const Sorted& sorted, const ReadOptions& options, IncludeFiles& includes, Diagnostics& diagnostics)
        : sorted_(sorted), includes_(includes),
          diagnostics_(diagnostics), context_{options, nullptr, &includes} {}

    void open_all() {
        for (const ReadFormat& format : read_format_list()) {
            std::vector<std::uint32_t> which;
            for (std::uint32_t i = 0; i < sorted_.formats.size(); ++i) {
                if (sorted_.formats[i] == &format) which.push_back(i);
            }
            if (which.empty()) continue;
            if (format.many_inputs) {
                try_to_open(format, std::move(which));
            } else {
                for (const std::uint32_t i : which) try_to_open(format, {i});
            }
        }
        settle();
    }

    std::vector<OpenedSource> take() {
        std::vector<OpenedSource> kept;
        for (OpenedSource& opened : sources_) {
            if (!was_included(opened.inputs)) kept.push_back(std::move(opened));
            // Sources without a mesh of their own may look at that of an included file.
            else
                kept_alive_.push_back(std::move(opened.source));
        }
        return kept;
    }
    std::vector<std::unique_ptr<ModelSource>> take_included() { return std::move(kept_alive_); }

private:
    struct Failed {
        const ReadFormat* format;
        std::vector<std::uint32_t> which;
        bool had_mesh;
        Error error;
    };

    bool was_included(const std::vector<std::uint32_t>& which) const {
        return std::ranges::all_of(which, [&](std::uint32_t i) {
            return includes_.taken().contains(sorted_.used[i].input.name());
        });
    }

    void open(const ReadFormat& format, std::vector<std::uint32_t> which) {
        std::vector<Input> group;
        for (const std::uint32_t i : which) group.push_back(sorted_.texts[i]);
        sources_.push_back({format.open(group, context_, diagnostics_), std::move(which)});
        context_.mesh = mesh_for_next(sources_);
    }

    void try_to_open(const ReadFormat& format, std::vector<std::uint32_t> which) {
        try {
            open(format, which);
        } catch (const Error& error) {
            failed_.push_back({&format, std::move(which), context_.mesh != nullptr, error});
        }
    }

    void settle() {
        std::vector<Failed> failed = std::move(failed_);
        failed_.clear();
        for (Failed& one : failed) {
            if (was_included(one.which)) continue;
            if (!one.had_mesh && context_.mesh != nullptr) {
                const std::size_t before = failed_.size();
                try_to_open(*one.format, one.which);
                if (failed_.size() == before) continue;
                failed_.pop_back();
            }
            const bool was_named =
                std::ranges::any_of(one.which, [&](std::uint32_t i) { return sorted_.was_named[i]; });
            if (was_named || sources_.empty()) throw one.error;
            diagnostics_.add(
                Code::InputLeftOut,
                sorted_.used[one.which.front()].input.name(),
                fmt::format("left out, it cannot be read: {}", one.error.what())
            );
        }
    }

    const Sorted& sorted_;
    IncludeFiles& includes_;
    Diagnostics& diagnostics_;
    ReadContext context_;
    std::vector<OpenedSource> sources_;
    std::vector<std::unique_ptr<ModelSource>> kept_alive_;
    std::vector<Failed> failed_;
};

/// Under way when another core can make them.
std::unique_ptr<EarlyDigests> digests_of(std::span<const UsedInput> used, const ReadOptions& options) {
    if (!options.hash_inputs || !options.hash_early || thread_count() < 2) return nullptr;
    std::vector<Input> inputs;
    for (const UsedInput& one : used) inputs.push_back(one.input);
    return std::make_unique<EarlyDigests>(std::move(inputs));
}

std::unique_ptr<ModelSource> open_inputs(
    std::span<const NamedInput> inputs, const ReadOptions& options, Diagnostics& diagnostics
) {
    Sorted sorted = sort_by_format(inputs, options);
    std::unique_ptr<EarlyDigests> early = digests_of(sorted.used, options);
    std::vector<Input> given;
    for (const NamedInput& one : inputs) given.push_back(one.input);
    IncludeFiles includes(given);
    Opener opener(sorted, options, includes, diagnostics);
    opener.open_all();
    std::vector<OpenedSource> sources = opener.take();
    for (const Input& input : includes.opened()) sorted.used.push_back({input, "included"});
    std::vector<Input> left_out;
    for (const Input& input : sorted.unknown) {
        if (includes.taken().contains(input.name()))
            sorted.used.push_back({input, "included"});
        else
            left_out.push_back(input);
    }
    tell_left_out(left_out, diagnostics);
    return merge_sources(
        std::move(sources),
        opener.take_included(),
        std::move(sorted.used),
        diagnostics,
        options.hash_inputs,
        std::move(early)
    );
}

}  // namespace

std::unique_ptr<ModelSource> open_model(
    std::span<const std::string> paths, const ReadOptions& options, Diagnostics& diagnostics
) {
    return open_inputs(files_of(paths), options, diagnostics);
}

std::unique_ptr<ModelSource> open_model(
    std::vector<NamedBytes> files, const ReadOptions& options, Diagnostics& diagnostics
) {
    std::vector<NamedInput> inputs;
    for (NamedBytes& file : files) {
        inputs.push_back({Input::from_memory(std::move(file.name), std::move(file.bytes)), true});
    }
    return open_inputs(inputs, options, diagnostics);
}

}  // namespace feelem
