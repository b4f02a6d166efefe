in vec3 positionInWorld;
in vec3 normalInWorld;
uniform float reflector; // its number, from 1
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 distanceAndReflector;

void main()
{
    colour = mirrorAt(positionInWorld, normalize(normalInWorld));
    distanceAndReflector = vec2(distance(positionInWorld, eyeInWorld), reflector);
}
