// SPDX-License-Identifier: Apache-2.0
// Comments of a deck that say what its commands do not: units, bodies, the release.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace feelem::ansys::cdb {

/// "NMM" of "--- Data in consistent NMM units. See Solving Units in the help system".
std::optional<std::string_view> unit_system_in(std::string_view remark);

/// "Solid" of "*********** Elements for Body 1 "Solid" ***********".
std::optional<std::string_view> body_in(std::string_view remark);

/// "2019 R2" of "ANSYS RELEASE 2019 R2           BUILD 19.4      UP20190416" (the build where no release is)
/// and "2021 R2" of "ANSYS input file written by Workbench version 2021 R2".
std::optional<std::string> release_in(std::string_view remark);

}  // namespace feelem::ansys::cdb
