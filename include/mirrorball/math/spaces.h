// Every space that a value can be in, and its range. All are right-handed; angles are radians. A value carries
// its space as a suffix (normalInView), a conversion is named xFromY, and conversions chain:
//     directionInProbe = probeFromWorld * worldFromView * directionInView
// Where a name says nothing of unit length, a direction may have any.
//
// World    the host's own space and unit of length, y up or z up; poses in double. Positions that shaders
//          hand over are float, relative to a point that is given in double (ReflectionProbe::Desc::
//          captureOrigin in pass 1, MaterialSettings::origin in pass 2), so that far places are as accurate.
// View     the host's camera: the eye is 0, it looks along -z, y is up. worldFromView is the inverse of the
//          view matrix, not the view matrix.
// Probe    the probe's centre is 0, turned by its pose. worldFromProbe is translation, rotation and uniform
//          scale; the scale stretches the probe's cube only, and radial distances stay in units of the world.
//          A material may turn further, by its own probeFromWorld, before the pose is taken away.
// Map      a direction in probe space falls into one component, 0 to components - 1: a layer of the texture
//          array, and the number in a file's name.
// Square   (u, v) in [0, 1]² of one component, closed; inverse maps continue to [-1/4, 5/4]². u runs along a
//          row; row 0 of a texture, and a file's first scanline, is the v = 0 side.
// Texel    column 0 to width - 1, row 0 to height - 1; the middle of a texel is at
//          u = (column + 1/2) / width, v = (row + 1/2) / height.
// Proxy    what stands for the surroundings: the unit sphere, or the cube [-1, 1]³, laid into the world by
//          the affine worldFromProxy.
//
// Distances are radial, from the probe's centre or the eye, in (near, far), infinite where nothing is seen.
// Colours are linear RGBA; 8-bit files are sRGB.
#pragma once
