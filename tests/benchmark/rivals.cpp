#include "rivals.h"

#include "rival_programs.h"

#include <epoxy/gl.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace tests::benchmark {

namespace {

using mirrorball::gl::Framebuffer;
using mirrorball::gl::Texture;

constexpr int faceCount = 6;

constexpr RivalInfo infos[] = {{Rival::plain, "six passes"},
                               {Rival::culled, "six passes, culled"},
                               {Rival::layeredGeometry, "layered, geometry shader"},
                               {Rival::layeredInstanced, "layered, instanced"}};

// OpenGL's cube-map table: what a face's s and t run along, and where it looks.
struct Face
{
    glm::vec3 right, up, forward;
};
constexpr std::array<Face, faceCount> cubeFaces = {{{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
                                                    {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                                    {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                                    {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                                    {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}};

bool hasClipControl()
{
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

// 90 degrees wide; depth is 1 at near and 0 at far, which keeps floats precise everywhere.
glm::mat4 clipFromWorld(const Face& face, float near, float far)
{
    float scale = -near / (far - near);
    float offset = near * far / (far - near);
    if (!hasClipControl()) { // depth from -1 to 1
        scale = 2.0f * scale - 1.0f;
        offset *= 2.0f;
    }
    const glm::vec3 depth = scale * face.forward;
    return glm::transpose(glm::mat4(glm::vec4(face.right, 0.0f), glm::vec4(face.up, 0.0f),
                                    glm::vec4(depth, offset), glm::vec4(face.forward, 0.0f)));
}

// Whether a sphere is not wholly outside one of the four side planes of the face's frustum.
bool touches(const Face& face, const mirrorball::Sphere& sphere)
{
    const float ahead = glm::dot(face.forward, sphere.centre);
    const float limit = -std::numbers::sqrt2_v<float> * sphere.radius; // the planes' normals have length √2
    for (const glm::vec3& side : {face.right, face.up}) {
        const float across = glm::dot(side, sphere.centre);
        if (ahead + across < limit || ahead - across < limit)
            return false;
    }
    return true;
}

Texture makeCube(int n, GLenum internalFormat, GLenum format, GLint filter = GL_LINEAR)
{
    Texture texture = Texture::create();
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture.name());
    for (GLenum face = 0; face < faceCount; ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, static_cast<GLint>(internalFormat), n, n, 0,
                     format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, filter);
    return texture;
}

// What all of them share: textures, framebuffers, the program and the state to draw with.
class CubeRival : public CubeMapContender
{
public:
    CubeRival(Rival rival, const Stage& stage, int n, bool cullBackFaces, examples::View view,
              RivalFormats formats);

    Work draw() override;
    MapImages read() const override;
    unsigned int colourTexture() const override { return colour_.name(); }
    unsigned int distanceTexture() const override { return distance_.name(); }

private:
    void attach(const Framebuffer& framebuffer, const std::function<void(GLenum, GLuint)>& attachment) const;
    void setState() const;
    void clear() const;
    Work drawFaces();
    Work drawLayered();

    Rival rival_;
    const Stage& stage_;
    int n_;
    bool cullBackFaces_;
    Texture colour_, distance_, depth_;
    std::array<Framebuffer, faceCount> faces_;
    Framebuffer allFaces_;
    mirrorball::gl::Program program_;
    int clipFromWorld_, faceList_, faceListLength_; // uniform locations
    std::array<glm::mat4, faceCount> matrices_;
    std::vector<mirrorball::CaptureMesh> meshes_;
};

CubeRival::CubeRival(Rival rival, const Stage& stage, int n, bool cullBackFaces, examples::View view,
                     RivalFormats formats)
    : rival_(rival), stage_(stage), n_(n), cullBackFaces_(cullBackFaces),
      meshes_(stage.meshes(view, cullBackFaces))
{
    if (formats == RivalFormats::eightBit) {
        colour_ = makeCube(n, GL_RGBA8, GL_RGBA);
        depth_ = makeCube(n, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT);
    } else {
        const bool wide = view != examples::View::colour; // positions and triangle numbers need whole floats
        colour_ = makeCube(n, wide ? GL_RGBA32F : GL_RGBA16F, GL_RGBA);
        distance_ = makeCube(n, GL_R32F, GL_RED, GL_NEAREST); // a mean of distances lies on no surface
        depth_ = makeCube(n, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    }
    for (GLenum face = 0; face < faceCount; ++face) {
        faces_[face] = Framebuffer::create();
        attach(faces_[face], [&](GLenum point, GLuint texture) {
            glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, 0);
        });
    }
    allFaces_ = Framebuffer::create();
    attach(allFaces_,
           [](GLenum point, GLuint texture) { glFramebufferTexture(GL_FRAMEBUFFER, point, texture, 0); });

    program_ = rivalProgram(rival, view, formats);
    const bool layered = rival == Rival::layeredGeometry || rival == Rival::layeredInstanced;
    clipFromWorld_ = glGetUniformLocation(program_.name(), layered ? "clipFromFace" : "clipFromWorld");
    faceList_ = glGetUniformLocation(program_.name(), "faceList");
    faceListLength_ = glGetUniformLocation(program_.name(), "faceListLength");
    // The corners of a face are √3 times as far as its near plane.
    for (std::size_t face = 0; face < faceCount; ++face)
        matrices_[face] = clipFromWorld(cubeFaces[face], stage.choice().near / std::numbers::sqrt3_v<float>,
                                        stage.choice().far);
}

void CubeRival::attach(const Framebuffer& framebuffer,
                       const std::function<void(GLenum, GLuint)>& attachment) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    attachment(GL_COLOR_ATTACHMENT0, colour_.name());
    attachment(GL_DEPTH_ATTACHMENT, depth_.name());
    if (!distance_)
        return;
    attachment(GL_COLOR_ATTACHMENT1, distance_.name());
    constexpr std::array<GLenum, 2> buffers = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, buffers.data());
}

void CubeRival::setState() const
{
    glViewport(0, 0, n_, n_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    if (hasClipControl())
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    (cullBackFaces_ ? glEnable : glDisable)(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glUseProgram(program_.name());
}

void CubeRival::clear() const
{
    const glm::vec4 background(stage_.scene().background, 1.0f);
    const std::array<float, 4> nothing = {std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    const float farthest = 0.0f;
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(background));
    if (distance_)
        glClearBufferfv(GL_COLOR, 1, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

Work CubeRival::draw()
{
    setState();
    return rival_ == Rival::plain || rival_ == Rival::culled ? drawFaces() : drawLayered();
}

Work CubeRival::drawFaces()
{
    Work work;
    for (std::size_t face = 0; face < faceCount; ++face) {
        glBindFramebuffer(GL_FRAMEBUFFER, faces_[face].name());
        clear();
        glUniformMatrix4fv(clipFromWorld_, 1, GL_FALSE, glm::value_ptr(matrices_[face]));
        for (const mirrorball::CaptureMesh& mesh : meshes_) {
            if (rival_ == Rival::culled && !touches(cubeFaces[face], *mesh.bounds))
                continue;
            stage_.drawMesh(mesh.id, program_.name());
            ++work.draws;
            work.triangles += mesh.triangles;
        }
    }
    return work;
}

Work CubeRival::drawLayered()
{
    Work work;
    glBindFramebuffer(GL_FRAMEBUFFER, allFaces_.name());
    clear();
    glUniformMatrix4fv(clipFromWorld_, faceCount, GL_FALSE, glm::value_ptr(matrices_[0]));
    for (const mirrorball::CaptureMesh& mesh : meshes_) {
        std::array<int, faceCount> list{};
        int length = 0;
        for (int face = 0; face < faceCount; ++face)
            if (touches(cubeFaces[static_cast<std::size_t>(face)], *mesh.bounds))
                list[static_cast<std::size_t>(length++)] = face;
        if (length == 0)
            continue;
        glUniform1iv(faceList_, faceCount, list.data());
        glUniform1i(faceListLength_, length);
        const int instances = rival_ == Rival::layeredInstanced ? length : 1;
        stage_.drawMesh(mesh.id, program_.name(), instances);
        ++work.draws;
        work.triangles += mesh.triangles * static_cast<std::size_t>(instances);
    }
    return work;
}

MapImages CubeRival::read() const
{
    const std::size_t texels = static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_);
    MapImages images{std::vector<float>(4 * texels * faceCount), std::vector<float>(texels * faceCount)};
    for (std::size_t face = 0; face < faceCount; ++face) {
        const GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
        glBindTexture(GL_TEXTURE_CUBE_MAP, colour_.name());
        glGetTexImage(target, 0, GL_RGBA, GL_FLOAT, &images.rgba[4 * texels * face]);
        glBindTexture(GL_TEXTURE_CUBE_MAP, distance_.name());
        glGetTexImage(target, 0, GL_RED, GL_FLOAT, &images.distance[texels * face]);
    }
    return images;
}

} // namespace

std::span<const RivalInfo> rivals()
{
    return infos;
}

bool isSupported(Rival rival)
{
    return rival != Rival::layeredInstanced || epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array");
}

std::unique_ptr<CubeMapContender> makeRival(Rival rival, const Stage& stage, int n, bool cullBackFaces,
                                            examples::View view, RivalFormats formats)
{
    return std::make_unique<CubeRival>(rival, stage, n, cullBackFaces, view, formats);
}

} // namespace tests::benchmark
