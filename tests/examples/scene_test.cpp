// Scenes from files: what is drawn is what the file says, and what is no scene is an Error.
#include "scene.h"

#include <mirrorball/error.h>

#include "io/scratch.h"
#include "support/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <fcntl.h>
#include <limits>
#include <unistd.h>

using examples::Image;
using examples::loadReflector;
using examples::loadScene;
using examples::Mesh;
using examples::Scene;
using mirrorball::ErrorKind;
using namespace std::string_literals;
using tests::store;

namespace {

const std::string models = "/usr/share/assimp/models/";
const std::string moreModels = "/usr/share/glmark2/models/";

// 2 × 2 texels, RGBA: red, green above blue, white; white has alpha 128, the others 255.
constexpr unsigned char fourColours[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x72, 0xb6, 0x0d,
    0x24, 0x00, 0x00, 0x00, 0x13, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xf0,
    0x1f, 0x0c, 0x81, 0x34, 0x08, 0x34, 0x00, 0x00, 0x49, 0x49, 0x78, 0x9c, 0x51, 0x17, 0x92, 0x40,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
const std::string fourColoursPng(reinterpret_cast<const char*>(fourColours), sizeof fourColours);

// One triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) with normals (0.6, 0.8, 0) and texture coordinates (0, 0), (1,
// 0), (0, 1), used by two nodes: the inner one of a chain (moved by (10, 0, 0), then turned by 90° about z
// and doubled in x), and one at rest.
std::string smallGltf(const std::string& alphaMode)
{
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"translation": [10, 0, 0], "children": [1]},
                  {"rotation": [0, 0, 0.70710678, 0.70710678], "scale": [2, 1, 1], "mesh": 0}, {"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "material": 0}]}],
        "materials": [{"alphaMode": ")" +
           alphaMode + R"(", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1],
                       "baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"uri": "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4z8DwHwyBNAg0AABJSQl4nFEXkgAAAABJRU5ErkJggg=="}],
        "buffers": [{"byteLength": 96, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAmpkZP83MTD8AAAAAmpkZP83MTD8AAAAAmpkZP83MTD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 72, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"}]})";
}

glm::ivec4 texel(const Image& image, int x, int y)
{
    const std::uint8_t* rgba = &image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

bool isNear(const glm::vec3& a, const glm::vec3& b, float tolerance)
{
    return glm::distance(a, b) <= tolerance;
}

// Every index is in range and every normal has unit length: what the programs rely on without looking.
void checkWhole(const Scene& scene)
{
    CHECK(scene.triangleCount() > 0);
    for (const Mesh& mesh : scene.meshes) {
        CHECK(mesh.normals.size() == mesh.positions.size());
        CHECK(mesh.textureCoordinates.size() == mesh.positions.size());
        CHECK(mesh.material >= 0 && mesh.material < static_cast<int>(scene.materials.size()));
        for (const auto& triangle : mesh.triangles) {
            CHECK(*std::max_element(triangle.begin(), triangle.end()) < mesh.positions.size());
        }
        for (const glm::vec3& normal : mesh.normals) {
            CHECK_NEAR(glm::length(normal), 1.0, 4e-7); // three roundings of float around 1
        }
    }
    for (const examples::Material& material : scene.materials) {
        CHECK(material.image < static_cast<int>(scene.images.size()));
    }
    for (const Image& image : scene.images) {
        CHECK(image.rgba.size() == static_cast<std::size_t>(4 * image.width * image.height));
    }
}

void testRealFiles()
{
    struct Expected
    {
        std::string file;
        std::size_t triangles;
        float highestY;
    };
    // The engine stores 75,730 triangles and the house 32,588; meshes used by several nodes are drawn several
    // times. Heights: Assimp's own conversion puts the house, stored z up, y up: its roof ends at 6.318 m.
    const Expected files[] = {
        {moreModels + "bunny.obj", 69'666, 0.991233f},
        {moreModels + "horse.3ds", 7'172, 0.391028f},
        {models + "IFC/AC14-FZK-Haus.ifc", 35'906, 6.31769f},
        {models + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 121'496, 92.0416f},
        {models + "Collada/duck.dae", 4'212, 1.6397f},
    };
    for (const Expected& expected : files) {
        const Scene scene = loadScene(expected.file);
        checkWhole(scene);
        CHECK(scene.triangleCount() == expected.triangles);
        float highest = -std::numeric_limits<float>::max();
        for (const Mesh& mesh : scene.meshes) {
            for (const glm::vec3& position : mesh.positions) {
                highest = std::max(highest, position.y);
            }
        }
        CHECK_NEAR(highest, expected.highestY, 1e-5f * expected.highestY); // written with six digits
    }
    const Scene duck = loadScene(models + "Collada/duck.dae");
    CHECK(duck.images.size() == 1 && duck.images[0].width == 512);
    CHECK(duck.materials[static_cast<std::size_t>(duck.meshes[0].material)].image == 0);
}

void testSameEveryTime()
{
    const Scene first = loadScene(models + "IFC/AC14-FZK-Haus.ifc");
    const Scene second = loadScene(models + "IFC/AC14-FZK-Haus.ifc");
    CHECK(first.meshes.size() == second.meshes.size());
    for (std::size_t i = 0; i < first.meshes.size(); ++i) {
        CHECK(first.meshes[i].positions == second.meshes[i].positions);
        CHECK(first.meshes[i].normals == second.meshes[i].normals);
        CHECK(first.meshes[i].triangles == second.meshes[i].triangles);
    }
}

void testNodesAndEmbeddedTexture(const tests::Scratch& scratch)
{
    const std::string file = scratch / "small.gltf";
    store(file, smallGltf("BLEND"));
    const Scene scene = loadScene(file);
    checkWhole(scene);
    CHECK(scene.triangleCount() == 2);
    const Mesh& moved = scene.meshes[0];
    // Doubled in x, turned, moved: (1, 0, 0) becomes (10, 2, 0), (0, 1, 0) becomes (9, 0, 0). The quaternion
    // has eight digits.
    CHECK(isNear(moved.positions[moved.triangles[0][0]], {10, 0, 0}, 1e-6f));
    CHECK(isNear(moved.positions[moved.triangles[0][1]], {10, 2, 0}, 1e-6f));
    CHECK(isNear(moved.positions[moved.triangles[0][2]], {9, 0, 0}, 1e-6f));
    // A normal goes by the inverse transpose: (0.3, 0.8, 0), turned.
    CHECK(isNear(moved.normals[0], glm::normalize(glm::vec3(-0.8f, 0.3f, 0)), 1e-6f));
    const Mesh& resting = scene.meshes[1];
    CHECK(resting.positions[resting.triangles[0][1]] == glm::vec3(1, 0, 0));

    const examples::Material& material = scene.materials[static_cast<std::size_t>(resting.material)];
    CHECK(material.diffuse == glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
    CHECK(material.specular == glm::vec3(0.0f));
    // In glTF (0, 0) is the top left texel: red. Here it is at v = 1, the last row.
    CHECK(scene.images.size() == 1);
    CHECK(resting.textureCoordinates[resting.triangles[0][0]] == glm::vec2(0, 1));
    CHECK(texel(scene.images[0], 0, 1) == glm::ivec4(255, 0, 0, 255));
    CHECK(texel(scene.images[0], 1, 0) == glm::ivec4(255, 255, 255, 128));

    store(file, smallGltf("OPAQUE"));
    CHECK(texel(loadScene(file).images.at(0), 1, 0) == glm::ivec4(255, 255, 255, 255));
}

void testTextureFiles(const tests::Scratch& scratch)
{
    std::filesystem::create_directory(scratch / "model");
    store(scratch / "model/here.png", fourColoursPng);
    store(scratch / "above.png", fourColoursPng);
    store(scratch / "model/broken.png", fourColoursPng.substr(0, 30));
    const auto imageCount = [&](const std::string& texture) {
        store(scratch / "model/m.mtl",
              "newmtl m\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nNs 7\nd 0.75\nmap_Kd " + texture);
        store(scratch / "model/m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
              "f 1/1 2/2 3/3\n");
        const Scene scene = loadScene(scratch / "model/m.obj");
        checkWhole(scene);
        const examples::Material& material =
            scene.materials[static_cast<std::size_t>(scene.meshes.at(0).material)];
        CHECK(material.diffuse == glm::vec4(0.1f, 0.2f, 0.3f, 0.75f));
        CHECK(material.specular == glm::vec3(0.4f, 0.5f, 0.6f));
        CHECK(material.shininess == 7.0f);
        CHECK((material.image == 0) == (scene.images.size() == 1));
        if (!scene.images.empty()) {
            CHECK(texel(scene.images[0], 0, 0) ==
                  glm::ivec4(0, 0, 255, 255)); // v = 0 is the bottom row: blue
        }
        return scene.images.size();
    };
    CHECK(imageCount("here.png") == 1);
    CHECK(imageCount("C:\\somebody\\else\\here.png") == 1);
    CHECK(imageCount("missing.png") == 0);
    CHECK(imageCount("broken.png") == 0);
    CHECK(imageCount("../above.png") == 0); // it is there, but outside the model's folder
    CHECK(imageCount((scratch / "above.png").string()) == 0);
}

void testTrianglesAreKept(const tests::Scratch& scratch)
{
    // A duplicate, a triangle without area, a point, a line and an arrow head (concave, area 1).
    store(scratch / "odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 1 2\np 1\nl 1 2\n"
                               "v 0 0 5\nv 2 -1 5\nv 1 0 5\nv 2 1 5\nf 4 5 6 7\n");
    const Scene scene = loadScene(scratch / "odd.obj");
    checkWhole(scene);
    CHECK(scene.triangleCount() == 5);
    double area = 0.0;
    for (const Mesh& mesh : scene.meshes) {
        for (const auto& t : mesh.triangles) {
            const auto& p = mesh.positions;
            if (p[t[0]].z == 5.0f) {
                area +=
                    0.5 * static_cast<double>(glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
            }
        }
    }
    CHECK_NEAR(area, 1.0, 1e-6);
}

// A cube without normals keeps its edges; a fan that bends by less than the limit becomes smooth.
void testNormals(const tests::Scratch& scratch)
{
    store(scratch / "edge.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 4 2\n");
    const Scene edge = loadScene(scratch / "edge.obj");
    for (const glm::vec3& normal : edge.meshes.at(0).normals) {
        CHECK(isNear(normal, {0, 1, 0}, 1e-6f) || isNear(normal, {1, 0, 0}, 1e-6f));
    }
    // Two squares that meet at 20° on the z axis.
    store(scratch / "bend.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -0.93969262 0.34202014 0\nf 1 2 3\nf 1 4 2\n");
    const Scene bend = loadScene(scratch / "bend.obj");
    const Mesh& mesh = bend.meshes.at(0);
    CHECK(mesh.positions.size() == 4);
    const glm::vec3 mean = glm::normalize(glm::vec3(0, 1, 0) + glm::vec3(0.34202014f, 0.93969262f, 0));
    CHECK(isNear(mesh.normals[0], mean, 1e-6f) || isNear(mesh.normals[1], mean, 1e-6f));
}

void testErrors(const tests::Scratch& scratch)
{
    store(scratch / "empty.obj", "");
    store(scratch / "points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n");
    store(scratch / "line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    store(scratch / "index.obj", "v 0 0 0\nf 1 2 3\n");
    store(scratch / "text.txt", "not a model");
    store(scratch / "noise.glb", std::string(1000, '\x5a'));
    // Announces polygons and has none.
    store(scratch / "faces.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n0\n0\n");
    const std::string engine =
        tests::bytesOf(models + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
    store(scratch / "short.glb", engine.substr(0, engine.size() / 2));
    const std::string house = tests::bytesOf(models + "IFC/AC14-FZK-Haus.ifc");
    store(scratch / "short.ifc", house.substr(0, house.size() * 9 / 10));
    for (const char* file : {"short.ifc", "empty.obj", "points.obj", "line.obj", "index.obj", "text.txt",
                             "noise.glb", "faces.off", "short.glb"})
    {
        CHECK_THROWS(loadScene(scratch / file), ErrorKind::badFile);
        CHECK_THROWS(loadReflector(scratch / file), ErrorKind::badFile);
    }
    CHECK_THROWS(loadScene(scratch / "missing.obj"), ErrorKind::notFound);
    CHECK_THROWS(loadScene(scratch / ""), ErrorKind::notFound);
    CHECK_THROWS(loadScene(""), ErrorKind::notFound);
    CHECK_THROWS(loadReflector("toaster"), ErrorKind::notFound);
    CHECK_THROWS(loadReflector("sphere:"), ErrorKind::unknownName);
    CHECK_THROWS(loadReflector("sphere:1x"), ErrorKind::unknownName);
    CHECK(loadReflector("sphere:0x1.8p0").positions == loadReflector("sphere:1.5").positions);
    CHECK_THROWS(loadReflector("sphere:0"), ErrorKind::badArgument);
    CHECK_THROWS(loadReflector("sphere:-1"), ErrorKind::badArgument);
    CHECK_THROWS(loadReflector("sphere:nan"), ErrorKind::badArgument);
    CHECK_THROWS(loadReflector("sphere:1e99"), ErrorKind::badArgument);
}

// Whatever Assimp has to say goes into the Error, not to the terminal.
void testSilence(const tests::Scratch& scratch)
{
    const int kept[] = {dup(STDOUT_FILENO), dup(STDERR_FILENO)};
    const int said = open((scratch / "said").c_str(), O_CREAT | O_WRONLY, 0600);
    CHECK(kept[0] >= 0 && kept[1] >= 0 && said >= 0);
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    for (const char* file : {"index.obj", "noise.glb", "short.glb", "faces.off", "odd.obj"}) {
        try {
            loadScene(scratch / file);
        } catch (const mirrorball::Error& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
    std::fflush(stdout);
    dup2(kept[0], STDOUT_FILENO);
    dup2(kept[1], STDERR_FILENO);
    for (const int descriptor : {kept[0], kept[1], said}) {
        close(descriptor);
    }
    CHECK(tests::bytesOf(scratch / "said").empty());
}

void testReflectors()
{
    const Mesh sphere = loadReflector("sphere:1.5");
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        CHECK_NEAR(glm::length(sphere.positions[i]), 1.5, 1e-6); // some roundings of float
        CHECK(isNear(sphere.positions[i], 1.5f * sphere.normals[i], 1e-6f));
    }
    const Mesh bunny = loadReflector(moreModels + "bunny.obj");
    CHECK(bunny.triangles.size() == 69'666);
    glm::vec3 low(1e9f);
    glm::vec3 high(-1e9f);
    for (const glm::vec3& position : bunny.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    CHECK(isNear(low, -high, 1e-6f));
}

} // namespace

int main()
{
    const tests::Scratch scratch;
    testRealFiles();
    testSameEveryTime();
    testNodesAndEmbeddedTexture(scratch);
    testTextureFiles(scratch);
    testTrianglesAreKept(scratch);
    testNormals(scratch);
    testErrors(scratch);
    testSilence(scratch);
    testReflectors();
}
