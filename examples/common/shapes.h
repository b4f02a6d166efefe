// Simple solids, appended to a mesh: what the built-in scenes are made of. Outward normals, triangles
// counter-clockwise seen from outside, texture coordinates once around each face.
#pragma once

#include "scene.h"

namespace examples {

// A parallelogram from `corner` along two edges; its normal is cross(u, v). Texture coordinates run from 0 to
// `repeats`. 2 triangles.
void appendQuad(Mesh& mesh, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                const glm::vec2& repeats = {1.0f, 1.0f});

// Each face cut into subdivisions² squares: 12 · subdivisions² triangles.
void appendBox(Mesh& mesh, const glm::vec3& low, const glm::vec3& high, int subdivisions = 1);

// 2 · sectors · (rings − 1) triangles; rings ≥ 2, sectors ≥ 3. Poles on the y axis.
void appendSphere(Mesh& mesh, const glm::vec3& centre, float radius, int rings, int sectors);

// Around `axis` (unit length): 2 · rings · sectors triangles; both ≥ 3, rings along the large circle.
void appendTorus(Mesh& mesh, const glm::vec3& centre, const glm::vec3& axis, float radius, float tubeRadius,
                 int rings, int sectors);

// An upright, capped cone frustum standing on `base`: 4 · sectors triangles; sectors ≥ 3, topRadius > 0.
void appendColumn(Mesh& mesh, const glm::vec3& base, float bottomRadius, float topRadius, float height,
                  int sectors);

// An empty mesh that uses a material.
Mesh meshOf(const char* name, int material);

} // namespace examples
