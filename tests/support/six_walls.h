// A room of six coloured walls around a point, with one quadrant of each wall darker, so that any flip, turn
// or mirroring of a map shows. The walls are finely cut, so that even perVertex capture draws them well.
#pragma once

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

#include <glm/glm.hpp>

namespace tests {

class SixWalls
{
public:
    // Walls at distance 2 along the axes of the world, around `centre`; `cuts` squares along each wall's
    // side.
    explicit SixWalls(const glm::vec3& centre, int cuts = 64);

    mirrorball::CaptureMesh mesh() const;
    void draw() const;

    // What is seen from the centre: red and so on for +X, -X, +Y, -Y, +Z, -Z; halved where the wall's first
    // and second tangent coordinates are both positive.
    static glm::vec3 colourInDirection(const glm::dvec3& directionInWorld);

    // The angle to the nearest change of colour, as the smallest coordinate difference on the wall.
    static double marginInDirection(const glm::dvec3& directionInWorld);

    // Host shaders that hand over positionInWorld and write the colour.
    static mirrorball::CaptureProgram makeProgram();

private:
    mirrorball::gl::VertexArray vertexArray_;
    mirrorball::gl::Buffer buffer_;
    int vertexCount_ = 0;
    mutable mirrorball::CaptureProgram program_;
    glm::vec3 centre_;
};

} // namespace tests
