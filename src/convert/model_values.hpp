// SPDX-License-Identifier: Apache-2.0
// A model's results as Feelem shows them: in the global system, averaged as asked, with ranges over the whole
// model.
#pragma once

#include "feelem/convert.hpp"
#include "feelem/derive.hpp"
#include "feelem/model.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// What a result becomes by averaging, without its values.
ResultInfo prepared_info(const ResultInfo& info, Averaging averaging);

/// Values of a result in the global system, averaged: the costly part.
Result load_prepared(ModelSource& source, std::size_t index, Averaging averaging);

/// Stored components first, then those that can be derived.
std::vector<std::string> all_components(const ResultInfo& info);

/// Derived components of a result, given away as they are asked for. What is made of the tensor's eigenvalues
/// is made at once, when the first of it is asked for: they are the costly part.
class DerivedComponents {
public:
    /// `result` must outlive it.
    DerivedComponents(const Result& result, std::vector<std::string_view> wanted);
    Result take(std::string_view component);

private:
    const Result& result_;
    std::vector<std::string_view> together_;  ///< Of the wanted ones, those that are made at once.
    std::vector<Result> made_;
};

/// Over all rows; NaN does not count.
ComponentRange range_over_model(const Mesh& mesh, const Result& result, std::size_t component);

/// One for each of all_components().
std::vector<ComponentRange> ranges_over_model(const Mesh& mesh, const Result& result);

}  // namespace feelem
