// SPDX-License-Identifier: Apache-2.0
// Where tests find and put files.
#pragma once

#include <optional>
#include <string>

namespace feelem::test {

/// A file of the project, from its top folder.
std::string project_file(const std::string& path);
/// A file of the team's corpus beside the project, or nothing where there is none: then the test says it was
/// skipped and the shipped files must be enough.
std::optional<std::string> corpus_file(const std::string& path);
/// A fresh, empty folder for this test under the build folder.
std::string scratch_folder(const std::string& name);
std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);

}  // namespace feelem::test
