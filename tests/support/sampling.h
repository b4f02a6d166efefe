// What a snippet of pass 2 shows in given directions.
#pragma once

#include "support/gl_image.h"

#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <functional>
#include <string>
#include <vector>

namespace tests {

enum class PastSeams { shown, hostile };

// A map's layers for ImageMap, a colour in each texel's direction. Texels whose direction belongs elsewhere hold 1000
// if hostile.
std::vector<float> layersOf(mirrorball::MapKind map, int n,
                            const std::function<glm::vec3(const glm::dvec3&)>& colour,
                            PastSeams pastSeams = PastSeams::hostile);

// Evaluates an expression for directions, each a pixel of a picture.
class SamplingProgram
{
public:
    // `result` is a vec4 made of the vec4 `direction`; `declarations` stand before main.
    SamplingProgram(const mirrorball::ReflectionMaterial& material, const std::string& result,
                    const std::string& declarations = "");
    ~SamplingProgram();
    SamplingProgram(const SamplingProgram&) = delete;
    SamplingProgram& operator=(const SamplingProgram&) = delete;

    // For uniforms of the declarations.
    GLuint name() const { return program_; }

    // One colour a direction, in rows of `width`. A shift by a pixel to the right or up changes which pixels share
    // derivatives.
    std::vector<glm::vec4> draw(const mirrorball::ReflectionMap& map,
                                const std::vector<glm::vec4>& directions, int width,
                                const glm::ivec2& shift = glm::ivec2(0),
                                const mirrorball::MaterialSettings& settings = {}) const;

private:
    GLuint program_;
    mirrorball::ProbeBinding binding_;
};

} // namespace tests
