// The rim of the sphere map's disc is one direction, but interpolation next to it would show a different colour at
// every point of it. Texels which that interpolation touches are given the mean of what is seen round the rim.
uniform vec4 textureFromSquare; // scale, offset
uniform vec2 levelSize;         // of the level drawn into, guard texels included

const float turn = 6.2831853;
const int around = 8;

void main()
{
    vec2 ab = 2.0 * (gl_FragCoord.xy / levelSize - textureFromSquare.zw) / textureFromSquare.xy - 1.0;
    vec2 texel = 2.0 / (levelSize * textureFromSquare.xy);
    vec2 reach = abs(ab) + texel; // of the texel's weight in linear interpolation
    if (dot(reach, reach) < 1.0)
        discard;
    vec2 size = vec2(textureSize(colours, 0).xy);
    colour = vec4(0.0);
    for (int k = 0; k < around; ++k) {
        float angle = turn * float(k) / float(around);
        vec2 rim = vec2(cos(angle), sin(angle)) * (1.0 - 1.0 / size);
        colour += fetchedNearest(vec3(0.5 * rim + 0.5, 0.0)) / float(around);
    }
}
