// SPDX-License-Identifier: Apache-2.0
// What is asked, read strictly: every key known and there once, every number finite.
#pragma once

#include "feelem/interior.hpp"

#include <httplib.h>

#include <string>

namespace feelem::server {

/// All throw Error(BadOption) with a reason for who asks.
PlaneQuestion plane_question(const httplib::Params& params);
LevelQuestion level_question(const httplib::Params& params);
PlaceQuestion place_question(const httplib::Params& params);
/// Whose earlier question this one replaces; empty: nobody's.
std::string client_of(const httplib::Params& params);

}  // namespace feelem::server
