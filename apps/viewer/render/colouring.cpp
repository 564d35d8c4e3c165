// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/colouring.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

void set_rgb(const Program& program, const char* uniform, const Rgb& colour) {
    const auto share = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; };
    glProgramUniform3f(
        program.get(), program.at(uniform), share(colour[0]), share(colour[1]), share(colour[2])
    );
}

}  // namespace

std::vector<std::uint8_t> palette_texels(const ColourEffect& effect) {
    const int count = effect.bands > 0 ? effect.bands : kSmoothPalette;
    std::vector<std::uint8_t> out;
    for (int i = 0; i < count; ++i) {
        const Rgb colour = palette_colour((i + 0.5) / count, effect);
        out.insert(out.end(), {colour[0], colour[1], colour[2], 255});
    }
    return out;
}

ShaderRange shader_range(const ValueRange& range) {
    const double magnitude = std::max(std::abs(range.lo), std::abs(range.hi));
    // A logarithm over a range that reaches zero is the symmetric one, as in present.
    const Scale scale = range.scale == Scale::Log && !(range.lo > 0) ? Scale::SymLog : range.scale;
    ShaderRange out;
    const bool is_signed = scale == Scale::Signed;
    out.lo = static_cast<float>(is_signed ? -magnitude : range.lo);
    out.hi = static_cast<float>(is_signed ? magnitude : range.hi);
    out.magnitude = static_cast<float>(magnitude > 0 ? magnitude : 1);
    out.scale = magnitude > 0 ? static_cast<int>(scale) : 0;
    return out;
}

void Palette::set(const ColourEffect& effect) {
    if (effect_ == effect) return;
    const std::vector<std::uint8_t> texels = palette_texels(effect);
    count_ = static_cast<int>(texels.size() / 4);
    texture_ = make_texture(GL_TEXTURE_2D);
    glTextureStorage2D(texture_.get(), 1, GL_RGBA8, count_, 1);
    glTextureSubImage2D(texture_.get(), 0, 0, 0, count_, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTextureParameteri(texture_.get(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.get(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    effect_ = effect;
}

void set_colours(const Program& program, const Look& look, bool is_coloured, const Palette& palette) {
    const ShaderRange range = shader_range(look.range);
    program.set("coloured", is_coloured ? 1 : 0);
    program.set("palette_size", static_cast<float>(palette.count()));
    program.set("lo", range.lo);
    program.set("hi", range.hi);
    program.set("magnitude", range.magnitude);
    program.set("scale_kind", range.scale);
    set_rgb(program, "above_colour", look.colour.above);
    set_rgb(program, "below_colour", look.colour.below);
    set_rgb(program, "missing_colour", look.colour.missing);
    glProgramUniform3f(program.get(), program.at("plain_colour"), 0.72F, 0.75F, 0.78F);
    program.set("shade_floor", std::clamp(look.shade_floor, 0.0F, 1.0F));
    program.set("isolines", look.isolines ? 1 : 0);
    program.set("has_limit", look.limit ? 1 : 0);
    program.set("limit", static_cast<float>(look.limit.value_or(0)));
}

}  // namespace feelem::viewer
