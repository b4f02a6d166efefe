// mirrorball: environment reflection in OpenGL programs that exist already. All that a host calls, in order:
//
// Maps     maps.h cuts the sphere of directions into squares, in eight ways; glsl.h prints one for a shader,
//          measures.h says how well it samples. math/spaces.h names every space.
// Pass 1   a CaptureProgram is made of the host's own shaders; a ReflectionProbe draws the host's meshes with
//          it, seen from the probe's centre, into a ReflectionMap. An ImageMap is one made of images.
// Pass 2   reflectionGlsl is included in the reflective object's fragment shader; a ProbeBinding sets its
//          textures and uniforms while the object is drawn.
// Errors   whatever fails throws Error, before anything of the host's has changed.
//
// What we do not do: open a window, make a context (component headless does, for programs without a window),
// own a scene or a material system, patch the host's fragment shader, load GL functions for the host, keep a
// thread, print. Components have headers of their own: headless/context.h, io/image.h.
#pragma once

#include <mirrorball/capture/capture_program.h>
#include <mirrorball/capture/capture_types.h>
#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/gl/objects.h>
#include <mirrorball/maps/glsl.h>
#include <mirrorball/maps/maps.h>
#include <mirrorball/maps/measures.h>
#include <mirrorball/math/spaces.h>
#include <mirrorball/reflect/image_map.h>
#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_map.h>
#include <mirrorball/reflect/reflection_material.h>
#include <mirrorball/version.h>
