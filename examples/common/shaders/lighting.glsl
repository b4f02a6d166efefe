// Phong with one point light, as scene.h defines it: what the fragment shaders of the programs share. The
// #version line, VIEW and AMBIENT are put before this text.
uniform vec4 diffuse;
uniform vec3 specular;
uniform float shininess;
uniform vec3 lightInWorld;
uniform vec3 eyeInWorld;

// The normal has unit length and either sign: it is turned to the eye.
vec3 phong(vec3 diffuseColour, vec3 position, vec3 unitNormal)
{
    vec3 toEye = normalize(eyeInWorld - position);
    vec3 n = dot(unitNormal, toEye) < 0.0 ? -unitNormal : unitNormal;
    vec3 toLight = normalize(lightInWorld - position);
    float lambert = dot(n, toLight);
    vec3 mirrored = 2.0 * lambert * n - toLight;
    float highlight = lambert > 0.0 ? pow(max(dot(mirrored, toEye), 0.0), shininess) : 0.0;
    return AMBIENT * diffuseColour + diffuseColour * max(lambert, 0.0) + specular * highlight;
}
