#include "capture/layer_check.h"

#include "capture/map_textures.h"
#include "capture_shaders.h"
#include "gl/program.h"

#include <epoxy/gl.h>

#include <string>

namespace mirrorball::capture {

bool drawsIntoLayers()
{
    const std::string version = "#version 330 core\n", name = "the check of layers";
    const gl::Program program = gl::linkProgram(
        {{GL_VERTEX_SHADER, version + std::string(shaders::copyVertex), "the vertex shader of " + name},
         {GL_GEOMETRY_SHADER, version + std::string(shaders::layerCheckGeometry),
          "the geometry shader of " + name},
         {GL_FRAGMENT_SHADER, version + std::string(shaders::layerCheckFragment),
          "the fragment shader of " + name}},
        name);
    const gl::VertexArray noAttributes = gl::VertexArray::create();
    const MapSize size{4, 2, 2}; // two blocks, two layers
    const gl::Texture depth = makeDepth(size);
    const MapTextures textures = makeMapTextures(size, ColourFormat::rgba8, &depth);

    const float black[4] = {}, farthest = 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, textures.allLayers.name());
    glViewport(0, 0, size.width, size.height);
    glClearBufferfv(GL_COLOR, 0, black);
    glClearBufferfv(GL_COLOR, 1, black);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glUseProgram(program.name());
    glBindVertexArray(noAttributes.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    unsigned char kept[4] = {};
    glBindFramebuffer(GL_FRAMEBUFFER, textures.layers[1].name());
    glReadPixels(size.width - 1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kept);
    return kept[0] == 255;
}

} // namespace mirrorball::capture
