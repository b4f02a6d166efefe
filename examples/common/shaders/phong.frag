// Phong with one point light, as scene.h defines it. The #version line and VIEW are put before this text.

in vec3 positionInWorld;
in vec3 normalInWorld;
in vec2 uv;
uniform vec4 diffuse;
uniform vec3 specular;
uniform float shininess;
uniform bool hasImage;
uniform sampler2D image;
uniform vec3 lightInWorld;
uniform vec3 eyeInWorld;
uniform int firstTriangle;
out vec4 colour;

void main()
{
    vec4 d = diffuse;
    if (hasImage)
        d *= texture(image, uv);
    if (d.a < 0.5)
        discard;
    vec3 toEye = normalize(eyeInWorld - positionInWorld);
    vec3 n = normalize(normalInWorld);
    if (dot(n, toEye) < 0.0)
        n = -n;
#if VIEW == 1
    colour = vec4(positionInWorld, 1.0);
#elif VIEW == 2
    colour = vec4(n, 1.0);
#elif VIEW == 3
    colour = vec4(float(firstTriangle + gl_PrimitiveID), 0.0, 0.0, 1.0);
#else
    vec3 toLight = normalize(lightInWorld - positionInWorld);
    float lambert = dot(n, toLight);
    vec3 mirrored = 2.0 * lambert * n - toLight;
    float highlight = lambert > 0.0 ? pow(max(dot(mirrored, toEye), 0.0), shininess) : 0.0;
    colour = vec4(AMBIENT * d.rgb + d.rgb * max(lambert, 0.0) + specular * highlight, 1.0);
#endif
}
