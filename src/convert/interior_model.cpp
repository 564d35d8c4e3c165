// SPDX-License-Identifier: Apache-2.0
#include "convert/interior_json.hpp"
#include "convert/prepared_source.hpp"
#include "convert/scene_plan.hpp"
#include "convert/selection.hpp"

#include "feelem/error.hpp"
#include "feelem/interior.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <mutex>
#include <system_error>
#include <utility>

namespace feelem {

/// A file as it was: a mapped file that is written anew would end the program when it is read.
struct FileStamp {
    std::filesystem::path path;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;

    static FileStamp of(const std::filesystem::path& path) {
        std::error_code error;
        FileStamp stamp{path, std::filesystem::file_size(path, error), {}};
        stamp.time = std::filesystem::last_write_time(path, error);
        return stamp;
    }
    bool operator==(const FileStamp&) const = default;
};

/// Solids as they are or moved, and the way to an element; made when it is first needed.
struct ShownShape {
    std::string name;
    Solids solids;
    std::unique_ptr<InteriorFinder> finder;
};

struct KeptResult {
    std::string name;
    std::shared_ptr<const Result> result;
};

namespace {

constexpr std::size_t kMostShapes = 2;
constexpr std::size_t kAllComponents = static_cast<std::size_t>(-1);

std::vector<FileStamp> stamps_of(const Job& job) {
    std::vector<FileStamp> stamps;
    for (const std::string& input : job.inputs) {
        std::error_code error;
        if (!std::filesystem::is_directory(input, error)) {
            stamps.push_back(FileStamp::of(input));
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(input, error)) {
            if (entry.is_regular_file(error)) stamps.push_back(FileStamp::of(entry.path()));
        }
    }
    return stamps;
}

std::size_t bytes_of(const Result& result) {
    return result.values.size() * sizeof(float) + result.row_owner.size() * sizeof(std::uint32_t) +
           result.row_node.size() * sizeof(NodeIndex);
}

}  // namespace

struct InteriorModel::State {
    State(Job from, const InteriorOptions& with)
        : job(std::move(from)), options(with), stamps(stamps_of(job)) {}

    Job job;
    InteriorOptions options;
    std::vector<FileStamp> stamps;
    std::mutex mutex;  ///< Of all that follows; questions are answered without it.
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> source;
    std::unique_ptr<PreparedSource> shown;
    ScenePlan plan;
    std::shared_ptr<ShownShape> still;
    std::list<std::shared_ptr<ShownShape>> moved;  ///< The latest first.
    std::list<KeptResult> kept;                    ///< The latest first.

    void open();
    void check_inputs() const;
    void need_solids() const;
    const PlannedResult& planned(const std::string& id) const;
    std::shared_ptr<const Result> load(const std::string& id, std::size_t component, std::size_t step);
    std::shared_ptr<const Result> keep(const std::string& name, Result result);
    /// One component of one result, as a result of its own.
    std::shared_ptr<const Result> field(const InteriorField& field);
    std::shared_ptr<ShownShape> shape(const std::optional<InteriorShape>& wanted);
    const InteriorFinder& finder(ShownShape& shape);
    const Mesh& mesh() const { return source->mesh(); }
};

void InteriorModel::State::check_inputs() const {
    for (const FileStamp& stamp : stamps) {
        if (FileStamp::of(stamp.path) == stamp) continue;
        throw Error(
            Code::SourcesDisagree,
            stamp.path.filename().string(),
            "the file is no longer the one that the scene was made of: start again to ask it"
        );
    }
}

void InteriorModel::State::open() {
    check_inputs();
    if (shown) return need_solids();
    auto opened = open_job(job, diagnostics, {});
    const auto steps = select_steps(opened->steps(), job.steps, DefaultSteps::UpToTwenty, diagnostics);
    auto prepared = std::make_unique<PreparedSource>(
        *opened, select_results(*opened, steps, job.results), preparing_of(job)
    );
    plan = plan_scene(*prepared, prepared->used_steps(), prepared->all_results());
    still = std::make_shared<ShownShape>();
    still->solids = find_solids(opened->mesh());
    source = std::move(opened);
    shown = std::move(prepared);
    need_solids();
}

void InteriorModel::State::need_solids() const {
    if (still->solids.count == 0)
        throw Error(Code::BadOption, "", "the model has no solids: shells and lines have no inside");
}

const PlannedResult& InteriorModel::State::planned(const std::string& id) const {
    const auto found = std::ranges::find(plan.results, id, [](const PlannedResult& r) { return r.scene.id; });
    if (found != plan.results.end()) return *found;
    throw Error(Code::UnknownName, "", "the scene has no such result");
}

std::shared_ptr<const Result> InteriorModel::State::load(
    const std::string& id, std::size_t component, std::size_t step
) {
    const std::string name = fmt::format("{}/{}/{}", id, component, step);
    const auto known = std::ranges::find(kept, name, &KeptResult::name);
    if (known != kept.end()) {
        kept.splice(kept.begin(), kept, known);
        return kept.front().result;
    }
    const PlannedResult& result = planned(id);
    if (component != kAllComponents && component >= result.components.size())
        throw Error(
            Code::UnknownName, "", fmt::format("the result has {} components", result.components.size())
        );
    const auto values = std::ranges::find(result.values, step - 1, &PlannedValues::step);
    if (step == 0 || values == result.values.end())
        throw Error(Code::UnknownName, "", "the result has no values at such a step");
    Result whole = shown->load(values->source_result);
    if (component == kAllComponents) return keep(name, std::move(whole));
    return keep(name, component_of(whole, result.components[component]));
}

std::shared_ptr<const Result> InteriorModel::State::keep(const std::string& name, Result result) {
    kept.push_front({name, std::make_shared<const Result>(std::move(result))});
    std::size_t bytes = 0;
    auto last = kept.begin();
    for (auto i = kept.begin(); i != kept.end(); ++i) {
        bytes += bytes_of(*i->result);
        if (i != kept.begin() && bytes > options.kept_bytes) break;
        last = i;
    }
    kept.erase(std::next(last), kept.end());
    return kept.front().result;
}

std::shared_ptr<const Result> InteriorModel::State::field(const InteriorField& field) {
    return load(field.result, field.component, field.step);
}

std::shared_ptr<ShownShape> InteriorModel::State::shape(const std::optional<InteriorShape>& wanted) {
    if (!wanted || wanted->factor == 0) return still;
    const std::string name = fmt::format("{}/{}/{}", wanted->result, wanted->step, wanted->factor);
    const auto known = std::ranges::find(moved, name, [](const auto& shape) { return shape->name; });
    if (known != moved.end()) {
        moved.splice(moved.begin(), moved, known);
        return moved.front();
    }
    const auto displacement = load(wanted->result, kAllComponents, wanted->step);
    moved.push_front(std::make_shared<ShownShape>());
    moved.front()->name = name;
    moved.front()->solids = moved_by(still->solids, *displacement, wanted->factor);
    if (moved.size() > kMostShapes) moved.pop_back();
    return moved.front();
}

const InteriorFinder& InteriorModel::State::finder(ShownShape& shape) {
    if (!shape.finder) shape.finder = std::make_unique<InteriorFinder>(shape.solids);
    return *shape.finder;
}

InteriorModel::InteriorModel(Job job, const InteriorOptions& options)
    : state_(std::make_unique<State>(std::move(job), options)) {}

InteriorModel::~InteriorModel() = default;

std::optional<Section> InteriorModel::section(const PlaneQuestion& question, const SectionLimits& limits) {
    std::unique_lock lock(state_->mutex);
    state_->open();
    const auto field = state_->field(question.field);
    const auto shape = state_->shape(question.shape);
    lock.unlock();
    return cut_plane(shape->solids, {field.get(), 0}, question.plane, limits);
}

std::optional<Section> InteriorModel::surface(const LevelQuestion& question, const SectionLimits& limits) {
    std::unique_lock lock(state_->mutex);
    state_->open();
    const auto field = state_->field(question.field);
    const auto colour = question.colour ? state_->field(*question.colour) : nullptr;
    const auto shape = state_->shape(question.shape);
    lock.unlock();
    std::optional<FieldOf> colours;
    if (colour) colours = FieldOf{colour.get(), 0};
    return isosurface(shape->solids, {field.get(), 0}, question.level, colours, limits);
}

std::optional<std::string> InteriorModel::place(const PlaceQuestion& question, const SectionLimits& limits) {
    std::unique_lock lock(state_->mutex);
    state_->open();
    const auto shape = state_->shape(question.shape);
    const InteriorFinder& finder = state_->finder(*shape);
    const auto found = finder.find(question.place);
    std::vector<InteriorReading> readings;
    for (const InteriorField& field : question.fields) {
        if (limits.is_cancelled && limits.is_cancelled()) return std::nullopt;
        const auto result = state_->field(field);
        const PlannedResult& planned = state_->planned(field.result);
        InteriorReading& reading = readings.emplace_back();
        reading.result = field.result;
        reading.component = planned.components[field.component];
        reading.unit = planned.scene.unit;
        reading.is_elemental = result->info.location == Location::Elemental;
        if (found) reading.value = value_at(state_->mesh(), {result.get(), 0}, *found);
    }
    return interior_json(state_->mesh(), question.place, found, readings);
}

std::vector<SectionOwner> InteriorModel::owners(const Section& section) {
    std::vector<SectionOwner> owners;
    owners.reserve(section.triangle_element.size());
    for (const ElementIndex index : section.triangle_element) {
        const ElementRef element = element_at(state_->mesh(), index);
        owners.push_back({raw(element.id()), raw(element.part())});
    }
    return owners;
}

}  // namespace feelem
