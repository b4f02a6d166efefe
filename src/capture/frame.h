// A probe as one capture sees it: where it stands, how far it looks, and what follows from that for each mesh.
#pragma once

#include "capture/capture_program.h"

#include <mirrorball/capture/reflection_probe.h>

#include <glm/mat4x4.hpp>

namespace mirrorball::capture {

// Whether texels past a component's seams show what is seen there: where the host asks for it, where mip levels are
// made of them, and where `layered` asks how a surface goes on. Mapped by the book they are wrong there, and are not
// used.
bool capturesPastSeams(const ReflectionProbe::Desc& desc);

class Frame
{
public:
    // Throws Error badArgument for a pose that is not rigid but for its scale, and for an empty range.
    explicit Frame(const ReflectionProbe::Desc& desc);

    const glm::dmat4& worldFromProbe() const { return worldFromProbe_; } // rigid
    const glm::dmat4& probeFromWorld() const
    {
        return probeFromWorld_;
    }                          // from positions relative to captureOrigin
    glm::dvec3 centre() const; // relative to captureOrigin
    MapKind map() const { return map_; }
    int n() const { return n_; }
    float near() const { return near_; }
    float far() const { return far_; }

    // Whether something inside these bounds, relative to captureOrigin, could be seen in a view.
    bool touches(int view, const Sphere& bounds) const;
    bool touches(int view, const Box& bounds) const;

    // How a mesh is drawn in a view, or into all layers at once (view < 0).
    Variant variantOf(const CaptureMesh& mesh, int view, bool peels) const;

    // To the middle of a mesh's bounds; 0 without.
    double distanceTo(const CaptureMesh& mesh) const;

    double tessellationSteps() const; // a radian

private:
    MapKind map_;
    int n_;
    CaptureMethod method_;
    DepthTerm depthTerm_;
    double epsilon_;
    bool pastSeams_;
    glm::dmat4 worldFromProbe_, probeFromWorld_;
    glm::dvec3 captureOrigin_;
    float near_, far_;
};

} // namespace mirrorball::capture
