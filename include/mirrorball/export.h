// MIRRORBALL_EXPORT marks what a shared build makes visible; everything else is hidden.
// The package defines MIRRORBALL_SHARED for its users where the library is shared, and
// MIRRORBALL_BUILDING while the library itself is compiled.
#pragma once

#if defined(_WIN32) && defined(MIRRORBALL_SHARED)
#if defined(MIRRORBALL_BUILDING)
#define MIRRORBALL_EXPORT __declspec(dllexport)
#else
#define MIRRORBALL_EXPORT __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define MIRRORBALL_EXPORT __attribute__((visibility("default")))
#else
#define MIRRORBALL_EXPORT
#endif
