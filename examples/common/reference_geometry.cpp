#include "reference_geometry.h"

#include <mirrorball/error.h>

#include <embree3/rtcore.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace examples {
namespace {

// The alpha below which a fragment is not there (scene.h).
constexpr double alphaLimit = 0.5;

double linearFromSrgb(std::uint8_t byte)
{
    // IEC 61966-2-1.
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

glm::dvec4 texel(const Image& image, long long x, long long y)
{
    const auto wrapped = [](long long i, int size) { return ((i % size) + size) % size; };
    const std::uint8_t* rgba = &image.rgba[static_cast<std::size_t>(
        4 * (wrapped(y, image.height) * image.width + wrapped(x, image.width)))];
    return {linearFromSrgb(rgba[0]), linearFromSrgb(rgba[1]), linearFromSrgb(rgba[2]), rgba[3] / 255.0};
}

glm::dvec4 surfaceColour(const PlacedMesh& placed, std::uint32_t triangle, const glm::dvec3& weights)
{
    glm::dvec4 colour(placed.material->diffuse);
    if (placed.image != nullptr) {
        const auto& [i, j, k] = placed.mesh->triangles[triangle];
        const auto& uv = placed.mesh->textureCoordinates;
        colour *= sampleImage(*placed.image, weights.x * glm::dvec2(uv[i]) + weights.y * glm::dvec2(uv[j]) +
                                                 weights.z * glm::dvec2(uv[k]));
    }
    return colour;
}

bool mayBeTransparent(const PlacedMesh& placed)
{
    if (placed.image == nullptr) {
        return false;
    }
    const std::vector<std::uint8_t>& rgba = placed.image->rgba;
    std::uint8_t least = 255;
    for (std::size_t i = 3; i < rgba.size(); i += 4) {
        least = std::min(least, rgba[i]);
    }
    return static_cast<double>(placed.material->diffuse.a) * least / 255.0 < alphaLimit;
}

void rejectTransparent(const RTCFilterFunctionNArguments* arguments)
{
    const auto& placed = *static_cast<const PlacedMesh*>(arguments->geometryUserPtr);
    for (unsigned int i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) {
            continue;
        }
        const double u = static_cast<double>(RTCHitN_u(arguments->hit, arguments->N, i));
        const double v = static_cast<double>(RTCHitN_v(arguments->hit, arguments->N, i));
        const std::uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
        if (surfaceColour(placed, triangle, {1.0 - u - v, u, v}).a < alphaLimit) {
            arguments->valid[i] = 0;
        }
    }
}

// Between a unit direction and the arc from a to b.
double angleToEdge(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b)
{
    const auto angleTo = [&](const glm::dvec3& v) {
        return std::atan2(glm::length(glm::cross(direction, v)), glm::dot(direction, v));
    };
    const glm::dvec3 normal = glm::cross(a, b);
    const bool beside =
        glm::dot(glm::cross(normal, a), direction) > 0.0 && glm::dot(glm::cross(b, normal), direction) > 0.0;
    const double length = glm::length(normal);
    if (beside && length > 0.0) {
        const double sine = glm::dot(direction, normal) / length;
        return std::abs(std::asin(glm::clamp(sine, -1.0, 1.0)));
    }
    return std::min(angleTo(a), angleTo(b));
}

} // namespace

double angleToEdges(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b,
                    const glm::dvec3& c)
{
    return std::min(
        {angleToEdge(direction, a, b), angleToEdge(direction, b, c), angleToEdge(direction, c, a)});
}

glm::dvec4 sampleImage(const Image& image, const glm::dvec2& textureCoordinate)
{
    // Texel centres lie at halves. A coordinate that is not finite reads the first texel.
    const glm::dvec2 at = textureCoordinate * glm::dvec2(image.width, image.height) - 0.5;
    if (!(std::abs(at.x) < 0x1p52) || !(std::abs(at.y) < 0x1p52)) {
        return texel(image, 0, 0);
    }
    const glm::dvec2 low = glm::floor(at);
    const glm::dvec2 f = at - low;
    const auto x = static_cast<long long>(low.x);
    const auto y = static_cast<long long>(low.y);
    const glm::dvec4 lower = glm::mix(texel(image, x, y), texel(image, x + 1, y), f.x);
    const glm::dvec4 upper = glm::mix(texel(image, x, y + 1), texel(image, x + 1, y + 1), f.x);
    return glm::mix(lower, upper, f.y);
}

struct ReferenceGeometry::Embree
{
    std::vector<PlacedMesh> meshes; // by Embree's geometry number
    std::vector<std::uint32_t> firstTriangle;
    glm::dvec3 origin{0.0};
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Embree() = default;
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree()
    {
        if (scene != nullptr) {
            rtcReleaseScene(scene);
        }
        if (device != nullptr) {
            rtcReleaseDevice(device);
        }
    }

    void attach(unsigned int number)
    {
        const PlacedMesh& placed = meshes[number];
        const bool isThere =
            placed.image != nullptr || static_cast<double>(placed.material->diffuse.a) >= alphaLimit;
        if (placed.mesh->triangles.empty() || !isThere) {
            return;
        }
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<glm::vec3*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                    placed.mesh->positions.size()));
        auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), placed.mesh->triangles.size()));
        if (positions == nullptr || triangles == nullptr) {
            rtcReleaseGeometry(geometry);
            throw mirrorball::Error(mirrorball::ErrorKind::unsupported, "reference tracer",
                                    "Embree cannot hold mesh " + placed.mesh->name);
        }
        for (const glm::vec3& position : placed.mesh->positions) {
            *positions++ = glm::vec3(placed.scale * glm::dvec3(position) + (placed.offset - origin));
        }
        std::copy(placed.mesh->triangles.begin(), placed.mesh->triangles.end(), triangles);
        if (mayBeTransparent(placed)) {
            rtcSetGeometryUserData(geometry, &meshes[number]);
            rtcSetGeometryIntersectFilterFunction(geometry, rejectTransparent);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, number);
        rtcReleaseGeometry(geometry);
    }

    // What Embree found, measured again in double.
    Hit measured(const RTCRayHit& found, const glm::dvec3& originInWorld,
                 const glm::dvec3& unitDirection) const
    {
        const PlacedMesh& placed = meshes[found.hit.geomID];
        const auto& [i, j, k] = placed.mesh->triangles[found.hit.primID];
        const auto relative = [&](std::uint32_t index) {
            return placed.scale * glm::dvec3(placed.mesh->positions[index]) + (placed.offset - originInWorld);
        };
        const glm::dvec3 a = relative(i);
        const glm::dvec3 b = relative(j);
        const glm::dvec3 c = relative(k);

        Hit hit;
        hit.found = true;
        hit.material = placed.mesh->material;
        hit.triangle = firstTriangle[found.hit.geomID] + found.hit.primID;
        const glm::dvec3 planeNormal = glm::cross(b - a, c - a);
        const double slope = glm::dot(unitDirection, planeNormal);
        hit.distance = slope != 0.0 ? glm::dot(a, planeNormal) / slope : static_cast<double>(found.ray.tfar);
        hit.position = originInWorld + hit.distance * unitDirection;

        // Barycentric weights of the plane's point, inside the triangle even where rounding put the ray
        // outside.
        glm::dvec3 weights(glm::dot(unitDirection, glm::cross(b, c)),
                           glm::dot(unitDirection, glm::cross(c, a)),
                           glm::dot(unitDirection, glm::cross(a, b)));
        weights = glm::max(slope < 0.0 ? -weights : weights, 0.0);
        const double sum = weights.x + weights.y + weights.z;
        weights = sum > 0.0 ? weights / sum : glm::dvec3(1.0 / 3.0);

        const auto& normals = placed.mesh->normals;
        const glm::dvec3 normal = weights.x * glm::dvec3(normals[i]) + weights.y * glm::dvec3(normals[j]) +
                                  weights.z * glm::dvec3(normals[k]);
        hit.normal = glm::normalize(glm::length(normal) > 0.0 ? normal : planeNormal);
        hit.colour = glm::vec3(surfaceColour(placed, found.hit.primID, weights));
        hit.edgeAngle = angleToEdges(unitDirection, a, b, c);
        return hit;
    }
};

ReferenceGeometry::ReferenceGeometry(std::span<const PlacedMesh> meshes, const glm::dvec3& origin)
    : embree_(std::make_unique<Embree>())
{
    embree_->origin = origin;
    embree_->meshes.assign(meshes.begin(), meshes.end());
    embree_->device = rtcNewDevice(nullptr);
    if (embree_->device == nullptr) {
        throw mirrorball::Error(mirrorball::ErrorKind::unsupported, "reference tracer",
                                "Embree cannot start");
    }
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    std::uint32_t first = 0;
    for (unsigned int number = 0; number < meshes.size(); ++number) {
        embree_->firstTriangle.push_back(first);
        first += static_cast<std::uint32_t>(meshes[number].mesh->triangles.size());
        embree_->attach(number);
    }
    rtcCommitScene(embree_->scene);
}

ReferenceGeometry::~ReferenceGeometry() = default;
ReferenceGeometry::ReferenceGeometry(ReferenceGeometry&&) noexcept = default;
ReferenceGeometry& ReferenceGeometry::operator=(ReferenceGeometry&&) noexcept = default;

Hit ReferenceGeometry::trace(const glm::dvec3& originInWorld, const glm::dvec3& direction, double near,
                             double far) const
{
    const double length = glm::length(direction);
    const glm::vec3 start(originInWorld - embree_->origin);
    const glm::vec3 along(direction); // as it is: where its coordinates are floats, so are Embree's
    RTCRayHit query{};
    query.ray.org_x = start.x;
    query.ray.org_y = start.y;
    query.ray.org_z = start.z;
    query.ray.dir_x = along.x;
    query.ray.dir_y = along.y;
    query.ray.dir_z = along.z;
    query.ray.tnear = static_cast<float>(near / length);
    query.ray.tfar = static_cast<float>(far / length);
    query.ray.mask = 0xffffffffu;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return {};
    }
    query.ray.tfar *= static_cast<float>(length);
    return embree_->measured(query, originInWorld, direction / length);
}

} // namespace examples
