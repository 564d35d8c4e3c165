// SPDX-License-Identifier: Apache-2.0
// write_scene: the order in which a scene is put together.
#include "scene/gltf_json.hpp"
#include "scene/scene_build.hpp"
#include "scene/scene_colour.hpp"
#include "scene/scene_deformation.hpp"
#include "scene/scene_extras.hpp"
#include "scene/scene_fields.hpp"
#include "scene/scene_geometry.hpp"
#include "scene/scene_levels.hpp"
#include "scene/scene_materials.hpp"
#include "scene/scene_store.hpp"

#include "feelem/error.hpp"

#include <set>

namespace feelem {
namespace {

void check_contents(const SceneContents& contents) {
    if (contents.mesh == nullptr || contents.surface == nullptr)
        throw Error(Code::BadStructure, "", "a scene needs a mesh and its skin");
    std::set<std::string> ids;
    for (const SceneResult& result : contents.results) {
        if (!ids.insert(result.id).second)
            throw Error(Code::BadStructure, "", "two results of the scene have the id " + result.id);
        for (const SceneValues& values : result.values) {
            if (values.step >= contents.steps.size())
                throw Error(
                    Code::BadStructure, "", "result " + result.id + " names a step that is not there"
                );
        }
    }
}

std::string build_scene(SceneBuild& build, SceneFiles& files, Diagnostics& diagnostics) {
    build.document.buffers.push_back({main_uri(files), 0});
    build.arrays.direct_to(0, *files.main);
    if (build.options.compress) build.arrays.pack();
    plan_parts(build, diagnostics);
    build.attribute_names = name_attributes(build.contents.results);
    choose_coloured(build);
    choose_deformation(build);
    write_geometry(build);
    write_level_triangles(build);
    write_fields(build, files);
    write_tree(build, write_materials(build));
    write_animation(build);
    build.document.buffers[0].bytes = files.main->size();
    build.digests = build.arrays.digests();
    return gltf::to_json(build.document, extras_text(build));
}

}  // namespace

void write_scene(
    const SceneContents& contents,
    const std::string& path,
    const SceneOptions& options,
    Diagnostics& diagnostics
) {
    check_contents(contents);
    SceneFiles files = open_files(path);
    try {
        SceneBuild build{contents, options};
        store(files, build_scene(build, files, diagnostics));
    } catch (...) {
        discard(files);
        throw;
    }
}

}  // namespace feelem
