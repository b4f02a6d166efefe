// hello_probe: what a host writes to put a mirror ball into its program. In every frame the probe in the
// ball's centre draws the room around it into a map, with the host's own shaders, and the ball shows the map.
#include "command_line.h" // the host's own: options, scene, how it compiles shaders and draws meshes
#include "gl_scene.h"
#include "gl_target.h"
#include "shapes.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <glm/gtc/matrix_transform.hpp>

#include <optional>

using namespace mirrorball;
using namespace examples;

namespace {

Scene roomWithBall()
{
    Scene scene = loadScene("builtin:room");
    scene.meshes.push_back(meshOf("ball", 0));
    appendSphere(scene.meshes.back(), glm::vec3(0.0f), 1.0f, 32, 64);
    return scene;
}

const std::string ballShader = R"(
in vec3 positionInWorld, normalInWorld;
uniform vec3 eyeInWorld;
out vec4 colour;
void main() { colour = mirrorball_reflection(positionInWorld, normalInWorld, eyeInWorld); })";

struct Hello
{
    const std::string vertex = phongVertexSource(), fragment = phongFragmentSource(View::colour);
    const GlScene scene{roomWithBall(), glm::dvec3(0.0)};
    const gl::Program roomProgram = linkProgram(vertex, fragment);
    const gl::Program ballProgram = linkProgram(
        vertex, "#version 330 core\n" + reflectionGlsl({.map = MapKind::tennisBall}) + ballShader);
    CaptureProgram captureProgram{{.vertexSource = vertex, .fragmentSource = fragment}};
    ReflectionProbe probe{{.map = MapKind::tennisBall, .n = 256, .halfExtent = 0.9}};
    const ProbeBinding binding{ballProgram.name()};
    const std::vector<CaptureMesh> meshes = allButTheBall(); // for as long as neither they nor the probe move

    // The ball is the last mesh.
    std::vector<CaptureMesh> allButTheBall()
    {
        std::vector<CaptureMesh> all = scene.captureMeshes(captureProgram);
        all.pop_back();
        return all;
    }

    void draw(float seconds, const glm::ivec2& pixels)
    {
        // Pass 1: everything but the ball.
        const glm::vec3 light(5 * std::sin(seconds), 3, 5 * std::cos(seconds));
        probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
            scene.drawMesh(mesh.id, draw.program, {.light = light, .eye = glm::vec3(0.0f)});
        });

        // The room as ever, then pass 2: the ball shows the map.
        const glm::vec3 eye(6 * std::sin(0.3f * seconds), 2, 6 * std::cos(0.3f * seconds));
        const glm::mat4 clipFromWorld = glm::perspective(0.8f, 1.0f * pixels.x / pixels.y, 0.1f, 100.0f) *
                                        glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
        const auto drawMesh = [&](std::size_t id, const gl::Program& program) {
            glUseProgram(program.name());
            glUniformMatrix4fv(glGetUniformLocation(program.name(), "clipFromWorld"), 1, GL_FALSE,
                               &clipFromWorld[0][0]);
            scene.drawMesh(id, program.name(), {.light = light, .eye = eye});
        };
        glViewport(0, 0, pixels.x, pixels.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_FRAMEBUFFER_SRGB);
        for (const CaptureMesh& mesh : meshes)
            drawMesh(mesh.id, roomProgram);
        const auto bound = binding.bind(probe.map());
        drawMesh(meshes.size(), ballProgram);
    }
};

void showWindow(int frames)
{
    glfwInit();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
    GLFWwindow* const window = glfwCreateWindow(960, 540, "hello_probe", nullptr, nullptr);
    if (window == nullptr)
        throw Error(ErrorKind::noContext, "a window", "GLFW cannot open one", "try --headless OUT.png");
    glfwMakeContextCurrent(window);
    for (Hello hello; !glfwWindowShouldClose(window) && frames != 0; --frames) {
        glm::ivec2 pixels;
        glfwGetFramebufferSize(window, &pixels.x, &pixels.y);
        hello.draw(static_cast<float>(glfwGetTime()), pixels);
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
}

void writePicture(const std::string& file)
{
    const headless::Context context;
    const GlTarget target({960, 540});
    Hello().draw(0.0f, {960, 540});
    io::writePng(file, target.image());
}

void run(const std::string& file, std::optional<int> frames)
{
    if (!file.empty() && !file.ends_with(".png"))
        throw Error(ErrorKind::badArgument, "the output '" + file + "'", "its extension is not .png",
                    "name it so");
    if (frames && *frames < 1)
        throw Error(ErrorKind::badArgument, "--frames " + std::to_string(*frames), "it is less than 1",
                    "give 1 or more");
    file.empty() ? showWindow(frames.value_or(-1)) : writePicture(file);
}

} // namespace

int main(int argc, char** argv)
{
    std::string file;
    std::optional<int> frames;
    const auto addOptions = [&](CLI::App& app) {
        addText(app, "--headless", file, "OUT.png", "draws one frame and writes it");
        addOptionalInteger(app, "--frames", frames, "closes the window after so many frames",
                           "it stays open");
    };
    return runProgram("hello_probe",
                      "A mirror ball in a room, in a window that stays open until it is closed.", argc, argv,
                      addOptions, [&] { run(file, frames); });
}
