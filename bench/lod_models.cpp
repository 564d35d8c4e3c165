// SPDX-License-Identifier: Apache-2.0
// The skin of a solver's model, cut finely, with its von Mises stress.
#include "lod_models.hpp"

#include "feelem/derive.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"

namespace feelem::bench {

LodModel refined_model(const std::string& path) {
    Diagnostics diagnostics;
    const std::string paths[]{path};
    const auto source = open_model(paths, {}, diagnostics);
    SkinOptions options;
    options.subdivide = 4;
    const Surface surface = make_skin(source->mesh(), options, diagnostics);
    LodModel model;
    model.name = path;
    const LodSurface drawn = lod_surface(surface);
    model.positions.assign(surface.positions.begin(), surface.positions.end());
    model.triangles.assign(surface.triangles.begin(), surface.triangles.end());
    model.places = drawn.places;
    model.parts = drawn.parts;
    for (std::size_t i = 0; i < source->results().size(); ++i) {
        if (source->results()[i].name != "stress") continue;
        const Result stress = source->load(i);
        model.fields.assign(1, carry(source->mesh(), surface, component_of(stress, "von_mises")).values);
    }
    return model;
}

}  // namespace feelem::bench
