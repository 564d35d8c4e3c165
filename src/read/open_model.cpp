// SPDX-License-Identifier: Apache-2.0
// Files and folders in, one model out: each file goes to the reader that is surest of its content.
#include "base/nearest_name.hpp"
#include "base/text_encoding.hpp"
#include "read/merged_model.hpp"
#include "read/read_format.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>

namespace feelem {
namespace {

namespace fs = std::filesystem;

/// Files as given; of a folder its files, one level, by name, without hidden ones.
std::vector<std::string> files_of(std::span<const std::string> paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back(path);
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
        files.insert(files.end(), std::move_iterator(inside.begin()), std::move_iterator(inside.end()));
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
};

Sorted sort_by_format(std::span<const Input> inputs, const ReadOptions& options, Diagnostics& diagnostics) {
    const ReadFormat* forced = options.from.empty() ? nullptr : forced_format(options.from);
    Sorted sorted;
    std::string unknown;
    for (const Input& input : inputs) {
        Input text = without_encoding(input);
        const ReadFormat* format = forced != nullptr ? forced : surest_format(text);
        if (format == nullptr) {
            if (unknown.empty()) unknown = input.name();
            // Named in the text too: entries of one text are counted together.
            diagnostics.add(
                Code::UnknownBlock,
                input.name(),
                fmt::format(
                    "{} is left out: no reader recognises it", fs::path(input.name()).filename().string()
                )
            );
            continue;
        }
        sorted.texts.push_back(std::move(text));
        sorted.formats.push_back(format);
        sorted.used.push_back({input, std::string(format->info.id)});
    }
    if (sorted.texts.empty()) {
        throw Error(
            Code::UnknownFormat,
            unknown,
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

std::unique_ptr<ModelSource> open_inputs(
    std::span<const Input> inputs, const ReadOptions& options, Diagnostics& diagnostics
) {
    Sorted sorted = sort_by_format(inputs, options, diagnostics);
    std::vector<OpenedSource> sources;
    IncludeFiles includes(inputs);
    ReadContext context{options, nullptr, &includes};
    const auto open = [&](const ReadFormat& format, std::vector<std::uint32_t> which) {
        std::vector<Input> group;
        for (const std::uint32_t i : which) group.push_back(sorted.texts[i]);
        sources.push_back({format.open(group, context, diagnostics), std::move(which)});
        context.mesh = &sources.front().source->mesh();
    };
    for (const ReadFormat& format : read_format_list()) {
        std::vector<std::uint32_t> which;
        for (std::uint32_t i = 0; i < sorted.formats.size(); ++i) {
            if (sorted.formats[i] == &format) which.push_back(i);
        }
        if (which.empty()) continue;
        if (format.many_inputs) {
            open(format, std::move(which));
        } else {
            for (const std::uint32_t i : which) open(format, {i});
        }
    }
    for (const Input& input : includes.opened()) sorted.used.push_back({input, "included"});
    return merge_sources(std::move(sources), std::move(sorted.used));
}

}  // namespace

std::unique_ptr<ModelSource> open_model(
    std::span<const std::string> paths, const ReadOptions& options, Diagnostics& diagnostics
) {
    std::vector<Input> inputs;
    for (const std::string& file : files_of(paths)) inputs.push_back(Input::from_file(file));
    return open_inputs(inputs, options, diagnostics);
}

std::unique_ptr<ModelSource> open_model(
    std::vector<NamedBytes> files, const ReadOptions& options, Diagnostics& diagnostics
) {
    std::vector<Input> inputs;
    for (NamedBytes& file : files) {
        inputs.push_back(Input::from_memory(std::move(file.name), std::move(file.bytes)));
    }
    return open_inputs(inputs, options, diagnostics);
}

}  // namespace feelem
