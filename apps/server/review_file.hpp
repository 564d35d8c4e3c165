// SPDX-License-Identifier: Apache-2.0
// Page and scene in one file that opens from disk, without server and network.
#pragma once

#include <string>

namespace feelem::server {

/// `scene_path`: a .glb with its side folder, if it has one. The file is written as a whole or not at all.
/// Throws Error(WriteFailed), and Error(BadOption) when this program was built without its page.
void write_review_file(const std::string& scene_path, const std::string& output);

}  // namespace feelem::server
