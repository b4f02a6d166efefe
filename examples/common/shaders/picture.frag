// Into a picture: with the distance from the eye, and 0 for the scene, where a reflector has its number from 1.
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 distanceAndReflector;

void main()
{
    colour = surface();
    distanceAndReflector = vec2(distance(positionInWorld, eyeInWorld), 0.0);
}
