// FLIP, how different two pictures look when one replaces the other on the same screen (Andersson, Nilsson,
// Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM
// Comput. Graph. Interact. Tech. 3(2), 2020): from 0, the same, to 1.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace tests {

// For each pixel, in rows. Colours are linear sRGB and clamped to [0, 1]; the viewer is that of the paper, 0.7 m before
// a screen 0.7 m and 3840 pixels wide. Precondition: each picture has size.x * size.y pixels.
std::vector<double> flip(const glm::ivec2& size, const std::vector<glm::dvec3>& reference,
                         const std::vector<glm::dvec3>& test);

} // namespace tests
