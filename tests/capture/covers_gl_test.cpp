// How closely exact capture covers triangles: the fragments that it runs, of which those outside a triangle are waste.
#include "support/check.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <cmath>
#include <cstdio>

using namespace mirrorball;

namespace {

// Fragment-shader runs of one capture.
double fragmentsOf(const examples::GlScene& drawable, CaptureProgram& program,
                   const ReflectionProbe::Desc& desc)
{
    ReflectionProbe probe(desc);
    const std::vector<CaptureMesh> meshes = drawable.captureMeshes(program);
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, query);
    probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        drawable.drawMesh(mesh.id, draw.program, {});
    });
    glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    GLuint64 runs = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &runs);
    glDeleteQueries(1, &query);
    return static_cast<double>(runs);
}

// Times what the cube's faces run without covers, at as many texels. On llvmpipe the most is 2.4; 4.5 with pieces of
// rings on the sphere map's disc, and 3.5 with the octahedral map's eight views, which fit less closely.
double mostOf(MapKind map)
{
    return map == MapKind::sphereMap ? 5.0 : map == MapKind::octahedral ? 4.0 : 2.5;
}

void check(const char* name)
{
    const examples::Scene scene = examples::loadScene(name);
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    constexpr int cubeN = 128;
    const auto descOf = [](MapKind map, int n, CaptureMethod method) {
        return ReflectionProbe::Desc{
            .map = map, .n = n, .near = 0.1f, .mipLevels = false, .pastSeams = true, .method = method};
    };
    const double linear =
        fragmentsOf(drawable, program, descOf(MapKind::cube, cubeN, CaptureMethod::automatic));
    for (const MapInfo& info : maps()) {
        const int squares = info.components * info.widthInN * info.heightInN;
        const int n = static_cast<int>(std::lround(cubeN * std::sqrt(6.0 / squares)));
        const double ratio =
            fragmentsOf(drawable, program, descOf(info.kind, n, CaptureMethod::exact)) / linear;
        std::printf("%s, %s, n = %d: %.2f times the fragments of the cube's faces\n", name,
                    std::string(info.name).c_str(), n, ratio);
        CHECK(ratio >= 1.0 && ratio < mostOf(info.kind));
    }
}

} // namespace

int main()
{
    const headless::Context context;
    if (epoxy_gl_version() < 46 && !epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) {
        std::printf("skipped: this driver has no pipeline statistics\n");
        return 0;
    }
    check("builtin:cards");
    check("builtin:room");
    check("builtin:garden");
    check("builtin:crowd:12000");
}
