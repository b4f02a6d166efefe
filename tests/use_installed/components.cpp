// Both components: a context without a window, a picture there and back, and an error that is caught by its
// type although another library threw it.
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>
#include <mirrorball/io/image.h>

#include <cstdio>
#include <exception>
#include <filesystem>

int main()
try {
    const mirrorball::headless::Context context;
    std::puts(context.description().c_str());

    // In the working directory, which the test makes for it.
    const mirrorball::io::Image image{2, 1, 3, {0, 1, 0, 1, 0, 1}};
    mirrorball::io::writePng("components.png", image);
    mirrorball::io::writeExr("components.exr", exrFromImage(image, mirrorball::io::ExrType::half));
    if (mirrorball::io::readImage("components.png").pixels != image.pixels ||
        mirrorball::io::readImage("components.exr").pixels != image.pixels)
        return 1;
    std::filesystem::remove("components.png");
    std::filesystem::remove("components.exr");

    try {
        mirrorball::io::readImage("components.png");
        return 1;
    } catch (const mirrorball::Error& error) {
        return error.kind() == mirrorball::ErrorKind::notFound ? 0 : 1;
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
