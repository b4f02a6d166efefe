#include "scene_file.h"

#include "image_file.h"

#include <mirrorball/error.h>

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace examples {
namespace {

using mirrorball::Error;
using mirrorball::ErrorKind;

// Normals that Assimp makes join faces that meet at less than this: bodies stay smooth, boxes keep their
// edges.
constexpr float smoothDegrees = 60.0f;

bool isFinite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 vectorFrom(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

// Assimp's matrices are stored by rows.
glm::dmat4 matrixFrom(const aiMatrix4x4& m)
{
    return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4,
                                     m.d1, m.d2, m.d3, m.d4));
}

// ---- Materials
// --------------------------------------------------------------------------------------------------

class MaterialReader
{
public:
    MaterialReader(const aiScene& source, std::filesystem::path folder, Scene& scene)
        : source_(source), folder_(std::move(folder)), scene_(scene)
    {
    }

    Material read(const aiMaterial& from)
    {
        Material material;
        material.name = from.GetName().C_Str();
        aiColor4D diffuse;
        if (from.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) == AI_SUCCESS) {
            material.diffuse = {diffuse.r, diffuse.g, diffuse.b, 1.0f};
        }
        float opacity = 1.0f;
        from.Get(AI_MATKEY_OPACITY, opacity);
        material.diffuse.a = opacity;

        // Without an exponent a file means no highlight; an exponent of 0 would light up the whole surface.
        aiColor3D specular;
        float shininess = 0.0f;
        from.Get(AI_MATKEY_SHININESS, shininess);
        if (from.Get(AI_MATKEY_COLOR_SPECULAR, specular) == AI_SUCCESS && shininess > 0.0f) {
            material.specular = {specular.r, specular.g, specular.b};
            material.shininess = shininess;
        }

        aiString mode;
        const bool opaque =
            from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == AI_SUCCESS && mode == aiString("OPAQUE");
        if (opaque) {
            material.diffuse.a = 1.0f;
        }
        aiString texture;
        if (from.GetTexture(aiTextureType_DIFFUSE, 0, &texture) == AI_SUCCESS) {
            material.image = imageIndex(texture.C_Str(), opaque);
        }
        return material;
    }

private:
    int imageIndex(const std::string& name, bool opaque)
    {
        const auto [entry, isNew] = indices_.try_emplace({name, opaque}, -1);
        if (isNew) {
            if (std::optional<Image> image = load(name)) {
                for (std::size_t i = 3; opaque && i < image->rgba.size(); i += 4) {
                    image->rgba[i] = 255;
                }
                scene_.images.push_back(std::move(*image));
                entry->second = static_cast<int>(scene_.images.size() - 1);
            }
        }
        return entry->second;
    }

    std::optional<Image> load(std::string name) const
    {
        if (const aiTexture* embedded = source_.GetEmbeddedTexture(name.c_str())) {
            return fromEmbedded(*embedded);
        }
        for (char& c : name) {
            c = c == '\\' ? '/' : c;
        }
        // Only below the model's folder: a file must not be able to name any other on the machine. Paths from
        // other people's machines come down to the plain file name beside the model.
        const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
        if (path.is_relative() && !path.empty() && *path.begin() != "..") {
            if (std::optional<Image> image = readImage(folder_ / path)) {
                return image;
            }
        }
        return readImage(folder_ / path.filename());
    }

    static std::optional<Image> fromEmbedded(const aiTexture& texture)
    {
        if (texture.mHeight == 0) { // a whole file of mWidth bytes
            return decodeImage({reinterpret_cast<const std::uint8_t*>(texture.pcData), texture.mWidth});
        }
        Image image{static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), {}};
        for (unsigned int y = texture.mHeight; y-- > 0;) {
            for (unsigned int x = 0; x < texture.mWidth; ++x) {
                const aiTexel& texel = texture.pcData[std::size_t{y} * texture.mWidth + x];
                image.rgba.insert(image.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
            }
        }
        return image;
    }

    const aiScene& source_;
    std::filesystem::path folder_;
    Scene& scene_;
    std::map<std::pair<std::string, bool>, int> indices_;
};

// ---- Meshes
// -----------------------------------------------------------------------------------------------------

// Appends vertices, giving bitwise equal ones the same index: many formats repeat them for each triangle.
class VertexJoiner
{
public:
    explicit VertexJoiner(Mesh& mesh) : mesh_(mesh) {}

    std::uint32_t index(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv)
    {
        std::string key(sizeof position + sizeof normal + sizeof uv, '\0');
        std::memcpy(key.data(), &position, sizeof position);
        std::memcpy(key.data() + sizeof position, &normal, sizeof normal);
        std::memcpy(key.data() + sizeof position + sizeof normal, &uv, sizeof uv);
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [entry, isNew] = indices_.try_emplace(std::move(key), next);
        if (isNew) {
            mesh_.positions.push_back(position);
            mesh_.normals.push_back(normal);
            mesh_.textureCoordinates.push_back(uv);
        }
        return entry->second;
    }

private:
    Mesh& mesh_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

// The normal of a triangle, or up where it has no area.
glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(normal);
    const bool usable = std::isfinite(length) && length > 0.0;
    return usable ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

Mesh readMesh(const aiMesh& from, const glm::dmat4& worldFromNode)
{
    Mesh mesh;
    mesh.name = from.mName.C_Str();
    mesh.material = static_cast<int>(from.mMaterialIndex);
    const glm::dmat3 normalMatrix = glm::inverseTranspose(glm::dmat3(worldFromNode));
    VertexJoiner joiner(mesh);
    for (unsigned int i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) { // points and lines; polygons have been cut
            continue;
        }
        std::array<glm::vec3, 3> positions;
        for (unsigned int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 inNode = vectorFrom(from.mVertices[face.mIndices[corner]]);
            positions[corner] = glm::vec3(worldFromNode * glm::dvec4(inNode, 1.0));
        }
        std::array<std::uint32_t, 3> triangle{};
        for (unsigned int corner = 0; corner < 3; ++corner) {
            const unsigned int index = face.mIndices[corner];
            glm::vec3 normal(std::numeric_limits<float>::quiet_NaN());
            if (from.HasNormals()) {
                normal = glm::normalize(normalMatrix * glm::dvec3(vectorFrom(from.mNormals[index])));
            }
            if (!isFinite(normal)) {
                normal = faceNormal(positions[0], positions[1], positions[2]);
            }
            const glm::vec2 uv = from.HasTextureCoords(0)
                                     ? glm::vec2(vectorFrom(from.mTextureCoords[0][index]))
                                     : glm::vec2(0.0f);
            triangle[corner] = joiner.index(positions[corner], normal, uv);
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

// Depth first, children in the file's order.
void readNode(const aiScene& source, const aiNode& node, const glm::dmat4& worldFromParent, Scene& scene)
{
    const glm::dmat4 worldFromNode = worldFromParent * matrixFrom(node.mTransformation);
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
        Mesh mesh = readMesh(*source.mMeshes[node.mMeshes[i]], worldFromNode);
        if (!mesh.triangles.empty()) {
            scene.meshes.push_back(std::move(mesh));
        }
    }
    for (unsigned int i = 0; i < node.mNumChildren; ++i) {
        readNode(source, *node.mChildren[i], worldFromNode, scene);
    }
}

// Some readers announce polygons where a broken file has none, and a checked build of Assimp ends the program
// over it when it triangulates. So each mesh is told what it has; without any type Assimp would guess
// polygons.
void correctPrimitiveTypes(aiMesh& mesh)
{
    constexpr unsigned int typeOf[] = {aiPrimitiveType_POINT, aiPrimitiveType_POINT, aiPrimitiveType_LINE,
                                       aiPrimitiveType_TRIANGLE, aiPrimitiveType_POLYGON};
    mesh.mPrimitiveTypes = aiPrimitiveType_POINT;
    for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
        mesh.mPrimitiveTypes |= typeOf[std::min(mesh.mFaces[i].mNumIndices, 4u)];
    }
}

// IFC files are STEP files, which end with a mark of their own (ISO 10303-21). Assimp reads what there is of
// a file that was cut off, and says nothing.
bool isCutOffStep(const std::string& file)
{
    constexpr std::string_view begin = "ISO-10303-21;";
    constexpr std::string_view end = "END-ISO-10303-21;";
    constexpr std::streamoff tail = 1024; // room for comments and blank lines behind the mark
    std::ifstream stream(file, std::ios::binary);
    std::string head(begin.size(), '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (head != begin) {
        return false;
    }
    stream.seekg(0, std::ios::end);
    stream.seekg(std::max<std::streamoff>(stream.tellg() - tail, 0));
    const std::string last(std::istreambuf_iterator<char>(stream), {});
    return last.find(end) == std::string::npos;
}

// An Error's text is one line, whatever a file's name or content brings into Assimp's message.
std::string oneLine(std::string text)
{
    for (char& c : text) {
        c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
    }
    return text;
}

// Reads, then triangulates and makes the normals that are missing. The importer owns the result.
const aiScene& import(Assimp::Importer& importer, const std::string& file, const std::string& asked)
{
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, smoothDegrees);
    const aiScene* source = nullptr;
    std::string problem;
    try {
        source = importer.ReadFile(file, 0);
        for (unsigned int i = 0; source != nullptr && i < source->mNumMeshes; ++i) {
            correctPrimitiveTypes(*source->mMeshes[i]);
        }
        if (source != nullptr) {
            source = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_GenSmoothNormals);
        }
        problem = importer.GetErrorString();
    } catch (const std::exception& exception) {
        source = nullptr;
        problem = exception.what();
    }
    if (source == nullptr || source->mRootNode == nullptr) {
        throw Error(ErrorKind::badFile, asked, "Assimp cannot read it: " + oneLine(problem));
    }
    return *source;
}

// A light that every axis sees from its positive side, outside the bounds: half of all faces are lit, whether
// the scene is seen from outside or from within.
glm::vec3 defaultLight(const Scene& scene)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-low);
    for (const Mesh& mesh : scene.meshes) {
        for (const glm::vec3& position : mesh.positions) {
            if (isFinite(position)) {
                low = glm::min(low, position);
                high = glm::max(high, position);
            }
        }
    }
    if (low.x > high.x) {
        return glm::vec3(0.0f);
    }
    constexpr glm::vec3 towards(0.5f, 0.8f, 0.6f);
    return 0.5f * (low + high) + glm::length(high - low) * towards;
}

} // namespace

Scene readSceneFile(const std::string& file)
{
    const std::string asked = "model " + file;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
        const char* const found =
            std::filesystem::exists(file, ignored) ? "it is not a file" : "no such file";
        throw Error(ErrorKind::notFound, asked, found, "give a file or one of the built-in names");
    }
    if (std::filesystem::file_size(file, ignored) == 0) {
        throw Error(ErrorKind::badFile, asked, "the file is empty", "write it again");
    }
    if (isCutOffStep(file)) {
        throw Error(ErrorKind::badFile, asked, "the file is cut off: its end mark is missing",
                    "write it again");
    }

    Assimp::Importer importer;
    const aiScene& source = import(importer, file, asked);
    Scene scene;
    scene.name = file;
    scene.background = {0.55f, 0.70f, 0.90f};
    MaterialReader materials(source, std::filesystem::path(file).parent_path(), scene);
    for (unsigned int i = 0; i < source.mNumMaterials; ++i) {
        scene.materials.push_back(materials.read(*source.mMaterials[i]));
    }
    readNode(source, *source.mRootNode, glm::dmat4(1.0), scene);
    if (scene.triangleCount() == 0) {
        throw Error(ErrorKind::badFile, asked, "there is no triangle in it", "give a model with surfaces");
    }
    scene.light = defaultLight(scene);
    return scene;
}

} // namespace examples
