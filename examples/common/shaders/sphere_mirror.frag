// A true sphere: the pixel's ray meets it, whatever was drawn to get here. From within nothing of it is seen.
uniform mat4 clipFromWorld;
uniform mat3 rayFromPixel; // of window coordinates (x, y, 1)
uniform vec3 centreInWorld;
uniform vec3 eyeFromCentre; // subtracted in double
uniform float radius;
uniform vec2 depthFromClip; // depth = x * z / w + y
uniform float reflector;    // its number, from 1
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 distanceAndReflector;

void main()
{
    vec3 ray = normalize(rayFromPixel * vec3(gl_FragCoord.xy, 1.0));
    float middle = -dot(eyeFromCentre, ray); // the ray's point nearest to the centre
    // Seen from there nothing cancels, however far the eye is; taking off the part along the ray a second time
    // removes what the rounding of a long eyeFromCentre left.
    vec3 nearest = eyeFromCentre + middle * ray;
    nearest -= dot(nearest, ray) * ray;
    float halfChordSquared = radius * radius - dot(nearest, nearest);
    bool isInside = dot(eyeFromCentre, eyeFromCentre) < radius * radius;
    if (halfChordSquared < 0.0 || middle < 0.0 || isInside)
        discard;
    vec3 fromCentre = nearest - sqrt(halfChordSquared) * ray;
    vec3 position = centreInWorld + fromCentre;

    colour = mirrorAt(position, fromCentre / radius);
    distanceAndReflector = vec2(distance(eyeFromCentre, fromCentre), reflector);
    vec4 clip = clipFromWorld * vec4(position, 1.0);
    gl_FragDepth = depthFromClip.x * clip.z / clip.w + depthFromClip.y;
}
