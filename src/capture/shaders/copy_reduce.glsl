// k x k samples become one texel: colour is averaged in linear light, distance is taken from one sample, since a mean
// of distances lies on no surface.
uniform sampler2DArray colours;
uniform sampler2DArray distances;
uniform int layer;
uniform int k;
layout(location = 0) out vec4 colour;
layout(location = 1) out float distanceOfTexel;

void main()
{
    ivec2 first = k * ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < k; ++y)
        for (int x = 0; x < k; ++x)
            sum += texelFetch(colours, ivec3(first + ivec2(x, y), layer), 0);
    colour = sum / float(k * k);
    // In the middle, or of the four around it for an even k, the upper right one.
    distanceOfTexel = texelFetch(distances, ivec3(first + k / 2, layer), 0).x;
}
