// Where a probe's seams lie best.
#pragma once

#include <mirrorball/capture/reflection_probe.h>

#include <span>

namespace mirrorball::capture {

glm::dmat4 cheapestPose(const ReflectionProbe::Desc& desc, std::span<const CaptureMesh> meshes);

} // namespace mirrorball::capture
