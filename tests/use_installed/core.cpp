// GLM and the core: no window, no context, no file.
#include <mirrorball/mirrorball.h>

#include <glm/vec3.hpp>

int main()
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(mirrorball::MapKind::tennisBall);
    const bool toTheFront = mirrorball::componentOf(info.kind, glm::vec3(0, 0, 1)) == 0;
    // An exception crosses the border of the library with its type.
    try {
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "asked", "found");
    } catch (const std::runtime_error&) {
        return info.components == 2 && toTheFront ? 0 : 1;
    }
}
