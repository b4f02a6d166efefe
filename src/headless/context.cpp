#include <mirrorball/headless/context.h>

#include <mirrorball/error.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

namespace mirrorball::headless {

struct Context::State
{
    EGLDisplay display = EGL_NO_DISPLAY;
    bool displayIsCounted = false; // eglTerminate undoes one eglInitialize, not everybody's
    EGLContext context = EGL_NO_CONTEXT;
    std::string description;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();
};

namespace {

struct Version
{
    int major;
    int minor;
    auto operator<=>(const Version&) const = default;
};

constexpr Version desktopVersions[] = {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0},
                                       {3, 3}, {3, 2}, {3, 1}, {3, 0}, {2, 1}, {2, 0}};
constexpr Version esVersions[] = {{3, 2}, {3, 1}, {3, 0}, {2, 0}};

std::string text(Version version)
{
    return std::to_string(version.major) + "." + std::to_string(version.minor);
}

std::string apiName(const Context::Desc& desc)
{
    return desc.es ? "OpenGL ES" : "OpenGL";
}

std::string asked(const Context::Desc& desc)
{
    return "a context of " + apiName(desc) + " " + text({desc.major, desc.minor}) + " without a window";
}

// The extension stands in the space-separated list as a whole word.
bool hasExtension(const char* list, std::string_view extension)
{
    std::istringstream words(list != nullptr ? list : "");
    for (std::string word; words >> word;)
        if (word == extension)
            return true;
    return false;
}

// eglCreateContext reads the calling thread's bound API; a host that uses EGL itself finds its own again.
class BoundApi
{
public:
    explicit BoundApi(EGLenum api) : previous(eglQueryAPI()) { eglBindAPI(api); }
    BoundApi(const BoundApi&) = delete;
    BoundApi& operator=(const BoundApi&) = delete;
    ~BoundApi() { eglBindAPI(previous); }

private:
    EGLenum previous;
};

struct PlatformDisplay
{
    EGLenum platform;
    void* native;
};

std::vector<PlatformDisplay> displaysToTry(const char* clientExtensions)
{
    std::vector<PlatformDisplay> displays;
    if (hasExtension(clientExtensions, "EGL_MESA_platform_surfaceless"))
        displays.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (hasExtension(clientExtensions, "EGL_EXT_platform_device") && queryDevices != nullptr &&
        queryDevices(0, nullptr, &count) == EGL_TRUE && count > 0)
    {
        std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
        if (queryDevices(count, devices.data(), &count) == EGL_TRUE)
            for (EGLDeviceEXT device : std::span(devices).first(static_cast<std::size_t>(count)))
                displays.push_back({EGL_PLATFORM_DEVICE_EXT, device});
    }
    return displays;
}

// Without EGL_KHR_display_reference a display is shared by the whole process, and eglTerminate would take it
// from everybody else in it.
bool initialise(const PlatformDisplay& platformDisplay, bool counted, EGLDisplay& display)
{
    const EGLAttrib countedAttributes[] = {EGL_TRACK_REFERENCES_KHR, EGL_TRUE, EGL_NONE};
    display = eglGetPlatformDisplay(platformDisplay.platform, platformDisplay.native,
                                    counted ? countedAttributes : nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE)
        return false;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    return hasExtension(extensions, "EGL_KHR_create_context") &&
           hasExtension(extensions, "EGL_KHR_surfaceless_context");
}

// In the words of EGL_KHR_create_context, which displays older than EGL 1.5 understand too (Mesa's softpipe
// is one).
EGLContext createContext(EGLDisplay display, const Context::Desc& desc, Version version)
{
    const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       !desc.es             ? EGL_OPENGL_BIT
                                       : version.major == 2 ? EGL_OPENGL_ES2_BIT
                                                            : EGL_OPENGL_ES3_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, configAttributes, &config, 1, &count) != EGL_TRUE || count == 0)
        return EGL_NO_CONTEXT;

    std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION, version.major, EGL_CONTEXT_MINOR_VERSION,
                                      version.minor};
    if (!desc.es && version >= Version{3, 2})
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             desc.compatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT
                                                                : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
    if (desc.debug)
        attributes.insert(attributes.end(), {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

// From eglGetProcAddress, so that the component links no OpenGL library.
std::string describeCurrent(const Context::Desc& desc)
{
    using GetString = const unsigned char* (*)(unsigned int);
    constexpr unsigned int glVendor = 0x1F00; // as the OpenGL registry numbers them
    constexpr unsigned int glRenderer = 0x1F01;
    constexpr unsigned int glVersion = 0x1F02;
    const auto getString = reinterpret_cast<GetString>(eglGetProcAddress("glGetString"));
    const auto spelled = [&](unsigned int name) -> std::string {
        const unsigned char* value = getString != nullptr ? getString(name) : nullptr;
        return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
    };
    const std::string version = spelled(glVersion); // on ES it begins with "OpenGL ES" already
    return (desc.es ? "" : "OpenGL ") + version + ", " + spelled(glRenderer) + ", " + spelled(glVendor);
}

} // namespace

Context::State::~State()
{
    if (context != EGL_NO_CONTEXT) {
        if (eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
    if (displayIsCounted && display != EGL_NO_DISPLAY)
        eglTerminate(display);
}

Context::Context() : Context(Desc{}) {}

Context::Context(const Desc& desc)
{
    const std::span<const Version> versions =
        desc.es ? std::span<const Version>(esVersions) : std::span<const Version>(desktopVersions);
    const Version oldest{desc.major, desc.minor};
    if (std::find(versions.begin(), versions.end(), oldest) == versions.end())
        throw Error(ErrorKind::badArgument, asked(desc), "there is no such version");

    const BoundApi boundApi(desc.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    const char* clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const bool counted = hasExtension(clientExtensions, "EGL_KHR_display_reference");
    std::optional<Version> newestFound;
    for (const PlatformDisplay& platformDisplay : displaysToTry(clientExtensions)) {
        auto candidate = std::make_unique<State>();
        candidate->displayIsCounted = counted;
        if (!initialise(platformDisplay, counted, candidate->display))
            continue;
        for (Version version : versions) {
            candidate->context = createContext(candidate->display, desc, version);
            if (candidate->context == EGL_NO_CONTEXT)
                continue;
            newestFound = std::max(newestFound.value_or(version), version);
            break;
        }
        if (candidate->context != EGL_NO_CONTEXT && newestFound >= oldest) {
            state = std::move(candidate);
            makeCurrent();
            state->description = describeCurrent(desc);
            return;
        }
    }
    if (newestFound)
        throw Error(ErrorKind::unsupported, asked(desc),
                    "the driver offers " + text(*newestFound) + " at most", "install a newer driver");
    throw Error(ErrorKind::noContext, asked(desc), "no EGL driver here makes one",
                "install one, for example Mesa's (Debian: libegl1 and libgl1-mesa-dri)");
}

Context::Context(Context&& other) noexcept = default;
Context& Context::operator=(Context&& other) noexcept = default;
Context::~Context() = default;

void Context::makeCurrent() const
{
    assert(state != nullptr);
    if (eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context) != EGL_TRUE)
        throw Error(ErrorKind::noContext, "making a context current on this thread", "EGL refused",
                    "release it on the thread where it is current");
}

const std::string& Context::description() const
{
    assert(state != nullptr);
    return state->description;
}

} // namespace mirrorball::headless
