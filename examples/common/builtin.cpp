#include "builtin.h"

#include <mirrorball/error.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

namespace examples {

using mirrorball::Error;
using mirrorball::ErrorKind;

int addMaterial(Scene& scene, const char* name, const glm::vec3& diffuse, float specular, float shininess,
                int image)
{
    scene.materials.push_back({name, glm::vec4(diffuse, 1.0f), glm::vec3(specular), shininess, image});
    return static_cast<int>(scene.materials.size() - 1);
}

namespace {

// The N of builtin:crowd:N, if it is a number at all.
std::optional<unsigned long long> numberFrom(std::string_view text)
{
    unsigned long long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc::result_out_of_range) {
        return std::numeric_limits<unsigned long long>::max();
    }
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

} // namespace

Scene builtinScene(const std::string& name)
{
    constexpr std::string_view crowd = "builtin:crowd:";
    if (name == "builtin:room") {
        return roomScene();
    }
    if (name == "builtin:garden") {
        return gardenScene();
    }
    if (name == "builtin:cards") {
        return cardsScene();
    }
    if (name.starts_with(crowd)) {
        if (const auto triangles = numberFrom(std::string_view(name).substr(crowd.size()))) {
            // Some gigabytes of memory; more than any of our measurements needs.
            constexpr unsigned long long most = 20'000'000;
            if (*triangles < 1 || *triangles > most) {
                throw Error(ErrorKind::badArgument, "scene " + name,
                            "the number of triangles is out of range", "give 1 to 20000000");
            }
            return crowdScene(*triangles);
        }
    }
    throw Error(ErrorKind::unknownName, "scene " + name, "no built-in scene has this name",
                "there are builtin:garden, builtin:room, builtin:cards and builtin:crowd:N");
}

} // namespace examples
