// Views of a piecewise linear map: homogeneous coordinates that the rasteriser interpolates exactly.
uniform mat3 mirrorballCapture_clipFromDirection[MIRRORBALL_SLOTS];
uniform mat3 mirrorballCapture_inwardPlanes[MIRRORBALL_SLOTS];
uniform vec2 mirrorballCapture_depth; // z = depth.x * w + depth.y

vec4 mirrorballCapture_project(int view, vec3 position)
{
    vec3 clip = mirrorballCapture_clipFromDirection[MIRRORBALL_SLOT(view)] * position;
    return vec4(clip.xy, mirrorballCapture_depth.x * clip.z + mirrorballCapture_depth.y, clip.z);
}

vec3 mirrorballCapture_inside(int view, vec3 position)
{
    return mirrorballCapture_inwardPlanes[MIRRORBALL_SLOT(view)] * position;
}
