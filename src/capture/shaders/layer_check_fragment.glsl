// Of two neighbouring 2 x 2 blocks the first is discarded.
layout(location = 0) out vec4 colour;
layout(location = 1) out float distanceOfTexel;

void main()
{
    if (gl_FragCoord.x < 2.0)
        discard;
    colour = vec4(1.0);
    distanceOfTexel = 1.0;
}
